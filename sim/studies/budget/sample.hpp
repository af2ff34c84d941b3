// SPDX-License-Identifier: Apache-2.0
// budget_sample: random Gaussians through the models, and through the usual formulas in float and half,
// against double.
//
// Idea    A scene of random Gaussians, log-uniform in scale, ratio, depth and opacity, is packed as any scene is. Each
//         is taken through the models in the window that holds its mean, and looked at in a few pixels that count. The
//         truth gets what the packed record holds, so what is measured is arithmetic; what the record itself rounds is
//         measured apart. The reference is what renderers do: J W R S S^T R^T W^T J^T + 0.3, its inverse by a c - b b,
//         the power by Eq. 1, every operation rounded to T (float, or half with its range).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

// One Gaussian, worst over its pixels. Powers in log2 units; infinite where a format gave no number.
struct BudgetSample {
  double ratio = 1, sigma = 0;  // longest over shortest axis; standard deviation along the longest in the image, pixels
  double power = 0, bound = 0, power32 = 0, power16 = 0;
  double record = 0, record_bound = 0;  // what the record's rounding moves, and its bound
  double alpha = 0, alpha_bound = 0, alpha32 = 0, alpha16 = 0;
  double power_excess = 0, alpha_excess = 0;  // beyond the bound of the same pixel: 0 when all hold
};

// `count` Gaussians; those that no pixel of the image sees are drawn again.
std::vector<BudgetSample> budget_samples(const Config& config, uint64_t seed, size_t count,
                                         const std::function<void(double)>& progress = {});

}  // namespace pipegs
