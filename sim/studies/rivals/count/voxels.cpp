// SPDX-License-Identifier: Apache-2.0
// voxels.cpp: see voxels.hpp.
//
// Idea    Voxel by voxel on all threads: its corners in the image bound the groups that may meet it, the rays of their
//         pixels decide; then each of its Gaussians goes through both filters in the groups that do. A Gaussian is lost
//         in groups that do not meet its voxel.
#include "sim/studies/rivals/count/voxels.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <span>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"
#include "sim/studies/rivals/count/meet.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

class Streamer {
 public:
  Streamer(const Scene& scene, const std::vector<SeenGaussian>& seen, const std::vector<double>& group_stop,
           const std::vector<uint32_t>& places, const Camera& camera, double edge, double near_plane,
           std::vector<FilterCounts>& groups)
      : groups_(groups),
        scene_(scene),
        seen_(seen),
        group_stop_(group_stop),
        places_(places),
        camera_(camera),
        near_(near_plane),
        edge_(edge),
        grid_(camera, kGroupSide),
        meeting_(camera, near_plane, edge) {}

  void run(std::span<const Member> members) {
    meet(members.front().voxel * edge_);
    met_.for_each([&](int x, int y) {
      add(group(x, y).voxels, 1);
      add(group(x, y).fetched, members.size());
    });
    if (met_.count() == 0) return;
    for (const Member& member : members) filter(member.index);
  }

 private:
  FilterCounts& group(int x, int y) const { return groups_[grid_.at(x, y)]; }
  static void add(uint64_t& count, uint64_t more) { std::atomic_ref(count).fetch_add(more, std::memory_order_relaxed); }

  // Fills met_: the groups that meet the voxel while they are open.
  void meet(const glm::dvec3& low) {
    const PixelRect groups = meeting_.around(low, grid_);
    const double nearest = meeting_.nearest(low);
    met_.clear(groups);
    for (int y = groups.y0; y < groups.y1; ++y) {
      for (int x = groups.x0; x < groups.x1; ++x) {
        if (nearest <= group_stop_[grid_.at(x, y)] && meets(low, x, y)) met_.add(x, y);
      }
    }
  }

  bool meets(const glm::dvec3& low, int group_x, int group_y) const {
    const int side = grid_.side, x1 = std::min((group_x + 1) * side, camera_.width),
              y1 = std::min((group_y + 1) * side, camera_.height);
    for (int y = group_y * side; y < y1; ++y) {
      for (int x = group_x * side; x < x1; ++x) {
        if (meeting_.passes(low, meeting_.ray(x, y))) return true;
      }
    }
    return false;
  }

  void filter(uint32_t index) {
    const Circle circle = coarse_circle(scene_, index, camera_, near_);
    if (circle.radius < 0) return;
    const uint32_t place = places_[index];
    exact_.clear({});
    if (place != kNowhere) {
      reached_spans(seen_[place], spans_);
      covered(seen_[place], spans_, grid_, Cover::kExact, exact_);
    }
    met_.for_each([&](int x, int y) {
      if (!circle.touches(grid_, x, y)) return;
      add(group(x, y).coarse, 1);
      if (exact_.has(x, y)) add(group(x, y).fine, 1);
    });
  }

  std::vector<FilterCounts>& groups_;  // of all threads
  const Scene& scene_;
  const std::vector<SeenGaussian>& seen_;
  const std::vector<double>& group_stop_;
  const std::vector<uint32_t>& places_;
  const Camera& camera_;
  double near_, edge_;
  TileGrid grid_;
  Meeting meeting_;
  TileSet met_, exact_;
  std::vector<PixelSpan> spans_;
};

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
  const std::vector<Member> members = members_of(scene, edge);
  const std::vector<std::span<const Member>> voxels = voxels_of(members);
  const std::vector<double> group_stop = stop_of_groups(stop_depth, camera);
  std::vector<uint32_t> places(scene.gaussians.size(), kNowhere);
  for (size_t place = 0; place < seen.size(); ++place) places[seen[place].index] = static_cast<uint32_t>(place);
  VoxelCounts counts{.groups = std::vector<FilterCounts>(group_stop.size())};
  parallel_for(voxels.size(), options.threads, [&](size_t v) {
    if (interrupted()) throw std::runtime_error("interrupted");
    Streamer(scene, seen, group_stop, places, camera, edge, options.near_plane, counts.groups).run(voxels[v]);
  });
  return counts;
}

}  // namespace pipegs
