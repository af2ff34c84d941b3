// SPDX-License-Identifier: Apache-2.0
// pu_alpha: the alpha code of a pixel from its power.
//
// Paper   Eq. 1 and Sec. 4.2.1; the cut at 1/AlphaCut (255) and the cap at 0.99 are those of the reference renderer.
// Idea    alpha = 2^power, opacity included. The integer part of the power is a shift, the fraction goes through exp2.
//           power < -PowerCut   -> 0         (a compare: no exponential decides the cut)
//           power > 0           -> power 0   (rounding may lift the peak just above 0; it must not vanish)
// Numbers power s20.PowerF -> u0.AlphaW, rounded to nearest, 1 .. round(0.99 * 2^AlphaW).
// RTL     rtl/pu/rows/pu_alpha.sv; its steps: rtl/pu/rows/pu_clamp.sv, rtl/pu/rows/pu_code.sv
#pragma once

#include <algorithm>

#include "cpp_model/lib/math/exp2.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

struct PuAlpha {
  explicit PuAlpha(const Config& config)
      : exp2(config),
        power_f(config.power_f),
        input_shift(config.power_f - config.exp_f()),
        whole_mask((uint64_t{1} << config.whole_w()) - 1),
        cut(-config.power_cut()),
        alpha_max(static_cast<uint32_t>(config.alpha_max())) {}

  // power in [cut - 1, 0]: what clamping any power to this range gives.
  uint32_t clamped(int32_t power) const {
    const int whole = -(power >> power_f);  // 0 .. 10
    const uint32_t fraction = (static_cast<uint32_t>(power) & ((uint32_t{1} << power_f) - 1)) >> input_shift;
    const uint32_t code = ((exp2(fraction) >> (6 + whole)) + 1) >> 1;
    return power < cut ? 0 : std::clamp(code, 1u, alpha_max);
  }
  // What stands between the two steps of the RTL, pu_clamp and pu_code.
  Exponent exponent(int64_t power) const {
    const int64_t held = std::min<int64_t>(power, 0);
    const uint64_t fraction = static_cast<uint64_t>(held) & ((uint64_t{1} << power_f) - 1);
    return {.fraction = fraction >> input_shift,
            .whole = static_cast<uint64_t>(-(held >> power_f)) & whole_mask,
            .visible = power >= cut};
  }
  uint32_t operator()(int64_t power) const {
    return clamped(static_cast<int32_t>(std::clamp<int64_t>(power, cut - 1, 0)));
  }

  Exp2 exp2;
  int power_f, input_shift;
  uint64_t whole_mask;
  int32_t cut;
  uint32_t alpha_max;
};

inline uint32_t pu_alpha(const PuAlpha& constants, int64_t power) { return constants(power); }

}  // namespace pipegs
