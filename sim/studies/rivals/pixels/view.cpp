// SPDX-License-Identifier: Apache-2.0
// view.cpp: see view.hpp.
//
// Idea    A group is blended tile by tile: a tile walks the group's sequence and takes what its own pixels may see.
//         Powers of a row are computed without branches, and a Gaussian is dropped at a pixel by its power, before the
//         exponential: as the truth does, so the two are as fast.
#include "sim/studies/rivals/pixels/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

constexpr size_t kBlock = 4096;  // Gaussians that a thread takes at a time

PixelRect common(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

class TileBlender {
 public:
  TileBlender(const PixelView& view, const PixelRect& area, Image& image, OrderCounts& counts)
      : view_(view), area_(area), image_(image), counts_(counts) {
    alive_ = (area.x1 - area.x0) * (area.y1 - area.y0);
    std::fill(std::begin(deepest_), std::end(deepest_), -std::numeric_limits<double>::infinity());
  }

  // How many of the sequence were walked until no pixel was alive.
  size_t run(const std::vector<uint32_t>& places) {
    for (size_t k = 0; k < places.size(); ++k) {
      const PixelRect r = common(view_.seen.gaussians[places[k]].reach, area_);
      if (r.empty()) continue;
      take(view_.seen.gaussians[places[k]], view_.rgb[places[k]], r);
      if (alive_ == 0) return k + 1;
    }
    return kNeverStops;
  }

 private:
  void take(const SeenGaussian& s, const glm::dvec3& rgb, const PixelRect& r) {
    double powers[kTileSide];
    for (int y = r.y0; y < r.y1; ++y) {
      const double dy = s.mean.y - y;
      for (int x = r.x0; x < r.x1; ++x) powers[x - r.x0] = power_at(s.conic, s.mean.x - x, dy);
      for (int x = r.x0; x < r.x1; ++x) {
        const double power = powers[x - r.x0];
        const int at = (y - area_.y0) * kTileSide + (x - area_.x0);
        if (!(power >= s.least_power) || stopped_[at]) continue;
        const double alpha = std::min(kMaxAlpha, s.opacity * std::exp(std::min(power, 0.0)));
        if (alpha >= kMinAlpha) add(s, rgb, alpha, image_.at(x, y), at);
      }
    }
  }

  void add(const SeenGaussian& s, const glm::dvec3& rgb, double alpha, size_t pixel, int at) {
    const double before = image_.transmittance[pixel], next = before * (1 - alpha);
    if (next < kMinTransmittance) {
      stopped_[at] = true;
      --alive_;
      return;
    }
    const double weight = alpha * before;
    image_.rgb[pixel] += weight * rgb;
    image_.depth[pixel] += weight * s.depth;
    image_.transmittance[pixel] = next;
    ++image_.blended[pixel];
    ++counts_.blends;
    counts_.late += s.depth < deepest_[at];
    deepest_[at] = std::max(deepest_[at], s.depth);
  }

  const PixelView& view_;
  PixelRect area_;
  Image& image_;
  OrderCounts& counts_;
  bool stopped_[kTileSide * kTileSide] = {};
  double deepest_[kTileSide * kTileSide];
  int alive_;
};

}  // namespace

PixelView pixel_view(const Scene& scene, const Camera& camera, double near_plane, unsigned threads) {
  PixelView view{camera, see(scene, camera, {.near_plane = near_plane, .threads = threads})};
  const size_t count = view.seen.gaussians.size();
  view.rgb.resize(count);
  parallel_for((count + kBlock - 1) / kBlock, threads, [&](size_t b) {
    for (size_t place = b * kBlock; place < std::min(count, (b + 1) * kBlock); ++place) {
      const size_t i = view.seen.gaussians[place].index;
      const glm::dvec3 offset = glm::dvec3(scene.gaussians[i].mean) - camera.position;
      const double length = glm::length(offset);
      view.rgb[place] = sh_color(scene.gaussians[i].sh_dc, sh_rest_of(scene, i), scene.sh_degree,
                                 length > 0 ? offset / length : glm::dvec3(0, 0, 1));
    }
  });
  return view;
}

std::vector<uint32_t> depth_order(const PixelView& view) {
  std::vector<uint32_t> order(view.seen.gaussians.size());
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

Sequences sequences_of(const PixelView& view, const std::vector<uint32_t>& order, int side) {
  const TileGrid grid(view.camera, side);
  Sequences sequences{side, {}};
  sequences.places.resize(grid.count());
  for (const uint32_t place : order) {
    const PixelRect& r = view.seen.gaussians[place].reach;
    if (r.empty()) continue;
    for (int y = r.y0 / side; y <= (r.y1 - 1) / side; ++y) {
      for (int x = r.x0 / side; x <= (r.x1 - 1) / side; ++x) sequences.places[grid.at(x, y)].push_back(place);
    }
  }
  return sequences;
}

Sequences exact_sequences(const PixelView& view, int side, unsigned threads) {
  const TileGrid grid(view.camera, side);
  struct Item {
    size_t group;
    uint32_t place;
  };
  const size_t count = view.seen.gaussians.size();
  std::vector<std::vector<Item>> blocks((count + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), threads, [&](size_t b) {
    std::vector<PixelSpan> spans;
    TileSet groups;
    for (size_t place = b * kBlock; place < std::min(count, (b + 1) * kBlock); ++place) {
      reached_spans(view.seen.gaussians[place], spans);
      covered(view.seen.gaussians[place], spans, grid, Cover::kExact, groups);
      groups.for_each([&](int x, int y) { blocks[b].push_back({grid.at(x, y), static_cast<uint32_t>(place)}); });
    }
  });
  Sequences sequences{side, {}};
  sequences.places.resize(grid.count());
  for (const std::vector<Item>& block : blocks) {
    for (const Item& item : block) sequences.places[item.group].push_back(item.place);
  }
  return sequences;
}

OrderedPicture blend(const PixelView& view, const Sequences& sequences, unsigned threads) {
  const Camera& camera = view.camera;
  if (sequences.side <= 0 || sequences.side % kTileSide != 0)
    throw std::invalid_argument("blend: a group's side is a multiple of 16");
  const TileGrid grid(camera, sequences.side);
  if (sequences.places.size() != grid.count()) throw std::invalid_argument("blend: sequences of another grid");
  OrderedPicture result{.image = Image(camera.width, camera.height)};
  result.stops.assign(grid.count(), 0);
  std::vector<OrderCounts> each(grid.count());
  parallel_for(grid.count(), threads, [&](size_t g) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const int left = static_cast<int>(g % static_cast<size_t>(grid.columns)) * grid.side,
              top = static_cast<int>(g / static_cast<size_t>(grid.columns)) * grid.side;
    for (int y = top; y < std::min(top + grid.side, camera.height); y += kTileSide) {
      for (int x = left; x < std::min(left + grid.side, camera.width); x += kTileSide) {
        const PixelRect area{x, y, std::min(x + kTileSide, camera.width), std::min(y + kTileSide, camera.height)};
        TileBlender blender(view, area, result.image, each[g]);
        result.stops[g] = std::max(result.stops[g], blender.run(sequences.places[g]));
      }
    }
  });
  for (const OrderCounts& one : each) result.counts.blends += one.blends, result.counts.late += one.late;
  return result;
}

}  // namespace pipegs
