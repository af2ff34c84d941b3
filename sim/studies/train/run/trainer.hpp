// SPDX-License-Identifier: Apache-2.0
// trainer: INRIA's training of a scene of 3D Gaussians, step by step, on a CPU.
//
// Paper   Eq. 6: the loss of the photographs, and of layers if there are any (Eq. 5, in cldr.hpp).
// Idea    A step takes one view: draw, loss, gradient, Adam; from time to time Gaussians are added and removed. All
//         that one step hands to the next is a TrainState. Which view a step takes and what is drawn by chance follow
//         from the seed and the step's number, so that a run that goes on from a state is the run that never stopped.
// Order   With layers a picture is drawn in the machine's order of layers, so that what is trained is what it draws.
// Steps   INRIA's defaults for 30000 steps. What they give as a share of the run is a share of the run here: the
//         position's rate (1.6e-4 to 1.6e-6 of the extent, exponentially), the SH degree (one more each 30th), growing
//         (from a 60th to the half). What lets Adam settle is a number of steps and stays one: growing each 100,
//         opacities reset each 3000, both while it grows.
//         Fine-tuning begins with a scene that is good: the position's last rate, a tenth of the others, all of which
//         fall to a tenth, so that it comes to rest, and small gradients are damped (adam.hpp). All degrees take part,
//         and nothing grows.
// Rule    No bit depends on the number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/layers/cldr.hpp"
#include "sim/studies/train/gradient/drawing.hpp"
#include "sim/studies/train/optimise/adam.hpp"
#include "sim/studies/train/optimise/densify.hpp"
#include "sim/studies/train/photos/view.hpp"

namespace pipegs {

struct Schedule {
  int steps = 30000;
  bool fine_tuning = false;

  // Steps are counted from 1, as INRIA does. `extent` is that of the scene.
  Rates rates(int step, double extent) const;
  int sh_degree(int step, int highest) const;
  bool counts_gradients(int step) const;  // for growing
  bool grows(int step) const;
  bool resets_opacity(int step) const;
  bool prunes_large(int step) const;  // Gaussians larger than a tenth of the extent
};

struct TrainOptions {
  Schedule schedule;
  std::uint64_t seed = 1;
  std::size_t most_gaussians = 200000;
  int layers = 0;             // cells per axis; 0: exact order, no layers
  double layers_begin = 0;    // share of the run before the first step that knows of layers
  bool draws_layered = true;  // with layers: the picture is drawn in their order
  bool regularised = true;    // with layers: cldr_loss is part of the loss
  CldrOptions cldr{.weight = 1};
  unsigned threads = 0;
};

struct TrainState {
  int step = 0;  // how many are done
  Parameters parameters;
  Moments moments;
  Demand demand;
  LayerGrid grid;
  double seconds = 0;  // of all runs that led here; no step depends on it
};

class Trainer {
 public:
  // `views` must live as long. The state is a new one, or one that a Trainer of the same options and views had.
  Trainer(const TrainOptions& options, const TrainingViews& views, TrainState state);
  static TrainState begin(Parameters parameters);

  const TrainState& state() const { return state_; }
  bool done() const { return state_.step >= options_.schedule.steps; }
  void add_seconds(double seconds) { state_.seconds += seconds; }
  // The loss of the view that was taken, before the step.
  double step();

 private:
  const TrainingView& view_of(int step);
  bool in_layers(int step) const;
  void update_grid(int step);

  TrainOptions options_;
  const TrainingViews& views_;
  TrainState state_;
  Gradient gradient_;
  std::vector<glm::vec3> d_picture_;
  std::vector<std::uint32_t> order_;  // of the views, in the round `round_`
  int round_ = -1;
};

}  // namespace pipegs
