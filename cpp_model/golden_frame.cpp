// SPDX-License-Identifier: Apache-2.0
// golden_frame.cpp: windows of the golden model as pictures: see golden.hpp.
#include <algorithm>
#include <cmath>
#include <mutex>

#include "cpp_model/aov_image.hpp"
#include "cpp_model/eyes.hpp"
#include "cpp_model/float/parallel.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/regions.hpp"
#include "cpp_model/ru/ru_resolve.hpp"

namespace pipegs {
namespace {

// The colour that memory holds of a pixel.
glm::dvec3 shown(const Config& config, const PixelState& pixel) {
  if (config.pixel_w == 64)
    return glm::dvec3(pixel.rgb[0], pixel.rgb[1], pixel.rgb[2]) / std::ldexp(1.0, config.rgb_w - 2);
  const auto code = [&](int channel) { return static_cast<double>(ru_unorm(config, pixel.rgb[channel])); };
  return glm::dvec3(code(0), code(1), code(2)) / static_cast<double>(kMostCode);
}

constexpr uint64_t kUnseen = ~uint64_t{0};

// The place of each Gaussian of the scene by {order, index}; those that no window has seen come last. `order` has the
// index by which the machine orders.
std::vector<uint32_t> ranks(const PackedScene& packed, const std::vector<uint64_t>& order) {
  struct Turn {
    uint64_t order;
    uint32_t index;
  };
  std::vector<Turn> seen;
  seen.reserve(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    if (order[i] != kUnseen) seen.push_back({order[i], static_cast<uint32_t>(i)});
  }
  std::sort(seen.begin(), seen.end(),
            [](const Turn& a, const Turn& b) { return a.order != b.order ? a.order < b.order : a.index < b.index; });
  constexpr uint32_t kNone = ~uint32_t{0};
  std::vector<uint32_t> rank(packed.scene_gaussians, kNone);
  for (size_t i = 0; i < seen.size(); ++i) rank[packed.scene_index(seen[i].index)] = static_cast<uint32_t>(i);
  auto next = static_cast<uint32_t>(seen.size());
  for (uint32_t& one : rank) {
    if (one == kNone) one = next++;
  }
  return rank;
}

GoldenPicture picture_of(const GoldenInput& input) {
  const Frame& frame = input.frame;
  GoldenPicture picture;
  picture.image = Image(static_cast<int>(frame.raster.width), static_cast<int>(frame.raster.height));
  picture.pixels.assign(picture.image.rgb.size(), 0);
  picture.stopped.assign(picture.pixels.size(), 0);
  for (size_t i = 0; i < kAovs.size(); ++i) {
    if (wants_aov(input.packed->config, frame, kAovs[i])) picture.aovs[i].assign(picture.pixels.size(), 0);
  }
  return picture;
}

// A region of a window, in the picture that it is of.
void show_region(const Config& config, const GoldenWindow& window, int region, GoldenPicture& picture) {
  const double t_one = BlendConstants(config).one;
  const auto r = static_cast<size_t>(region);
  for (int p = 0; p < kRegionPixels; ++p) {
    const int x = static_cast<int>(window.x) * config.window + 8 * region_x(config, region) + p % 8,
              y = static_cast<int>(window.y) * config.window + 8 * region_y(config, region) + p / 8;
    if (x >= picture.image.width || y >= picture.image.height) continue;
    const PixelState pixel = window.regions[r].pixel(p);
    const size_t at = picture.image.at(x, y), in_window = r * kRegionPixels + static_cast<size_t>(p);
    picture.image.rgb[at] = shown(config, pixel);
    picture.image.transmittance[at] = pixel.t / t_one;
    picture.image.depth[at] = window.depth[in_window];
    picture.image.blended[at] = window.blended[in_window];
    picture.pixels[at] = ru_resolve(config, pixel);
    picture.stopped[at] = pixel.done ? 1 : 0;
    for (size_t i = 0; i < kAovs.size(); ++i) {
      if (!picture.aovs[i].empty())
        picture.aovs[i][at] =
            static_cast<uint32_t>(ru_aov_word(config, kAovs[i], pixel.t, window.aovs[r][static_cast<size_t>(p)]));
    }
  }
}

}  // namespace

GoldenFrame golden_frame(const GoldenInput& input, const GoldenOptions& options) {
  const Config& config = input.packed->config;
  const Frame& frame = input.frame;
  const uint64_t columns = frame.raster.windows.last_x - frame.raster.windows.first_x + 1,
                 count = columns * (frame.raster.windows.last_y - frame.raster.windows.first_y + 1);
  GoldenFrame result;
  static_cast<GoldenPicture&>(result) = picture_of(input);
  if (config.eyes > 1 && wants_eye(config, frame, 0) && wants_eye(config, frame, 1)) result.second = picture_of(input);
  // (layer, depth key) of each Gaussian; it has the same in every window.
  std::vector<uint64_t> order(std::max(input.packed->scene_gaussians, input.packed->slot_to_index.size()), kUnseen);
  std::mutex mutex;
  uint64_t finished = 0;
  if (config.has_lists()) {
    const GoldenLists& lists = golden_lists(input, options.threads);
    result.work += lists.work;
    result.saturations += lists.saturations;
    result.called += lists.called;
  }

  parallel_for(count, options.threads, [&](size_t i) {
    const GoldenWindow window =
        golden_window(input, frame.raster.windows.first_x + i % columns, frame.raster.windows.first_y + i / columns);
    for (int r = 0; r < config.regions(); ++r) {
      const int eye = region_eye(config, r);
      if (wants_eye(config, frame, eye))
        show_region(config, window, r, eye == 1 && result.second ? *result.second : result);
    }
    const std::lock_guard lock(mutex);
    for (const GoldenLayer& layer : window.layers) {
      for (const GoldenSplat& splat : layer.splats)
        order[splat.splat.index] = static_cast<uint64_t>(layer.ordinal) << 32 | splat.splat.depth;
    }
    result.work += window.work;
    result.saturations += window.saturations;
    result.called += window.called;
    ++finished;
    if (options.progress) options.progress(static_cast<double>(finished) / static_cast<double>(count));
  });

  show_aovs(*input.packed, frame, result.aovs, result.image);
  if (result.second) show_aovs(*input.packed, frame, result.second->aovs, result.second->image);
  result.rank = ranks(*input.packed, order);
  return result;
}

}  // namespace pipegs
