// SPDX-License-Identifier: Apache-2.0
// meet.cpp: see meet.hpp.
#include "sim/studies/rivals/count/meet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pipegs {
namespace {

struct Corners {
  glm::dvec3 at[8];  // in the camera's space; number i has the higher x, y, z where bit 0, 1, 2 of i is set
};

Corners corners_of(const glm::dvec3& low, double edge, const Camera& camera) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = low + edge * glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
    corners.at[i] = camera.world_to_camera * (corner - camera.position);
  }
  return corners;
}

}  // namespace

bool Member::operator<(const Member& o) const {
  return std::tie(voxel.x, voxel.y, voxel.z, index) < std::tie(o.voxel.x, o.voxel.y, o.voxel.z, o.index);
}

std::vector<Member> members_of(const Scene& scene, double edge) {
  std::vector<Member> members;
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    members.push_back({glm::floor(gaussian.mean / edge), static_cast<uint32_t>(i)});
  }
  std::sort(members.begin(), members.end());
  return members;
}

std::vector<std::span<const Member>> voxels_of(const std::vector<Member>& members) {
  std::vector<std::span<const Member>> voxels;
  for (size_t first = 0, last = 0; first < members.size(); first = last) {
    while (last < members.size() && members[last].voxel == members[first].voxel) ++last;
    voxels.push_back(std::span(members).subspan(first, last - first));
  }
  return voxels;
}

double Meeting::nearest(const glm::dvec3& low) const {
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& corner : corners_of(low, edge_, camera_).at) least = std::min(least, corner.z);
  return least;
}

// The rectangle around its corners, and where its edges pass through the near plane.
PixelRect Meeting::around(const glm::dvec3& low_corner, const TileGrid& grid) const {
  const Corners corners = corners_of(low_corner, edge_, camera_);
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  const auto add = [&](const glm::dvec3& p) {
    const glm::dvec2 pixel(camera_.fx * p.x / p.z + camera_.cx, camera_.fy * p.y / p.z + camera_.cy);
    low = glm::min(low, pixel), high = glm::max(high, pixel);
  };
  for (int i = 0; i < 8; ++i) {
    if (corners.at[i].z >= near_) add(corners.at[i]);
    for (int axis = 1; axis < 8; axis *= 2) {
      const glm::dvec3 &a = corners.at[i], &b = corners.at[i | axis];
      if ((a.z < near_) != (b.z < near_)) {
        glm::dvec3 p = glm::mix(a, b, (near_ - a.z) / (b.z - a.z));
        p.z = near_;
        add(p);
      }
    }
  }
  if (!(low.x <= high.x)) return {};
  // A pixel on each side for rounding: rays decide.
  const auto tile = [&](double pixel, int count) {
    return static_cast<int>(std::clamp(std::floor(pixel / grid.side), -1.0, static_cast<double>(count)));
  };
  return {std::max(tile(low.x - 1, grid.columns), 0), std::max(tile(low.y - 1, grid.rows), 0),
          std::min(tile(high.x + 1, grid.columns) + 1, grid.columns),
          std::min(tile(high.y + 1, grid.rows) + 1, grid.rows)};
}

bool Meeting::passes(const glm::dvec3& low, const glm::dvec3& ray) const {
  double enter = near_, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = low[axis] - camera_.position[axis], to = from + edge_;
    if (ray[axis] == 0) {
      if (from > 0 || to < 0) return false;
      continue;
    }
    const double a = from / ray[axis], b = to / ray[axis];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

Circle coarse_circle(const Scene& scene, uint32_t index, const Camera& camera, double near_plane) {
  ActivatedGaussian gaussian;
  if (activate(scene, index, gaussian) != Cull::kNone) return {};
  gaussian.scale = glm::dvec3(std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z}));
  const ProjectionOptions projection{Semantics::kExact, near_plane, false, 0};
  const TruthProjection p = project_truth(gaussian, scene.gaussians[index].sh_dc, nullptr, 0, camera, projection);
  if (!p.visible) return {};
  return {p.mean, three_sigma(p.a, p.b, p.c)};
}

}  // namespace pipegs
