// SPDX-License-Identifier: Apache-2.0
// pu_orient: the Gaussian's axes in view space, from its quaternion and the camera's.
//
// Paper   Eq. 1: the rotation of Sigma = R S S^T R^T and the viewing transform W, as one rotation.
// Idea    q' = camera_q (x) q (Hamilton), R' = W R = matrix of q': 16 + 9 products instead of 9 + 27.
// Numbers q' s1.18 and R' s1.18: sums of exact products, one rounding each, saturated (only for q far from unit
//         length). The matrix formula of INRIA's rasteriser; unit length is assumed, not enforced.
// RTL     rtl/pu/project/pu_orient.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

Oriented pu_orient(const Config& config, const Frame& frame, const Projected& projected);

}  // namespace pipegs
