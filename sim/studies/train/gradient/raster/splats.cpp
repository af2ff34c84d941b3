// SPDX-License-Identifier: Apache-2.0
// splats: see splats.hpp.
#include "sim/studies/train/gradient/raster/splats.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "cpp_model/float/parallel.hpp"
#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBlock = 512;  // Gaussians that a thread projects at a time: few, so that the heap reuses memory

// The layer of each Gaussian along the camera's principal axis.
struct Layers {
  const LayerGrid* grid;
  int axis = 0;
  std::vector<int> of_slab;

  Layers(const LayerGrid* layer_grid, const Camera& camera) : grid(layer_grid), axis(principal_axis(camera)) {
    if (grid != nullptr) of_slab = layers_of_slabs(*grid, camera);
  }
  std::uint16_t of(const glm::dvec3& mean) const {
    if (grid == nullptr) return 0;
    return static_cast<std::uint16_t>(of_slab[static_cast<std::size_t>(grid->slab(axis, mean[axis]))]);
  }
};

template <class Scalar>
std::optional<DrawnSplat<Scalar>> splat_of(const Parameters& parameters, std::size_t i, const Camera& camera,
                                           const ProjectionOptions& options, const Layers& layers) {
  // The truth's own test of the near plane, before all that costs time.
  const glm::dvec3 offset = glm::dvec3(parameters.mean[i]) - camera.position;
  if (!((camera.world_to_camera * offset).z > options.near_plane)) return std::nullopt;
  ActivatedGaussian gaussian;
  if (activate(parameters, i, gaussian) != Cull::kNone) return std::nullopt;
  const TruthProjection p =
      project_truth(gaussian, parameters.sh_dc[i], sh_rest_of(parameters, i), parameters.sh_degree, camera, options);
  const PixelRect rect = footprint(p, camera, Semantics::kExact);
  if (rect.empty()) return std::nullopt;
  const auto tile = [](int pixel) { return static_cast<std::uint16_t>(pixel / kTile); };
  DrawnSplat<Scalar> splat;
  splat.mean = p.mean;
  splat.depth = p.depth;
  splat.slope = static_cast<Scalar>(p.b / p.c);
  splat.steep = static_cast<Scalar>(std::sqrt(std::numbers::log2e / 2 * p.c / p.det));
  splat.tall = static_cast<Scalar>(std::numbers::log2e / 2 / p.c);
  splat.log2_opacity = static_cast<Scalar>(std::log2(p.opacity));
  for (int channel = 0; channel < 3; ++channel) splat.rgb[channel] = static_cast<Scalar>(p.rgb[channel]);
  splat.index = static_cast<std::uint32_t>(i);
  splat.pair = 0;
  splat.layer = layers.of(gaussian.mean);
  splat.x0 = tile(rect.x0), splat.y0 = tile(rect.y0);
  splat.x1 = tile(rect.x1 + kTile - 1), splat.y1 = tile(rect.y1 + kTile - 1);
  return splat;
}

// Gives each splat its pairs; how many there are.
template <class Scalar>
std::uint32_t number_pairs(std::vector<DrawnSplat<Scalar>>& splats) {
  std::uint64_t pairs = 0;
  for (DrawnSplat<Scalar>& splat : splats) {
    splat.pair = static_cast<std::uint32_t>(pairs);
    pairs += splat.pairs();
    if (pairs > std::numeric_limits<std::uint32_t>::max()) {
      throw std::invalid_argument("drawing: Gaussians touch more than 2^32 tiles");
    }
  }
  return static_cast<std::uint32_t>(pairs);
}

// Places of the splats by layer, depth and index.
template <class Scalar>
std::vector<std::uint32_t> sorted(const std::vector<DrawnSplat<Scalar>>& splats) {
  struct Turn {
    double depth;
    std::uint32_t layer, place;
    bool operator<(const Turn& o) const {
      return layer != o.layer ? layer < o.layer : depth != o.depth ? depth < o.depth : place < o.place;
    }
  };
  std::vector<Turn> turns(splats.size());
  for (std::size_t i = 0; i < splats.size(); ++i) {
    turns[i] = {splats[i].depth, splats[i].layer, static_cast<std::uint32_t>(i)};
  }
  std::sort(turns.begin(), turns.end());
  std::vector<std::uint32_t> order(splats.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = turns[i].place;
  return order;
}

// Calls action(tile, number of the pair) for the tiles of a splat, in the order of its pairs.
template <class Scalar, class Action>
void for_each_tile(const DrawnSplat<Scalar>& splat, int columns, Action&& action) {
  std::uint32_t pair = splat.pair;
  for (int y = splat.y0; y < splat.y1; ++y) {
    for (int x = splat.x0; x < splat.x1; ++x) action(static_cast<std::size_t>(y * columns + x), pair++);
  }
}

template <class Scalar>
void fill_lists(DrawnSplats<Scalar>& all) {
  const std::uint32_t pairs = number_pairs(all.splats);
  const std::vector<std::uint32_t> order = sorted(all.splats);
  all.first.assign(static_cast<std::size_t>(all.columns) * static_cast<std::size_t>(all.rows) + 1, 0);
  for (const DrawnSplat<Scalar>& splat : all.splats) {
    for_each_tile(splat, all.columns, [&](std::size_t tile, std::uint32_t) { ++all.first[tile + 1]; });
  }
  for (std::size_t tile = 1; tile < all.first.size(); ++tile) all.first[tile] += all.first[tile - 1];
  all.lists.resize(pairs);
  std::vector<std::size_t> next(all.first.begin(), all.first.end() - 1);
  for (const std::uint32_t place : order) {
    for_each_tile(all.splats[place], all.columns, [&](std::size_t tile, std::uint32_t pair) {
      all.lists[next[tile]++] = {place, pair};
    });
  }
}

}  // namespace

template <class Scalar>
DrawnSplats<Scalar> splats_of(const Parameters& parameters, const Camera& camera, const DrawOptions& options) {
  const ProjectionOptions projection{Semantics::kExact, options.near_plane, false, options.sh_degree};
  const Layers layers(options.layers, camera);
  const std::size_t count = parameters.size();
  std::vector<std::vector<DrawnSplat<Scalar>>> blocks((count + kBlock - 1) / kBlock);
  parallel_for(blocks.size(), options.threads, [&](std::size_t b) {
    blocks[b].reserve(kBlock);
    for (std::size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i) {
      if (const auto splat = splat_of<Scalar>(parameters, i, camera, projection, layers)) blocks[b].push_back(*splat);
    }
  });
  DrawnSplats<Scalar> all;
  all.columns = (camera.width + kTile - 1) / kTile;
  all.rows = (camera.height + kTile - 1) / kTile;
  std::size_t seen = 0;
  for (const auto& block : blocks) seen += block.size();
  all.splats.reserve(seen);
  for (const auto& block : blocks) all.splats.insert(all.splats.end(), block.begin(), block.end());
  fill_lists(all);
  return all;
}

template DrawnSplats<float> splats_of<float>(const Parameters&, const Camera&, const DrawOptions&);
template DrawnSplats<double> splats_of<double>(const Parameters&, const Camera&, const DrawOptions&);

}  // namespace pipegs
