// SPDX-License-Identifier: Apache-2.0
// knobs.hpp: what can be turned of a drawn view: entries of the configuration, pixels and Gaussians that are left out.
//
// Idea    A knob is one entry of config.def, or a few that go together, and a list of settings from coarse to fine; a
//         value may also say what less is drawn (less.hpp). It is put on top of a base configuration; what it does not
//         name stays as it is there.
// Docs    docs/numerics/accuracy.md
#pragma once

#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/studies/explore/less.hpp"

namespace pipegs {

struct KnobValue {
  std::string label;
  std::vector<std::string> settings = {};  // key=value
  Less less = {};
};

struct Knob {
  std::string name;
  std::string what;               // one line
  std::vector<KnobValue> values;  // coarse to fine
  bool orders = false;            // changes the order in which Gaussians are blended: its price is an order error, too
  bool together = true;  // takes part when knobs are turned together; not when its entries have knobs of their own
};

// Blended layer by layer of a grid with so many cells along an axis, without what needs the exact order.
std::vector<std::string> layers_of_grid(int grid);

// Those that trade accuracy for cost.
const std::vector<Knob>& accuracy_knobs();

// By name, all without names. Throws ConfigError, one line that names the known knobs.
std::vector<const Knob*> find_knobs(const std::vector<std::string>& names);

// `base` with the value on top. Throws ConfigError when that is no legal configuration.
Config with_value(const Config& base, const KnobValue& value);

}  // namespace pipegs
