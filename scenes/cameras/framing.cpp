// SPDX-License-Identifier: Apache-2.0
// framing: see framing.hpp.
//
// Idea    At most 200000 Gaussians, evenly out of the file, stand for all. What hides a cone of directions from a point
//         is the sum of opacity times area over distance squared of the Gaussians in it, per solid angle: an optical
//         depth, in which one Gaussian is never more than a tenth.
#include "scenes/cameras/framing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kSample = 200000;
constexpr double kFaint = 1.0 / 255, kUnbounded = 6, kRoof = 2.5, kFlat = 0.25, kMargin = 0.95;
constexpr double kDown = 20 * std::numbers::pi / 180;
constexpr int kRing = 16;

struct Point {
  glm::dvec3 mean;
  double weight, area;
};

// The value below which `share` of the weight lies.
double weighted(std::vector<std::pair<double, double>>& values, double share) {
  std::sort(values.begin(), values.end());
  double all = 0, below = 0;
  for (const auto& [value, weight] : values) all += weight;
  for (const auto& [value, weight] : values) {
    below += weight;
    if (below >= share * all) return value;
  }
  return values.back().first;
}

std::vector<Point> sample_of(const Scene& scene) {
  std::vector<Point> points;
  std::vector<double> sizes;
  const std::size_t step = scene.gaussians.size() / kSample + 1;
  for (std::size_t i = 0; i < scene.gaussians.size(); i += step) {
    ActivatedGaussian g;
    if (activate(scene, i, g) != Cull::kNone || g.opacity < kFaint) continue;
    double s[] = {g.scale.x, g.scale.y, g.scale.z};
    std::sort(s, s + 3);
    points.push_back({g.mean, g.opacity, std::numbers::pi * g.opacity * s[1] * s[2] * static_cast<double>(step)});
    sizes.push_back(s[2]);
  }
  if (points.empty()) throw InputError(scene.name, "", "found no Gaussian that is visible, expected one to look at");
  std::vector<double> sorted = sizes;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double least = std::max(1e-3 * sorted[sorted.size() / 2], 1e-30);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].weight /= std::max(sizes[i], least);
  return points;
}

class View {
 public:
  View(const Scene& scene, const Framing& framing)
      : points_(sample_of(scene)),
        half_x_(std::tan(glm::radians(framing.fov) / 2)),
        half_y_(half_x_ * framing.height / framing.width) {
    for (int a = 0; a < 3; ++a) {
      std::vector<std::pair<double, double>> values;
      for (const Point& point : points_) values.emplace_back(point.mean[a], point.weight);
      lowest_[a] = weighted(values, 0.02);
      centre_[a] = weighted(values, 0.5);
      highest_[a] = weighted(values, 0.98);
    }
    up_ = framing.up ? glm::normalize(*framing.up) : found_up();
    const glm::dvec3 along = std::abs(up_.z) > 0.7 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    ahead_ = glm::normalize(along - up_ * glm::dot(along, up_));
    right_ = glm::cross(ahead_, up_);
  }

  const glm::dvec3& up() const { return up_; }

  // Where the camera stands and looks.
  std::pair<glm::dvec3, glm::dvec3> found() const {
    std::vector<std::pair<double, double>> distances;
    for (const Point& point : points_) distances.emplace_back(glm::length(point.mean - centre_), point.weight);
    const double half = weighted(distances, 0.5), most = weighted(distances, 0.98);
    if (is_room(half, most)) return inside(half);
    const glm::dvec3 look = std::cos(kDown) * ahead_ - std::sin(kDown) * up_;
    if (most > kUnbounded * half) {
      const double narrow = std::min(half_x_, half_y_);
      return {centre_ - look * (half * std::sqrt(1 + 1 / (narrow * narrow))), centre_};
    }
    const glm::dvec3 middle = (lowest_ + highest_) * 0.5;
    return {middle - look * filling_distance(look), middle};
  }

 private:
  glm::dvec3 found_up() const {
    const glm::dvec3 side = highest_ - lowest_;
    for (const int a : {0, 2}) {
      glm::dvec3 axis(0);
      axis[a] = 1;
      if (side[a] <= kFlat * std::min(side[(a + 1) % 3], side[(a + 2) % 3])) return axis;
    }
    return {0, -1, 0};
  }

  // From which the corners of the box lie within the picture, and one at its margin.
  double filling_distance(const glm::dvec3& look) const {
    const glm::dvec3 x = right_, y = glm::cross(look, x), side = highest_ - lowest_;
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p = side * (glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) - 0.5);
      const double across = std::abs(glm::dot(p, x)) / (kMargin * half_x_),
                   along = std::abs(glm::dot(p, y)) / (kMargin * half_y_);
      distance = std::max(distance, std::max(across, along) - glm::dot(p, look));
    }
    return distance > 0 ? distance : 1;  // one point
  }

  // Of the cone about `axis` from `eye`, of the points that are near enough.
  double hidden(const glm::dvec3& eye, const glm::dvec3& axis, double cosine, double farthest) const {
    double sum = 0;
    for (const Point& point : points_) {
      const glm::dvec3 d = point.mean - eye;
      const double distance = glm::length(d);
      if (distance < farthest && distance > 0 && glm::dot(d, axis) > cosine * distance)
        sum += std::min(point.area / (distance * distance), 0.1);
    }
    return sum / (2 * std::numbers::pi * (1 - cosine));
  }

  glm::dvec3 on_ring(int i) const {
    const double turn = 2 * std::numbers::pi * i / kRing;
    return std::cos(turn) * ahead_ + std::sin(turn) * right_;
  }

  bool is_room(double half, double most) const {
    const glm::dvec3 side = highest_ - lowest_;
    const auto extent = [&](const glm::dvec3& axis) { return glm::dot(glm::abs(axis), side); };
    if (extent(up_) > 0.7 * std::min(extent(ahead_), extent(right_))) return false;
    int roofed = 0;
    for (int i = 0; i < kRing; ++i) {
      const double roof = hidden(centre_ + half * on_ring(i), up_, std::sqrt(0.5), most);
      roofed += roof > kRoof;
    }
    return roofed > kRing / 2;
  }

  std::pair<glm::dvec3, glm::dvec3> inside(double half) const {
    int best = 0;
    double least = 0;
    for (int i = 0; i < kRing; ++i) {
      const double veil = hidden(centre_ - half * on_ring(i), on_ring(i), 0.8, half);
      if (i == 0 || veil < least) best = i, least = veil;
    }
    return {centre_ - half * on_ring(best), centre_};
  }

  std::vector<Point> points_;
  double half_x_, half_y_;
  glm::dvec3 lowest_, centre_, highest_, up_, ahead_, right_;
};

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {  // Rodrigues
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
}

}  // namespace

std::vector<Camera> framed_cameras(const Scene& scene, const Framing& framing) {
  const View view(scene, framing);
  auto [from, target] = view.found();
  // What is given replaces what was found; from the one given the other keeps its distance and direction.
  const glm::dvec3 offset = from - target;
  if (framing.look_at) target = *framing.look_at, from = target + offset;
  if (framing.from) from = *framing.from;
  const glm::dvec3 ahead = target - from, right = glm::cross(ahead, view.up());
  if (!(glm::length(right) > 1e-9 * glm::length(ahead)) || !std::isfinite(glm::length(right)))
    throw InputError("--from, --look-at", "", "the camera would look along the axis that points up, or nowhere");
  std::vector<Camera> cameras;
  for (int i = 0; i < framing.views; ++i) {
    const double angle = 2 * std::numbers::pi * i / framing.views;
    const glm::dvec3 z = glm::normalize(turned(ahead, view.up(), angle)),
                     x = glm::normalize(turned(right, view.up(), angle));
    Camera camera;
    camera.name = framing.views == 1 ? "framed" : fmt::format("orbit_{}", i);
    camera.id = i;
    camera.width = framing.width;
    camera.height = framing.height;
    camera.position = target - turned(ahead, view.up(), angle);
    camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
    camera.fx = camera.fy = camera.width / (2 * std::tan(glm::radians(framing.fov) / 2));
    camera.cx = (camera.width - 1) / 2.0;
    camera.cy = (camera.height - 1) / 2.0;
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace pipegs
