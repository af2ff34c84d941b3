// SPDX-License-Identifier: Apache-2.0
// pu_covariance: the projected covariance in square pixels, dilated by 0.3, and its determinant.
//
// Paper   Eq. 1; the dilation of the reference rasteriser.
// Idea    a0 = gx^2 |u0|^2,  c0 = gy^2 |u1|^2,  a = a0 + 0.3,  c = c0 + 0.3,  b = gx gy (u0 . u1),
//         det = (gx gy)^2 |u0 x u1|^2 + 0.3 (a + c0): positive terms only, never below 0.09 (less rounding).
// Numbers a, c, det: m normalised in MantissaW bits, truncated; b: m in SlopeW bits signed, normalised to one bit.
//         With antialias also the determinant before dilation, (gx gy)^2 |u0 x u1|^2, its 16 leading bits.
//         Exponents saturate at the range of FloatEW (a splat of more than 2^128 pixels, or b below 2^-256).
// RTL     rtl/pu/project/pu_covariance.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

// The centre joins the record here.
Covariance pu_covariance(const Config& config, const Frame& frame, const Squares& squares, const Center& center);

}  // namespace pipegs
