// SPDX-License-Identifier: Apache-2.0
// pu_conic: the inverse of the covariance, as what the coefficients need: two curvatures, a slope, and a box.
//
// Paper   Eq. 1 (the exponent), k = log2(e)/2 folded in: alpha = 2^power.
// Idea    Eliminate the narrower axis (x if c >= a, else exchange x and y):
//           power = -k [ (c/det) (dx - m dy)^2 + (1/c) dy^2 ] - log2(opacity),   m = b/c, |m| <= 1
//         Both squares are positive, so nothing cancels: a needle keeps its bits at any distance from its mean.
//         narrow = k c/det (at most k/0.3 by the dilation), wide = k/c.
//         Box: |dx| <= sqrt(a (log2(AlphaCut) - opacity) / k), |dy| the same with c.
// Numbers narrow, wide: MantissaW bits, relative error below 2^-(MantissaW-3). slope s1.(SlopeW-2), rounded, saturated
//         to 1. extent u18.4: never too small (see kMargin in the .cpp), at most 1 % and 1/4 pixel too large.
// RTL     rtl/pu/conic/pu_conic.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Conic pu_conic(const Config& config, const Frame& frame, const Covariance& covariance);

}  // namespace pipegs
