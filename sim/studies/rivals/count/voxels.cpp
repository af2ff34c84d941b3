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
        grid_(camera, options.group),
        meeting_(camera, near_, edge_) {}

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
    const PixelRect groups = meeting_.around(low, grid_);
    met_.clear(groups);
    for (int y = groups.y0; y < groups.y1; ++y) {
      for (int x = groups.x0; x < groups.x1; ++x) {
        if (meets(low, x, y)) met_.add(x, y);
      }
    }
    return meeting_.nearest(low);
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

  void filter(uint32_t index, VoxelCounts& counts) {
    const Circle circle = coarse_circle(scene_, index, camera_, near_);
    if (circle.radius < 0) return;
    const uint32_t place = places_[index];
    if (place != kNowhere) {
      reached_spans(seen_.gaussians[place], spans_);
      covered(seen_.gaussians[place], spans_, grid_, Cover::kExact, exact_);
    } else {
      exact_.clear({});
    }
    uint64_t coarse = 0, fine = 0;
    met_.for_each([&](int x, int y) {
      if (!circle.touches(grid_, x, y)) return;
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
  TileGrid grid_;
  Meeting meeting_;
  TileSet met_, exact_;
  std::vector<PixelSpan> spans_;
};

// The largest of its tiles.
std::vector<double> stop_of_groups(const std::vector<double>& stop_depth, const Camera& camera, int side) {
  const TileGrid tiles(camera, kTileSide), groups(camera, side);
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
