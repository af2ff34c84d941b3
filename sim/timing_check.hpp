// timing_check.hpp: the timing model against the RTL: cycles of the frame and of each window.
#pragma once

#include "sim/rtl_model.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {

struct RtlTiming {
  uint64_t cycles = 0, overflow_lines = 0;
  std::vector<uint64_t> window_ends;  // as TimingResult::window_ends
  double seconds = 0;                 // of one core, nothing compared
};

// Seconds that this thread has computed: other work on the machine does not count.
double thread_seconds();

// Runs the RTL of input's scene in the given configuration, and looks at nothing but time.
RtlTiming rtl_timing(const GoldenInput& input, const Config& config, const ExternalMemoryOptions& memory, uint64_t seed = 1);

struct TimingErrors {
  double frame = 0;         // model / RTL - 1
  double worst_window = 0;  // largest magnitude, among windows of at least kWindowCycles cycles in the RTL
  size_t windows = 0;       // such windows
};

inline constexpr uint64_t kWindowCycles = 20000;

TimingErrors timing_errors(const TimingResult& model, const RtlTiming& rtl);

}  // namespace pipegs
