// SPDX-License-Identifier: Apache-2.0
// pu_color_basis: the fifteen SH basis functions of bands 1 to 3 for a unit direction.
//
// Paper   Eq. for colours; constants, order and signs of the reference implementation.
// Idea    Bands 2 and 3 are built from each other: 25 products instead of the 45 of the plain polynomials.
//           (x + iy)^2 -> b4, b8;  times N (x + iy) -> b9, b15;  times sqrt(7) z -> b10, b14
//           zz of a unit vector replaces xx + yy = 1 - zz in b6, b11, b12, b13.
// Stream  unit_direction (s1.16) -> sh_basis (s0.16). Each product is rounded once, to 2^-16.
// Error   2^-14 and better for a unit input, 2^-12.9 behind pu_color_normalise (measured by the test); b12 is the
//         worst.
// RTL     rtl/pu/color/pu_color_basis.sv
#pragma once

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

// Constants in s1.16, rounded to nearest.
inline constexpr int64_t kShBand1 = 32021;   // C1 = 0.4886025119
inline constexpr int64_t kShPair = 71601;    // 2 C2e = 1.0925484306
inline constexpr int64_t kShHeight = 86696;  // sqrt(7) / 2 = 1.3228756555
inline constexpr int64_t kShCube = -70787;   // C3a / C2e = -1.0801234497
inline constexpr int64_t kShSixA = 62009;    // 3 C2c = 0.9461746958
inline constexpr int64_t kShSixB = -20670;   // -C2c = -0.3153915653
inline constexpr int64_t kShRimA = -74882;   // 5 C3c / 2 = -1.1426144987
inline constexpr int64_t kShRimB = 14976;    // -C3c / 2 = 0.2285228997
inline constexpr int64_t kShPoleA = 122282;  // 5 C3d = 1.8658816630
inline constexpr int64_t kShPoleB = -73369;  // -3 C3d = -1.1195289978

inline ShBasis pu_color_basis(const UnitDirection& d) {
  constexpr int kF = 16;
  const auto mul = [](int64_t a, int64_t b) { return shift_round(a * b, kF); };
  const auto mul2 = [](int64_t a, int64_t b) { return shift_round(a * b, kF - 1); };      // 2 a b
  const auto mul_half = [](int64_t a, int64_t b) { return shift_round(a * b, kF + 1); };  // a b / 2
  const int64_t px = mul(kShPair, d.x), py = mul(kShPair, d.y);
  const int64_t zz = mul(d.z, d.z);
  const int64_t height = mul(kShHeight, d.z);
  const int64_t cube_x = mul(kShCube, d.x), cube_y = mul(kShCube, d.y);
  const int64_t rim = mul(kShRimA, zz) + kShRimB;
  const int64_t pole = mul(kShPoleA, zz) + kShPoleB;
  ShBasis b;
  b.b1 = mul(-kShBand1, d.y);
  b.b2 = mul(kShBand1, d.z);
  b.b3 = mul(-kShBand1, d.x);
  b.b4 = mul(px, d.y);
  b.b5 = -mul(py, d.z);
  b.b6 = mul(kShSixA, zz) + kShSixB;
  b.b7 = -mul(px, d.z);
  b.b8 = mul_half(px - py, d.x + d.y);
  b.b9 = shift_round(cube_y * b.b8 + cube_x * b.b4, kF);
  b.b10 = mul2(height, b.b4);
  b.b11 = mul2(rim, d.y);
  b.b12 = mul(pole, d.z);
  b.b13 = mul2(rim, d.x);
  b.b14 = mul2(height, b.b8);
  b.b15 = shift_round(cube_x * b.b8 - cube_y * b.b4, kF);
  return b;
}

}  // namespace pipegs
