// SPDX-License-Identifier: Apache-2.0
// meet.hpp: which voxels hold which Gaussians, which pixels' rays meet them, and what the coarse filter keeps.
//
// Rule    A Gaussian belongs to the voxel of its mean, however large it is. Voxels begin at multiples of their edge and
//         are met by a pixel when the ray through its centre passes through them beyond the near plane, faces included.
//         The coarse filter knows mean and largest scale: its circle in the image is that of a round Gaussian of this
//         scale, by the same projection, so it holds every ellipse of 3 sigma.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {

struct Member {
  glm::dvec3 voxel;  // lowest corner over the edge
  uint32_t index;    // of the Gaussian in the scene
  bool operator<(const Member& o) const;
};

// All valid Gaussians, voxel by voxel: by x, then y, then z.
std::vector<Member> members_of(const Scene& scene, double edge);
std::vector<std::span<const Member>> voxels_of(const std::vector<Member>& members);

class Meeting {
 public:
  Meeting(const Camera& camera, double near_plane, double edge) : camera_(camera), near_(near_plane), edge_(edge) {}

  // Of the voxel with this lowest corner: its least depth, and the tiles around the part beyond the near plane.
  double nearest(const glm::dvec3& low) const;
  PixelRect around(const glm::dvec3& low, const TileGrid& grid) const;

  // A ray's parameter is its view depth.
  glm::dvec3 ray(int x, int y) const {
    return glm::dvec3((x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1) * camera_.world_to_camera;
  }
  bool passes(const glm::dvec3& low, const glm::dvec3& ray) const;

 private:
  const Camera& camera_;
  double near_, edge_;
};

// The coarse filter's circle, pixels; a radius below 0 behind the near plane.
struct Circle {
  glm::dvec2 mean{0};
  double radius = -1;
  bool touches(const TileGrid& grid, int x, int y) const {
    const glm::dvec2 apart = glm::max(glm::abs(mean - middle_of(grid.side, x, y)) - half_of(grid.side), 0.0);
    return radius >= 0 && glm::dot(apart, apart) <= radius * radius;
  }
};
Circle coarse_circle(const Scene& scene, uint32_t index, const Camera& camera, double near_plane);

}  // namespace pipegs
