// SPDX-License-Identifier: Apache-2.0
// cycle_engine.hpp: how many cycles a view takes in one configuration and memory after the other, by the timing model.
#pragma once

#include <cstdint>
#include <functional>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

struct EngineResult {
  uint64_t cycles = 0;  // of the frame
  uint64_t bytes = 0;   // over the pins of the external memory
};

using CycleEngine = std::function<EngineResult(const Config&, const ExternalMemoryOptions&)>;

// The trace of the latest configuration is kept, and serves all that differ only in what timing_config() names. May be
// asked from several threads. `scene` and `camera` must outlive the engine.
CycleEngine model_engine(const Scene& scene, const Camera& camera, const SimulateOptions& options);

}  // namespace pipegs
