// SPDX-License-Identifier: Apache-2.0
// less.cpp: see less.hpp.
#include "sim/studies/explore/less.hpp"

#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#include <stb/stb_image_resize.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "cpp_model/float/truth.hpp"
#include "scenes/own_failure.hpp"

namespace pipegs {

std::vector<float> contributions(const Scene& scene, const std::vector<Camera>& cameras, double near_plane,
                                 const std::function<void(double)>& progress) {
  std::vector<float> largest(scene.gaussians.size());
  const auto count = static_cast<double>(cameras.size());
  for (size_t i = 0; i < cameras.size(); ++i) {
    TruthOptions options{.near_plane = near_plane, .progress = [&](double share) {
                           if (progress) progress((static_cast<double>(i) + share) / count);
                         }};
    options.largest_weight = &largest;
    render_truth(scene, cameras[i], options);
  }
  return largest;
}

size_t left_out(size_t count, double without) {
  return static_cast<size_t>(std::llround(without * static_cast<double>(count)));
}

Scene without_least(const Scene& scene, const std::vector<float>& contributions, double without) {
  const size_t count = scene.gaussians.size(), rest = 3 * static_cast<size_t>(sh_rest_count(scene.sh_degree));
  std::vector<uint32_t> order(count);
  for (size_t i = 0; i < count; ++i) order[i] = static_cast<uint32_t>(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](uint32_t a, uint32_t b) { return contributions[a] < contributions[b]; });
  const size_t gone = left_out(count, without);
  std::vector<bool> stays(count, true);
  for (size_t i = 0; i < gone; ++i) stays[order[i]] = false;

  Scene result{.name = scene.name,
               .sh_degree = scene.sh_degree,
               .gaussians = {},
               .sh_rest = {},
               .antialiased = scene.antialiased};
  result.gaussians.reserve(count - gone);
  result.sh_rest.reserve((count - gone) * rest);
  for (size_t i = 0; i < count; ++i) {
    if (!stays[i]) continue;
    result.gaussians.push_back(scene.gaussians[i]);
    const auto from = scene.sh_rest.begin() + static_cast<std::ptrdiff_t>(i * rest);
    result.sh_rest.insert(result.sh_rest.end(), from, from + static_cast<std::ptrdiff_t>(rest));
  }
  return result;
}

Image resampled(const Image& image, int width, int height) {
  std::vector<float> in(3 * image.rgb.size());
  for (size_t i = 0; i < image.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) in[3 * i + static_cast<size_t>(c)] = static_cast<float>(image.rgb[i][c]);
  }
  Image result(width, height);
  std::vector<float> out(3 * result.rgb.size());
  if (stbir_resize_float_generic(in.data(), image.width, image.height, 0, out.data(), width, height, 0, 3,
                                 STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_CLAMP, STBIR_FILTER_CATMULLROM,
                                 STBIR_COLORSPACE_LINEAR, nullptr) == 0)
    throw OwnFailure("no memory to resample a picture");
  for (size_t i = 0; i < result.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) result.rgb[i][c] = static_cast<double>(out[3 * i + static_cast<size_t>(c)]);
  }
  return result;
}

}  // namespace pipegs
