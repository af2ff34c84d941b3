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
#include <array>
#include <cmath>
#include <fstream>
#include <optional>

#include "scenes/cameras/forms.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

// A frame, some of whose fields may stand above all frames.
class Frame {
 public:
  Frame(JsonNode own, const JsonNode& above) : own_(std::move(own)), above_(above) {}

  const JsonNode& own() const { return own_; }
  bool has(const char* field) const { return own_.has(field) || above_.has(field); }
  JsonNode operator[](const char* field) const {
    return (above_.has(field) && !own_.has(field) ? above_ : own_)[field];
  }
  double real_or(const char* field, double otherwise) const { return has(field) ? (*this)[field].real() : otherwise; }
  std::string text_or(const char* field, const std::string& otherwise) const {
    return has(field) ? (*this)[field].text() : otherwise;
  }

 private:
  JsonNode own_;
  const JsonNode& above_;
};

// The upper three rows of a matrix, by columns.
struct Placement {
  glm::dmat3 axes{1};
  glm::dvec3 origin{0};
};

Placement read_matrix(const JsonNode& rows) {
  if (rows.size() != 3 && rows.size() != 4) rows.refuse("3 or 4 rows of 4 numbers");
  Placement m;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<double> row = rows[r].reals(4);
    const int line = static_cast<int>(r);
    if (r == 3 && row != std::vector<double>{0, 0, 0, 1}) rows[r].refuse("0, 0, 0, 1");
    for (int c = 0; r < 3 && c < 4; ++c) (c < 3 ? m.axes[c][line] : m.origin[line]) = row[static_cast<std::size_t>(c)];
  }
  return m;
}

std::optional<Placement> read_applied(const JsonNode& json) {
  if (json.has("applied_scale") && json["applied_scale"].real() != 1)
    json["applied_scale"].refuse("1: the scene has another size than its cameras");
  if (!json.has("applied_transform")) return std::nullopt;
  const Placement applied = read_matrix(json["applied_transform"]);
  // A mirror in it and in the matrices is none in the cameras.
  const bool mirrored = glm::determinant(applied.axes) < 0;
  checked_rotation(json["applied_transform"], mirrored ? -applied.axes : applied.axes);
  return applied;
}

void check_lens(const Frame& frame, const CameraReading& reading) {
  static const std::string kBent = "; take the distortion out with colmap image_undistorter";
  const std::string model = frame.text_or("camera_model", "PINHOLE");
  const char* const pinholes[] = {"PINHOLE", "SIMPLE_PINHOLE", "OPENCV", "FULL_OPENCV", "SIMPLE_RADIAL", "RADIAL"};
  if (std::find(std::begin(pinholes), std::end(pinholes), model) == std::end(pinholes))
    frame["camera_model"].refuse("PINHOLE" + kBent);
  if (frame.has("is_fisheye") && frame["is_fisheye"].boolean()) frame["is_fisheye"].refuse("false" + kBent);
  for (const char* field : {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"}) {
    if (frame.real_or(field, 0) != 0 && !reading.ignore_distortion)
      frame[field].refuse("0" + kBent + ", or --ignore-distortion");
  }
}

// Width and height of a PNG, of its first bytes: 8 of signature, 4 of length, "IHDR", then both, each 4 bytes, the high
// one first. False when there is none at `path`.
bool png_size(const fs::path& path, Camera& camera) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::array<char, 24> head{};
  if (!std::ifstream(path, std::ios::binary).read(head.data(), head.size())) return false;
  const std::string_view text(head.data(), head.size());
  if (!text.starts_with("\x89PNG\r\n\x1a\n") || text.substr(12, 4) != "IHDR") return false;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(text[at + i]);
    return value;
  };
  const std::uint32_t columns = number(16), rows = number(20);
  if (columns < 1 || columns > kMaxImageSide || rows < 1 || rows > kMaxImageSide) return false;
  camera.width = static_cast<int>(columns);
  camera.height = static_cast<int>(rows);
  return true;
}

// Of the file, of the option, or of the picture.
void find_size(const Frame& frame, const CameraReading& reading, Camera& camera) {
  if (frame.has("w") || frame.has("h")) {
    camera.width = frame["w"].whole(1, kMaxImageSide);
    camera.height = frame["h"].whole(1, kMaxImageSide);
    return;
  }
  if (reading.width == 0 && frame.has("file_path")) {
    fs::path picture = fs::path(frame.own().file()).parent_path() / frame["file_path"].text();
    if (!picture.has_extension()) picture += ".png";
    if (png_size(picture, camera)) return;
  }
  take_size(frame.own(), reading, camera);
}

double focal(const JsonNode& angle, int pixels) {
  return pixels / (2 * std::tan(angle.real({.low = 0, .high = 3.1415, .above = true}) / 2));
}

Camera read_frame(const Frame& frame, const std::optional<Placement>& applied, const CameraReading& reading) {
  Placement m = read_matrix(frame["transform_matrix"]);
  check_lens(frame, reading);
  Camera camera;
  find_size(frame, reading, camera);
  const bool angle_x = !frame.has("fl_x") && frame.has("camera_angle_x");
  camera.fx = angle_x ? focal(frame["camera_angle_x"], camera.width) : frame["fl_x"].real(kPositive);
  if (frame.has("fl_y")) camera.fy = frame["fl_y"].real(kPositive);
  else camera.fy = frame.has("camera_angle_y") ? focal(frame["camera_angle_y"], camera.height) : camera.fx;
  camera.cx = frame.real_or("cx", camera.width / 2.0) - 0.5;
  camera.cy = frame.real_or("cy", camera.height / 2.0) - 0.5;
  if (applied) {
    const glm::dmat3 undo = glm::inverse(applied->axes);
    m = {undo * m.axes, undo * (m.origin - applied->origin)};
  }
  camera.position = m.origin;
  camera.world_to_camera =
      checked_rotation(frame["transform_matrix"], glm::transpose(glm::dmat3(m.axes[0], -m.axes[1], -m.axes[2])));
  return camera;
}

}  // namespace

std::vector<Camera> transforms_cameras(const JsonNode& json, const CameraReading& reading) {
  const std::optional<Placement> applied = read_applied(json);
  const JsonNode frames = json["frames"];
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame frame(frames[i], json);
    cameras.push_back(read_frame(frame, applied, reading));
    cameras.back().id = static_cast<int>(i);
    cameras.back().name = frame.text_or("file_path", fmt::format("view_{}", i));
  }
  return cameras;
}

}  // namespace pipegs
