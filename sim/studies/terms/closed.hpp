// SPDX-License-Identifier: Apache-2.0
// closed.hpp: the paper's figures held against each other without a scene: what follows, what contradicts.
//
// Idea    Time is in units of a tile's sort. Lists pass SUs and RUs side by side, so a frame takes P + R where P is the
//         exposed preprocessing and R the rasterization: the paper's raster / sort. Operations: terms.hpp.
#pragma once

#include <string>
#include <vector>

namespace pipegs {

struct ClosedRow {
  std::string figure, equation;
  double value = 0, paper = 0;
  double residue() const { return value / paper - 1; }
};
std::vector<ClosedRow> closed_form();

}  // namespace pipegs
