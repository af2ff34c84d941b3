// SPDX-License-Identifier: Apache-2.0
// machine_kind.hpp: configurations as the fits of areas and paths see them: which kind of machine, and where its knobs
// stand.
//
// Idea    A kind is what a design point decides: `late`, `order`, `quadratic`, `quads` and `pace`. Machines of one kind
//         have the same blocks in the same units; kinds differ by offsets. A knob is a free entry of config.def.
// Rule    `fronts` counts as what there is of them, pu_fronts: more than there are units are none.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

// The configuration that config_difference has named, as the tables of synth/data do: "default" or key=value,key=value.
// ConfigError for any other text.
Config config_of(const std::string& difference);

using MachineKind = std::array<int, 5>;  // late, order, quadratic, quads, pace
MachineKind kind_of(const Config& config);

// 1, and an offset for each part of a kind; ridges that go with them.
std::vector<double> kind_terms(const Config& config);
std::vector<double> kind_ridges();

// From -1 to 1 over the knob's legal range, `records` by the bits of a slot: logic grows with those, and what a store
// of records costs is SramCost's. ConfigError when there is no such knob.
double scaled(const Config& config, const std::string& knob);

// Whether one of the points is of this kind and tests regions as it does, which has blocks of its own, and each free
// entry lies between the least and the largest of the points'; alike where no point moves it. The number of PUs that
// fetch lies between those of the points of this kind: what such a PU holds depends on it, and on the kind.
bool within(const Config& config, const std::vector<Config>& points);

}  // namespace pipegs
