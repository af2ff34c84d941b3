// SPDX-License-Identifier: Apache-2.0
// view.cpp: see view.hpp.
#include "sim/studies/explore/view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/input_error.hpp"
#include "sim/design/static_cost.hpp"
#include "sim/progress.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/timing/timing_check.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

constexpr size_t kOrders = 4;  // truths in an order: some 40 MB each

ErrorFigures errors(const Image& a, const Image& b) {
  const Image shown_a = shown(a), shown_b = shown(b);
  return {psnr(a, b), ssim(a, b), max_abs_error(shown_a, shown_b), percentile_abs_error(shown_a, shown_b, 0.999)};
}

void stop_when_interrupted(double) {
  if (interrupted()) throw std::runtime_error("interrupted");
}

}  // namespace

View::View(const Scene& scene, const Camera& camera, const std::vector<Camera>& cameras, const SimulateOptions& options,
           Measured measured)
    : scene_(scene),
      camera_(camera),
      cameras_(cameras),
      options_(options),
      measured_(measured),
      engine_(model_engine(scene, camera, options)) {}

Camera View::camera(const Less& less) const { return less.scale < 1 ? scaled_camera(camera_, less.scale) : camera_; }

size_t View::gaussians(const Less& less) const {
  return scene_.gaussians.size() - left_out(scene_.gaussians.size(), less.without);
}

std::string View::shared(const Config& config, const Less& less) const {
  return measured_ == Measured::kCycles ? config_difference(timing_config(config)) : fmt::format("{}", less.without);
}

nlohmann::ordered_json View::key(const Less& less) const {
  using Json = nlohmann::ordered_json;
  Json key = {{"measured", static_cast<int>(measured_)}, {"scale", less.scale}, {"without", less.without}};
  if (less.rest != 0) key["rest"] = less.rest;
  if (less.lod != 0) key["lod_pixels"] = less.lod;
  if (less.without == 0) return key;
  std::string poses;
  for (const Camera& c : cameras_) {
    poses += Json{c.width, c.height, c.fx, c.fy, c.cx, c.cy, c.position.x, c.position.y, c.position.z}.dump();
    for (int i = 0; i < 3; ++i)
      poses += Json{c.world_to_camera[i].x, c.world_to_camera[i].y, c.world_to_camera[i].z}.dump();
  }
  key["cameras"] = hash_of_text(poses);
  return key;
}

const Image& View::exact() const {
  std::call_once(exact_once_, [&] { exact_ = truth(nullptr, 0); });
  return exact_;
}

Image View::truth(const std::vector<uint32_t>* rank, unsigned threads) const {
  const PixelRect area = asked_pixels(camera_.width, camera_.height, options_);
  TruthOptions truth{.rank = rank,
                     .near_plane = options_.near_plane,
                     .clip_window = true,
                     .threads = threads,
                     .progress = stop_when_interrupted};
  truth.x0 = area.x0, truth.y0 = area.y0, truth.x1 = area.x1, truth.y1 = area.y1;
  return render_truth(scene_, camera_, truth);
}

std::shared_ptr<const View::Ordered> View::ordered(const std::vector<uint32_t>& rank) const {
  {
    const std::lock_guard lock(mutex_);
    for (const auto& one : orders_) {
      if (one->rank == rank) return one;
    }
  }
  auto made = std::make_shared<Ordered>(Ordered{rank, truth(&rank, 1), {}});
  made->error = errors(made->truth, exact());
  const std::lock_guard lock(mutex_);
  orders_.push_back(made);
  if (orders_.size() > kOrders) orders_.erase(orders_.begin() + 1);  // the first one is the base's, which most share
  return made;
}

std::shared_ptr<const View::Lesser> View::scene_without(double without) const {
  const std::lock_guard lock(lesser_mutex_);
  if (contributions_.empty()) {
    Progress progress("contributions");
    contributions_ = contributions(scene_, cameras_, options_.near_plane, [&](double share) {
      stop_when_interrupted(share);
      progress.update(share);
    });
  }
  if (!lesser_ || lesser_->without != without)
    lesser_ = std::make_shared<Lesser>(Lesser{without, without_least(scene_, contributions_, without)});
  return lesser_;
}

void View::tell(const Findings& findings) const {
  if (options_.found) options_.found(findings);
}

void View::measure_picture(const Config& config, const Less& less, Figures& result) const {
  const Image& exact = this->exact();
  SimulateOptions asked = options_;
  asked.config = config;
  asked.rest = less.rest;
  asked.lod_pixels = less.lod;
  asked.found = [&](const Findings& findings) {  // an empty frame is kept with the figures: who asks tells of which
    for (const Finding& finding : findings) {
      if (finding.kind->key == "empty_frame") result.empty = finding.what;
      else tell({finding});
    }
  };
  const std::shared_ptr<const Lesser> lesser = less.without > 0 ? scene_without(less.without) : nullptr;
  Simulation simulation;
  simulate_pack(lesser ? lesser->scene : scene_, camera(less), asked, simulation);
  simulate_golden(asked, simulation, {.threads = 1, .progress = stop_when_interrupted});
  Image golden = crop_window(simulation.golden.image, asked);
  if (golden.width != exact.width || golden.height != exact.height)
    golden = resampled(golden, exact.width, exact.height);
  if (measured_ == Measured::kErrors && less.lod > 0) {
    result.numeric = errors(golden, exact);
    result.order = errors(exact, exact);
  } else if (measured_ == Measured::kErrors) {
    const auto order = ordered(simulation.golden.rank);
    result.numeric = errors(golden, order->truth);
    result.order = order->error;
  }
  result.total = errors(golden, exact);
  const TimingTrace trace = timing_trace(simulation.input, 1);
  stop_when_interrupted(0);
  const TimingResult timing = timing_run(trace, config, asked.memory);
  result.cycles = timing.cycles;
  for (const MemoryTraffic& stream : timing.streams) result.bytes += stream.bytes_read + stream.bytes_written;
}

Figures View::measure(const Config& config, const Less& less) const {
  Figures result;
  try {
    if (measured_ == Measured::kCycles) {
      const EngineResult frame = engine_(config, options_.memory);
      result.cycles = frame.cycles, result.bytes = frame.bytes;
    } else {
      measure_picture(config, less, result);
    }
  } catch (const InputError& error) {
    result.failure = error.what();
    return result;
  }
  for (const BufferCost& buffer : static_cost(config).buffers) result.buffer_bits += buffer.bits();
  return result;
}

}  // namespace pipegs
