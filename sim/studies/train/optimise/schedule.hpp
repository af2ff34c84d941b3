// SPDX-License-Identifier: Apache-2.0
// schedule: what happens at which step, and how large a step is.
//
// Paper   INRIA's defaults for 30000 steps. What they give as a share of the run is a share of the run here: the
//         position's rate (1.6e-4 to 1.6e-6 of the extent, exponentially), the SH degree (one more each 30th), growing
//         (from a 60th to the half). What lets Adam settle is a number of steps and stays one: growing each 100,
//         opacities reset each 3000, both while it grows.
// Idea    Fine-tuning begins with a scene that is good: the position's last rate, a tenth of the others, all of which
//         fall to a tenth, so that it comes to rest, and small gradients are
//         damped (adam.hpp). All degrees take part, and nothing grows.
#pragma once

namespace pipegs {

struct Rates {
  double mean, sh_dc, sh_rest, opacity, scale, rotation;
  double damping = 0;  // of adam_step
};

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

}  // namespace pipegs
