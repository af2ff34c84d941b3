// SPDX-License-Identifier: Apache-2.0
// front.hpp: knobs turned together: which configurations are worth having.
//
// Idea    Errors of different roundings add up (nearly): MSE(together) ~ MSE(base) + sum of what each knob alone adds
//         to the base's. So single sweeps predict every combination. From the most accurate value of every knob on, the
//         step that loses least predicted accuracy for the cost that it saves is taken, again and again, down to the
//         coarsest: a path. Configurations evenly spaced along it, in predicted decibels, are then measured; what is
//         reported is measured.
// Cost    Cycles. Most widths change none, so beside a cycle's share there is a hundredth of the buffers' share, and a
//         little for a coarser value as such (it saves area). A second path weighs cycles and buffers alike.
#pragma once

#include <optional>
#include <vector>

#include "sim/studies/accuracy/sweep/knobs.hpp"
#include "sim/studies/accuracy/view.hpp"
#include "sim/silicon/frame_model.hpp"

namespace pipegs {

struct MeasuredPoint {
  Config config;
  Accuracy figures;
  std::optional<FrameCost> silicon = std::nullopt;  // interpolated; none of a machine whose area is not known
};

struct SweptKnob {
  const Knob* knob = nullptr;
  std::vector<const KnobValue*> values;  // of the knob's, those that fit the base
  std::vector<MeasuredPoint> points;     // by value
};

// At most `count` configurations along both paths, of each the most accurate first; `base` is what the knobs were
// swept around.
std::vector<Config> together_path(const MeasuredPoint& base, const std::vector<SweptKnob>& knobs, int count);

// What a front is drawn over. Time is known where the clock is.
enum class Cost { kCycles, kTime, kBytes, kBuffers, kArea, kEnergy };
bool has_cost(const MeasuredPoint& point, Cost cost);
double cost_of(const MeasuredPoint& point, Cost cost);

// Points that no other one with this cost beats in numeric PSNR and cost together, the cheapest first. Only those whose
// order is good enough (see reaches) for their own numeric PSNR.
std::vector<const MeasuredPoint*> pareto_front(const std::vector<MeasuredPoint>& points, Cost cost);

// A point reaches `decibels` when its numeric PSNR does and its order is no excuse: an order PSNR of at least that too,
// or of 58.9 dB, what rounding to 8 bits costs.
inline constexpr double kOrderFloor = 58.9;
bool reaches(const Accuracy& figures, double decibels);

// The cheapest that reaches it: fewest cycles; among those within 1 % of the fewest the least buffers, then bytes.
// Null if none does.
const MeasuredPoint* cheapest(const std::vector<MeasuredPoint>& points, double decibels);

}  // namespace pipegs
