// SPDX-License-Identifier: Apache-2.0
// voxels.cpp: see lists.hpp.
//
// Idea    Voxel by voxel on all threads: its corners in the image bound the groups that may meet it, the rays of their
//         pixels decide; then each of its Gaussians goes through both filters in the groups that do. A Gaussian is lost
//         in groups that do not meet its voxel.
// Rule    A Gaussian belongs to the voxel of its mean, however large it is. Voxels begin at multiples of their edge and
//         are met by a pixel when the ray through its centre passes through them beyond the near plane, faces included.
//         The coarse filter knows mean and largest scale: its circle in the image is that of a round Gaussian of this
//         scale, by the same projection, so it holds every ellipse of 3 sigma.
#include "sim/studies/rivals/count/lists.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

// All valid Gaussians, voxel by voxel: by the x, y and z of its lowest corner over the edge.
using Voxels = std::map<std::array<double, 3>, std::vector<uint32_t>>;
Voxels voxels_of(const Scene& scene, double edge) {
  Voxels voxels;
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    const glm::dvec3 voxel = glm::floor(gaussian.mean / edge);
    voxels[{voxel.x, voxel.y, voxel.z}].push_back(static_cast<uint32_t>(i));
  }
  return voxels;
}

// The corners of a voxel in the camera's space: number i has the higher x, y, z where bit 0, 1, 2 of i is set.
using Corners = std::array<glm::dvec3, 8>;
Corners corners_of(const glm::dvec3& low, double edge, const Camera& camera) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = low + edge * glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
    corners[static_cast<size_t>(i)] = camera.world_to_camera * (corner - camera.position);
  }
  return corners;
}

// The groups around the part of a voxel that lies beyond the near plane: the rectangle around its corners, and where
// its edges pass through that plane.
PixelRect groups_around(const Corners& corners, const TileGrid& grid, const Camera& camera, double near_plane) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  const auto add = [&](const glm::dvec3& p) {
    const glm::dvec2 pixel(camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy);
    low = glm::min(low, pixel), high = glm::max(high, pixel);
  };
  for (size_t i = 0; i < 8; ++i) {
    if (corners[i].z >= near_plane) add(corners[i]);
    for (size_t axis = 1; axis < 8; axis *= 2) {
      const glm::dvec3 &a = corners[i], &b = corners[i | axis];
      if ((a.z < near_plane) != (b.z < near_plane)) {
        glm::dvec3 p = glm::mix(a, b, (near_plane - a.z) / (b.z - a.z));
        p.z = near_plane;
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

// Whether the ray through a pixel's centre passes through the voxel. A ray's parameter is its view depth.
bool ray_passes(const glm::dvec3& low, double edge, int x, int y, const Camera& camera, double near_plane) {
  const glm::dvec3 ray =
      glm::dvec3((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1) * camera.world_to_camera;
  double enter = near_plane, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double from = low[axis] - camera.position[axis], to = from + edge;
    if (ray[axis] == 0) {
      if (from > 0 || to < 0) return false;
      continue;
    }
    const double a = from / ray[axis], b = to / ray[axis];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

// The coarse filter's circle, pixels; a radius below 0 behind the near plane.
struct Circle {
  glm::dvec2 mean{0};
  double radius = -1;
  bool touches(const TileGrid& grid, int x, int y) const {
    const glm::dvec2 apart = glm::max(glm::abs(mean - middle_of(grid.side, x, y)) - half_of(grid.side), 0.0);
    return radius >= 0 && glm::dot(apart, apart) <= radius * radius;
  }
};
Circle coarse_circle(const Scene& scene, uint32_t index, const Camera& camera, double near_plane) {
  ActivatedGaussian gaussian;
  if (activate(scene, index, gaussian) != Cull::kNone) return {};
  gaussian.scale = glm::dvec3(std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z}));
  const ProjectionOptions projection{Semantics::kExact, near_plane, false, 0};
  const TruthProjection p = project_truth(gaussian, scene.gaussians[index].sh_dc, nullptr, 0, camera, projection);
  if (!p.visible) return {};
  return {p.mean, three_sigma(p.a, p.b, p.c)};
}

// The groups that meet a voxel while they are open.
TileSet meeting_groups(const glm::dvec3& low, double edge, const TileGrid& grid, const Camera& camera,
                       double near_plane, const std::vector<double>& group_stop) {
  const auto meets = [&](const PixelRect& pixels) {
    for (int y = pixels.y0; y < pixels.y1; ++y) {
      for (int x = pixels.x0; x < pixels.x1; ++x) {
        if (ray_passes(low, edge, x, y, camera, near_plane)) return true;
      }
    }
    return false;
  };
  const Corners corners = corners_of(low, edge, camera);
  const PixelRect groups = groups_around(corners, grid, camera, near_plane);
  const double nearest = std::ranges::min(corners, {}, [](const glm::dvec3& corner) { return corner.z; }).z;
  TileSet met;
  met.clear(groups);
  for (int y = groups.y0; y < groups.y1; ++y) {
    for (int x = groups.x0; x < groups.x1; ++x) {
      if (nearest <= group_stop[grid.at(x, y)] && meets(grid.pixels(x, y, camera))) met.add(x, y);
    }
  }
  return met;
}

void add(uint64_t& count, uint64_t more) { std::atomic_ref(count).fetch_add(more, std::memory_order_relaxed); }

// The largest of its tiles.
std::vector<double> stop_of_groups(const std::vector<double>& stop_depth, const Camera& camera) {
  const TileGrid tiles(camera, kTileSide), groups(camera, kGroupSide);
  std::vector<double> stop(groups.count(), 0);
  for (int y = 0; y < tiles.rows; ++y) {
    for (int x = 0; x < tiles.columns; ++x) {
      double& group = stop[groups.at(x * kTileSide / kGroupSide, y * kTileSide / kGroupSide)];
      group = std::max(group, stop_depth[tiles.at(x, y)]);
    }
  }
  return stop;
}

}  // namespace

VoxelCounts count_voxels(const Scene& scene, const std::vector<SeenGaussian>& seen,
                         const std::vector<double>& stop_depth, const Camera& camera, double edge,
                         const CountOptions& options) {
  const Voxels found = voxels_of(scene, edge);
  const std::vector<Voxels::value_type> voxels(found.begin(), found.end());
  const std::vector<double> group_stop = stop_of_groups(stop_depth, camera);
  std::vector<uint32_t> places(scene.gaussians.size(), kNowhere);
  for (size_t place = 0; place < seen.size(); ++place) places[seen[place].index] = static_cast<uint32_t>(place);
  const TileGrid grid(camera, kGroupSide);
  VoxelCounts counts{.groups = std::vector<FilterCounts>(group_stop.size())};
  parallel_for(voxels.size(), options.threads, [&](size_t v) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const std::array<double, 3>& key = voxels[v].first;
    const std::vector<uint32_t>& members = voxels[v].second;
    const TileSet met =
        meeting_groups(edge * glm::dvec3(key[0], key[1], key[2]), edge, grid, camera, options.near_plane, group_stop);
    if (met.count() == 0) return;
    met.for_each([&](int x, int y) {
      add(counts.groups[grid.at(x, y)].voxels, 1);
      add(counts.groups[grid.at(x, y)].fetched, members.size());
    });
    TileSet exact;
    std::vector<PixelSpan> spans;
    for (const uint32_t index : members) {
      const Circle circle = coarse_circle(scene, index, camera, options.near_plane);
      if (circle.radius < 0) continue;
      exact.clear({});
      if (const uint32_t place = places[index]; place != kNowhere) {
        reached_spans(seen[place], spans);
        covered(seen[place], spans, grid, Cover::kExact, exact);
      }
      met.for_each([&](int x, int y) {
        if (!circle.touches(grid, x, y)) return;
        add(counts.groups[grid.at(x, y)].coarse, 1);
        if (exact.has(x, y)) add(counts.groups[grid.at(x, y)].fine, 1);
      });
    }
  });
  return counts;
}

}  // namespace pipegs
