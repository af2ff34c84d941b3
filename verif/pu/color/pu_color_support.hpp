// SPDX-License-Identifier: Apache-2.0
// pu_color_support.hpp: random cameras, directions and SH lines that are legal, and their values in double precision.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/sh_code.hpp"
#include "cpp_model/records.hpp"
#include "scenes/sh_basis.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {

// A frame whose W is a random rotation.
template <class Rng>
void set_rotation(const Config& config, Frame& frame, Rng& rng) {
  const glm::dmat3 r = glm::mat3_cast(
      glm::normalize(glm::dquat{draw_normal(rng), draw_normal(rng), draw_normal(rng), draw_normal(rng)}));
  const auto fixed = [&](double x) { return std::llround(std::ldexp(x, config.rot_f())); };
  frame.camera.rotation.w00 = fixed(r[0][0]), frame.camera.rotation.w01 = fixed(r[0][1]),
  frame.camera.rotation.w02 = fixed(r[0][2]);
  frame.camera.rotation.w10 = fixed(r[1][0]), frame.camera.rotation.w11 = fixed(r[1][1]),
  frame.camera.rotation.w12 = fixed(r[1][2]);
  frame.camera.rotation.w20 = fixed(r[2][0]), frame.camera.rotation.w21 = fixed(r[2][1]),
  frame.camera.rotation.w22 = fixed(r[2][2]);
}

inline glm::dvec3 to_world(const Config& config, const Frame& frame, const glm::dvec3& v) {
  return glm::dvec3(
             frame.camera.rotation.w00 * v.x + frame.camera.rotation.w10 * v.y + frame.camera.rotation.w20 * v.z,
             frame.camera.rotation.w01 * v.x + frame.camera.rotation.w11 * v.y + frame.camera.rotation.w21 * v.z,
             frame.camera.rotation.w02 * v.x + frame.camera.rotation.w12 * v.y + frame.camera.rotation.w22 * v.z) *
         std::ldexp(1.0, -config.rot_f());
}

// Mostly block-normalised; now and then along an axis, short, or zero.
template <class Rng>
ViewDirection random_direction(const Config& config, Rng& rng) {
  const int64_t top = int64_t{1} << (config.direction_w() - 1);
  const auto whole = [&] { return static_cast<int64_t>(rng() % (2 * top)) - top; };
  ViewDirection d{.x = whole(), .y = whole(), .z = whole()};
  switch (rng() % 16) {
    case 0: return {};
    case 1: d.x = d.y = 0; return d;
    case 2: d.y = d.z = 0, d.x = -top; return d;
    case 3: d.x >>= 9, d.y >>= 9, d.z >>= 9; return d;
    case 4: d.x = -top, d.y = -top, d.z = top - 1; return d;
    default: break;
  }
  const auto large = [&](int64_t x) { return x >= top / 2 || x < -top / 2; };
  if (!large(d.x) && !large(d.y) && !large(d.z)) d.z = top / 2 + (d.z & (top / 2 - 1));
  return d;
}

inline std::array<int64_t, 15> functions(const ShBasis& b) {
  return {b.b1, b.b2, b.b3, b.b4, b.b5, b.b6, b.b7, b.b8, b.b9, b.b10, b.b11, b.b12, b.b13, b.b14, b.b15};
}

// Noise in every bit; the exponents from `low` to `high` wherever a Gaussian may begin.
template <class Rng>
std::array<uint32_t, 16> random_line(const Config& config, Rng& rng, int low = 0, int high = 31) {
  std::array<uint32_t, 16> line;
  for (uint32_t& word : line) word = static_cast<uint32_t>(rng());
  for (int at = 0; at < config.memory_w(); at += config.coded() ? 64 : 128)
    put_bits(line.data(), at, config.sh_e_w,
             static_cast<uint64_t>(low) + rng() % static_cast<uint64_t>(high - low + 1));
  return line;
}

// Coefficient k = 0.. of channel c in double.
inline double coefficient(const Config& config, const Frame& frame, const uint32_t* line, uint64_t slot, int k, int c) {
  const int degree = static_cast<int>(frame.tables.sh_degree);
  const ShMantissas found = sh_mantissas(config, degree, line, color_place(config, degree, slot));
  const auto m = static_cast<double>(found.of[static_cast<size_t>(3 * k + c)]);
  return std::ldexp(m, found.exponent - 26 - config.sh_m_w);
}

}  // namespace pipegs
