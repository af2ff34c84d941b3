// SPDX-License-Identifier: Apache-2.0
// view.cpp: see view.hpp.
#include "sim/studies/accuracy/view.hpp"

#include <cmath>
#include <stdexcept>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/input_error.hpp"
#include "sim/progress.hpp"
#include "sim/design/static_cost.hpp"
#include "sim/timing/timing_model.hpp"
#include "sim/timing/timing_check.hpp"

namespace pipegs {
namespace {

constexpr size_t kKept = 4;  // truths in an order: some 40 MB each

ErrorFigures errors(const Image& a, const Image& b) {
  return {psnr(a, b), ssim(a, b), max_abs_error(a, b), percentile_abs_error(a, b, 0.999)};
}

void stop_when_interrupted(double) {
  if (interrupted()) throw std::runtime_error("interrupted");
}

}  // namespace

double mean_square(double psnr) { return std::isinf(psnr) ? 0 : std::pow(10, -psnr / 10); }

AccuracyView::AccuracyView(const Scene& scene, const Camera& camera, const SimulateOptions& options)
    : scene_(scene),
      camera_(camera),
      options_(options),
      exact_(truth(nullptr, 0)),
      flips_(std::make_unique<FlipCounter>(scene, camera, options.near_plane,
                                           asked_pixels(camera.width, camera.height, options))) {}

SimulateOptions AccuracyView::options(const Config& config) const {
  SimulateOptions options = options_;
  options.config = config;
  return options;
}

bool AccuracyView::can_show(const Config& config) const {
  return !options_.window || config.window == options_.config.window;
}

Image AccuracyView::truth(const std::vector<uint32_t>* rank, unsigned threads) const {
  const PixelRect area = asked_pixels(camera_.width, camera_.height, options_);
  TruthOptions truth{.rank = rank,
                     .near_plane = options_.near_plane,
                     .clip_window = true,
                     .threads = threads,
                     .progress = stop_when_interrupted};
  truth.x0 = area.x0, truth.y0 = area.y0, truth.x1 = area.x1, truth.y1 = area.y1;
  return render_truth(scene_, camera_, truth);
}

std::shared_ptr<const AccuracyView::Ordered> AccuracyView::ordered(const std::vector<uint32_t>& rank,
                                                                   unsigned threads) const {
  {
    const std::lock_guard lock(mutex_);
    for (const auto& one : kept_) {
      if (one->rank == rank) return one;
    }
  }
  auto made = std::make_shared<Ordered>(Ordered{rank, truth(&rank, threads), {}});
  made->error = errors(made->truth, exact_);
  const std::lock_guard lock(mutex_);
  kept_.push_back(made);
  if (kept_.size() > kKept) kept_.erase(kept_.begin() + 1);  // the first one is the base's, which most share
  return made;
}

Image AccuracyView::golden(const Config& config) const {
  const SimulateOptions asked = options(config);
  Simulation simulation;
  simulate_pack(scene_, camera_, asked, simulation);
  return crop_window(golden_frame(simulation.input, {.threads = 0, .progress = stop_when_interrupted}).image, asked);
}

Accuracy AccuracyView::measure(const Config& config) const {
  const SimulateOptions asked = options(config);
  Accuracy result;
  Simulation simulation;
  try {
    simulate_pack(scene_, camera_, asked, simulation);
  } catch (const InputError& error) {
    result.failure = error.what();
    return result;
  }
  double before = thread_seconds();
  const auto lap = [&before] {
    const double now = thread_seconds(), passed = now - before;
    before = now;
    return passed;
  };
  simulation.golden = golden_frame(simulation.input, {.threads = 1, .progress = stop_when_interrupted});
  result.seconds_golden = lap();
  const Image golden = crop_window(simulation.golden.image, asked);
  const auto order = ordered(simulation.golden.rank, 1);
  result.seconds_truth = lap();
  result.numeric = errors(golden, order->truth);
  result.order = order->error;
  result.total = errors(golden, exact_);
  result.flips = flips_->count(simulation.input, simulation.golden.rank);
  lap();
  const TimingTrace trace = timing_trace(simulation.input, 1);
  result.seconds_trace = lap();
  stop_when_interrupted(0);
  const TimingResult timing = timing_run(trace, config, asked.memory);
  result.seconds_model = lap();
  result.cycles = timing.cycles;
  for (const TimingResult::Stream& stream : timing.streams) result.bytes += stream.bytes_read + stream.bytes_written;
  for (const BufferCost& buffer : static_cost(config).buffers) result.buffer_bits += buffer.bits();
  return result;
}

}  // namespace pipegs
