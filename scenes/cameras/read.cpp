// SPDX-License-Identifier: Apache-2.0
// read: which format a file of cameras has, recognised by its contents, and what the formats share; see camera.hpp.
//
// Rule    A folder, or a file with a name of COLMAP's model, is read as COLMAP's. All others are JSON: a list is
//         INRIA's; an object with frames is a transforms.json when its first frame has a transform_matrix, and a list
//         of frames of PlayCanvas when it has a position; poseSets, animTracks, cameras or camera are SuperSplat's.
// Idea    The rotation is brought to the nearest orthonormal matrix by Newton's iteration R <- (R + R^-T) / 2, which
//         favours no axis (Gram-Schmidt would put the whole error on the last one).
#include <fmt/format.h>

#include <cmath>

#include "scenes/cameras/forms.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/text/json.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/foreign.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

constexpr double kOrthonormalTolerance = 1e-4;
constexpr double kFarthestCamera = 1e12;  // beyond that it is no place, and its square is no number
constexpr const char* kPolycam =
    "found a camera of Polycam's raw data, a file each: ns-process-data polycam, of nerfstudio, makes a "
    "transforms.json of its folder";
constexpr const char* kRecord3d =
    "found the metadata of Record3D: ns-process-data record3d, of nerfstudio, makes a transforms.json of its folder";

std::vector<Camera> cameras_of(const JsonNode& json, const CameraReading& reading, Findings& findings) {
  if (json.is_array()) {
    const bool exported = json.size() > 0 && json[std::size_t{0}].has("transform");
    return exported ? nerfstudio_exported_cameras(json, reading, findings) : inria_cameras(json);
  }
  if (json.has("camera_path")) return nerfstudio_path_cameras(json, reading);
  if (json.has("transform") && json.has("scale"))
    json.fail(
        "found nerfstudio's dataparser_transforms.json, which says how its export was moved: name transforms.json, "
        "beside which it is found");
  if (json.has("t_00")) json.fail(kPolycam);
  if (json.has("poses") && json.has("K")) json.fail(kRecord3d);
  if (json.has("frames")) {
    const JsonNode frames = json["frames"];
    if (frames.size() == 0) frames.refuse("a list of at least one");
    const JsonNode first = frames[std::size_t{0}];
    if (first.has("transform_matrix")) return transforms_cameras(json, reading, findings);
    if (first.has("position")) return playcanvas_cameras(json, reading);
    first.refuse("an object with transform_matrix or position");
  }
  for (const char* field : {"poseSets", "animTracks", "cameras", "camera"}) {
    if (json.has(field)) return playcanvas_cameras(json, reading);
  }
  json.fail(
      "found none of the known formats, expected a list of cameras, or an object with frames, animTracks, cameras or "
      "poseSets");
}

// At the size that was asked for, whatever the file says.
std::vector<Camera> sized(const std::string& file, std::vector<Camera> cameras, const CameraReading& reading) {
  for (Camera& camera : cameras) {
    camera.name = one_line(camera.name);  // it stands in tables
    for (int axis = 0; axis < 3; ++axis) {
      if (!(std::abs(camera.position[axis]) <= kFarthestCamera))
        throw InputError(
            file, fmt::format("camera {}, position", quote(camera.name)),
            fmt::format("found {:g}, expected a number of at most {:g}", camera.position[axis], kFarthestCamera));
    }
    const bool same = camera.width == reading.width && camera.height == reading.height;
    if (reading.width > 0 && !same) camera = resized(camera, reading.width, reading.height);
  }
  return cameras;
}

std::vector<Camera> parsed(const std::string& file, std::string_view text, const CameraReading& reading,
                           Findings& findings) {
  refuse_foreign(file, text, "a file of cameras");
  if (text.starts_with("ply")) throw InputError(file, "", "found a .ply, expected a file of cameras");
  return sized(file, cameras_of(JsonNode::parse(file, text), reading, findings), reading);
}

// The file of cameras in a folder that holds no model of COLMAP; nothing without one.
std::filesystem::path camera_file_of(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* model : {"sparse", "cameras.bin", "cameras.txt"}) {
    if (std::filesystem::exists(folder / model, ignored)) return {};
  }
  for (const char* name : {"cameras.json", "transforms.json", "metadata.json"}) {
    if (std::filesystem::is_regular_file(folder / name, ignored)) return folder / name;
  }
  if (std::filesystem::exists(folder / "keyframes", ignored)) throw InputError(folder.string(), "", kPolycam);
  for (const char* name : {"transforms_train.json", "transforms_eval.json", "transforms_test.json", "camera_path.json",
                           "settings.json", "document.json"}) {
    if (std::filesystem::is_regular_file(folder / name, ignored))
      throw InputError(folder.string(), "",
                       fmt::format("found a folder without cameras.json, transforms.json and COLMAP's model, expected "
                                   "cameras: name the file, such as {}",
                                   quote(name)));
  }
  return {};
}

}  // namespace

glm::dvec3 triple(const JsonNode& numbers) {
  const std::vector<double> v = numbers.reals(3);
  return {v[0], v[1], v[2]};
}

glm::dmat3 checked_rotation(const JsonNode& place, const glm::dmat3& m) {
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      const double off = std::abs(glm::dot(m[r], m[s]) - (r == s ? 1 : 0));
      if (off > worst || std::isnan(off)) worst = off;  // NaN stays
    }
  }
  if (!(worst <= kOrthonormalTolerance))
    place.fail(fmt::format("rows are orthonormal to {:.3g}, expected {:g}", worst, kOrthonormalTolerance));
  if (!(glm::determinant(m) > 0)) place.fail("determinant is -1 (a mirrored frame), expected +1");
  glm::dmat3 nearest = m;
  for (int i = 0; i < 6; ++i) nearest = (nearest + glm::transpose(glm::inverse(nearest))) * 0.5;
  return nearest;
}

void take_size(const JsonNode& place, const CameraReading& reading, Camera& camera) {
  if (reading.width == 0) place.fail("the file has no size, expected --size WxH");
  camera.width = reading.width;
  camera.height = reading.height;
}

std::vector<Camera> parse_cameras(const std::string& file, std::string_view text, const CameraReading& reading) {
  Findings dropped;
  return parsed(file, text, reading, dropped);
}

std::vector<Camera> read_cameras(const std::filesystem::path& path, const CameraReading& reading, Findings& findings) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    const std::filesystem::path inside = camera_file_of(path);
    if (inside.empty())
      return sized(path.string(), colmap_folder_cameras(path, reading.ignore_distortion, findings), reading);
    findings.emplace_back("camera_folder",
                          fmt::format("the cameras of the folder are those of {}", quote(inside.filename().string())));
    return read_cameras(inside, reading, findings);
  }
  if (is_colmap_name(path))
    return sized(path.string(), colmap_folder_cameras(path, reading.ignore_distortion, findings), reading);
  return parsed(path.string(), read_text_file(path, "a file of cameras", kMostJsonBytes), reading, findings);
}

std::vector<Camera> read_cameras(const std::filesystem::path& path, const CameraReading& reading) {
  Findings dropped;
  return read_cameras(path, reading, dropped);
}

}  // namespace pipegs
