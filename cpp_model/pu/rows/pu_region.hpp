// SPDX-License-Identifier: Apache-2.0
// pu_region: the coefficients of a Gaussian moved to the first pixel of one of its regions.
//
// Paper   Eq. 3, step 1 of Fig. 5a, in the shared form: A to F once per Gaussian, here only shifted by (8 rx, 8 ry).
// Idea    power   = A + 8 (B rx + C ry) + 64 (D rx^2 + F rx ry + E ry^2)
//         slope_x = B + 16 D rx + 8 F ry,   slope_y = C + 16 E ry + 8 F rx
// Numbers Exact in CoeffF fraction bits, then each rounded once to PowerF. Nothing saturates: in a part of 64 pixels
//         |power| <= 2^16 + 2*63*2^12 + 3*63^2*2^3 < 2^20 for any coefficients, |slope| < 2^13.
// RTL     rtl/pu/rows/pu_region.sv
#pragma once

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// `bit` is a set bit of the job's mask.
inline Region pu_region(const Config& config, const RowJob& job, int bit) {
  const int shift = config.coeff_f - config.power_f;
  const int64_t rx = bit % config.part_regions_x(), ry = bit / config.part_regions_x();
  const uint64_t before = job.mask & ((uint64_t{1} << bit) - 1);
  Region r;
  r.kind = job.kind;
  const int64_t linear = job.b * rx + job.c * ry, square = (job.d * rx + job.f * ry) * rx + job.e * ry * ry;
  r.power = shift_round(job.a + 8 * linear + 64 * square, shift);
  r.slope_x = shift_round(job.b + 16 * job.d * rx + 8 * job.f * ry, shift);
  r.slope_y = shift_round(job.c + 16 * job.e * ry + 8 * job.f * rx, shift);
  r.curve_x = shift_round(job.d, shift);
  r.curve_y = shift_round(job.e, shift);
  r.twist = shift_round(job.f, shift);
  const uint64_t address = job.address + static_cast<uint64_t>(std::popcount(before));
  r.address = address & ((uint64_t{1} << config.alpha_address_w()) - 1);
  r.ext = job.ext;
  r.index = job.index;
  r.region = static_cast<uint64_t>(bit);
  return r;
}

}  // namespace pipegs
