// SPDX-License-Identifier: Apache-2.0
// generate_random: random numbers and noise that are the same on every machine.
//
// Idea    splitmix64 (Steele et al. 2014) for numbers; std distributions differ between libraries.
//         r2(i): the low-discrepancy sequence of the plastic number, which covers an area without
//         holes and clumps. noise(x, y): smoothed lattice noise in [0,1]; fbm: octaves of it.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace pipegs::generate {

inline constexpr double kPi = 3.14159265358979323846;

inline std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15u); }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double normal() {
    const double u = 1 - uniform(), v = uniform();  // u in (0, 1]: the logarithm is finite
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * kPi * v);
  }
  // Vectors, drawn in the order x, y, z. C++ leaves the order of a call's arguments to the compiler,
  // so two draws in one argument list would give two scenes.
  glm::dvec3 normals() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }
  glm::dvec3 level_normals() {
    const double x = normal(), z = normal();
    return {x, 0, z};
  }

 private:
  std::uint64_t state_;
};

inline glm::dvec2 r2(std::uint64_t i) {
  const double n = static_cast<double>(i) + 0.5, a = n * 0.7548776662466927, b = n * 0.5698402909980532;
  return {a - std::floor(a), b - std::floor(b)};
}

inline double lattice(std::int64_t x, std::int64_t y) {
  const auto key =
      static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu;
  return static_cast<double>(mixed(key + 0x165667b19e3779f9u) >> 11) * 0x1p-53;
}

inline double noise(double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const double u = (x - fx) * (x - fx) * (3 - 2 * (x - fx)), v = (y - fy) * (y - fy) * (3 - 2 * (y - fy));
  const double top = lattice(ix, iy) * (1 - u) + lattice(ix + 1, iy) * u;
  const double bottom = lattice(ix, iy + 1) * (1 - u) + lattice(ix + 1, iy + 1) * u;
  return top * (1 - v) + bottom * v;
}

inline double fbm(double x, double y, int octaves) {
  double sum = 0, amplitude = 0.5;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.5) {
    sum += amplitude * noise(x, y);
    const double turned = 1.6 * x - 1.2 * y + 17.3;  // turn by 37 degrees and double: hides the lattice
    y = 1.2 * x + 1.6 * y + 5.1;
    x = turned;
  }
  return sum / (1 - amplitude * 2);
}

}  // namespace pipegs::generate
