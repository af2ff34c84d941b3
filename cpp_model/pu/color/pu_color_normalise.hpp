// SPDX-License-Identifier: Apache-2.0
// pu_color_normalise: divides the world direction by its length.
//
// Idea    length2 = u * 4^h with u in [1, 4); unit = world * rsqrt(u) * 2^-h. Any length works, also an unnormalised
//         one; a zero direction gives zero.
// Stream  world_direction -> unit_direction, s1.16, rounded to nearest, saturated (only when W was no rotation).
// Error   |unit - exact| <= 2^-15 in each component, direction included (measured by the test).
// RTL     rtl/pu/color/pu_color_normalise.sv
#pragma once

#include "cpp_model/fixed.hpp"
#include "cpp_model/lib/math/rsqrt.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline UnitDirection pu_color_normalise(const Config& config, const WorldDirection& world) {
  const int half = world.length2 == 0 ? 0 : (bit_length(world.length2) - 1) / 2;  // h
  const int top = config.length_w() - 2;                                          // leading one to bit top or top + 1
  const int64_t u = static_cast<int64_t>((world.length2 << (top - 2 * half)) >> (top - kRsqrtInF));
  const int64_t r = rsqrt(u);
  const int shift = 1 + kRsqrtOutF + half - config.unit_direction_f();
  const auto component = [&](int64_t x) { return saturate(shift_round(x * r, shift), config.unit_direction_w()); };
  return {.x = component(world.x), .y = component(world.y), .z = component(world.z)};
}

}  // namespace pipegs
