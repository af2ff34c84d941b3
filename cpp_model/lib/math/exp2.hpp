// SPDX-License-Identifier: Apache-2.0
// exp2: 2^f for a fraction f, by a table of 2^ExpIndexW chords, or without chords (ExpLinear = 0).
//
// Paper   "applying exponential function to the power" (Sec. 4.2.1).   RTL  rtl/lib/math/pipegs_exp2.sv
// Idea    f = (i + r / 2^R) / 2^ExpIndexW:   2^f ~ value[i] + delta[i] * r / 2^R.   The table is the flat localparam
//         Exp2Table of pipegs_pkg, printed from this file, so RTL and bit-accurate model cannot differ.
//         Without chords delta is 0 and value is that of the middle of its interval, so the error is centred.
// Numbers f u0.ExpF, value u1.(AlphaW+6), delta in the same unit, result u1.(AlphaW+7), truncated.
// Error   In units of the last place of an alpha near 1 (result in [1,2) is alpha in [1/2,1)), default widths:
//         chord +0.0038, table +-0.0039, truncation -0.0039; measured in exp2_test: -0.0075 .. +0.0065.
//         Without chords half an entry, 2^AlphaW * 0.35 / 2^ExpIndexW at the top: ExpIndexW = AlphaW gives 0.35.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cpp_model/config.hpp"

namespace pipegs {

struct Exp2 {
  explicit Exp2(const Config& config)
      : index_shift(config.exp_f() - config.exp_index_w), rest_mask((uint32_t{1} << index_shift) - 1) {
    const int entries = 1 << config.exp_index_w;
    const auto entry = [&](double at) {
      return static_cast<uint32_t>(std::lround(std::ldexp(std::exp2(at / entries), config.alpha_w + 6)));
    };
    for (int i = 0; i < entries; ++i) {
      value[i] = entry(config.exp_linear ? i : i + 0.5);
      delta[i] = config.exp_linear ? entry(i + 1) - entry(i) : 0;
    }
  }

  // fraction: u0.ExpF -> 2^fraction, u1.(AlphaW+7).
  uint32_t operator()(uint32_t fraction) const {
    const uint32_t i = fraction >> index_shift, rest = fraction & rest_mask;
    return (value[i] << 1) + ((delta[i] * rest) >> (index_shift - 1));  // 16 x 16 bits at most
  }

  int index_shift;  // R
  uint32_t rest_mask;
  std::array<uint32_t, 1024> value{}, delta{};
};

}  // namespace pipegs
