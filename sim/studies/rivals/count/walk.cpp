// SPDX-License-Identifier: Apache-2.0
// walk.cpp: see lists.hpp.
//
// Idea    A tile is sixteen words of sixteen bits: pixels that are alive, pixels that a Gaussian reaches, pixels of the
//         parts that its oriented box touches. All counts are logic on them; only the blending itself needs alphas.
//         Once the tile is opaque nothing more of it counts.
#include "sim/studies/rivals/count/lists.hpp"

#include <algorithm>
#include <array>
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

// Parts of kSide x kSide pixels of which a pixel is in `touched` and one is alive.
template <int kSide>
uint64_t open_parts(const Bits& touched, const Bits& alive) {
  uint64_t count = 0;
  for (size_t top = 0; top < kTileSide; top += kSide) {
    unsigned t = 0, a = 0;
    for (size_t y = top; y < top + kSide; ++y) t |= touched[y], a |= alive[y];
    for (int left = 0; t != 0 && left < kTileSide; left += kSide) {
      const unsigned part = ones(left, left + kSide);
      count += (t & part) != 0 && (a & part) != 0;
    }
  }
  return count;
}

class Walker {
 public:
  explicit Walker(const PixelRect& area) : area_(area) {
    for (int y = 0; y < area.y1 - area.y0; ++y) alive_[static_cast<size_t>(y)] = ones(0, area.x1 - area.x0);
    alive_pixels_ = (area.x1 - area.x0) * (area.y1 - area.y0);
    transmittance_.fill(1);
  }

  bool open() const { return alive_pixels_ > 0; }

  // Of an open tile.
  void take(const SeenGaussian& s, const Entry& entry, TileCounts& counts) {
    for (const Cover cover : kAllCovers) counts.open[cover] += entry.by(cover);
    if (entry.by(Cover::kOriented)) counts.oriented_8x8 += open_parts<kPart>(touched(s), alive_);
    if (!entry.by(Cover::kExact)) return;
    const Bits reached = reach(s);
    counts.exact_8x8 += open_parts<8>(reached, alive_);
    counts.exact_4x4 += open_parts<4>(reached, alive_);
    blend(s, reached & alive_);
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

  // Pixels of the parts that the oriented box touches.
  Bits touched(const SeenGaussian& s) const {
    Bits bits{};
    for (int top = 0; top < kTileSide; top += kPart) {
      for (int left = 0; left < kTileSide; left += kPart) {
        const glm::dvec2 middle(area_.x0 + left + half_of(kPart), area_.y0 + top + half_of(kPart));
        if (!box_touches(s, middle, half_of(kPart))) continue;
        for (int y = top; y < top + kPart; ++y) bits[static_cast<size_t>(y)] |= ones(left, left + kPart);
      }
    }
    return bits;
  }

  void blend(const SeenGaussian& s, const Bits& live) {
    for (size_t y = 0; y < kTileSide; ++y) {
      for (unsigned rest = live[y]; rest != 0; rest &= rest - 1) {
        const int x = std::countr_zero(rest);
        double& transmittance = transmittance_[y * kTileSide + static_cast<size_t>(x)];
        const double next = transmittance * (1 - alpha_at(s, area_.x0 + x, area_.y0 + static_cast<int>(y)));
        if (next < kMinTransmittance) {
          alive_[y] &= static_cast<uint16_t>(~(1u << x));
          --alive_pixels_;
        } else {
          transmittance = next;
        }
      }
    }
  }

  PixelRect area_;  // of the image
  Bits alive_{};
  int alive_pixels_ = 0;
  std::array<double, kTileSide * kTileSide> transmittance_;
};

}  // namespace

std::vector<double> count_walks(const std::vector<SeenGaussian>& seen, const TileLists& lists, const Camera& camera,
                                const CountOptions& options, FrameCounts& counts) {
  const TileGrid grid(camera, kTileSide);
  counts.tiles.assign(grid.count(), {});
  std::vector<double> stop_depth(grid.count(), std::numeric_limits<double>::infinity());
  std::mutex mutex;
  size_t done = 0;
  parallel_for(grid.count(), options.threads, [&](size_t t) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const int tile = static_cast<int>(t);
    Walker walker(grid.pixels(tile % grid.columns, tile / grid.columns, camera));
    for (const Entry& entry : lists[t]) {
      const SeenGaussian& s = seen[entry.place];
      walker.take(s, entry, counts.tiles[t]);
      if (walker.open()) continue;
      stop_depth[t] = s.depth;
      break;
    }
    if (!options.progress) return;
    const std::lock_guard lock(mutex);
    options.progress(static_cast<double>(++done) / static_cast<double>(grid.count()));
  });
  return stop_depth;
}

}  // namespace pipegs
