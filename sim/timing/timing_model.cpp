// SPDX-License-Identifier: Apache-2.0
// timing_model.cpp: see timing_model.hpp.
#include "sim/memory/axi/bus_timing.hpp"
#include "sim/timing/timing_model.hpp"

#include <stdexcept>

#include "sim/timing/machine.hpp"

namespace pipegs {

TimingResult timing_run(const TimingTrace& trace, const Config& config, const ExternalMemoryOptions& options,
                        const TimingOptions& timing) {
  const std::unique_ptr<MemoryTiming> memory = machine_memory_timing(options, config);
  return timing_run(trace, config, *memory, timing);
}

TimingResult timing_run(const TimingTrace& trace, const Config& config, MemoryTiming& memory,
                        const TimingOptions& timing) {
  if (!(timing_config(trace.config) == timing_config(config))) {
    throw std::invalid_argument("timing model: the trace is of configuration " +
                                config_difference(timing_config(trace.config)) + ", asked for is " +
                                config_difference(timing_config(config)));
  }
  const auto machine = std::make_unique<timing::Machine>(trace, config, memory);
  machine->every_cycle = timing.every_cycle;
  TimingResult result;
  result.cycles = static_cast<uint64_t>(machine->run());
  result.overflow_lines = machine->overflow_lines;
  result.peak_lines = machine->peak_lines;
  result.peak_records = machine->peak_records;
  for (const timing::Cycle end : machine->window_ends) result.window_ends.push_back(static_cast<uint64_t>(end));
  for (const std::string& name : memory_streams(config)) result.streams.push_back({.stream = name});
  for (int port = 0; port < config.memory_ports(); ++port) {
    MemoryTraffic& stream = result.streams[memory_stream(config, port)];
    stream.bursts += machine->memory.bursts(port);
    stream.bytes_read += 32 * machine->memory.halves_read(port);
    stream.bytes_written += 32 * machine->memory.halves_written(port);
  }
  return result;
}

}  // namespace pipegs
