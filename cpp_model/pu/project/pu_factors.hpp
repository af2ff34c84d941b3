// SPDX-License-Identifier: Apache-2.0
// pu_factors: brings in the scales: the rows of U = J W R diag(s) and their cross product, each with one exponent.
//
// Paper   Eq. 1: Sigma = R S S^T R^T, kept as its factor.
// Idea    u0_j = v0_j s_j, u1_j = v1_j s_j, t_k = n_k s_i s_j. The exponents are known before the products, so each
//         product is aligned to its row's largest at once. Squares of the gains for the later stages: gx^2, gy^2, gx
//         gy, (gx gy)^2.
// Numbers Each row has its own exponent (a needle along one axis keeps the other row's bits). Rounded to nearest:
//         error below 2^-(MantissaW-2) of the row's largest (u), 2^-(MantissaW-3) (t). Gains truncated.
// RTL     rtl/pu/project/pu_factors.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Factors pu_factors(const Config& config, const Frame& frame, const Jacobian& jacobian);

}  // namespace pipegs
