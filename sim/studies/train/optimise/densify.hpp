// SPDX-License-Identifier: Apache-2.0
// densify: Gaussians where the picture asks for more, fewer where nothing is left to see.
//
// Paper   INRIA, Sec. 5.2: where the mean |d loss / d mean2d| of the views that saw a Gaussian is at least 2e-4, a
//         small one (largest scale at most 0.01 of the extent) is cloned, a larger one split in two drawn from it, with
//         scales / 1.6. Opacity below 0.005, or a scale above a tenth of the extent once opacities were reset, is the
//         end of one. INRIA's rule of the radius in pixels never fires in its code, and is left out.
// Idea    Where there is no room for all, the largest gradients get it, ties to the lowest index: the result depends on
//         nothing but its inputs and the seed.
// Layout  Those that stay in their order, then clones, then the halves of those that were split.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/studies/train/gradient/drawing.hpp"
#include "sim/layers/parameters.hpp"
#include "sim/studies/train/optimise/adam.hpp"

namespace pipegs {

// Gradients since the last growing.
struct Demand {
  std::vector<float> sum;           // of |d loss / d mean2d|
  std::vector<std::uint32_t> seen;  // in how many views

  void clear(std::size_t gaussians);
  void add(const Seen& view);
};

struct DensifyOptions {
  double extent = 1;
  std::size_t most = 0;  // Gaussians afterwards
  bool prune_large = false;
  std::uint64_t seed = 0;
};

// `demand` is cleared to the new number of Gaussians. New ones have moments of 0.
void densify(Parameters& parameters, Moments& moments, Demand& demand, const DensifyOptions& options);

// No opacity above 0.01 any more, their moments 0.
void reset_opacity(Parameters& parameters, Moments& moments);

}  // namespace pipegs
