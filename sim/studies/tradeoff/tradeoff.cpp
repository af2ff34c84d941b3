// SPDX-License-Identifier: Apache-2.0
// tradeoff.cpp: see tradeoff.hpp.
#include "sim/studies/tradeoff/tradeoff.hpp"

#include <limits>
#include <optional>
#include <stdexcept>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/text/json.hpp"
#include "sim/progress.hpp"
#include "sim/report/finite.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/studies/tradeoff/contribution.hpp"
#include "sim/studies/tradeoff/resample.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

void stop_when_interrupted(double) {
  if (interrupted()) throw std::runtime_error("interrupted");
}

// What the ways of a view share, computed when a point is measured: all of them may be kept.
class Study {
 public:
  explicit Study(const TradeoffView& view)
      : view_(view), store_(view.keep, view.scene, view.camera, view.options, {{"cameras", poses(view.cameras)}}) {}

  TradeoffPoint point(const Way& way) {
    const Camera camera = way.scale < 1 ? scaled_camera(view_.camera, way.scale) : view_.camera;
    const size_t count = view_.scene.gaussians.size();
    TradeoffPoint point{.way = way,
                        .config = config_of(view_.options.config, way),
                        .width = camera.width,
                        .height = camera.height,
                        .gaussians = count - left_out(count, way.without)};
    const MeasurementStore store = store_.with({{"scale", way.scale}, {"without", way.without}});
    const auto read = [&](const Json& json) { return with_figures(point, json); };
    if (const std::optional<TradeoffPoint> kept = store.load(point.config, read)) {
      point = *kept;
    } else {
      measure(camera, point);
      store.save(point.config, figures(point));
    }
    stop_when_interrupted(0);
    return point;
  }

 private:
  static std::string poses(const std::vector<Camera>& cameras);
  static Json figures(const TradeoffPoint& point);
  static TradeoffPoint with_figures(TradeoffPoint point, const Json& json);
  const Scene& scene_without(double without);
  void measure(const Camera& camera, TradeoffPoint& point);

  const TradeoffView& view_;
  const MeasurementStore store_;
  std::optional<Image> truth_;
  std::vector<float> contributions_;
  Scene less_;  // without `less_without_` of the Gaussians
  double less_without_ = 0;
};

std::string Study::poses(const std::vector<Camera>& cameras) {
  std::string text;
  for (const Camera& c : cameras) {
    text += Json{c.width, c.height, c.fx, c.fy, c.cx, c.cy, c.position.x, c.position.y, c.position.z}.dump();
    for (int i = 0; i < 3; ++i)
      text += Json{c.world_to_camera[i].x, c.world_to_camera[i].y, c.world_to_camera[i].z}.dump();
  }
  return hash_of_text(text);
}

// JSON has neither infinity, the PSNR of equal pictures, nor the SSIM of pictures below 11 pixels.
Json Study::figures(const TradeoffPoint& point) {
  return {{"cycles", point.cycles},
          {"bytes", point.bytes},
          {"psnr", finite_json(point.psnr)},
          {"ssim", finite_json(point.ssim)}};
}

TradeoffPoint Study::with_figures(TradeoffPoint point, const Json& json) {
  const Json &psnr = json.at("psnr"), &ssim = json.at("ssim");
  point.cycles = json_integer<uint64_t>(json.at("cycles"), 1);
  point.bytes = json_integer<uint64_t>(json.at("bytes"));
  point.psnr = psnr.is_null() ? std::numeric_limits<double>::infinity() : json_real(psnr);
  point.ssim = ssim.is_null() ? std::nan("") : json_real(ssim, {-1, 1});
  return point;
}

const Scene& Study::scene_without(double without) {
  if (without == 0) return view_.scene;
  if (contributions_.empty()) {
    Progress progress("contributions");
    contributions_ = contributions(view_.scene, view_.cameras, view_.options.near_plane, [&](double share) {
      stop_when_interrupted(share);
      progress.update(share);
    });
  }
  if (less_without_ != without) less_ = without_least(view_.scene, contributions_, without);
  less_without_ = without;
  return less_;
}

void Study::measure(const Camera& camera, TradeoffPoint& point) {
  if (!truth_)
    truth_ = render_truth(view_.scene, view_.camera,
                          {.near_plane = view_.options.near_plane, .progress = stop_when_interrupted});
  SimulateOptions options = view_.options;
  options.config = point.config;
  Simulation simulation;
  simulate_pack(scene_without(point.way.without), camera, options, simulation);
  const Image golden = golden_frame(simulation.input, {.threads = 0, .progress = stop_when_interrupted}).image;
  const bool whole = golden.width == truth_->width && golden.height == truth_->height;
  const Image shown = whole ? golden : resampled(golden, truth_->width, truth_->height);
  point.psnr = psnr(shown, *truth_);
  point.ssim = ssim(shown, *truth_);
  const TimingTrace trace = timing_trace(simulation.input, 0);
  stop_when_interrupted(0);
  const TimingResult timing = timing_run(trace, options.config, options.memory);
  point.cycles = timing.cycles;
  for (const TimingResult::Stream& stream : timing.streams) point.bytes += stream.bytes_read + stream.bytes_written;
}

}  // namespace

std::vector<TradeoffPoint> tradeoff(const TradeoffView& view, int together) {
  Progress progress("trade-offs");
  Study study(view);
  std::vector<TradeoffPoint> points;
  const std::vector<Way> alone = ways_alone(view.options.config, view.scene);
  const double all = static_cast<double>(alone.size()) + together;
  const auto take = [&](const std::vector<Way>& ways) {
    for (const Way& way : ways) {
      points.push_back(study.point(way));
      progress.update(static_cast<double>(points.size()) / all, way.knob);
    }
  };
  take(alone);
  take(ways_together(points, together));
  find_front(points);
  return points;
}

}  // namespace pipegs
