// SPDX-License-Identifier: Apache-2.0
// voxels.cpp: see voxels.hpp.
//
// Idea    Voxel by voxel on all threads: its corners in the image bound the groups that may meet it, the rays of their
//         pixels decide; then each of its Gaussians goes through both filters in the groups that do.
// Rule    A Gaussian belongs to the voxel of its mean, however large it is, and is lost in groups that do not meet that
//         voxel. Voxels begin at multiples of their edge. The coarse filter knows mean and largest scale: its circle in
//         the image is that of a round Gaussian of this scale, by the same projection, so it holds every ellipse of 3
//         sigma.
#include "sim/study/rivals/count/voxels.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <tuple>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

struct Member {
  glm::dvec3 voxel;  // lowest corner over the edge
  uint32_t index;    // of the Gaussian in the scene
  bool operator<(const Member& o) const {
    return std::tie(voxel.x, voxel.y, voxel.z, index) < std::tie(o.voxel.x, o.voxel.y, o.voxel.z, o.index);
  }
};

// All valid Gaussians, voxel by voxel.
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

class Streamer {
 public:
  Streamer(const Scene& scene, const SeenScene& seen, const std::vector<double>& group_stop,
           const std::vector<uint32_t>& places, const Camera& camera, const CountOptions& options,
           std::vector<GroupCounts>& groups)
      : groups_(groups),
        scene_(scene),
        seen_(seen),
        group_stop_(group_stop),
        places_(places),
        camera_(camera),
        near_(options.near_plane),
        edge_(options.voxel),
        grid_(camera, options.group) {}

  VoxelCounts run(std::span<const Member> members) {
    VoxelCounts counts{.occupied = 1, .largest = members.size()};
    nearest_ = meet(members.front().voxel * edge_);
    counts.pairs = met_.count();
    met_.for_each([&](int x, int y) { counts.open_pairs += open(x, y); });
    if (counts.pairs == 0) return counts;
    counts.met = 1;
    counts.distinct.fetched = members.size();
    counts.all.fetched = counts.pairs * members.size();
    counts.open.fetched = counts.open_pairs * members.size();
    met_.for_each([&](int x, int y) {
      if (!open(x, y)) return;
      add(group(x, y).voxels, 1);
      add(group(x, y).filtered.fetched, members.size());
    });
    for (const Member& member : members) filter(member.index, counts);
    return counts;
  }

 private:
  GroupCounts& group(int x, int y) const { return groups_[grid_.at(x, y)]; }
  static void add(uint64_t& count, uint64_t more) { std::atomic_ref(count).fetch_add(more, std::memory_order_relaxed); }
  bool open(int x, int y) const { return nearest_ <= group_stop_[grid_.at(x, y)]; }

  // Fills met_; returns the least depth of the voxel.
  double meet(const glm::dvec3& low) {
    glm::dvec3 corners[8];
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 corner = low + edge_ * glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
      corners[i] = camera_.world_to_camera * (corner - camera_.position);
      nearest = std::min(nearest, corners[i].z);
    }
    const PixelRect groups = groups_around(corners);
    met_.clear(groups);
    for (int y = groups.y0; y < groups.y1; ++y) {
      for (int x = groups.x0; x < groups.x1; ++x) {
        if (meets(low, x, y)) met_.add(x, y);
      }
    }
    return nearest;
  }

  // Groups of the rectangle around the part of a voxel beyond the near plane: its corners, and where its edges pass
  // through that plane.
  PixelRect groups_around(const glm::dvec3 (&corners)[8]) const {
    glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
    const auto add = [&](const glm::dvec3& p) {
      const glm::dvec2 pixel(camera_.fx * p.x / p.z + camera_.cx, camera_.fy * p.y / p.z + camera_.cy);
      low = glm::min(low, pixel), high = glm::max(high, pixel);
    };
    for (int i = 0; i < 8; ++i) {
      if (corners[i].z >= near_) add(corners[i]);
      for (int axis = 1; axis < 8; axis *= 2) {
        const glm::dvec3 &a = corners[i], &b = corners[i | axis];
        if ((a.z < near_) != (b.z < near_)) {
          glm::dvec3 p = glm::mix(a, b, (near_ - a.z) / (b.z - a.z));
          p.z = near_;
          add(p);
        }
      }
    }
    if (!(low.x <= high.x)) return {};
    // A pixel on each side for rounding: rays decide.
    const auto group = [&](double pixel, int count) {
      return static_cast<int>(std::clamp(std::floor(pixel / grid_.side), -1.0, static_cast<double>(count)));
    };
    return {std::max(group(low.x - 1, grid_.columns), 0), std::max(group(low.y - 1, grid_.rows), 0),
            std::min(group(high.x + 1, grid_.columns) + 1, grid_.columns),
            std::min(group(high.y + 1, grid_.rows) + 1, grid_.rows)};
  }

  bool meets(const glm::dvec3& low, int group_x, int group_y) const {
    const int side = grid_.side, x1 = std::min((group_x + 1) * side, camera_.width),
              y1 = std::min((group_y + 1) * side, camera_.height);
    for (int y = group_y * side; y < y1; ++y) {
      for (int x = group_x * side; x < x1; ++x) {
        if (ray_passes(low, x, y)) return true;
      }
    }
    return false;
  }

  // The ray's parameter is its view depth.
  bool ray_passes(const glm::dvec3& low, int x, int y) const {
    const glm::dvec3 ray =
        glm::dvec3((x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1) * camera_.world_to_camera;
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

  void filter(uint32_t index, VoxelCounts& counts) {
    ActivatedGaussian gaussian;
    activate(scene_, index, gaussian);
    gaussian.scale = glm::dvec3(std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z}));
    const ProjectionOptions projection{Semantics::kExact, near_, false, 0};
    const TruthProjection p = project_truth(gaussian, scene_.gaussians[index].sh_dc, nullptr, 0, camera_, projection);
    if (!p.visible) return;
    const double radius = three_sigma(p.a, p.b, p.c);
    const uint32_t place = places_[index];
    if (place != kNowhere) {
      reached_spans(seen_.gaussians[place], spans_);
      covered(seen_.gaussians[place], spans_, grid_, Cover::kExact, exact_);
    } else {
      exact_.clear({});
    }
    uint64_t coarse = 0, fine = 0;
    met_.for_each([&](int x, int y) {
      const glm::dvec2 apart = glm::max(glm::abs(p.mean - middle_of(grid_.side, x, y)) - half_of(grid_.side), 0.0);
      if (!(glm::dot(apart, apart) <= radius * radius)) return;
      ++coarse;
      counts.open.coarse += open(x, y);
      if (open(x, y)) add(group(x, y).filtered.coarse, 1);
      if (!exact_.has(x, y)) return;
      ++fine;
      counts.open.fine += open(x, y);
      if (open(x, y)) add(group(x, y).filtered.fine, 1);
    });
    counts.all.coarse += coarse, counts.all.fine += fine;
    counts.distinct.coarse += coarse > 0, counts.distinct.fine += fine > 0;
  }

  std::vector<GroupCounts>& groups_;  // of all threads
  const Scene& scene_;
  const SeenScene& seen_;
  const std::vector<double>& group_stop_;
  const std::vector<uint32_t>& places_;
  const Camera& camera_;
  double near_, edge_, nearest_ = 0;
  Grid grid_;
  TileSet met_, exact_;
  std::vector<Span> spans_;
};

// The largest of its tiles.
std::vector<double> stop_of_groups(const std::vector<double>& stop_depth, const Camera& camera, int side) {
  const Grid tiles(camera, kTileSide), groups(camera, side);
  std::vector<double> stop(groups.count(), 0);
  for (int y = 0; y < tiles.rows; ++y) {
    for (int x = 0; x < tiles.columns; ++x) {
      double& group = stop[groups.at(x * kTileSide / side, y * kTileSide / side)];
      group = std::max(group, stop_depth[tiles.at(x, y)]);
    }
  }
  return stop;
}

void add(FilterCounts& sum, const FilterCounts& one) {
  sum.fetched += one.fetched, sum.coarse += one.coarse, sum.fine += one.fine;
}

}  // namespace

VoxelCounts count_voxels(const Scene& scene, const SeenScene& seen, const std::vector<double>& stop_depth,
                         const Camera& camera, const CountOptions& options) {
  const std::vector<Member> members = members_of(scene, options.voxel);
  const std::vector<std::span<const Member>> voxels = voxels_of(members);
  const std::vector<double> group_stop = stop_of_groups(stop_depth, camera, options.group);
  std::vector<uint32_t> places(scene.gaussians.size(), kNowhere);
  for (size_t place = 0; place < seen.gaussians.size(); ++place)
    places[seen.gaussians[place].index] = static_cast<uint32_t>(place);
  std::vector<VoxelCounts> each(voxels.size());
  std::vector<GroupCounts> groups(group_stop.size());
  parallel_for(voxels.size(), options.threads, [&](size_t v) {
    if (interrupted()) throw std::runtime_error("interrupted");
    each[v] = Streamer(scene, seen, group_stop, places, camera, options, groups).run(voxels[v]);
  });
  VoxelCounts sum{.edge = options.voxel, .groups = std::move(groups)};
  for (const VoxelCounts& one : each) {
    sum.occupied += one.occupied, sum.met += one.met;
    sum.largest = std::max(sum.largest, one.largest);
    sum.pairs += one.pairs, sum.open_pairs += one.open_pairs;
    add(sum.all, one.all), add(sum.open, one.open), add(sum.distinct, one.distinct);
  }
  return sum;
}

}  // namespace pipegs
