// SPDX-License-Identifier: Apache-2.0
// report.hpp: what a simulation found, as report.json (keys: docs/commands.md) and as a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

// Smallest number of cycles that each resource needs for the frame's work, and the largest of them.
struct Bounds {
  double rows = 0, ru = 0, su = 0, cull = 0, memory = 0, bus = 0;
  std::string largest_name;
  double largest = 0;
};
Bounds work_bounds(const Simulation& simulation, const SimulateOptions& options);

// {bytes_read, bytes_written, by_stream}
nlohmann::ordered_json traffic_json(const std::vector<MemoryTraffic>& streams);
// Null without one.
nlohmann::ordered_json mismatch_json(const std::optional<Mismatch>& mismatch);
// `odd` is what was found in the scene, its camera and the frame.
nlohmann::ordered_json report_json(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                                   const Simulation& simulation, const Findings& odd);
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace pipegs
