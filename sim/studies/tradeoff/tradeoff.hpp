// SPDX-License-Identifier: Apache-2.0
// tradeoff.hpp: what accuracy costs in time: one view with less of everything, against the truth.
//
// Idea    A way is a thing to do without (pixels, Gaussians, SH degrees, late contributions, faint ones, the order) and
//         how much of it. Each is measured alone, then those that promise most together (ways.hpp). Cycles are those of
//         the timing model; accuracy is that of the golden model's picture, brought to full size, against the float64
//         truth of the whole scene in depth order at full size.
// Rule    A front holds the points that no other one beats in both, the most accurate is its first. What is kept of
//         the same scene, cameras, memory and configuration is not measured again.
// Errors  InputError when the scene does not fit the configuration; std::runtime_error("interrupted").
// Docs    docs/numerics/time.md
#pragma once

#include <filesystem>
#include <vector>

#include "scenes/camera.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/studies/tradeoff/ways.hpp"

namespace pipegs {

struct TradeoffView {
  const Scene& scene;
  const Camera& camera;
  const std::vector<Camera>& cameras;  // whose pictures the contributions are of
  SimulateOptions options;             // of the base
  std::filesystem::path keep;          // folder of what was measured; "": nothing is kept
};

// The base, each way alone, and at most `together` of several; places on the front are found.
std::vector<TradeoffPoint> tradeoff(const TradeoffView& view, int together);

}  // namespace pipegs
