// SPDX-License-Identifier: Apache-2.0
// tradeoff.cpp: see tradeoff.hpp.
#include "sim/study/tradeoff/tradeoff.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/text/json.hpp"
#include "sim/progress.hpp"
#include "sim/study/measurement_store.hpp"
#include "sim/study/tradeoff/contribution.hpp"
#include "sim/study/tradeoff/resample.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

Config config_of(const Config& base, const Way& way) {
  Config config = base;
  for (const std::string& setting : way.settings) config_set(config, setting);
  config_check(config);
  return config;
}

void stop_when_interrupted(double) {
  if (interrupted()) throw std::runtime_error("interrupted");
}

// One picture and one frame's time.
void measure(const Scene& scene, const Camera& camera, const SimulateOptions& options, const Image& truth,
             TradeoffPoint& point) {
  Simulation simulation;
  simulate_pack(scene, camera, options, simulation);
  const Image golden = golden_frame(simulation.input, {.threads = 0, .progress = stop_when_interrupted}).image;
  const bool whole = golden.width == truth.width && golden.height == truth.height;
  const Image shown = whole ? golden : resampled(golden, truth.width, truth.height);
  point.psnr = psnr(shown, truth);
  point.ssim = ssim(shown, truth);
  const TimingTrace trace = timing_trace(simulation.input, 0);
  stop_when_interrupted(0);
  const TimingResult timing = timing_run(trace, options.config, options.memory);
  point.cycles = timing.cycles;
  for (const TimingResult::Stream& stream : timing.streams) point.bytes += stream.bytes_read + stream.bytes_written;
}

nlohmann::ordered_json figures(const TradeoffPoint& point) {
  return {{"cycles", point.cycles}, {"bytes", point.bytes}, {"psnr", point.psnr}, {"ssim", point.ssim}};
}

bool take_kept(const std::optional<nlohmann::ordered_json>& kept, TradeoffPoint& point) {
  if (!kept) return false;
  try {
    point.cycles = json_integer<uint64_t>(kept->at("cycles"), 1);
    point.bytes = json_integer<uint64_t>(kept->at("bytes"));
    point.psnr = kept->at("psnr").get<double>();
    point.ssim = kept->at("ssim").get<double>();
    return true;
  } catch (const NumberError&) { return false; } catch (const nlohmann::json::exception&) {
    return false;
  }
}

void find_front(std::vector<TradeoffPoint>& points) {
  for (TradeoffPoint& one : points) {
    one.front = std::none_of(points.begin(), points.end(), [&](const TradeoffPoint& other) {
      return other.cycles <= one.cycles && other.psnr >= one.psnr &&
             (other.cycles < one.cycles || other.psnr > one.psnr);
    });
  }
}

}  // namespace

std::vector<Way> tradeoff_ways(const Config& base, const Scene& scene) {
  std::vector<Way> ways = {{.knob = "base", .label = "all", .settings = {}}};
  const std::vector<std::pair<double, std::string>> scales = {{0.75, "3/4"}, {0.5, "1/2"}};
  for (const auto& [scale, label] : scales)
    ways.push_back({.knob = "resolution", .label = label, .scale = scale, .settings = {}});
  for (const int percent : {5, 10, 20, 40, 60})
    ways.push_back(
        {.knob = "contribution", .label = fmt::format("-{} %", percent), .without = percent / 100.0, .settings = {}});
  const int degree = std::min(scene.sh_degree, base.sh_degree);
  for (int lower = degree - 1; lower >= 0; --lower)
    ways.push_back(
        {.knob = "SH degree", .label = std::to_string(lower), .settings = {fmt::format("sh_degree={}", lower)}});
  for (const int cut : {100000, 1000, 100})
    ways.push_back({.knob = "T cut", .label = fmt::format("1/{}", cut), .settings = {fmt::format("t_cut={}", cut)}});
  for (const int cut : {512, 128, 64})
    ways.push_back(
        {.knob = "alpha cut", .label = fmt::format("1/{}", cut), .settings = {fmt::format("alpha_cut={}", cut)}});
  if (base.order == 2) {
    for (const int grid : {8, 4, 1})
      ways.push_back({.knob = "order",
                      .label = grid == 1 ? "one layer" : fmt::format("layers of grid {}", grid),
                      .settings = {"order=0", "tight_boxes=0", fmt::format("grid={}", grid)}});
  }
  for (const auto& [scale, label] : {std::pair<double, std::string>{1, "1"}, scales[0], scales[1]}) {
    for (const int percent : {0, 20, 40}) {
      for (const int lower : {degree, 1}) {
        const int parts = (scale < 1) + (percent > 0) + (lower < degree);
        if (parts < 2) continue;
        Way way{.knob = "together", .scale = scale, .without = percent / 100.0, .settings = {}};
        if (scale < 1) way.label += "resolution " + label;
        if (percent > 0) way.label += fmt::format("{}-{} %", way.label.empty() ? "" : ", ", percent);
        if (lower < degree) {
          way.label += fmt::format(", SH {}", lower);
          way.settings.push_back(fmt::format("sh_degree={}", lower));
        }
        ways.push_back(way);
      }
    }
  }
  return ways;
}

std::vector<TradeoffPoint> tradeoff(const TradeoffView& view, const std::vector<Way>& ways) {
  Progress progress("trade-offs");
  const Image truth =
      render_truth(view.scene, view.camera, {.near_plane = view.options.near_plane, .progress = stop_when_interrupted});
  std::vector<float> weights;  // when a way asks for them
  std::map<double, Scene> scenes;
  const auto scene_without = [&](double share) -> const Scene& {
    if (share == 0) return view.scene;
    if (weights.empty())
      weights = contributions(view.scene, view.cameras, view.options.near_plane, stop_when_interrupted);
    if (!scenes.contains(share)) scenes.emplace(share, without_least(view.scene, weights, share));
    return scenes.at(share);
  };
  std::vector<TradeoffPoint> points;
  for (const Way& way : ways) {
    const Camera camera = way.scale < 1 ? smaller_camera(view.camera, way.scale) : view.camera;
    const Scene& scene = scene_without(way.without);
    SimulateOptions options = view.options;
    options.config = config_of(view.options.config, way);
    TradeoffPoint point{.way = way,
                        .config = options.config,
                        .width = camera.width,
                        .height = camera.height,
                        .gaussians = scene.gaussians.size()};
    const MeasurementStore store(view.keep, scene, camera, options,
                                 {{"full_width", view.camera.width}, {"full_height", view.camera.height}});
    if (!take_kept(store.load(options.config), point)) {
      measure(scene, camera, options, truth, point);
      store.save(options.config, figures(point));
    }
    points.push_back(point);
    stop_when_interrupted(0);
    progress.update(static_cast<double>(points.size()) / static_cast<double>(ways.size()), way.knob);
  }
  find_front(points);
  return points;
}

nlohmann::ordered_json to_json(const std::vector<TradeoffPoint>& points) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TradeoffPoint& point : points) {
    list.push_back({{"knob", point.way.knob},
                    {"label", point.way.label},
                    {"configuration", config_difference(point.config)},
                    {"width", point.width},
                    {"height", point.height},
                    {"gaussians", point.gaussians},
                    {"cycles", point.cycles},
                    {"us", point.us()},
                    {"bytes", point.bytes},
                    {"psnr", point.psnr},
                    {"ssim", point.ssim},
                    {"front", point.front}});
  }
  return list;
}

std::string to_text(const std::vector<TradeoffPoint>& points) {
  const double base = static_cast<double>(points.front().cycles);
  std::string text = fmt::format("  {:<14}{:<34}{:>10}{:>9}{:>9}{:>9}{:>9}  front\n", "without", "how much", "us",
                                 "of all", "MB", "dB", "SSIM");
  for (const TradeoffPoint& point : points) {
    text += fmt::format("  {:<14}{:<34}{:>10.1f}{:>7.1f} %{:>9.1f}{:>9.2f}{:>9.4f}  {}\n", point.way.knob,
                        point.way.label, point.us(), 100 * static_cast<double>(point.cycles) / base,
                        static_cast<double>(point.bytes) / 1e6, point.psnr, point.ssim, point.front ? "*" : "");
  }
  return text +
         "  us: of a frame at 1 GHz; dB, SSIM: the picture at full size against the float64 truth; *: no other one is "
         "both faster and closer\n";
}

Chart tradeoff_chart(const std::string& title, const std::vector<TradeoffPoint>& points) {
  Chart chart{.form = Chart::Form::kScatter,
              .title = title,
              .x_label = "microseconds of a frame at 1 GHz",
              .y_label = "dB against the truth",
              .from_zero = false};
  std::map<std::string, size_t> place;
  const auto series = [&](const std::string& name) -> Series& {
    if (!place.contains(name)) {
      place[name] = chart.series.size();
      chart.series.push_back({.name = name});
    }
    return chart.series[place[name]];
  };
  for (const TradeoffPoint& point : points) {
    Series& one = series(point.way.knob);
    one.x.push_back(point.us());
    one.values.push_back(point.psnr);
    one.labels.push_back(point.way.label);
  }
  std::vector<const TradeoffPoint*> front;
  for (const TradeoffPoint& point : points) {
    if (point.front) front.push_back(&point);
  }
  std::sort(front.begin(), front.end(),
            [](const TradeoffPoint* a, const TradeoffPoint* b) { return a->cycles < b->cycles; });
  Series joined{.name = "front", .outlined = true};
  for (const TradeoffPoint* point : front) {
    joined.x.push_back(point->us());
    joined.values.push_back(point->psnr);
    joined.labels.push_back(point->way.knob + " " + point->way.label);
  }
  chart.series.push_back(joined);
  return chart;
}

}  // namespace pipegs
