// SPDX-License-Identifier: Apache-2.0
// trainer: see trainer.hpp.
#include "sim/studies/train/run/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenes/generate/generate_random.hpp"
#include "sim/studies/train/gradient/photo_loss.hpp"

namespace pipegs {
namespace {

constexpr double kDssimWeight = 0.2;
constexpr double kFirstMeanRate = 1.6e-4, kLastMeanRate = 1.6e-6;  // of the extent
constexpr Rates kRates{0, 2.5e-3, 2.5e-3 / 20, 0.05, 5e-3, 1e-3};
constexpr int kGrowEvery = 100, kResetEvery = 3000;
constexpr double kFine = 0.1, kComesToRest = 0.1, kDamping = 1;
constexpr int kGridEvery = 100;  // the planes of the layers follow the scene

// Independent numbers for each use and each step.
generate::Random random_of(std::uint64_t seed, std::uint64_t use, int step) {
  return generate::Random(generate::mixed(seed * 4 + use) + static_cast<std::uint64_t>(step));
}
enum Use : std::uint64_t { kOrder, kGrow };

}  // namespace

Rates Schedule::rates(int step, double extent) const {
  const double share = static_cast<double>(step) / steps;
  Rates rates = kRates;
  if (!fine_tuning) {
    rates.mean = kFirstMeanRate * extent * std::pow(kLastMeanRate / kFirstMeanRate, share);
    return rates;
  }
  const double rest = std::pow(kComesToRest, share), fine = kFine * rest;
  return {kLastMeanRate * extent * rest,
          fine * rates.sh_dc,
          fine * rates.sh_rest,
          fine * rates.opacity,
          fine * rates.scale,
          fine * rates.rotation,
          kDamping};
}

int Schedule::sh_degree(int step, int highest) const {
  return fine_tuning ? highest : std::min<int>(highest, static_cast<int>(30.0 * step / steps));
}

bool Schedule::counts_gradients(int step) const { return !fine_tuning && step < steps / 2; }

bool Schedule::grows(int step) const { return counts_gradients(step) && step > steps / 60 && step % kGrowEvery == 0; }

bool Schedule::resets_opacity(int step) const { return counts_gradients(step) && step % kResetEvery == 0; }

bool Schedule::prunes_large(int step) const { return step > kResetEvery; }

TrainState Trainer::begin(Parameters parameters) {
  TrainState state;
  state.moments = {zero_gradient(parameters), zero_gradient(parameters)};
  state.demand.clear(parameters.size());
  state.parameters = std::move(parameters);
  return state;
}

Trainer::Trainer(const TrainOptions& options, const TrainingViews& views, TrainState state)
    : options_(options), views_(views), state_(std::move(state)) {}

// All views in a random order, then all again in another one.
const TrainingView& Trainer::view_of(int step) {
  const auto count = static_cast<int>(views_.trained.size());
  if (const int round = (step - 1) / count; round != round_) {
    round_ = round;
    order_.resize(views_.trained.size());
    std::iota(order_.begin(), order_.end(), 0u);
    generate::Random random = random_of(options_.seed, kOrder, round);
    for (std::size_t i = order_.size() - 1; i > 0; --i) std::swap(order_[i], order_[random.bits() % (i + 1)]);
  }
  return views_.trained[order_[static_cast<std::size_t>((step - 1) % count)]];
}

bool Trainer::in_layers(int step) const {
  return options_.layers > 0 && step > options_.layers_begin * options_.schedule.steps;
}

// At the first step in layers, too.
void Trainer::update_grid(int step) {
  if (in_layers(step) && ((step - 1) % kGridEvery == 0 || !in_layers(step - 1)))
    state_.grid = layer_grid(state_.parameters, options_.layers);
}

double Trainer::step() {
  const int step = state_.step + 1;
  const Schedule& schedule = options_.schedule;
  Parameters& parameters = state_.parameters;
  const TrainingView& view = view_of(step);
  update_grid(step);

  DrawOptions draw;
  if (in_layers(step) && options_.draws_layered) draw.layers = &state_.grid;
  draw.sh_degree = schedule.sh_degree(step, parameters.sh_degree);
  draw.threads = options_.threads;
  draw.near_plane = view.near_plane;
  gradient_ = zero_gradient(parameters);
  Seen seen;
  double loss = 0;
  {
    const Drawing drawing(parameters, view.camera, draw);
    loss = schedule.fine_tuning ? squared_loss(drawing.picture(), view.picture(), &d_picture_)
                                : photo_loss(drawing.picture(), view.picture(), view.camera.width, view.camera.height,
                                             kDssimWeight, &d_picture_);
    drawing.backward(d_picture_, gradient_, schedule.counts_gradients(step) ? &seen : nullptr);
  }
  if (in_layers(step) && options_.regularised) loss += cldr_loss(parameters, state_.grid, options_.cldr, &gradient_);
  adam_step(parameters, state_.moments, gradient_, schedule.rates(step, views_.extent), step, options_.threads);
  if (schedule.counts_gradients(step)) state_.demand.add(seen);
  if (schedule.grows(step)) {
    densify(parameters, state_.moments, state_.demand,
            {views_.extent, options_.most_gaussians, schedule.prunes_large(step),
             random_of(options_.seed, kGrow, step).bits()});
  }
  if (schedule.resets_opacity(step)) reset_opacity(parameters, state_.moments);
  state_.step = step;
  return loss;
}

}  // namespace pipegs
