// SPDX-License-Identifier: Apache-2.0
// sweep.hpp: every knob alone around a base configuration, then together.
//
// Idea    Points are measured once each, several at a time on one core each. Single sweeps first: they predict which
//         combinations are worth measuring (front.hpp). What a folder holds already is not measured again.
#pragma once

#include <string>
#include <vector>

#include "sim/studies/accuracy/sweep/front.hpp"
#include "sim/report/measurement_store.hpp"

namespace pipegs {

struct SweepOptions {
  std::vector<const Knob*> knobs;
  int points = 40;      // measured together, at most; 0: knobs alone only
  bool resume = false;  // take what the store holds
};

struct AccuracySweep {
  MeasuredPoint base;
  std::vector<SweptKnob> knobs;
  std::vector<MeasuredPoint> together;
  std::vector<std::string> skipped;  // values that do not fit the base or the window, each with its reason
  size_t computed = 0, kept = 0;     // points measured now, and taken from the store
  double seconds = 0;                // wall time of this run
  double flips_sampled = 1;          // share of the pixels whose decisions were looked at

  std::vector<MeasuredPoint> all() const;  // each configuration once, the base first
};

// `config` is the base. Throws std::runtime_error when interrupted; what was measured until then is in the store.
// Area and energy are told by `silicon`, and not kept.
AccuracySweep accuracy_sweep(const AccuracyView& view, const MeasurementStore& store, const FrameModel& silicon,
                             const Config& config, const SweepOptions& options);

}  // namespace pipegs
