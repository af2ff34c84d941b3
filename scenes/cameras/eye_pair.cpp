// SPDX-License-Identifier: Apache-2.0
// eye_pair.cpp: see eye_pair.hpp.
#include "scenes/cameras/eye_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr double kPixels = 0.01, kWay = 1e-4;

// Between two attitudes, radians.
double angle(const glm::dmat3& a, const glm::dmat3& b) {
  double squares = 0;
  for (int column = 0; column < 3; ++column) {
    const glm::dvec3 apart = a[column] - b[column];
    squares += glm::dot(apart, apart);
  }
  return 2 * std::asin(std::min(1.0, std::sqrt(squares / 8)));
}

}  // namespace

EyePair eye_pair(const Camera& first, const Camera& second) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format("views {} and {}", quote(first.name), quote(second.name)), "", what);
  };
  if (first.width != second.width || first.height != second.height) {
    refuse(fmt::format("found {}x{} and {}x{} pixels, expected eyes of one size", first.width, first.height,
                       second.width, second.height));
  }
  const auto same = [&](const char* field, double a, double b) {
    if (std::abs(a - b) > kPixels)
      refuse(fmt::format("{}: found {:g} and {:g} pixels, expected eyes of one lens", field, a, b));
  };
  same("fx", first.fx, second.fx), same("fy", first.fy, second.fy);
  same("cx", first.cx, second.cx), same("cy", first.cy, second.cy);
  const double turned = angle(first.world_to_camera, second.world_to_camera);
  if (turned * std::max(first.fx, first.fy) > kPixels) {
    refuse(fmt::format("they are turned by {:.4g} degrees, expected parallel eyes", turned * 180 / std::numbers::pi));
  }
  const glm::dvec3 way = first.world_to_camera * (second.position - first.position);
  if (std::abs(way.z) > kWay * glm::length(way)) {
    refuse(fmt::format("the second one stands {:g} before the first one, of a way of {:g}, expected eyes side by side",
                       way.z, glm::length(way)));
  }
  EyePair pair{first, {way.x / 2, way.y / 2}};
  pair.middle.position = (first.position + second.position) / 2.0;
  return pair;
}

}  // namespace pipegs
