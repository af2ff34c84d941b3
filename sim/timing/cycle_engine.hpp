// SPDX-License-Identifier: Apache-2.0
// cycle_engine.hpp: what tells how many cycles a frame takes in a configuration and with a memory.
//
// Idea    A sweep asks the same question many times. The RTL is one who can answer; the timing model (sim/timing) is
//         another.
#pragma once

#include <cstdint>
#include <functional>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

struct EngineResult {
  uint64_t cycles = 0;      // of the frame
  uint64_t bytes = 0;       // over the pins of the external memory
  uint64_t mismatches = 0;  // beats and pixels unlike the golden model; 0 for an engine that computes none
};

using CycleEngine = std::function<EngineResult(const Config&, const ExternalMemoryOptions&)>;

// The RTL on one view, with all comparisons. The golden model of the latest configuration is kept: ask for one
// configuration after the other. `scene` and `camera` must outlive the engine.
CycleEngine rtl_engine(const Scene& scene, const Camera& camera, const SimulateOptions& options);

// The timing model on one view, without pixels. The trace of the latest configuration is kept, and serves all that
// differ only in what timing_config() names. May be asked from several threads. `scene` and `camera` must outlive the
// engine.
CycleEngine model_engine(const Scene& scene, const Camera& camera, const SimulateOptions& options);

}  // namespace pipegs
