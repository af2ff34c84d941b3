// SPDX-License-Identifier: Apache-2.0
// pu_color_sum: coefficients times basis, plus the constant band, clamped to the colour's range.
//
// Paper   SH colour of 3D Gaussian splatting; + 1/2 is already in the base.
// Idea    All coefficients of a Gaussian share one exponent e, so the 15 products of a channel are added exactly as
//         integers and the sum is shifted once:  s(ShMW+BasisW+4) sum * 2^(e - 26 - ShMW - BasisF)  ->  s8.WorkF
// Stream  color_task, SH line, sh_basis -> colored. WorkF = two guard bits below the finer of base and colour.
// Round   To nearest at the shift and at the end; below 0 clamps to 0, above u2 saturates (counted; wraps if
//         Saturation is 0).
// RTL     rtl/pu/color/pu_color_sum.sv
#pragma once

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/sh_code.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kShExponentBias = 26;

struct ColorCounts {
  uint64_t saturated = 0;  // channels at or above 4
};

// The three sums over the bands of `degree`, exact; `line` is the 64-byte line of memory, `quarter` the low bits of the
// slot, which say where in it.
struct ColorSums {
  int64_t sum[3] = {0, 0, 0};
  int exponent = 0;
};

inline ColorSums color_sums(const Config& config, const Frame& frame, uint64_t quarter, const uint32_t* line,
                            const ShBasis& basis) {
  const int degree = color_degree(config, frame);
  const int count = (degree + 1) * (degree + 1) - 1;
  const int scene_degree = static_cast<int>(frame.tables.sh_degree), place = color_place(config, scene_degree, quarter);
  const int64_t b[15] = {basis.b1, basis.b2,  basis.b3,  basis.b4,  basis.b5,  basis.b6,  basis.b7, basis.b8,
                         basis.b9, basis.b10, basis.b11, basis.b12, basis.b13, basis.b14, basis.b15};
  const ShMantissas mantissas = sh_mantissas(config, scene_degree, line, place);
  ColorSums sums{.exponent = mantissas.exponent};
  for (int i = 0; i < 3 * count; ++i) sums.sum[i % 3] += mantissas.of[static_cast<size_t>(i)] * b[i / 3];
  return sums;
}

inline Colored pu_color_sum(const Config& config, const Frame& frame, const ColorTask& task, const uint32_t* line,
                            const ShBasis& basis, ColorCounts* counts = nullptr) {
  Colored colored{.kind = task.kind,
                  .depth = task.depth,
                  .index = task.index,
                  .mask = task.mask,
                  .address = task.address,
                  .ext = task.ext};
  if (task.kind != kData) return colored;
  const int base_f = config.base_w - 3, color_f = config.color_w - 2, work_f = std::max(base_f, color_f) + 2;
  ColorSums sums;
  if (color_degree(config, frame) > 0) sums = color_sums(config, frame, task.quarter, line, basis);
  const int shift = kShExponentBias + config.sh_m_w + config.basis_f() - work_f - sums.exponent;
  const int64_t base[3] = {task.base_r, task.base_g, task.base_b};
  uint64_t color[3];
  for (int c = 0; c < 3; ++c) {
    const int64_t total = shift_round(sums.sum[c], shift) + (base[c] << (work_f - base_f));
    const int64_t value = shift_round(total, work_f - color_f);
    // Without Saturation the bits above are cut.
    const int64_t mask = (int64_t{1} << config.color_w) - 1;
    color[c] =
        static_cast<uint64_t>(config.saturation || value < 0 ? saturate_unsigned(value, config.color_w) : value & mask);
    if (counts != nullptr && value >= int64_t{1} << config.color_w) ++counts->saturated;
  }
  colored.red = color[0], colored.green = color[1], colored.blue = color[2];
  return colored;
}

}  // namespace pipegs
