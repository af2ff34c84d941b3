// SPDX-License-Identifier: Apache-2.0
// voxel_order.cpp: see voxel_order.hpp.
//
// Idea    The rays are traced once, in tiles of 16 pixels: a voxel's corners in the image bound the tiles that may meet
//         it, and each pixel passes the tile's candidates in order of their steps. The graph of a group is the union of
//         those of its tiles. A voxel goes out in the round that is the longest path to it.
#include "sim/studies/rivals/pixels/voxel_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

VoxelOrder::VoxelOrder(const std::vector<std::span<const Member>>& members, const Camera& camera, double near_plane,
                       double edge, unsigned threads)
    : tiles_(camera, kTileSide), numbers_(members.size()), traced_(tiles_.count()) {
  const glm::dvec3 home = glm::floor(camera.position / edge);
  std::vector<double> steps;
  for (const std::span<const Member> voxel : members) {
    const glm::dvec3 apart = glm::abs(voxel.front().voxel - home);
    steps.push_back(apart.x + apart.y + apart.z);
  }
  std::iota(numbers_.begin(), numbers_.end(), 0u);
  std::stable_sort(numbers_.begin(), numbers_.end(), [&](uint32_t a, uint32_t b) { return steps[a] < steps[b]; });
  for (const uint32_t number : numbers_) corners_.push_back(members[number].front().voxel * edge);

  const Meeting meeting(camera, near_plane, edge);
  std::vector<PixelRect> around(numbers_.size());
  parallel_for(numbers_.size(), threads, [&](size_t rank) { around[rank] = meeting.around(corners_[rank], tiles_); });
  std::vector<std::vector<uint32_t>> candidates(tiles_.count());
  for (uint32_t rank = 0; rank < around.size(); ++rank) {
    for (int y = around[rank].y0; y < around[rank].y1; ++y) {
      for (int x = around[rank].x0; x < around[rank].x1; ++x) candidates[tiles_.at(x, y)].push_back(rank);
    }
  }
  parallel_for(tiles_.count(), threads, [&](size_t tile) {
    if (interrupted()) throw std::runtime_error("interrupted");
    trace(camera, meeting, candidates[tile], tile);
  });
}

void VoxelOrder::trace(const Camera& camera, const Meeting& meeting, const std::vector<uint32_t>& candidates,
                       size_t tile) {
  constexpr size_t kNone = std::numeric_limits<size_t>::max();
  const int left = static_cast<int>(tile % static_cast<size_t>(tiles_.columns)) * kTileSide,
            top = static_cast<int>(tile / static_cast<size_t>(tiles_.columns)) * kTileSide;
  std::vector<size_t> followed(candidates.size(), kNone);  // by the candidate that did so last
  std::vector<uint8_t> met(candidates.size(), 0);
  Tile& graph = traced_[tile];
  for (int y = top; y < std::min(top + kTileSide, camera.height); ++y) {
    for (int x = left; x < std::min(left + kTileSide, camera.width); ++x) {
      const glm::dvec3 ray = meeting.ray(x, y);
      size_t before = kNone;
      for (size_t k = 0; k < candidates.size(); ++k) {
        if (!meeting.passes(corners_[candidates[k]], ray)) continue;
        met[k] = 1;
        if (before != kNone && followed[before] != k) {
          followed[before] = k;
          graph.edges.push_back(uint64_t{candidates[before]} << 32 | candidates[k]);
        }
        before = k;
      }
    }
  }
  for (size_t k = 0; k < candidates.size(); ++k) {
    if (met[k] != 0) graph.nodes.push_back(candidates[k]);
  }
  sort_unique(graph.edges);
}

std::vector<uint32_t> VoxelOrder::of_group(const TileGrid& groups, int x, int y) const {
  const int span = groups.side / kTileSide;
  std::vector<uint32_t> nodes;
  std::vector<uint64_t> edges;
  for (int ty = y * span; ty < std::min((y + 1) * span, tiles_.rows); ++ty) {
    for (int tx = x * span; tx < std::min((x + 1) * span, tiles_.columns); ++tx) {
      const Tile& tile = traced_[tiles_.at(tx, ty)];
      nodes.insert(nodes.end(), tile.nodes.begin(), tile.nodes.end());
      edges.insert(edges.end(), tile.edges.begin(), tile.edges.end());
    }
  }
  sort_unique(nodes);
  sort_unique(edges);
  const auto place = [&](uint32_t rank) {
    return static_cast<size_t>(std::lower_bound(nodes.begin(), nodes.end(), rank) - nodes.begin());
  };
  // An edge leads to a higher rank, so in this order the round of its first end is settled.
  std::vector<uint32_t> round(nodes.size(), 0);
  for (const uint64_t edge : edges) {
    uint32_t& to = round[place(static_cast<uint32_t>(edge))];
    to = std::max(to, round[place(static_cast<uint32_t>(edge >> 32))] + 1);
  }
  std::vector<std::pair<uint32_t, uint32_t>> out;  // round, number
  for (size_t k = 0; k < nodes.size(); ++k) out.push_back({round[k], numbers_[nodes[k]]});
  std::sort(out.begin(), out.end());
  std::vector<uint32_t> order;
  for (const auto& [_, number] : out) order.push_back(number);
  return order;
}

}  // namespace pipegs
