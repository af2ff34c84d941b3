// SPDX-License-Identifier: Apache-2.0
// timing_model.hpp: how many cycles a frame takes, without its pixels: what parameter sweeps use in the place of the
// RTL.
//
// Idea    timing_trace() runs the golden model once and keeps what control depends on; timing_run() plays the control
//         of every unit on it: queues, handshakes, latencies, memory. The trace serves every configuration that agrees
//         with its own in all that timing_config() leaves.
// Rule    Same trace, configuration and memory: same result, cycle for cycle.
// Docs    docs/cycles/timing_model.md
#pragma once

#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/memory/memory_timing.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs {

struct TimingResult {
  uint64_t cycles = 0;
  std::vector<MemoryTraffic> streams;
  uint64_t overflow_lines = 0;
  uint64_t peak_lines = 0, peak_records = 0;  // most that one alpha store, one SU's store held
  std::vector<uint64_t> window_ends;          // of each window: the cycle in which its end leaves the merge
};

struct TimingOptions {
  bool every_cycle = false;  // steps every unit in every cycle: for tests, changes nothing but the host's time
};

// Throws std::invalid_argument when the trace is not one of this configuration.
TimingResult timing_run(const TimingTrace& trace, const Config& config, const ExternalMemoryOptions& memory = {},
                        const TimingOptions& options = {});
// With a memory of any timing.
TimingResult timing_run(const TimingTrace& trace, const Config& config, MemoryTiming& memory,
                        const TimingOptions& options = {});

}  // namespace pipegs
