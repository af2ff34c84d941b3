// SPDX-License-Identifier: Apache-2.0
// tradeoff.hpp: what accuracy costs in time: one view with less of everything, against the truth.
//
// Idea    A knob is a thing to do without (pixels, Gaussians, SH degrees, what shines through, what is faint, half of a
//         record, the order), a value how much of it. Each is measured alone. Squared errors of different knobs add and
//         their shares of the time multiply (nearly): so points that were measured alone predict every combination. Of
//         those that no other is predicted to beat, a few, evenly spaced in decibels, are measured.
// Rule    Accuracy is Figures::total. The most accurate point is the front's first.
// Docs    docs/numerics/time.md
#pragma once

#include <string>
#include <vector>

#include "scenes/scene.hpp"
#include "sim/studies/explore/explore.hpp"

namespace pipegs {

// The base, each value alone, and at most `together` of several knobs; places on the front are found. Throws InputError
// when the scene does not fit the configuration.
std::vector<Point> tradeoff(const MeasurePoints& measure, const Config& base, const Scene& scene, int together);

// Each value that the base and the scene allow, the base itself first. A value that the base has is left out.
std::vector<Point> less_alone(const Config& base, const Scene& scene);
// At most `most` of several knobs, predicted from `alone`, whose first point is the base.
std::vector<Point> less_together(const std::vector<Point>& alone, int most);

// From the most accurate point to the least, and the places of all points.
std::vector<const Point*> find_tradeoff_front(std::vector<Point>& points);

// The front from its most accurate point down, in steps: each ends at the fastest point that still has 50, 40 or 30 dB.
// A decibel's price is a step's cycles over its decibels. A level that changes nothing has no step.
struct PricedStep {
  const Point *from, *to;
  double cycles, cycles_per_db;
};
std::vector<PricedStep> price(const std::vector<const Point*>& front);

}  // namespace pipegs
