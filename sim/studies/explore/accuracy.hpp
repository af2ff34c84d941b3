// SPDX-License-Identifier: Apache-2.0
// accuracy.hpp: what accuracy costs: every knob alone around a base configuration, then together.
//
// Idea    Errors of different roundings add up (nearly): MSE(together) ~ MSE(base) + sum of what each knob alone adds
//         to the base's. So single sweeps predict every combination. From the most accurate value of every knob on, the
//         step that loses least predicted accuracy for the cost that it saves is taken, again and again, down to the
//         coarsest: a path. Configurations evenly spaced along it, in predicted decibels, are then measured; what is
//         reported is measured.
// Cost    Cycles. Most widths change none, so beside a cycle's share there is a hundredth of the buffers' share, and a
//         little for a coarser value as such (it saves area). A second path weighs cycles and buffers alike.
// Docs    docs/numerics/accuracy.md
#pragma once

#include <string>
#include <vector>

#include "sim/studies/explore/explore.hpp"

namespace pipegs {

struct SweptKnob {
  const Knob* knob = nullptr;
  std::vector<Point> points;  // of its values, those that fit the base
};

struct SweepOptions {
  std::vector<const Knob*> knobs;
  int points = 40;            // measured together, at most; 0: knobs alone only
  bool window_fixed = false;  // a part was asked for: windows of another side show another one
};

struct AccuracySweep {
  Point base;
  std::vector<SweptKnob> knobs;
  std::vector<Point> together;
  std::vector<std::string> skipped;  // values that do not fit the base or the window, each with its reason

  std::vector<Point> all() const;  // each once, by configuration and by what less is drawn; the base first
};

// `config` is the base. Throws InputError when the scene does not fit it.
AccuracySweep accuracy_sweep(const MeasurePoints& measure, const Config& config, const SweepOptions& options);

// At most `count` configurations along both paths, of each the most accurate first; `base` is what the knobs were
// swept around.
std::vector<Config> together_path(const Point& base, const std::vector<SweptKnob>& knobs, int count);

// What a front is drawn over.
struct Cost {
  const char *name, *title, *axis;
  double unit;  // of the axis
  double (*of)(const Point&);
};
const std::vector<Cost>& costs();  // the first is cycles

// Points that no other one with this cost beats in numeric PSNR and cost together, the cheapest first. Only those whose
// order is good enough (see reaches) for their own numeric PSNR.
std::vector<const Point*> accuracy_front(const std::vector<Point>& points, const Cost& cost);

// A point reaches `decibels` when its numeric PSNR does and its order is no excuse: an order PSNR of at least that too,
// or of 58.9 dB, what rounding to 8 bits costs.
inline constexpr double kOrderFloor = 58.9;
bool reaches(const Figures& figures, double decibels);

// The cheapest that reaches it: fewest cycles; among those within 1 % of the fewest the least buffers, then bytes.
// Null if none does.
const Point* cheapest(const std::vector<Point>& points, double decibels);

}  // namespace pipegs
