// SPDX-License-Identifier: Apache-2.0
// timing_check.hpp: the timing model against the RTL: cycles of the frame and of each window, bytes of each stream.
//
// Rule    They agree exactly, or they differ: there is no error that is small enough.
#pragma once

#include "sim/compare/simulate.hpp"
#include "sim/rtl/rtl_model.hpp"
#include "sim/timing/lockstep.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {

struct RtlTiming {
  uint64_t cycles = 0, overflow_lines = 0;
  std::vector<MemoryTraffic> traffic;
  std::vector<uint64_t> window_ends;  // as TimingResult::window_ends; none without taps
  double seconds = 0;                 // of one core, the lockstep's included if there is one
};

// Seconds that this thread has computed: other work on the machine does not count.
double thread_seconds();

// Runs the RTL of input's scene in the given configuration, and looks at nothing but time. With a lockstep the model is
// played beside it.
RtlTiming rtl_timing(const GoldenInput& input, const Config& config, const ExternalMemoryOptions& memory,
                     uint64_t seed = 1, Lockstep* lockstep = nullptr);

// One line for each figure in which they differ. A machine without taps shows no windows: they are not compared then.
std::vector<std::string> timing_differences(const TimingResult& model, const RtlTiming& rtl);

}  // namespace pipegs
