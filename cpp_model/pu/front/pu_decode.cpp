// SPDX-License-Identifier: Apache-2.0
// pu_decode: see pu_decode.hpp.
#include "cpp_model/pu/front/pu_decode.hpp"

#include <algorithm>
#include <array>

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/sqrt.hpp"

namespace pipegs {

uint64_t decode_scale(const Config& c, uint64_t code, uint64_t scale_exp) {
  const int most = (kScaleSteps << c.scale_e_w) - 1;
  const int place =
      std::min(kScaleSteps * (static_cast<int>(scale_exp) + kScaleHeadroom) - static_cast<int>(code), most);
  if (code == kNoScale || place < kScaleSteps) return 0;
  return static_cast<uint64_t>(place / kScaleSteps) << c.scale_m_w | scale_step(c, place % kScaleSteps);
}

void set_offsets(const Config& c, const GaussianRecord& record, GaussianCode& code) {
  const int down = c.pos_w - Config::offset_code_w();
  code.offset_x = record.offset_x >> down;
  code.offset_y = record.offset_y >> down;
  code.offset_z = record.offset_z >> down;
}

GaussianRecord pu_decode(const Config& c, const GaussianCode& code, uint64_t scale_exp, uint64_t slot) {
  GaussianRecord g;
  const int up = c.pos_w - Config::offset_code_w();
  g.offset_x = code.offset_x * (int64_t{1} << up);
  g.offset_y = code.offset_y * (int64_t{1} << up);
  g.offset_z = code.offset_z * (int64_t{1} << up);

  const std::array<int64_t, 3> turn = {code.turn_0, code.turn_1, code.turn_2};
  const int fraction = c.quat_w - 1, down = 16 + Config::turn_code_w() - 1 - fraction;  // of turn * kHalfRoot
  const int64_t rest = turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2];
  const int64_t root = sqrt_fraction(std::max<int64_t>(0, (int64_t{1} << kSqrtF) - rest));
  const int64_t largest = std::min(shift_round(root, kSqrtF - fraction), (int64_t{1} << fraction) - 1);
  std::array<int64_t, 4> q{};
  for (size_t i = 0, next = 0; i < q.size(); ++i)
    q[i] = i == code.axis ? largest : shift_round(turn[next++] * kHalfRoot, down);
  g.qw = q[0], g.qx = q[1], g.qy = q[2], g.qz = q[3];

  g.scale_0 = decode_scale(c, code.scale_0, scale_exp);
  g.scale_1 = decode_scale(c, code.scale_1, scale_exp);
  g.scale_2 = decode_scale(c, code.scale_2, scale_exp);
  g.opacity = opacity_of_code(c, static_cast<int>(code.opacity));

  const int base_up = c.base_w - 3 - (Config::base_code_w() - 1);
  const auto base = [&](int64_t value) { return (value + 64) * (int64_t{1} << base_up); };
  g.base_r = base(code.base_r);
  g.base_g = base(code.base_g);
  g.base_b = base(code.base_b);
  g.index = slot;
  return g;
}

}  // namespace pipegs
