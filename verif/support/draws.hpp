// SPDX-License-Identifier: Apache-2.0
// draws.hpp: random numbers that are the same with every compiler and library.
//
// Why     The standard fixes what std::mt19937_64 gives, and not what the library's distributions make of it: with them
//         a figure that a test prints would be that of one library.
// Rule    Two draws in one expression stand in braces, which order them, or are two statements.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace pipegs {

// In [0, 1), 53 bits.
template <class Rng>
double draw_unit(Rng& rng) {
  static_assert(Rng::max() == ~uint64_t{0}, "an engine of 64 bits");
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

// In [low, high).
template <class Rng>
double draw_uniform(Rng& rng, double low, double high) {
  return low + (high - low) * draw_unit(rng);
}

// Of low .. high, which are fewer than 2^63.
template <class Rng>
int64_t draw_integer(Rng& rng, int64_t low, int64_t high) {
  return low + static_cast<int64_t>(rng() % (static_cast<uint64_t>(high - low) + 1));
}

// Of mean 0 and deviation 1 (Box and Muller).
template <class Rng>
double draw_normal(Rng& rng) {
  const double radius = std::sqrt(-2 * std::log(1 - draw_unit(rng)));
  return radius * std::cos(6.283185307179586 * draw_unit(rng));
}
template <class Rng>
glm::dvec3 draw_normals(Rng& rng) {
  return {draw_normal(rng), draw_normal(rng), draw_normal(rng)};
}

}  // namespace pipegs
