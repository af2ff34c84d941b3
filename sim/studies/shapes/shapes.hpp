// SPDX-License-Identifier: Apache-2.0
// shapes.hpp: which shape of a machine draws a view soonest for its area, at equal pixels.
//
// Idea    First the base and each of its neighbours (neighbours.hpp), one entry changed at a time. Then rounds, a
//         descent along coordinates from every shape of the front at once: each neighbour of the front has a predicted
//         time, its origin's times what that entry alone gained on the base, and an area, which needs no run. Measured
//         are those that promise to beat the best within the wanted area, two a round, and those by which the front
//         would gain most, in relative time over relative area.
// Rule    What is told is measured: cycles and bytes by the timing model. Areas and clocks are interpolated
//         (frame_model.hpp). A shape is on the front when no other one takes both no more time and no more area. Ends
//         after `runs` shapes, or when no neighbour of the front promises anything.
// Errors  ConfigError: the model knows no area of such a machine.
// Docs    docs/silicon/shapes.md
#pragma once

#include <functional>
#include <vector>

#include "sim/silicon/frame_model.hpp"
#include "sim/timing/cycle_engine.hpp"

namespace pipegs {

struct Shape {
  enum class Step { kBase, kAlone, kTogether };
  Config config;
  EngineResult frame;
  FrameCost cost;
  Step step = Step::kBase;
  int front = 0;  // its place on the front, the smallest machine first; 0: not on it

  double us() const { return cost.us; }
  double mm2() const { return cost.mm2.mid; }
};

// Frames of several configurations, in their order.
using MeasureShapes = std::function<std::vector<EngineResult>(const std::vector<Config>&)>;

struct ShapeOptions {
  double mm2 = 0;  // the wanted area
  int runs = 40;   // most shapes that are measured
};

// Throws ConfigError, one line, when the area of such a machine is not known.
void check_shapes(const Config& base, const FrameModel& silicon);

// The base first; places on the front are found.
std::vector<Shape> sweep_shapes(const Config& base, const FrameModel& silicon, const MeasureShapes& measure,
                                const ShapeOptions& options);

void find_front(std::vector<Shape>& shapes);
std::vector<const Shape*> front_of(const std::vector<Shape>& shapes);  // by their places

// The soonest whose area is at most this, of equals the smallest; null when none is so small.
const Shape* best_within(const std::vector<Shape>& shapes, double mm2);

}  // namespace pipegs
