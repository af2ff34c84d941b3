// SPDX-License-Identifier: Apache-2.0
// drawing: see drawing.hpp.
//
// Idea    Forward: splats and their lists (raster/splats.hpp), then the tiles. Backward: the tiles from the end of
//         their lists (raster/tile.hpp), each pair into its own place; then every splat sums its pairs and is taken
//         back to its Gaussian (raster/back_project.hpp). So no two threads ever add to one number.
#include "sim/studies/train/gradient/drawing.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "cpp_model/float/parallel.hpp"
#include "sim/studies/train/gradient/raster/back_project.hpp"
#include "sim/studies/train/gradient/raster/splats.hpp"
#include "sim/studies/train/gradient/raster/tile.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kBlock = 1024;  // splats that a thread takes back at a time

void check(const Parameters& parameters, const Camera& camera) {
  check_consistent(parameters);
  if (camera.width < 1 || camera.height < 1 || camera.width > kMaxImageSide || camera.height > kMaxImageSide) {
    throw std::invalid_argument("drawing: a camera of " + std::to_string(camera.width) + "x" +
                                std::to_string(camera.height) + " pixels");
  }
}

}  // namespace

template <class Scalar>
struct BasicDrawing<Scalar>::State {
  const Parameters& parameters;
  Camera camera;
  DrawOptions options;
  DrawnSplats<Scalar> splats;
  std::vector<TileState<Scalar>> tiles;
  std::vector<Color> picture;

  TileArea area(std::size_t tile) const {
    const int x = static_cast<int>(tile) % splats.columns * kTile, y = static_cast<int>(tile) / splats.columns * kTile;
    return {x, y, std::min(kTile, camera.width - x), std::min(kTile, camera.height - y)};
  }
  // Calls action(place in the tile's row, row of the tile, pixel) for the pixels of a tile.
  template <class Action>
  void for_each_pixel(const TileArea& area, Action&& action) const {
    for (int y = 0; y < area.rows; ++y) {
      for (int x = 0; x < area.columns; ++x) {
        action(x, y,
               static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(camera.width) +
                   static_cast<std::size_t>(area.x + x));
      }
    }
  }

  void draw(std::size_t tile) {
    TileColors<Scalar> colors;
    blend_tile<Scalar>(area(tile), splats.splats, splats.list(tile), tiles[tile], colors);
    const Color background(options.background);
    for_each_pixel(area(tile), [&](int x, int y, std::size_t pixel) {
      const Color color(colors.rgb[0][y][x], colors.rgb[1][y][x], colors.rgb[2][y][x]);
      picture[pixel] = color + tiles[tile].transmittance[y][x] * background;
    });
  }

  void take_back(std::size_t tile, const std::vector<Color>& d_picture, PairSums<Scalar>* sums) const {
    TileColors<Scalar> gradient = {};
    for_each_pixel(area(tile), [&](int x, int y, std::size_t pixel) {
      for (int channel = 0; channel < 3; ++channel) gradient.rgb[channel][y][x] = d_picture[pixel][channel];
    });
    unblend_tile<Scalar>(area(tile), splats.splats, splats.list(tile), tiles[tile], gradient, options.background, sums);
  }

  void take_back(const DrawnSplat<Scalar>& splat, const PairSums<Scalar>* sums, Gradient& gradient, Seen* seen) const {
    SplatSums total;
    for (std::uint32_t n = splat.pair; n < splat.pair + splat.pairs(); ++n) {
      for (int k = 0; k < 6; ++k) total.power[k] += sums[n].power[k];
      for (int channel = 0; channel < 3; ++channel) total.color[channel] += sums[n].color[channel];
    }
    const SplatView view{{splat.rgb[0] > 0, splat.rgb[1] > 0, splat.rgb[2] > 0}, options.sh_degree};
    const SeenSplat found = back_project(parameters, splat.index, camera, view, total, gradient);
    if (seen == nullptr) return;
    seen->mean_gradient[splat.index] = static_cast<float>(found.mean_gradient);
    seen->radius[splat.index] = static_cast<float>(found.radius);
  }
};

template <class Scalar>
BasicDrawing<Scalar>::BasicDrawing(const Parameters& parameters, const Camera& camera, const DrawOptions& options) {
  check(parameters, camera);
  state_ = std::make_unique<State>(State{parameters, camera, options, {}, {}, {}});
  state_->splats = splats_of<Scalar>(parameters, camera, options);
  state_->tiles.resize(state_->splats.first.size() - 1);
  state_->picture.resize(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  parallel_for(state_->tiles.size(), options.threads, [&](std::size_t tile) { state_->draw(tile); });
}

template <class Scalar>
BasicDrawing<Scalar>::~BasicDrawing() = default;
template <class Scalar>
BasicDrawing<Scalar>::BasicDrawing(BasicDrawing&&) noexcept = default;

template <class Scalar>
int BasicDrawing<Scalar>::width() const {
  return state_->camera.width;
}
template <class Scalar>
int BasicDrawing<Scalar>::height() const {
  return state_->camera.height;
}
template <class Scalar>
const std::vector<typename BasicDrawing<Scalar>::Color>& BasicDrawing<Scalar>::picture() const {
  return state_->picture;
}

template <class Scalar>
void BasicDrawing<Scalar>::backward(const std::vector<Color>& d_picture, Gradient& sum, Seen* seen) const {
  check_same_shape(state_->parameters, sum);
  if (d_picture.size() != state_->picture.size()) {
    throw std::invalid_argument("drawing: a gradient of " + std::to_string(d_picture.size()) + " pixels, expected " +
                                std::to_string(state_->picture.size()));
  }
  if (seen != nullptr) {
    seen->mean_gradient.assign(sum.size(), 0);
    seen->radius.assign(sum.size(), 0);
  }
  const auto sums = std::make_unique_for_overwrite<PairSums<Scalar>[]>(state_->splats.lists.size());
  const unsigned threads = state_->options.threads;
  parallel_for(state_->tiles.size(), threads,
               [&](std::size_t tile) { state_->take_back(tile, d_picture, sums.get()); });
  const auto& splats = state_->splats.splats;
  parallel_for((splats.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(splats.size(), (block + 1) * kBlock); ++i) {
      state_->take_back(splats[i], sums.get(), sum, seen);
    }
  });
}

template class BasicDrawing<float>;
template class BasicDrawing<double>;

}  // namespace pipegs
