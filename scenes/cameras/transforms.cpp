// SPDX-License-Identifier: Apache-2.0
// transforms: transforms.json of nerfstudio, instant-ngp and Blender's NeRF scenes.
//
// Layout  "frames" hold "transform_matrix", camera-to-world with the axes of OpenGL: x right, y up, z backward, so the
//         second and third column are negated. fl_x, fl_y, cx, cy, w, h stand above the frames or in each; the centre
//         of pixel i is at i + 0.5, so half a pixel less here.
// Idea    Without fl_x the angle says it: fl_x = w / 2 / tan(camera_angle_x / 2). Blender writes no size: it is that of
//         the option, or of the picture beside the file. nerfstudio's applied_transform A turned COLMAP's world, in
//         which the scene lies: camera-to-world = A^-1 * transform_matrix. instant-ngp's scale and offset are for its
//         own use, the matrices are without them.
// Rule    Lenses that bend rays are refused, unless the distortion is to be ignored; fisheyes always.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "scenes/cameras/entry.hpp"
#include "scenes/cameras/forms.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

// The upper three rows of a matrix, by columns.
struct Placement {
  glm::dmat3 axes{1};
  glm::dvec3 origin{0};
};

Placement read_matrix(const CameraEntry& entry, const std::string& field, std::size_t fewest_rows) {
  const Json& value = entry.at(field);
  const bool rows = value.is_array() && value.size() >= fewest_rows && value.size() <= 4;
  if (!rows ||
      !std::all_of(value.begin(), value.end(), [](const Json& row) { return row.is_array() && row.size() == 4; })) {
    entry.fail(field, fmt::format("found {}, expected {}4 rows of 4 numbers", quote(json_text(value)),
                                  fewest_rows < 4 ? "3 or " : ""));
  }
  Placement m;
  for (std::size_t r = 0; r < value.size(); ++r) {
    for (std::size_t c = 0; c < 4; ++c) {
      double number = 0;
      try {
        number = json_real(value[r][c]);
      } catch (const NumberError& error) { entry.fail(fmt::format("{} row {}", field, r), error.what()); }
      const int row = static_cast<int>(r), column = static_cast<int>(c);
      if (r == 3 && number != (c == 3 ? 1 : 0))
        entry.fail(fmt::format("{} row 3", field), fmt::format("found {:g}, expected 0, 0, 0, 1", number));
      if (r < 3) (c < 3 ? m.axes[column][row] : m.origin[row]) = number;
    }
  }
  return m;
}

std::optional<Placement> read_applied(const CameraEntry& top) {
  if (const double scale = top.number_or("applied_scale", 1); scale != 1)
    top.fail("applied_scale",
             fmt::format("found {:g}, expected 1: the scene has another size than its cameras", scale));
  if (top.find("applied_transform") == nullptr) return std::nullopt;
  const Placement applied = read_matrix(top, "applied_transform", 3);
  // A mirror in it and in the matrices is none in the cameras.
  glm::dmat3 turned = applied.axes;
  if (glm::determinant(turned) < 0) turned = -turned;
  checked_rotation(top, "applied_transform", turned);
  return applied;
}

void check_lens(const CameraEntry& entry, const CameraReading& reading) {
  static const char* const kBent = "; take the distortion out with colmap image_undistorter";
  const std::string model = entry.text_or("camera_model", "PINHOLE");
  const char* const pinholes[] = {"PINHOLE", "SIMPLE_PINHOLE", "OPENCV", "FULL_OPENCV", "SIMPLE_RADIAL", "RADIAL"};
  if (std::find(std::begin(pinholes), std::end(pinholes), model) == std::end(pinholes))
    entry.fail("camera_model", fmt::format("found {}, expected PINHOLE{}", quote(model), kBent));
  if (const Json* fisheye = entry.find("is_fisheye"); fisheye != nullptr && *fisheye != false)
    entry.fail("is_fisheye", fmt::format("found {}, expected false{}", quote(json_text(*fisheye)), kBent));
  for (const char* field : {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"}) {
    const double bent = entry.number_or(field, 0);
    if (bent != 0 && !reading.ignore_distortion)
      entry.fail(field, fmt::format("found {:g}, expected 0{}, or --ignore-distortion", bent, kBent));
  }
}

// Of the file, of the option, or of the picture.
void find_size(const CameraEntry& entry, const CameraReading& reading, Camera& camera) {
  if (entry.find("w") != nullptr || entry.find("h") != nullptr) {
    camera.width = entry.integer("w", 1, kMaxImageSide);
    camera.height = entry.integer("h", 1, kMaxImageSide);
    return;
  }
  if (reading.width == 0 && entry.find("file_path") != nullptr) {
    fs::path picture = fs::path(entry.file).parent_path() / entry.text_or("file_path", "");
    if (!picture.has_extension()) picture += ".png";
    if (png_size(picture, camera.width, camera.height)) return;
  }
  take_size(entry, reading, camera);
}

double focal(const CameraEntry& entry, const std::string& angle_field, int pixels) {
  const double angle = entry.number(angle_field, {.low = 0, .high = 3.1415, .above = true});
  return pixels / (2 * std::tan(angle / 2));
}

Camera read_frame(const CameraEntry& entry, const std::optional<Placement>& applied, const CameraReading& reading) {
  entry.must_be_object();
  check_lens(entry, reading);
  Camera camera;
  find_size(entry, reading, camera);
  const bool angle_x = entry.find("fl_x") == nullptr && entry.find("camera_angle_x") != nullptr;
  camera.fx = angle_x ? focal(entry, "camera_angle_x", camera.width) : entry.number("fl_x", kPositive);
  if (entry.find("fl_y") != nullptr) camera.fy = entry.number("fl_y", kPositive);
  else camera.fy = entry.find("camera_angle_y") != nullptr ? focal(entry, "camera_angle_y", camera.height) : camera.fx;
  camera.cx = entry.number_or("cx", camera.width / 2.0) - 0.5;
  camera.cy = entry.number_or("cy", camera.height / 2.0) - 0.5;
  Placement m = read_matrix(entry, "transform_matrix", 3);
  if (applied) {
    const glm::dmat3 undo = glm::inverse(applied->axes);
    m = {undo * m.axes, undo * (m.origin - applied->origin)};
  }
  camera.position = m.origin;
  camera.world_to_camera =
      checked_rotation(entry, "transform_matrix", glm::transpose(glm::dmat3(m.axes[0], -m.axes[1], -m.axes[2])));
  return camera;
}

}  // namespace

std::vector<Camera> transforms_cameras(const std::string& file, const Json& json, const CameraReading& reading) {
  const std::optional<Placement> applied = read_applied({file, "top level", json});
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < json["frames"].size(); ++i) {
    const CameraEntry entry{file, fmt::format("frame {}", i), json["frames"][i], &json};
    cameras.push_back(read_frame(entry, applied, reading));
    cameras.back().id = static_cast<int>(i);
    cameras.back().name = entry.text_or("file_path", fmt::format("view_{}", i));
  }
  return cameras;
}

}  // namespace pipegs
