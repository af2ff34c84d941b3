// SPDX-License-Identifier: Apache-2.0
// splat: antimatter15's .splat, 32 bytes a Gaussian and nothing else; SH degree 0.
//
// Layout  float position[3], float scale[3] (linear), uint8 R G B A, uint8 quaternion w x y z.
// Rule    The file has no signature: its first Gaussians must be such as a scene has. Up to half of them may hold what
//         is no number (they are culled) or nothing, scales may be logarithms, and a part of a row may follow the last.
//         Text and whole numbers are no floats of a scene. Where few quaternions are of unit length that is said.
//         Writers store trunc(128 q + 128); the viewer that the format comes from reads (v - 128) / 128, others
//         v / 127.5 - 1. The second lies in the middle of the step (errors half as large), and is read here.
#include <fmt/format.h>

#include <algorithm>
#include <glm/glm.hpp>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kRow = 32, kLooked = 256;
constexpr float kLeastLog = -40;   // a scale below 0 is a logarithm
constexpr float kFarthest = 1e9f;  // of a position and a scale that a scene has: other bytes as floats are any number
constexpr float kLeast = 1e-30f;   // but for 0; whole numbers of 32 bits, and text of 16 bits a letter, are less
constexpr double kUnit = 0.05;     // off it, by 8 bits and the ways to read them

enum class Row { kPlausible, kEmpty, kOther };

Row looked_at(const std::uint8_t* row) {
  if (std::all_of(row, row + kRow, is_printable)) return Row::kOther;
  bool number = true;
  for (int k = 0; k < 3; ++k) {
    const auto position = load<float>(row + 4 * k), scale = load<float>(row + 12 + 4 * k);
    const bool finite = std::isfinite(position) && std::isfinite(scale);
    number = number && finite;
    const auto tiny = [](float v) { return v != 0 && std::abs(v) < kLeast; };
    const bool far = std::abs(position) >= kFarthest || scale >= kFarthest || scale < kLeastLog;
    if (finite && (far || tiny(position) || tiny(scale))) return Row::kOther;
  }
  const bool nothing = std::all_of(row + 24, row + kRow, [](std::uint8_t v) { return v == 0; });
  return number && !nothing ? Row::kPlausible : Row::kEmpty;
}

// Floats of another file have one in eight, by chance.
void check_rotations(const std::uint8_t* rows, std::uint64_t count, SceneFormat& format) {
  std::uint64_t units = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    glm::dvec4 q;
    for (int k = 0; k < 4; ++k) q[k] = rows[kRow * i + 28 + static_cast<std::uint64_t>(k)] / 127.5 - 1;
    units += std::abs(glm::length(q) - 1) < kUnit;
  }
  if (4 * units >= count) return;
  format.findings.emplace_back(
      "guessed", fmt::format("nothing says that this is a .splat, and {} of the first {} quaternions are not of unit "
                             "length: it may be another file",
                             count - units, count));
}

}  // namespace

bool looks_like_splat(const InputFile& file) {
  if (file.size() < kRow) return false;
  const std::uint64_t looked = std::min(file.size() / kRow, kLooked);
  const std::uint8_t* rows = file.rows(0, looked, kRow, "splat");
  std::uint64_t empty = 0;
  for (std::uint64_t i = 0; i < looked; ++i) {
    const Row row = looked_at(rows + i * kRow);
    if (row == Row::kOther) return false;
    empty += row == Row::kEmpty;
  }
  return 2 * empty <= looked && empty < looked;
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
  tell_behind(file.behind(count * kRow), format);
  const std::uint8_t* row = file.rows(0, count, kRow, "splats");
  check_rotations(row, std::min(count, kLooked), format);
  Scene scene = scene_of_size(static_cast<std::size_t>(count), 0);
  for (Gaussian& g : scene.gaussians) {
    for (int k = 0; k < 3; ++k) {
      g.mean[k] = load<float>(row + 4 * k);
      g.log_scale[k] = load<float>(row + 12 + 4 * k);
      g.sh_dc[k] = dc_of(row[24 + k] / 255.0);
    }
    g.opacity_logit = logit_of(row[27] / 255.0);
    for (int k = 0; k < 4; ++k) g.rotation[k] = static_cast<float>(row[28 + k] / 127.5 - 1);
    row += kRow;
  }
  take_linear_scales(scene, format);
  return scene;
}

}  // namespace pipegs
