// SPDX-License-Identifier: Apache-2.0
// pu_squares: the sums of squares and products of the factors: |u0|^2, |u1|^2, u0 . u1 and |u0 x u1|^2.
//
// Paper   Eq. 1: Sigma' = U U^T.
// Idea    Sums of squares: nothing cancels in a, c and the determinant, for needles and pancakes of any ratio.
//         The exponents of the gains are added here; their mantissas are multiplied by pu_covariance.
// Numbers Exact sums; a, c, d normalised and truncated to MantissaW bits, b to FactorW bits signed. Zero stays zero.
// RTL     rtl/pu/project/pu_squares.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Squares pu_squares(const Config& config, const Frame& frame, const Factors& factors);

}  // namespace pipegs
