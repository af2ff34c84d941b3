// SPDX-License-Identifier: Apache-2.0
// neighbours.hpp: the shapes of a machine: how many units, how wide and how deep, with the same pixels.
//
// Idea    An entry of the shape is one of config.def that changes time and area, and no pixel. A neighbour of a
//         configuration has one of these entries at another value of the table.
// Rule    Only what config_check allows. More PUs that fetch than there are PUs are none (pu_fronts), so `fronts` is at
//         most `units`; entries of watermarks are entries of machines that have them, and windows below 64 pixels,
//         whose footprints have another anchor, stay as they are.
#pragma once

#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct ShapeEntry {
  std::string name;
  int Config::*member;
  std::vector<int> values;
};
const std::vector<ShapeEntry>& shape_entries();

// The configuration with the entry at this value; itself when there is no such machine.
Config with_shape(const Config& config, const ShapeEntry& entry, int value);

struct Neighbour {
  Config config;
  const ShapeEntry* entry;
  int value;
};
// Each machine once, in the order of the table.
std::vector<Neighbour> neighbours(const Config& config);

}  // namespace pipegs
