// SPDX-License-Identifier: Apache-2.0
// pu_decode: the geometry of a Gaussian from its code of 16 bytes (record = 48).
//
// Paper   None: the paper's Gaussians lie in memory as they are worked with.
// Idea    offset    the code, PosW - 14 bits up
//         rotation  three components a, b, c of the quaternion, unit 2^-8 / sqrt(2), so that the fourth, the largest,
//                   is sqrt(1 - (a^2 + b^2 + c^2) 2^-17), exact up to the root; -a times sqrt(1/2) for the others
//         scale     2^(scale_exp + 3 - code / 16), scale_exp the exponent of the chunk's scale_max; of the last code 0.
//                   So the most is 4 to 8 times scale_max: what reaches less because it is transparent may be larger
//         opacity   -log2(code / 255) from a table; code 0 is as transparent as the field can say
//         base      (code + 64) / 128: band 0 plus one half
//         index     the slot: Gaussians of one depth are ordered by it
// Error   quaternion kTurnCodeError in all (2^-9.5 each of three components); scale 2.2 %
// RTL     rtl/pu/front/pu_decode.sv
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kScaleSteps = 16;                              // of an octave
inline constexpr int kScaleHeadroom = 3;                            // octaves above scale_exp
inline constexpr int kNoScale = (1 << Config::scale_code_w()) - 1;  // code of scale zero
inline constexpr int kMostOpacity = (1 << Config::opacity_code_w()) - 1;
inline constexpr double kTurnCodeError = 0.0049;
inline constexpr int64_t kHalfRoot = 46341;  // sqrt(1/2), u0.16

// Mantissa of 2^(step / 16), ScaleMW bits.
inline uint64_t scale_step(const Config& config, int step) {
  return static_cast<uint64_t>(std::llround(std::ldexp(std::exp2(step / double{kScaleSteps}) - 1, config.scale_m_w)));
}

// The field -log2(opacity) of a code.
inline uint64_t opacity_of_code(const Config& config, int code) {
  const uint64_t most = (uint64_t{1} << config.opacity_w()) - 1;
  if (code == 0) return most;
  const double bits = -std::log2(code / double{kMostOpacity});
  return std::min(most, static_cast<uint64_t>(std::llround(std::ldexp(bits, config.opacity_f))));
}

// The field of a scale.
uint64_t decode_scale(const Config& config, uint64_t code, uint64_t scale_exp);

// The codes of a record's offsets, which are multiples of the codes' unit.
void set_offsets(const Config& config, const GaussianRecord& record, GaussianCode& code);

GaussianRecord pu_decode(const Config& config, const GaussianCode& code, uint64_t scale_exp, uint64_t slot);

}  // namespace pipegs
