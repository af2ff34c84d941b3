// SPDX-License-Identifier: Apache-2.0
// pu_extent: the half extents of the box of pixels that a Gaussian can reach.
//
// Paper   the bounding box before the tile test (Sec. 4.2).
// Idea    On the box's side the power is -budget:  extent^2 = 2 ln(2) variance (log2(AlphaCut) - opacity).
// Numbers u18.4, never too small, at most 1 % and 1/4 pixel too large for opacities above 0.006; saturates at 2^18
//         pixels.
// RTL     rtl/pu/conic/pu_extent.sv
#pragma once

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/conic/pu_root.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// 2 ln(2) (1 + 1/64) * 2^8, rounded up. The 1/64 covers what the box's variance may differ from the variance that the
// rounded narrow and wide imply. The rounded slope shifts the far end of a needle by less than its length *
// 2^-(MantissaW - 1), for which each extent grows by the other's 2^-(MantissaW - 4).
inline constexpr int64_t kBoxMargin = 361;

// floor((root + 1) * 2^x) of sqrt(variance * t * 2^-OpacityF) in 1/16 pixel, at most 1 too small.
inline uint64_t pu_extent_root(const Config& config, uint64_t m, int64_t e, uint64_t t) {
  // t < 2^OpacityW; shifted to the left end: the product has MantissaW + OpacityW bits or one less.
  const int lead = config.opacity_w() - bit_length(t);
  const int cut = config.mantissa_w + config.opacity_w() - kRadicandW;
  const uint64_t product = m * (t << lead);
  const int64_t exponent = e - config.opacity_f - lead + 8 + cut;
  const int odd = static_cast<int>(exponent & 1);
  const uint64_t up = pu_root(product >> (cut + odd)) + 1;
  const int64_t half = (exponent + odd) >> 1;
  const uint64_t top = (uint64_t{1} << config.extent_w()) - 1;
  return half >= config.extent_w() ? top
         : half >= 0               ? std::min(top, up << half)
                                   : shift_floor(up, static_cast<int>(-half));
}

struct PuExtent {
  uint64_t x, y;
};

inline PuExtent pu_extent(const Config& config, const Covariance& in) {
  const int64_t budget = config.cut_budget() - static_cast<int64_t>(in.opacity);
  const uint64_t t = static_cast<uint64_t>((std::max<int64_t>(budget, 0) * kBoxMargin) >> 8) + 1;  // u4.OpacityF
  const uint64_t x = pu_extent_root(config, in.a_m, in.a_e, t), y = pu_extent_root(config, in.c_m, in.c_e, t);
  const uint64_t top = (uint64_t{1} << config.extent_w()) - 1;
  const int far = config.mantissa_w - 4;
  return {std::min(top, x + (y >> far) + 2), std::min(top, y + (x >> far) + 2)};
}

}  // namespace pipegs
