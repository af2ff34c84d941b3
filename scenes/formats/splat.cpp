// SPDX-License-Identifier: Apache-2.0
// splat: antimatter15's .splat, 32 bytes a Gaussian and nothing else; SH degree 0.
//
// Layout  float position[3], float scale[3] (linear), uint8 R G B A, uint8 quaternion w x y z.
// Rule    The file has no signature: its size is a multiple of 32, and its first Gaussians must be such as a scene has.
//         Writers store trunc(128 q + 128); the viewer that the format comes from reads (v - 128) / 128, others
//         v / 127.5 - 1. The second lies in the middle of the step (errors half as large), and is read here.
// Errors  InputError of a size that is no multiple of 32.
#include <fmt/format.h>

#include <algorithm>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kRow = 32, kLooked = 256;
constexpr float kFarthest = 1e9f;  // of a position and a scale that a scene has: other bytes as floats are any number

bool plausible(const std::uint8_t* row) {
  for (int k = 0; k < 3; ++k) {
    const auto position = load<float>(row + 4 * k), scale = load<float>(row + 12 + 4 * k);
    if (!(std::abs(position) < kFarthest) || !(scale >= 0 && scale < kFarthest)) return false;
  }
  return std::any_of(row + 24, row + kRow, [](std::uint8_t v) { return v != 0; });
}

}  // namespace

bool looks_like_splat(const InputFile& file) {
  if (file.size() == 0 || file.size() % kRow != 0) return false;
  const std::uint64_t looked = std::min(file.size() / kRow, kLooked);
  const std::uint8_t* rows = file.rows(0, looked, kRow, "splat");
  for (std::uint64_t i = 0; i < looked; ++i) {
    if (!plausible(rows + i * kRow)) return false;
  }
  return true;
}

Scene read_splat(const InputFile& file, SceneFormat& format) {
  format.name = ".splat";
  format.axes = "RDF";
  format.fields = {{"position", "float32"},
                   {"scale", "float32, linear"},
                   {"rotation", "4 x 8 bits"},
                   {"opacity", "8 bits"},
                   {"colour", "3 x 8 bits, cut to 0 .. 1"},
                   {"SH", "none: colours do not change with the view"}};
  const std::uint64_t count = file.size() / kRow;
  file.check_end(count * kRow);
  const std::uint8_t* row = file.rows(0, count, kRow, "splats");
  Scene scene = scene_of_size(static_cast<std::size_t>(count), 0);
  for (Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k) {
      g.mean[k] = load<float>(row + 4 * k);
      g.log_scale[k] = log_of(load<float>(row + 12 + 4 * k));
      g.sh_dc[k] = dc_of(row[24 + k] / 255.0);
    }
    g.opacity_logit = logit_of(row[27] / 255.0);
    for (int k = 0; k < 4; ++k) g.rotation[k] = static_cast<float>(row[28 + k] / 127.5 - 1);
    row += kRow;
  }
  return scene;
}

}  // namespace pipegs
