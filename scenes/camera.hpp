// SPDX-License-Identifier: Apache-2.0
// camera: pinhole cameras, and the files that hold them.
//
// Idea    camera_space = world_to_camera * (p - position);  pixel = f * xy / z + c
//         Axes x right, y down, z forward. Pixel i has its centre at coordinate i, hence the
//         principal point of a centred camera is (width - 1) / 2.
// Reads   INRIA's cameras.json, COLMAP's model, transforms.json of nerfstudio, instant-ngp and Blender, cameras of
//         PlayCanvas and SuperSplat: recognised by contents (scenes/cameras/). Ours is cameras.json.
// Errors  InputError naming the camera's index and the field. Numbers and nesting: json.hpp.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pipegs {

inline constexpr int kMaxImageSide = 16384;

struct Camera {
  std::string name;
  int id = 0;
  int width = 0, height = 0;
  int of_width = 0, of_height = 0;  // pixels of the picture of which it shows a part; 0: of all of it
  glm::dvec3 position{0};
  glm::dmat3 world_to_camera{1};  // GLM column-major
  double fx = 0, fy = 0, cx = 0, cy = 0;
  // tan(fov / 2) of the whole picture.
  double tan_x() const { return (of_width == 0 ? width : of_width) / (2 * fx); }
  double tan_y() const { return (of_height == 0 ? height : of_height) / (2 * fy); }
};

// What a file of cameras does not say.
struct CameraReading {
  int width = 0, height = 0;  // all views get this size; 0: the file's, and there must be one
  bool ignore_distortion = false;
};

std::vector<Camera> read_cameras(const std::filesystem::path& path, const CameraReading& reading = {});
// The same of a text that is JSON; `file` is its name in errors.
std::vector<Camera> parse_cameras(const std::string& file, std::string_view text, const CameraReading& reading = {});
void write_cameras(const std::filesystem::path& path, const std::vector<Camera>& cameras);

// The same view with another number of pixels: as wide, and as high as the pixels make it.
Camera resized(Camera camera, int width, int height);

// A camera at `position` that looks at `target`, with world up = -y and square pixels.
Camera look_at(const std::string& name, int id, int width, int height, const glm::dvec3& position,
               const glm::dvec3& target, double horizontal_fov_degrees);

// Sides times `scale`, above 0, to whole pixels, at least one: both pictures cover the same rectangle.
Camera scaled_camera(const Camera& camera, double scale);

}  // namespace pipegs
