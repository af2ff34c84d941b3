// SPDX-License-Identifier: Apache-2.0
// cycle_engine.cpp: see cycle_engine.hpp.
#include "sim/timing/cycle_engine.hpp"

#include <memory>
#include <mutex>

#include "sim/timing/timing_model.hpp"

namespace pipegs {

CycleEngine rtl_engine(const Scene& scene, const Camera& camera, const SimulateOptions& options) {
  struct Kept {
    Config config;
    std::unique_ptr<Simulation> simulation;
  };
  return [&scene, &camera, options, kept = std::make_shared<Kept>()](const Config& config,
                                                                     const ExternalMemoryOptions& memory) {
    SimulateOptions asked = options;
    asked.config = config;
    asked.memory = memory;
    if (!kept->simulation || !(kept->config == config)) {
      kept->simulation.reset();
      auto simulation = std::make_unique<Simulation>();
      simulate_golden(scene, camera, asked, *simulation);
      kept->config = config;
      kept->simulation = std::move(simulation);
    }
    simulate_rtl(asked, *kept->simulation);
    EngineResult result{.cycles = kept->simulation->rtl.cycles, .mismatches = kept->simulation->mismatches};
    for (const MemoryTraffic& traffic : kept->simulation->traffic)
      result.bytes += traffic.bytes_read + traffic.bytes_written;
    return result;
  };
}

CycleEngine model_engine(const Scene& scene, const Camera& camera, const SimulateOptions& options) {
  struct Kept {
    std::mutex mutex;
    std::shared_ptr<const TimingTrace> trace;
  };
  return [&scene, &camera, options, kept = std::make_shared<Kept>()](const Config& config,
                                                                     const ExternalMemoryOptions& memory) {
    std::shared_ptr<const TimingTrace> trace;
    {
      const std::lock_guard lock(kept->mutex);
      if (!kept->trace || !(timing_config(kept->trace->config) == timing_config(config))) {
        SimulateOptions asked = options;
        asked.config = config;
        Simulation simulation;
        simulate_pack(scene, camera, asked, simulation);
        kept->trace = std::make_shared<const TimingTrace>(timing_trace(simulation.input));
      }
      trace = kept->trace;
    }
    const TimingResult timing = timing_run(*trace, config, memory);
    EngineResult result{.cycles = timing.cycles};
    for (const TimingResult::Stream& stream : timing.streams) result.bytes += stream.bytes_read + stream.bytes_written;
    return result;
  };
}

}  // namespace pipegs
