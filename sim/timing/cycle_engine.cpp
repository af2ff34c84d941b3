// SPDX-License-Identifier: Apache-2.0
// cycle_engine.cpp: see cycle_engine.hpp.
#include "sim/timing/cycle_engine.hpp"

#include <memory>
#include <mutex>

#include "sim/timing/timing_model.hpp"

namespace pipegs {

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
    for (const MemoryTraffic& stream : timing.streams) result.bytes += stream.bytes_read + stream.bytes_written;
    return result;
  };
}

}  // namespace pipegs
