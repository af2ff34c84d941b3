// SPDX-License-Identifier: Apache-2.0
// measure.hpp: shapes measured by the timing model, several at a time, each once.
//
// Idea    A trace serves all configurations that timing_config() makes equal: those are measured together. What a
//         folder holds of the same view, memory, sources and configuration is not measured again.
// Errors  std::runtime_error("interrupted"); what was measured until then is in the folder.
#pragma once

#include "sim/report/measurement_store.hpp"
#include "sim/studies/shapes/shapes.hpp"

namespace pipegs {

// Scene, camera and store must outlive it.
MeasureShapes measure_shapes(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                             const MeasurementStore& store);

}  // namespace pipegs
