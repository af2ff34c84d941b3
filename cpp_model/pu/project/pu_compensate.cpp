// SPDX-License-Identifier: Apache-2.0
// pu_compensate.cpp: see pu_compensate.hpp.
#include "cpp_model/pu/project/pu_compensate.hpp"

#include <algorithm>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/log2.hpp"

namespace pipegs {

Covariance pu_compensate(const Config& config, const Frame& frame, const Covariance& in) {
  if (in.kind != kData || frame.tables.antialias == 0) return in;
  int64_t fall = kMostCompensated;
  if (in.sharp_m != 0) {
    const uint64_t det = in.det_m >> (config.mantissa_w - config.sharp_w());
    const int64_t apart =
        (in.det_e - in.sharp_e) * (int64_t{1} << kCompensateF) + log2_mantissa(det) - log2_mantissa(in.sharp_m);
    fall = std::clamp<int64_t>(apart, 0, kMostCompensated);
  }
  Covariance out = in;
  out.opacity = saturate_unsigned(
      in.opacity + static_cast<uint64_t>(shift_round(fall, kCompensateF + 1 - config.opacity_f)), config.opacity_w());
  return out;
}

}  // namespace pipegs
