// SPDX-License-Identifier: Apache-2.0
// path.cpp: see path.hpp.
#include "sim/studies/rivals/pixels/path.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace pipegs {
namespace {

constexpr double kArc = 30;  // degrees around a lone view
constexpr double kDegrees = 180 / std::numbers::pi;

// The rotation that leads from one to the other.
double angle_between(const Camera& a, const Camera& b) {
  const glm::dmat3 turn = b.world_to_camera * glm::transpose(a.world_to_camera);
  return std::acos(std::clamp((turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2, -1.0, 1.0)) * kDegrees;
}

}  // namespace

double median_depth(const Scene& scene, const Camera& camera, double near_plane) {
  std::vector<double> depths;
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    const glm::dvec3 p = camera.world_to_camera * (gaussian.mean - camera.position);
    const double x = camera.fx * p.x / p.z + camera.cx, y = camera.fy * p.y / p.z + camera.cy;
    if (p.z > near_plane && x >= 0 && x <= camera.width - 1 && y >= 0 && y <= camera.height - 1) depths.push_back(p.z);
  }
  if (depths.empty()) return 1;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return *middle;
}

CameraPath::CameraPath(const Scene& scene, const Camera& view, const std::vector<Camera>& cameras, double near_plane)
    : view_(view) {
  for (size_t i = 0; i + 1 < cameras.size(); ++i)
    add(cameras[i], cameras[i + 1], median_depth(scene, cameras[i], near_plane));
  if (!legs_.empty()) return;
  arc_ = true;
  pivot_ = median_depth(scene, view, near_plane);
  length_ = rotation_ = parallax_ = kArc;
  distance_ = kArc / kDegrees * pivot_;
  legs_.push_back({view, view, 0, kArc});
}

void CameraPath::add(const Camera& from, const Camera& to, double depth) {
  const double turn = angle_between(from, to), move = glm::length(to.position - from.position);
  const double parallax = move / depth * kDegrees, length = std::max(turn, parallax);
  if (length < 1e-9) return;
  legs_.push_back({from, to, length_, length});
  length_ += length, rotation_ += turn, distance_ += move, parallax_ += parallax;
}

Camera CameraPath::at(double degrees) const {
  Camera camera = view_;
  if (arc_) {
    const double angle = (degrees - kArc / 2) / kDegrees;
    const glm::dmat3 to_world = glm::transpose(view_.world_to_camera);
    const glm::dmat3 turn = glm::mat3_cast(glm::angleAxis(angle, glm::dvec3(0, 1, 0)));
    const glm::dvec3 pivot = view_.position + to_world * glm::dvec3(0, 0, pivot_);
    camera.position = pivot - to_world * (turn * glm::dvec3(0, 0, pivot_));
    camera.world_to_camera = glm::transpose(to_world * turn);
    return camera;
  }
  size_t leg = 0;
  while (leg + 1 < legs_.size() && degrees >= legs_[leg + 1].begin) ++leg;
  const Leg& on = legs_[leg];
  const double t = (degrees - on.begin) / on.length;
  camera.position = glm::mix(on.from.position, on.to.position, t);
  camera.world_to_camera = glm::mat3_cast(
      glm::normalize(glm::slerp(glm::quat_cast(on.from.world_to_camera), glm::quat_cast(on.to.world_to_camera), t)));
  return camera;
}

}  // namespace pipegs
