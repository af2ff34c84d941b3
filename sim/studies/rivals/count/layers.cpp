// SPDX-License-Identifier: Apache-2.0
// layers.cpp: see layers.hpp.
//
// Idea    A Gaussian's slab is that of its mean alone, so a list is the sum of its layers' lists, whatever the order.
#include "sim/studies/rivals/count/layers.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>

#include "cpp_model/float/parallel.hpp"
#include "sim/studies/rivals/count/walk.hpp"

namespace pipegs {
namespace {

constexpr double kOutside = 0.02;  // of the means on either side of the grid's box
constexpr double kMargin = 1.001;  // of the box, so that its largest mean lies in the last cell
constexpr size_t kBlock = 2048;    // Gaussians that a thread takes at a time
constexpr int kRegion = 8;         // side of a region, pixels
constexpr uint64_t kTurn = 8;      // cycles of a stage that shares its multipliers

// The grid along one axis.
class Slabs {
 public:
  Slabs(std::vector<double> means, int cells) : cells_(cells) {
    if (means.empty()) return;
    const auto percentile = [&](double share) {
      const auto at = means.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(means.size() - 1));
      std::nth_element(means.begin(), at, means.end());
      return *at;
    };
    const double low = percentile(kOutside), high = percentile(1 - kOutside);
    const double size = std::max((high - low) * kMargin, std::numeric_limits<double>::min());
    low_ = (low + high - size) / 2;
    width_ = size / cells;
  }
  int at(double value) const {
    return static_cast<int>(std::clamp(std::floor((value - low_) / width_), 0.0, cells_ - 1.0));
  }

 private:
  int cells_;
  double low_ = 0, width_ = 1;
};

int principal_axis(const Camera& camera) {
  const glm::dvec3 forward = glm::abs(glm::transpose(camera.world_to_camera) * glm::dvec3(0, 0, 1));
  return forward.x >= forward.y && forward.x >= forward.z ? 0 : forward.y >= forward.z ? 1 : 2;
}

// Place of each slab in the walk: own, own + 1, own - 1, own + 2 ..., without those outside.
std::vector<uint8_t> walk_places(int own, int cells) {
  std::vector<uint8_t> place(static_cast<size_t>(cells));
  uint8_t next = 0;
  for (int step = 0; step < 2 * cells; ++step) {
    const int slab = step % 2 != 0 ? own + (step + 1) / 2 : own - step / 2;
    if (slab >= 0 && slab < cells) place[static_cast<size_t>(slab)] = next++;
  }
  return place;
}

ListCounts empty_lists(const Camera& camera, int side) {
  const TileGrid grid(camera, side);
  ListCounts lists{.side = side, .columns = grid.columns, .rows = grid.rows};
  for (const Cover cover : kAllCovers) lists.lengths[cover].assign(grid.count(), 0);
  return lists;
}

// The windows that a Gaussian's box of alpha >= 1/255 touches. Called side by side.
void count_windows(const SeenGaussian& s, const TileGrid& grid, std::vector<WindowCounts>& windows) {
  if (s.reach.empty()) return;
  const int in_window = grid.side / kRegion;
  const PixelRect box = {s.reach.x0 / kRegion, s.reach.y0 / kRegion, (s.reach.x1 - 1) / kRegion + 1,
                         (s.reach.y1 - 1) / kRegion + 1};
  for (int y = box.y0 / in_window; y * in_window < box.y1; ++y) {
    for (int x = box.x0 / in_window; x * in_window < box.x1; ++x) {
      const int wide = std::min(box.x1, (x + 1) * in_window) - std::max(box.x0, x * in_window),
                high = std::min(box.y1, (y + 1) * in_window) - std::max(box.y0, y * in_window);
      const auto regions = static_cast<uint64_t>(wide * high);
      WindowCounts& window = windows[grid.at(x, y)];
      std::atomic_ref(window.pairs).fetch_add(1, std::memory_order_relaxed);
      std::atomic_ref(window.regions).fetch_add(regions, std::memory_order_relaxed);
      std::atomic_ref(window.turns).fetch_add(std::max(regions, kTurn), std::memory_order_relaxed);
    }
  }
}

void count_lists_of(const SeenScene& seen, const std::vector<uint8_t>& layer, const Camera& camera,
                    const CountOptions& options, std::vector<LayerCounts>& layers) {
  const TileGrid windows(camera, kLayerSides[1]);
  for (LayerCounts& counts : layers) {
    for (size_t i = 0; i < kLayerSides.size(); ++i) counts.lists[i] = empty_lists(camera, kLayerSides[i]);
    counts.windows.assign(windows.count(), {});
  }
  const size_t count = seen.gaussians.size();
  parallel_for((count + kBlock - 1) / kBlock, options.threads, [&](size_t b) {
    std::vector<PixelSpan> spans;
    TileSet set;
    for (size_t place = b * kBlock; place < std::min(count, (b + 1) * kBlock); ++place) {
      const SeenGaussian& s = seen.gaussians[place];
      LayerCounts& counts = layers[layer[place]];
      reached_spans(s, spans);
      for (ListCounts& lists : counts.lists) {
        const TileGrid grid(camera, lists.side);
        for (const Cover cover : kAllCovers) {
          covered(s, spans, grid, cover, set);
          set.for_each([&](int x, int y) {
            std::atomic_ref(lists.lengths[cover][grid.at(x, y)]).fetch_add(1, std::memory_order_relaxed);
          });
          if (lists.side == kTileSide && set.count() > 0)
            std::atomic_ref(counts.listed[cover]).fetch_add(1, std::memory_order_relaxed);
        }
      }
      count_windows(s, windows, counts.windows);
    }
  });
}

}  // namespace

GridCounts count_layers(const Scene& scene, const SeenScene& seen, const TileLists& lists, int cells,
                        const Camera& camera, const CountOptions& options) {
  GridCounts grid{.cells = cells, .axis = principal_axis(camera)};
  std::vector<double> valid, drawn;  // means along the axis
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) continue;
    valid.push_back(gaussian.mean[grid.axis]);
    if (gaussian.opacity >= kMinAlpha) drawn.push_back(gaussian.mean[grid.axis]);
  }
  const Slabs slabs(std::move(drawn), cells);
  const std::vector<uint8_t> place = walk_places(slabs.at(camera.position[grid.axis]), cells);
  const auto place_of = [&](double mean) { return place[static_cast<size_t>(slabs.at(mean))]; };
  grid.layers.resize(static_cast<size_t>(cells));
  for (size_t slab = 0; slab < place.size(); ++slab) grid.layers[place[slab]].slab = static_cast<int>(slab);
  for (const double mean : valid) ++grid.layers[place_of(mean)].valid;
  std::vector<uint8_t> layer;
  for (const SeenGaussian& s : seen.gaussians) layer.push_back(place_of(scene.gaussians[s.index].mean[grid.axis]));
  count_lists_of(seen, layer, camera, options, grid.layers);
  count_layer_walks(seen, lists, layer, camera, options, grid.layers);
  return grid;
}

}  // namespace pipegs
