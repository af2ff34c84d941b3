// SPDX-License-Identifier: Apache-2.0
// adam: one step of Adam on all parameters of a scene.
//
// Paper   Kingma and Ba 2015, as PyTorch computes it: value -= rate / (1 - b1^t) * m / (sqrt(v / (1 - b2^t)) + 1e-15),
//         b1 = 0.9, b2 = 0.999, t from 1. INRIA's Gaussians all take every step, those that no view sees too.
// Damping Adam moves each number by about its rate, however small its gradient. In a scene that is good already most
//         gradients are small, and such steps are noise. With rates.damping the root of the mean v of the field, times
//         it, is added to each root: what has less than the usual gradient moves by less.
// Idea    Each number has its own m and v, in arrays of the parameters' shape, so that a Gaussian that is copied or
//         removed takes them along. Nothing depends on how many threads share the arrays.
// Rule    A gradient that is no number counts as 0, and none is larger than 1e15: its square is a float.
#pragma once

#include "sim/layers/parameters.hpp"

namespace pipegs {

struct Rates {
  double mean, sh_dc, sh_rest, opacity, scale, rotation;
  double damping = 0;  // of adam_step
};

struct Moments {
  Parameters first, second;  // m and v
};

// `step` is t.
void adam_step(Parameters& parameters, Moments& moments, const Gradient& gradient, const Rates& rates, int step,
               unsigned threads);

}  // namespace pipegs
