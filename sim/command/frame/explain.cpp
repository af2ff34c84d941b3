// SPDX-License-Identifier: Apache-2.0
// explain.cpp: `pipegs explain --pixel X,Y`: every Gaussian of a pixel in order, in double, golden and RTL.
//
// The columns stand side by side, so that "a wrong pixel" becomes "a wrong bit": power (log2 units, opacity included),
// alpha, weight and T before the Gaussian; below them its colour, and the sum of colours after it. The RTL columns
// come from a run of the pixel's window alone.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>

#include "cpp_model/float/projection.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "sim/command/command.hpp"

namespace pipegs {
namespace {

struct ExplainArguments {
  ViewArguments view;
  std::vector<int> pixel;
  bool json = false, no_rtl = false;
};

// Power of a job at a pixel of its part, log2 units: Eq. 3 with the golden coefficients.
double golden_power(const Config& config, const RowJob& job, double x, double y) {
  const auto value = [&](int64_t coefficient) { return std::ldexp(static_cast<double>(coefficient), -config.coeff_f); };
  return value(job.a) + value(job.b) * x + value(job.c) * y + value(job.d) * x * x + value(job.e) * y * y +
         value(job.f) * x * y;
}

// What float64 makes of a pixel: of each Gaussian its step and colour, and the sum of colours after it.
struct ExactStep {
  TruthStep step;
  glm::dvec3 color, sum;
};

std::map<uint32_t, ExactStep> exact_steps(const LoadedView& loaded, const TruthOptions& truth, int x, int y) {
  const Scene& scene = loaded.scene;
  const ProjectionOptions projection{truth.semantics, truth.near_plane, scene.antialiased, truth.sh_degree};
  std::map<uint32_t, ExactStep> steps;
  glm::dvec3 sum(0);
  for (const TruthStep& step : explain_truth(scene, loaded.camera, truth, x, y)) {
    ActivatedGaussian gaussian;
    activate(scene, step.index, gaussian);
    const glm::dvec3 color = project_truth(gaussian, scene.gaussians[step.index].sh_dc, sh_rest_of(scene, step.index),
                                           scene.sh_degree, loaded.camera, projection)
                                 .rgb;
    sum += step.weight * color;
    steps.emplace(step.index, ExactStep{step, color, sum});
  }
  return steps;
}

int explain(const ExplainArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  const int x = arguments.pixel.at(0), y = arguments.pixel.at(1), side = options.config.window;
  if (x >= loaded.camera.width || y >= loaded.camera.height) {
    throw ConfigError(
        fmt::format("--pixel {},{}: expected 0,0 to {},{}", x, y, loaded.camera.width - 1, loaded.camera.height - 1));
  }
  options.window = {x / side, y / side};
  options.watch = {x, y};
  if (!arguments.no_rtl) need_taps(options);
  check_picture_memory(loaded.camera, options, kGoldenPixels + kRtlPixels);
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  // The rank of a window's own Gaussians is all that the pixel's order needs.
  TruthOptions truth;
  truth.rank = &simulation.golden.rank;
  truth.near_plane = options.near_plane;
  const std::map<uint32_t, ExactStep> exact = exact_steps(loaded, truth, x, y);
  if (!arguments.no_rtl) simulate_rtl(options, simulation);
  std::map<uint32_t, StreamCheck::Seen> rtl;
  for (const StreamCheck::Seen& seen : simulation.seen) rtl.emplace(simulation.packed.scene_index(seen.index), seen);

  const Config& config = options.config;
  const BlendConstants constants(config, simulation.input.frame.raster.rest);
  const GoldenWindow window =
      golden_window(simulation.input, static_cast<uint64_t>(x / side), static_cast<uint64_t>(y / side));
  const int region = region_at(config, x % side / 8, y % side / 8), bit = region_bit(config, region),
            in_region = (y % 8) * 8 + x % 8, part_side = config.part_side();
  const double t_one = constants.one, alpha_one = std::ldexp(1.0, config.alpha_w);
  const auto color_json = [](const auto& channels, int fraction) {
    nlohmann::ordered_json rgb;
    for (int j = 0; j < 3; ++j) rgb.push_back(std::ldexp(static_cast<double>(channels[j]), -fraction));
    return rgb;
  };
  PixelState pixel{.t = constants.one}, shown = pixel;  // of the golden model and of the RTL
  bool told = false;                                    // where they part
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const GoldenLayer& layer : window.layers) {
    for (const GoldenSplat& splat : layer.splats) {
      if (static_cast<int>(splat.splat.part) != region_part(config, region)) continue;
      if ((splat.splat.mask >> bit & 1) == 0 || pixel.done) continue;
      uint16_t codes[kRegionPixels];
      golden_codes(config, splat.job, bit, codes);
      const uint32_t index = simulation.packed.scene_index(splat.splat.index);
      const auto truth_step = exact.find(index);
      const uint32_t color[3] = {static_cast<uint32_t>(splat.splat.red), static_cast<uint32_t>(splat.splat.green),
                                 static_cast<uint32_t>(splat.splat.blue)};
      const uint32_t t_before = pixel.t;
      const uint32_t weight = ru_blend(constants, pixel, codes[in_region], color);
      const auto seen = rtl.find(index);
      const bool differs = seen != rtl.end() && (seen->second.code != codes[in_region] || seen->second.after != pixel);
      if (codes[in_region] == 0 && truth_step == exact.end() && (!differs || told)) continue;
      nlohmann::ordered_json row = {{"layer", layer.ordinal}, {"gaussian", index}};
      nlohmann::ordered_json in_double = nullptr, in_rtl = nullptr;
      if (truth_step != exact.end()) {
        const auto& [step, step_color, sum] = truth_step->second;
        in_double = {{"power", std::log2(step.alpha)},
                     {"alpha", step.alpha},
                     {"weight", step.weight},
                     {"t", step.transmittance_before},
                     {"color", color_json(step_color, 0)},
                     {"sum", color_json(sum, 0)}};
      }
      if (seen != rtl.end()) {
        const auto& [name, code, after] = seen->second;
        in_rtl = {{"alpha", code / alpha_one},
                  {"weight", (static_cast<double>(shown.t) - after.t) / t_one},
                  {"t", shown.t / t_one},
                  {"sum", color_json(after.rgb, config.rgb_w - 2)},
                  {"first_that_differs", differs && !told}};
        shown = after;
        told = told || differs;
      }
      row["double"] = in_double;
      row["golden"] = {{"power", golden_power(config, splat.job, x % part_side, y % part_side)},
                       {"alpha", codes[in_region] / alpha_one},
                       {"weight", weight / t_one},
                       {"t", t_before / t_one},
                       {"done", pixel.done},
                       {"color", color_json(color, config.color_w - 2)},
                       {"sum", color_json(pixel.rgb, config.rgb_w - 2)}};
      row["rtl"] = in_rtl;
      rows.push_back(row);
    }
  }
  nlohmann::ordered_json mismatches = nullptr;  // nothing compared
  if (!arguments.no_rtl) mismatches = simulation.mismatches;
  if (arguments.json) {
    fmt::print("{}\n",
               nlohmann::ordered_json{{"pixel", {x, y}}, {"mismatches", mismatches}, {"gaussians", rows}}.dump(2));
  } else {
    fmt::print("pixel {},{}: power in log2 units with the opacity, T before the Gaussian\n", x, y);
    fmt::print(
        "layer Gaussian | power: double    golden | alpha: double  golden     rtl | weight: double  golden     rtl |  "
        "T: double  golden     rtl\n");
    const auto cell = [](const nlohmann::ordered_json& group, const char* key) {
      return group.is_null() || !group.contains(key) ? std::string("-")
                                                     : fmt::format("{:.5f}", group[key].get<double>());
    };
    for (const auto& row : rows) {
      fmt::print("{:5} {:8} | {:>13} {:>9} | {:>13} {:>7} {:>7} | {:>14} {:>7} {:>7} | {:>10} {:>7} {:>7}{}\n",
                 row["layer"].get<int>(), row["gaussian"].get<uint32_t>(), cell(row["double"], "power"),
                 cell(row["golden"], "power"), cell(row["double"], "alpha"), cell(row["golden"], "alpha"),
                 cell(row["rtl"], "alpha"), cell(row["double"], "weight"), cell(row["golden"], "weight"),
                 cell(row["rtl"], "weight"), cell(row["double"], "t"), cell(row["golden"], "t"), cell(row["rtl"], "t"),
                 row["golden"]["done"].get<bool>() ? "  stops here" : "");
    }
    fmt::print("\nlayer Gaussian | {:<23} {:<23} | {:<23} {:<23} rtl\n", "colour: double", "golden",
               "sum after it: double", "golden");
    const auto triple = [](const nlohmann::ordered_json& group, const char* key) {
      if (group.is_null()) return std::string("-");
      return fmt::format("{:.5f}", fmt::join(group[key].get<std::array<double, 3>>(), " "));
    };
    for (const auto& row : rows) {
      fmt::print(
          "{:5} {:8} | {:<23} {:<23} | {:<23} {:<23} {}{}\n", row["layer"].get<int>(), row["gaussian"].get<uint32_t>(),
          triple(row["double"], "color"), triple(row["golden"], "color"), triple(row["double"], "sum"),
          triple(row["golden"], "sum"), triple(row["rtl"], "sum"),
          !row["rtl"].is_null() && row["rtl"]["first_that_differs"].get<bool>() ? "  the first that differs" : "");
    }
  }
  if (!simulation.first_mismatch) return kExitOk;
  std::fflush(stdout);  // it stands last
  fmt::print(stderr, "first mismatch, {}\n", simulation.first_mismatch->line());
  return kExitDiffers;
}

}  // namespace

void add_explain(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "explain", "one pixel, Gaussian by Gaussian, in each model",
                  footer("pipegs explain garden.ply --cameras cameras.json --pixel 400,300",
                         "the RTL's window agrees (or --no-rtl: nothing compared)", "a bit of it differs"));
  static ExplainArguments arguments;
  arguments.view.add(command);
  add_place(command, "--pixel", arguments.pixel, "which pixel").required();
  add_flag(command, "--no-rtl", arguments.no_rtl, "leave out the RTL columns");
  add_flag(command, "--json", arguments.json, "as JSON");
  when_chosen(command, run, [] { return explain(arguments); });
}

}  // namespace pipegs
