// SPDX-License-Identifier: Apache-2.0
// transforms: transforms.json of nerfstudio, instant-ngp and Blender's NeRF scenes, and nerfstudio's other cameras.
//
// Layout  "frames" hold "transform_matrix", camera-to-world with the axes of OpenGL: x right, y up, z backward, so the
//         second and third column are negated. fl_x, fl_y, cx, cy, w, h stand above the frames or in each; the centre
//         of pixel i is at i + 0.5, so half a pixel less here.
// Idea    Without fl_x the angle says it: fl_x = w / 2 / tan(camera_angle_x / 2). Blender writes no size: it is that of
//         the option, or of the picture beside the file. nerfstudio's applied_transform A turned COLMAP's world, in
//         which the scene lies: camera-to-world = A^-1 * transform_matrix. What it exports lies elsewhere: its run's
//         dataparser_transforms.json, if it lies beside, leads there. instant-ngp's scale and offset are for its own
//         use, the matrices are without them.
// Rule    Lenses that bend rays are refused, unless the distortion is to be ignored; fisheyes always.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>

#include "scenes/cameras/forms.hpp"
#include "scenes/text/json.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

// A frame, some of whose fields may stand above all frames.
class Frame {
 public:
  Frame(JsonNode own, const JsonNode& above) : own_(std::move(own)), above_(above) {}

  const JsonNode& own() const { return own_; }
  bool has(const char* field) const { return says(own_, field) || says(above_, field); }
  JsonNode operator[](const char* field) const {
    return (says(above_, field) && !says(own_, field) ? above_ : own_)[field];
  }
  double real_or(const char* field, double otherwise) const { return has(field) ? (*this)[field].real() : otherwise; }
  std::string text_or(const char* field, const std::string& otherwise) const {
    return has(field) ? (*this)[field].text() : otherwise;
  }

 private:
  static bool says(const JsonNode& node, const char* field) { return node.has(field) && !node[field].is_null(); }

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

// What turned the world of the scene into that of the matrices.
struct Applied {
  Placement turn;
  double scale = 1;

  Placement undone(const Placement& m) const {
    const glm::dmat3 undo = glm::inverse(turn.axes);
    return {undo * m.axes, undo * (m.origin / scale - turn.origin)};
  }
};

// A mirror in it and in the matrices is none in the cameras.
void check_turn(const JsonNode& place, const Placement& turn) {
  checked_rotation(place, glm::determinant(turn.axes) < 0 ? -turn.axes : turn.axes);
}

Applied read_applied(const JsonNode& json, Findings& findings) {
  Applied applied;
  if (json.has("applied_scale")) applied.scale = json["applied_scale"].real(kPositive);
  if (applied.scale != 1)
    findings.emplace_back("applied_scale",
                          fmt::format("applied_scale of {:g} is undone: the scene is in the unit before "
                                      "it",
                                      applied.scale));
  if (!json.has("applied_transform")) return applied;
  applied.turn = read_matrix(json["applied_transform"]);
  check_turn(json["applied_transform"], applied.turn);
  return applied;
}

// nerfstudio's dataparser_transforms.json beside the file: from the cameras' world to that of its export.
struct Export {
  Placement turn;
  double scale = 1;
  // Its runs say the way from the matrices as they stand, newer ones from those before applied_transform.
  bool of_undone = false;

  Placement moved(const Placement& m) const {
    return {turn.axes * m.axes, scale * (turn.axes * m.origin + turn.origin)};
  }
};

constexpr const char* kExport = "dataparser_transforms.json";

std::optional<Export> read_export(const JsonNode& json) {
  const fs::path path = fs::path(json.file()).parent_path() / kExport;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  const JsonNode moved = JsonNode::parse(path.string(), read_text_file(path, "a JSON file", kMostJsonBytes));
  Export found{read_matrix(moved["transform"]), moved["scale"].real(kPositive)};
  check_turn(moved["transform"], found.turn);
  return found;
}

// The middle of all cameras is that of the export: if only the undone matrices give it, they are meant.
bool is_of_undone(const JsonNode& frames, const Applied& applied, const Export& moved) {
  constexpr double kCentred = 0.05;
  glm::dvec3 as_they_stand(0), undone(0);
  double farthest = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Placement m = read_matrix(frames[i]["transform_matrix"]);
    const glm::dvec3 at = moved.moved(m).origin, other = moved.moved(applied.undone(m)).origin;
    as_they_stand += at / static_cast<double>(frames.size());
    undone += other / static_cast<double>(frames.size());
    farthest = std::max(farthest, glm::length(other));
  }
  return frames.size() > 1 && glm::length(undone) < kCentred * farthest &&
         glm::length(as_they_stand) > 2 * glm::length(undone) + kCentred * farthest;
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

// Width and height of a PNG or a JPEG, of its first bytes. False when there is none at `path`.
//   PNG   8 of signature, 4 of length, "IHDR", then both, each 4 bytes, the high one first.
//   JPEG  ff d8, then segments: ff, kind, the length of what follows. Of kind c0 to cf but c4, c8, cc it has a byte,
//         then height and width, each 2 bytes.
bool picture_size(const fs::path& path, Camera& camera) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 24> bytes{};
  const std::string_view text(bytes.data(), bytes.size());
  const auto take = [&](std::size_t from, std::size_t to) {
    return bool{file.read(bytes.data() + from, static_cast<std::streamsize>(to - from))};
  };
  const auto number = [&](std::size_t at, std::size_t count) {
    int value = 0;
    for (const char c : text.substr(at, count)) value = (value & 0x7fffff) << 8 | static_cast<unsigned char>(c);
    return value;
  };
  const auto sized = [&](int columns, int rows) {
    camera.width = columns;
    camera.height = rows;
    return columns >= 1 && columns <= kMaxImageSide && rows >= 1 && rows <= kMaxImageSide;
  };
  if (!take(0, 2)) return false;
  if (text.starts_with("\x89P"))
    return take(2, 24) && text.starts_with("\x89PNG\r\n\x1a\n") && text.substr(12, 4) == "IHDR" &&
           sized(number(16, 4), number(20, 4));
  if (!text.starts_with("\xff\xd8")) return false;
  constexpr int kMostSegments = 256;  // before the size: of a profile or an XMP may be dozens
  for (int segment = 0; segment < kMostSegments && take(0, 2) && number(0, 1) == 0xff; ++segment) {
    const int kind = number(1, 1);
    if (kind == 0xff) {  // it fills up, and begins the next one
      file.seekg(-1, std::ios::cur);
      continue;
    }
    if (!take(2, 4) || number(2, 2) < 2) return false;
    if (kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc)
      return take(4, 9) && sized(number(7, 2), number(5, 2));
    file.seekg(number(2, 2) - 2, std::ios::cur);
  }
  return false;
}

// Of the file, of the option, or of the picture.
void find_size(const Frame& frame, const CameraReading& reading, Camera& camera) {
  if (frame.has("w") || frame.has("h")) {
    camera.width = frame["w"].whole(1, kMaxImageSide);
    camera.height = frame["h"].whole(1, kMaxImageSide);
    return;
  }
  if (reading.width == 0 && frame.has("file_path")) {
    std::string name = frame["file_path"].text();
    std::replace(name.begin(), name.end(), '\\', '/');  // as Windows writes it
    const fs::path picture = fs::path(frame.own().file()).parent_path() / name;
    for (const char* ending : {"", ".png", ".jpg"}) {
      if (picture_size(fs::path(picture) += ending, camera)) return;
    }
  }
  take_size(frame.own(), reading, camera);
}

double focal(const JsonNode& angle, int pixels) {
  return pixels / (2 * std::tan(angle.real({.low = 0, .high = 3.1415, .above = true}) / 2));
}

// Size, focal lengths and principal point.
Camera read_lens(const Frame& frame, const CameraReading& reading) {
  check_lens(frame, reading);
  Camera camera;
  find_size(frame, reading, camera);
  const bool angle_x = !frame.has("fl_x") && frame.has("camera_angle_x");
  camera.fx = angle_x ? focal(frame["camera_angle_x"], camera.width) : frame["fl_x"].real(kPositive);
  if (frame.has("fl_y")) camera.fy = frame["fl_y"].real(kPositive);
  else camera.fy = frame.has("camera_angle_y") ? focal(frame["camera_angle_y"], camera.height) : camera.fx;
  camera.cx = frame.real_or("cx", camera.width / 2.0) - 0.5;
  camera.cy = frame.real_or("cy", camera.height / 2.0) - 0.5;
  return camera;
}

// The axes of OpenGL.
void place(const JsonNode& matrix, const Placement& m, Camera& camera) {
  camera.position = m.origin;
  camera.world_to_camera = checked_rotation(matrix, glm::transpose(glm::dmat3(m.axes[0], -m.axes[1], -m.axes[2])));
}

}  // namespace

std::vector<Camera> transforms_cameras(const JsonNode& json, const CameraReading& reading, Findings& findings) {
  const Applied applied = read_applied(json, findings);
  const JsonNode frames = json["frames"];
  std::optional<Export> moved = read_export(json);
  if (moved) {
    moved->of_undone = is_of_undone(frames, applied, *moved);
    findings.emplace_back(
        "nerfstudio_export",
        fmt::format("cameras are moved into the frame of nerfstudio's export by {}, which lies beside "
                    "them (scale {:g}{})",
                    kExport, moved->scale, moved->of_undone ? ", behind applied_transform" : ""));
  }
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame frame(frames[i], json);
    const JsonNode matrix = frame["transform_matrix"];
    const Placement m = read_matrix(matrix);
    Camera camera = read_lens(frame, reading);
    place(matrix, !moved ? applied.undone(m) : moved->moved(moved->of_undone ? applied.undone(m) : m), camera);
    camera.id = static_cast<int>(i);
    camera.name = frame.text_or("file_path", fmt::format("view_{}", i));
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<Camera> nerfstudio_exported_cameras(const JsonNode& list, const CameraReading& reading,
                                                Findings& findings) {
  const fs::path path = fs::path(list.file()).parent_path() / "transforms.json";
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored))
    list.fail(
        "found poses of nerfstudio's ns-export cameras, which have no lenses: put the transforms.json of the "
        "photographs beside it");
  const JsonNode lenses = JsonNode::parse(path.string(), read_text_file(path, "a JSON file", kMostJsonBytes));
  const JsonNode frames = lenses["frames"];
  std::map<std::string, std::size_t> by_name;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i].has("file_path")) by_name.emplace(fs::path(frames[i]["file_path"].text()).filename().string(), i);
  }
  findings.emplace_back("exported_poses",
                        "poses of nerfstudio's ns-export cameras; their lenses are those of the "
                        "transforms.json beside them");
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string name = list[i].has("file_path") ? list[i]["file_path"].text() : fmt::format("view_{}", i);
    const auto found = by_name.find(fs::path(name).filename().string());
    const JsonNode own = found != by_name.end() ? frames[found->second] : lenses;
    Camera camera = read_lens(Frame(own, lenses), reading);
    place(list[i]["transform"], read_matrix(list[i]["transform"]), camera);
    camera.id = static_cast<int>(i);
    camera.name = name;
    cameras.push_back(camera);
  }
  return cameras;
}

std::vector<Camera> nerfstudio_path_cameras(const JsonNode& json, const CameraReading& reading) {
  const JsonNode path = json["camera_path"];
  if (path.size() == 0) path.refuse("a list of at least one");
  if (json.has("camera_type") && json["camera_type"].text() != "perspective") json["camera_type"].refuse("perspective");
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const JsonNode entry = path[i], numbers = entry["camera_to_world"];
    Camera camera;
    if (json.has("render_width")) {
      camera.width = json["render_width"].whole(1, kMaxImageSide);
      camera.height = json["render_height"].whole(1, kMaxImageSide);
    } else {
      take_size(entry, reading, camera);
    }
    Placement m;
    if (numbers.size() == 16) {  // row by row
      const std::vector<double> v = numbers.reals(16);
      for (std::size_t k = 0; k < 12; ++k) {
        const int row = static_cast<int>(k) / 4, column = static_cast<int>(k) % 4;
        (column < 3 ? m.axes[column][row] : m.origin[row]) = v[k];
      }
    } else {
      m = read_matrix(numbers);
    }
    place(numbers, m, camera);
    const JsonNode fov = entry.has("fov") ? entry["fov"] : json["default_fov"];  // from top to bottom, in degrees
    camera.fx = camera.fy =
        camera.height / (2 * std::tan(glm::radians(fov.real({.low = 0, .high = 179.9, .above = true})) / 2));
    camera.cx = (camera.width - 1) / 2.0;
    camera.cy = (camera.height - 1) / 2.0;
    camera.id = static_cast<int>(i);
    camera.name = fmt::format("path_{}", i);
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace pipegs
