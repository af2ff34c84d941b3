// SPDX-License-Identifier: Apache-2.0
// streaming.cpp: see streaming.hpp.
//
// Idea    Of a group, the Gaussians that its pixels see are known in depth order; sorted by the turn of their voxel,
//         and there still by depth, they are what the machine blends. How far it came says which voxels it fetched.
#include "sim/studies/rivals/pixels/streaming.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();
constexpr size_t kBlock = 8192;  // Gaussians that a thread takes at a time

// What one group streams.
struct Group {
  std::vector<uint32_t> voxels = {};  // numbers, in order
  std::vector<size_t> begins = {};    // of each voxel in the group's sequence
  std::vector<uint32_t> sequence = {};
  StreamCounts counts = {};
};

class Streamer {
 public:
  Streamer(const PixelView& view, const VoxelScene& voxels, const std::vector<Circle>& circles, const TileGrid& grid)
      : view_(view), voxels_(voxels), circles_(circles), grid_(grid) {}

  Group sort(size_t g, const std::vector<uint32_t>& exact) const {
    const auto [x, y] = at(g);
    Group group{.voxels = voxels_.order.of_group(grid_, x, y)};
    group.counts.met = group.voxels.size();
    group.counts.pairs = exact.size();
    std::vector<std::pair<uint32_t, uint32_t>> turns;  // number of a voxel, its turn
    for (uint32_t turn = 0; turn < group.voxels.size(); ++turn) turns.push_back({group.voxels[turn], turn});
    std::sort(turns.begin(), turns.end());
    std::vector<std::pair<uint32_t, uint32_t>> blended;  // turn, place
    for (const uint32_t place : exact) {
      const uint32_t index = view_.seen.gaussians[place].index, voxel = voxels_.voxel_of[index];
      const auto found = std::lower_bound(turns.begin(), turns.end(), std::pair{voxel, 0u});
      if (found == turns.end() || found->first != voxel) ++group.counts.lost_voxel;
      else if (!circles_[index].touches(grid_, x, y)) ++group.counts.lost_coarse;
      else blended.push_back({found->second, place});
    }
    std::sort(blended.begin(), blended.end());
    size_t next = 0;
    for (uint32_t turn = 0; turn < group.voxels.size(); ++turn) {
      group.begins.push_back(next);
      while (next < blended.size() && blended[next].first == turn) group.sequence.push_back(blended[next++].second);
    }
    return group;
  }

  // `walked`: how many of its sequence, or kNeverStops.
  void count_fetched(size_t g, size_t walked, Group& group) const {
    const auto [x, y] = at(g);
    for (size_t turn = 0; turn < group.voxels.size() && group.begins[turn] < walked; ++turn) {
      const std::span<const Member> members = voxels_.voxels[group.voxels[turn]];
      const size_t end = turn + 1 < group.voxels.size() ? group.begins[turn + 1] : group.sequence.size();
      ++group.counts.taken;
      group.counts.fetched += members.size();
      group.counts.fine += end - group.begins[turn];
      for (const Member& member : members) group.counts.coarse += circles_[member.index].touches(grid_, x, y);
    }
  }

 private:
  std::pair<int, int> at(size_t g) const {
    const auto columns = static_cast<size_t>(grid_.columns);
    return {static_cast<int>(g % columns), static_cast<int>(g / columns)};
  }

  const PixelView& view_;
  const VoxelScene& voxels_;
  const std::vector<Circle>& circles_;
  TileGrid grid_;
};

}  // namespace

VoxelScene voxel_scene(const Scene& scene, const PixelView& view, double edge, double near_plane, unsigned threads) {
  std::vector<Member> members = members_of(scene, edge);
  std::vector<std::span<const Member>> voxels = voxels_of(members);
  std::vector<uint32_t> voxel_of(scene.gaussians.size(), kNowhere);
  for (uint32_t number = 0; number < voxels.size(); ++number) {
    for (const Member& member : voxels[number]) voxel_of[member.index] = number;
  }
  VoxelOrder order(voxels, view.camera, near_plane, edge, threads);
  return {edge, std::move(members), std::move(voxels), std::move(voxel_of), std::move(order)};
}

std::vector<Circle> coarse_circles(const Scene& scene, const Camera& camera, double near_plane, unsigned threads) {
  const size_t count = scene.gaussians.size();
  std::vector<Circle> circles(count);
  parallel_for((count + kBlock - 1) / kBlock, threads, [&](size_t b) {
    for (size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i)
      circles[i] = coarse_circle(scene, static_cast<uint32_t>(i), camera, near_plane);
  });
  return circles;
}

StreamPicture stream(const PixelView& view, const VoxelScene& voxels, const std::vector<Circle>& circles,
                     const Sequences& exact, unsigned threads) {
  const TileGrid grid(view.camera, exact.side);
  const Streamer streamer(view, voxels, circles, grid);
  std::vector<Group> groups(grid.count());
  StreamPicture picture{.sequences = {exact.side, {}}, .blend = {}, .counts = {}};
  picture.sequences.places.resize(grid.count());
  parallel_for(grid.count(), threads, [&](size_t g) {
    if (interrupted()) throw std::runtime_error("interrupted");
    groups[g] = streamer.sort(g, exact.places[g]);
    picture.sequences.places[g] = groups[g].sequence;
  });
  picture.blend = blend(view, picture.sequences, threads);
  parallel_for(grid.count(), threads, [&](size_t g) { streamer.count_fetched(g, picture.blend.stops[g], groups[g]); });
  StreamCounts& sum = picture.counts;
  for (const auto& [_, begins, sequence, one] : groups) {
    sum.met += one.met, sum.taken += one.taken, sum.pairs += one.pairs;
    sum.lost_voxel += one.lost_voxel, sum.lost_coarse += one.lost_coarse;
    sum.fetched += one.fetched, sum.coarse += one.coarse, sum.fine += one.fine;
  }
  return picture;
}

Sequences by_depth(Sequences sequences) {
  for (std::vector<uint32_t>& places : sequences.places) std::sort(places.begin(), places.end());
  return sequences;
}

}  // namespace pipegs
