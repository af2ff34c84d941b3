// SPDX-License-Identifier: Apache-2.0
// walk.cpp: see walk.hpp.
//
// Idea    A tile is sixteen words of sixteen bits: pixels that are alive, pixels that a Gaussian reaches, pixels of the
//         parts that its oriented box touches. All counts are logic on them; only the blending itself needs alphas.
#include "sim/studies/rivals/count/walk.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr int kPart = 8;  // side of the parts that GSCore's bitmap names

using Bits = std::array<uint16_t, kTileSide>;  // a word for each row of the tile, a bit for each pixel

Bits operator&(const Bits& a, const Bits& b) {
  Bits both;
  for (size_t y = 0; y < both.size(); ++y) both[y] = a[y] & b[y];
  return both;
}

uint16_t ones(int from, int to) { return static_cast<uint16_t>((1u << to) - (1u << from)); }

uint64_t number(const Bits& bits) {
  int sum = 0;
  for (const uint16_t row : bits) sum += std::popcount(row);
  return static_cast<uint64_t>(sum);
}

// Parts of kWidth x kHeight pixels of which a pixel is in `touched`.
template <int kWidth, int kHeight>
void count_parts(const Bits& touched, const Bits& alive, const Bits& live, bool tile_open, PartCounts& counts) {
  for (size_t top = 0; top < kTileSide; top += kHeight) {
    unsigned t = 0, a = 0, l = 0;
    for (size_t y = top; y < top + kHeight; ++y) t |= touched[y], a |= alive[y], l |= live[y];
    for (int left = 0; t != 0 && left < kTileSide; left += kWidth) {
      const unsigned part = ones(left, left + kWidth);
      if ((t & part) == 0) continue;
      ++counts.all;
      counts.tile_open += tile_open;
      counts.open += (a & part) != 0;
      counts.live += (l & part) != 0;
    }
  }
}

class Walker {
 public:
  explicit Walker(const PixelRect& area) : area_(area) {
    for (int y = 0; y < area.y1 - area.y0; ++y) inside_[static_cast<size_t>(y)] = ones(0, area.x1 - area.x0);
    alive_ = inside_;
    alive_pixels_ = number(alive_);
    transmittance_.fill(1);
  }

  bool open() const { return alive_pixels_ > 0; }

  // Returns whether the Gaussian adds to a pixel.
  bool take(const SeenGaussian& s, const Entry& entry, TileCounts& counts) {
    const Bits reached = entry.by(Cover::kExact) ? reach(s) : Bits{};
    const Bits live = reached & alive_;
    for (const Cover cover : kAllCovers) {
      if (!entry.by(cover) || !open()) continue;
      ++counts.walk[cover].open;
      counts.walk[cover].alive += alive_pixels_;
    }
    if (entry.by(Cover::kOriented)) {
      count_parts<kPart, kPart>(touched(s), alive_, live, open(), counts.oriented_8x8);
    }
    if (!entry.by(Cover::kExact)) return false;
    count_parts<8, 8>(reached, alive_, live, open(), counts.exact_8x8);
    count_parts<4, 4>(reached, alive_, live, open(), counts.exact_4x4);
    count_parts<16, 1>(reached, alive_, live, open(), counts.exact_16x1);
    count_parts<8, 1>(reached, alive_, live, open(), counts.exact_8x1);
    counts.reached += number(reached);
    return blend(s, live, counts);
  }

 private:
  Bits reach(const SeenGaussian& s) const {
    Bits bits{};
    const PixelSpan limits{std::max(area_.x0, s.reach.x0), std::min(area_.x1, s.reach.x1)};
    for (int y = std::max(area_.y0, s.reach.y0); y < std::min(area_.y1, s.reach.y1); ++y) {
      const PixelSpan span = reached_span(s, y, limits);
      if (!span.empty()) bits[static_cast<size_t>(y - area_.y0)] = ones(span.x0 - area_.x0, span.x1 - area_.x0);
    }
    return bits;
  }

  // Pixels of the image in the parts that the oriented box touches.
  Bits touched(const SeenGaussian& s) const {
    Bits bits{};
    for (int top = 0; top < kTileSide; top += kPart) {
      for (int left = 0; left < kTileSide; left += kPart) {
        const glm::dvec2 middle(area_.x0 + left + half_of(kPart), area_.y0 + top + half_of(kPart));
        if (!box_touches(s, middle, half_of(kPart))) continue;
        for (int y = top; y < top + kPart; ++y) bits[static_cast<size_t>(y)] |= ones(left, left + kPart);
      }
    }
    return bits & inside_;
  }

  bool blend(const SeenGaussian& s, const Bits& live, TileCounts& counts) {
    const uint64_t before = counts.blends;
    for (size_t y = 0; y < kTileSide; ++y) {
      for (unsigned rest = live[y]; rest != 0; rest &= rest - 1) {
        const int x = std::countr_zero(rest);
        double& transmittance = transmittance_[y * kTileSide + static_cast<size_t>(x)];
        const double next = transmittance * (1 - alpha_at(s, area_.x0 + x, area_.y0 + static_cast<int>(y)));
        if (next < kMinTransmittance) {
          alive_[y] &= static_cast<uint16_t>(~(1u << x));
          --alive_pixels_;
          ++counts.stops;
        } else {
          transmittance = next;
          ++counts.blends;
        }
      }
    }
    return counts.blends > before;
  }

  PixelRect area_;  // of the image
  Bits inside_{}, alive_{};
  uint64_t alive_pixels_ = 0;
  std::array<double, kTileSide * kTileSide> transmittance_;
};

// Pixels of the image in a 16-px tile.
PixelRect tile_area(const TileGrid& grid, size_t tile, const Camera& camera) {
  const int x = static_cast<int>(tile % static_cast<size_t>(grid.columns)) * kTileSide,
            y = static_cast<int>(tile / static_cast<size_t>(grid.columns)) * kTileSide;
  return {x, y, std::min(x + kTileSide, camera.width), std::min(y + kTileSide, camera.height)};
}

}  // namespace

std::vector<double> count_walks(const SeenScene& seen, const TileLists& lists, const Camera& camera,
                                const CountOptions& options, FrameCounts& counts) {
  const TileGrid grid(camera, kTileSide);
  counts.tiles.assign(grid.count(), {});
  std::vector<double> stop_depth(grid.count(), std::numeric_limits<double>::infinity());
  std::vector<uint8_t> blended(seen.gaussians.size(), 0);
  std::mutex mutex;
  size_t done = 0;
  parallel_for(grid.count(), options.threads, [&](size_t t) {
    if (interrupted()) throw std::runtime_error("interrupted");
    Walker walker(tile_area(grid, t, camera));
    for (const Entry& entry : lists.of(t)) {
      const SeenGaussian& s = seen.gaussians[entry.place()];
      const bool was_open = walker.open();
      if (walker.take(s, entry, counts.tiles[t]))
        std::atomic_ref(blended[entry.place()]).store(1, std::memory_order_relaxed);
      if (was_open && !walker.open()) stop_depth[t] = s.depth;
    }
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    options.progress(static_cast<double>(++done) / static_cast<double>(grid.count()));
  });
  for (const TileCounts& tile : counts.tiles) counts.total += tile;
  counts.gaussians.blended = static_cast<uint64_t>(std::count(blended.begin(), blended.end(), 1));
  return stop_depth;
}

}  // namespace pipegs
