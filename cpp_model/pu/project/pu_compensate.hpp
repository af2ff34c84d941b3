// SPDX-License-Identifier: Apache-2.0
// pu_compensate: lowers a Gaussian's opacity by what the dilation adds to its area (scenes trained with antialiasing).
//
// Paper   beyond it: the compensation of the mip variant of 3DGS, flagged in a scene's header.
// Idea    opacity' = opacity sqrt(max(2.5e-5, det without dilation / det)). The machine holds -log2(opacity), so this
//         is an addition:  opacity + (log2(det) - log2(sharp)) / 2, at most 7.644 more. Nothing is divided, no root is
//         taken. A flat Gaussian seen from its edge has sharp = 0 and gets the most.
// Numbers log2 of 16 leading bits, u0.16; the difference s11.16, below 0 (by rounding) is 0; the half is rounded to
//         OpacityF; the sum saturates at the top of u4.OpacityF, where nothing is drawn.
// Error   of -log2(opacity): 5.3e-5 from cut mantissas and logarithms, and half a unit.
// RTL     rtl/pu/project/pu_compensate.sv, only built when antialias = 1
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kCompensateF = 16;               // fraction of the difference of the logarithms
inline constexpr int64_t kMostCompensated = 1001896;  // -log2(2.5e-5) * 2^16, rounded

Covariance pu_compensate(const Config& config, const Frame& frame, const Covariance& covariance);

}  // namespace pipegs
