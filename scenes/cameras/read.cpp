// SPDX-License-Identifier: Apache-2.0
// read: which format a file of cameras has, recognised by its contents; see camera.hpp.
//
// Rule    A folder, or a file with a name of COLMAP's model, is read as COLMAP's. All others are JSON: a list is
//         INRIA's; an object with frames is a transforms.json when its first frame has a transform_matrix, and a list
//         of frames of PlayCanvas when it has a position; poseSets, animTracks, cameras or camera are SuperSplat's.
#include <fmt/format.h>

#include "scenes/cameras/forms.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

std::vector<Camera> framed_cameras(const std::string& file, const Json& json, const CameraReading& reading) {
  const Json& frames = json["frames"];
  if (!frames.is_array() || frames.empty())
    throw InputError(file, "frames",
                     fmt::format("found {}, expected a list of at least one", quote(json_text(frames))));
  const Json& first = frames[0];
  if (first.is_object() && first.contains("transform_matrix")) return transforms_cameras(file, json, reading);
  if (first.is_object() && first.contains("position")) return playcanvas_cameras(file, json, reading);
  throw InputError(
      file, "frame 0",
      fmt::format("found {}, expected an object with transform_matrix or position", quote(json_text(first))));
}

std::vector<Camera> cameras_of(const std::string& file, const Json& json, const CameraReading& reading) {
  if (json.is_array()) return inria_cameras(file, json);
  if (json.is_object() && json.contains("frames")) return framed_cameras(file, json, reading);
  for (const char* field : {"poseSets", "animTracks", "cameras", "camera"}) {
    if (json.is_object() && json.contains(field)) return playcanvas_cameras(file, json, reading);
  }
  throw InputError(file, "top level",
                   "found none of the known formats, expected a list of cameras, or an object with frames, animTracks, "
                   "cameras or poseSets");
}

// At the size that was asked for, whatever the file says.
std::vector<Camera> sized(std::vector<Camera> cameras, const CameraReading& reading) {
  for (Camera& camera : cameras) {
    const bool same = camera.width == reading.width && camera.height == reading.height;
    if (reading.width > 0 && !same) camera = resized(camera, reading.width, reading.height);
  }
  return cameras;
}

}  // namespace

std::vector<Camera> parse_cameras(const std::string& file, std::string_view text, const CameraReading& reading) {
  return sized(cameras_of(file, parse_json<Json>(file, text), reading), reading);
}

std::vector<Camera> read_cameras(const std::filesystem::path& path, const CameraReading& reading) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored) || is_colmap_name(path))
    return sized(colmap_folder_cameras(path, reading.ignore_distortion), reading);
  return sized(cameras_of(path.string(), read_json<Json>(path, "a file of cameras"), reading), reading);
}

}  // namespace pipegs
