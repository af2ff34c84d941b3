// SPDX-License-Identifier: Apache-2.0
// pu_jacobian: the rows of J R' and their cross product, still without focal/z and without the scales.
//
// Paper   Eq. 1: J W of Sigma' = J W Sigma W^T J^T; J of EWA splatting with x/z, y/z clamped to the guard band.
// Idea    v0_j = R'0j - tan_x R'2j,   v1_j = R'1j - tan_y R'2j.
//         v0 x v1 in closed form, because R' is a rotation:  n_k = R'0k tan_x + R'1k tan_y + R'2k.
//         The sums are exact; then each value gets its own exponent, so what is left of a cancellation keeps its bits.
// Numbers m FactorW bits signed, normalised, truncated: relative error below 2^-(MantissaW-1). gx = focal_x / z the
//         same.
// RTL     rtl/pu/project/pu_jacobian.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Jacobian pu_jacobian(const Config& config, const Frame& frame, const Oriented& oriented);

}  // namespace pipegs
