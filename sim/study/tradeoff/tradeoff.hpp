// SPDX-License-Identifier: Apache-2.0
// tradeoff.hpp: what accuracy costs in time: one view with less of everything, against the truth.
//
// Idea    A way is a thing to do without (pixels, Gaussians, SH degrees, late contributions, faint ones, the order) and
//         how much of it; each is measured alone, then those that buy most are measured together. Time is that of the
//         timing model; accuracy that of the golden model's picture, brought to full size, against the float64 truth
//         of the whole scene in depth order at full size.
// Rule    A front holds the points that no other one beats in both; `price` is what it loses for each per cent of time.
// Errors  InputError when the scene does not fit the configuration; std::runtime_error("interrupted").
// Docs    docs/numerics/time.md
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/report/chart.hpp"

namespace pipegs {

struct Way {
  std::string knob;    // what is done without; "together" for several
  std::string label;   // how much of it
  double scale = 1;    // of the picture's sides
  double without = 0;  // share of the Gaussians that is left out
  std::vector<std::string> settings;
};

struct TradeoffPoint {
  Way way;
  Config config;
  int width = 0, height = 0;
  uint64_t gaussians = 0, cycles = 0, bytes = 0;
  double psnr = 0, ssim = 0;  // of the picture at full size
  bool front = false;

  double us() const { return static_cast<double>(cycles) / 1e3; }  // at 1 GHz
};

// All that the base and the scene allow: each knob alone, then several together. The first one changes nothing.
std::vector<Way> tradeoff_ways(const Config& base, const Scene& scene);

struct TradeoffView {
  const Scene& scene;
  const Camera& camera;
  const std::vector<Camera>& cameras;  // whose pictures the contributions are of
  SimulateOptions options;             // of the base
  std::filesystem::path keep;          // folder of what was measured; "": nothing is kept
};

std::vector<TradeoffPoint> tradeoff(const TradeoffView& view, const std::vector<Way>& ways);

nlohmann::ordered_json to_json(const std::vector<TradeoffPoint>& points);
std::string to_text(const std::vector<TradeoffPoint>& points);
Chart tradeoff_chart(const std::string& title, const std::vector<TradeoffPoint>& points);

}  // namespace pipegs
