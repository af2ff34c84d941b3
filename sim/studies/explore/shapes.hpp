// SPDX-License-Identifier: Apache-2.0
// shapes.hpp: which shape of a machine draws a view soonest for its area, at equal pixels: how many units, how wide and
// how deep.
//
// Idea    An entry of the shape is one of config.def that changes time and area, and no pixel; a neighbour of a
//         configuration has one of these entries at another value of the table. First the base and each of its
//         neighbours. Then rounds, a descent along coordinates from every shape of the front at once: each neighbour of
//         the front has a predicted time, its origin's times what that entry alone gained on the base, and an area,
//         which needs no run. Measured are those that promise to beat the best within the wanted area, two a round, and
//         those by which the front would gain most, in relative time over relative area.
// Rule    Neighbours: only what config_check allows. More PUs that fetch than there are PUs are none (pu_fronts), so
//         `fronts` is at most `units`; entries of watermarks are entries of machines that have them, and windows below
//         64 pixels, whose footprints have another anchor, stay as they are. A shape is on the front when no other one
//         takes both no more time and no more area. Ends after `runs` shapes, or when no neighbour of the front
//         promises anything. Time counts at 1 GHz where no clock is known.
// Errors  ConfigError: the model knows no area of such a machine; InputError: the scene does not fit.
// Docs    docs/silicon/shapes.md
#pragma once

#include <string>
#include <vector>

#include "sim/studies/explore/explore.hpp"

namespace pipegs {

struct ShapeEntry {
  std::string name;
  int Config::*member;
  std::vector<int> values;
};
const std::vector<ShapeEntry>& shape_entries();

struct Neighbour {
  Config config;
  const ShapeEntry* entry;
  int value;
};
// Each machine once, in the order of the table.
std::vector<Neighbour> neighbours(const Config& config);

struct ShapeOptions {
  double mm2 = 0;  // the wanted area
  int runs = 40;   // most shapes that are measured
};

// Throws ConfigError, one line, when the area of such a machine is not known.
void check_shapes(const Config& base, const FrameModel& silicon);

// The base first; places on the front are found, the smallest machine first. The base passes check_shapes.
std::vector<Point> sweep_shapes(const MeasurePoints& measure, const FrameModel& silicon, const Config& base,
                                const ShapeOptions& options);

std::vector<const Point*> shape_front(const std::vector<Point>& shapes);

// The soonest whose area is at most this, of equals the smallest; null when none is so small.
const Point* best_within(const std::vector<Point>& shapes, double mm2);

}  // namespace pipegs
