// SPDX-License-Identifier: Apache-2.0
// camera: pinhole cameras and INRIA's cameras.json.
//
// Idea    camera_space = world_to_camera * (p - position);  pixel = f * xy / z + c
//         Axes x right, y down, z forward. Pixel i has its centre at coordinate i, hence the
//         principal point of a centred camera is (width - 1) / 2.
// Layout  cameras.json: "rotation" holds the rows of the camera-to-world matrix, which are the
//         columns of world_to_camera. "cx", "cy" are ours, and optional: a principal point off the centre.
// Rule    A rotation within 1e-4 of orthonormal is accepted and made orthonormal in double;
//         anything else is an InputError naming the camera's index and the field. Numbers and nesting: json.hpp.
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
  glm::dvec3 position{0};
  glm::dmat3 world_to_camera{1};  // GLM column-major
  double fx = 0, fy = 0, cx = 0, cy = 0;
};

std::vector<Camera> read_cameras(const std::filesystem::path& path);
// The same of a text; `file` is its name in errors.
std::vector<Camera> parse_cameras(const std::string& file, std::string_view text);
void write_cameras(const std::filesystem::path& path, const std::vector<Camera>& cameras);

// A camera at `position` that looks at `target`, with world up = -y and square pixels.
Camera look_at(const std::string& name, int id, int width, int height, const glm::dvec3& position,
               const glm::dvec3& target, double horizontal_fov_degrees);

// Sides times `scale`, above 0, to whole pixels, at least one: both pictures cover the same rectangle.
Camera scaled_camera(const Camera& camera, double scale);

}  // namespace pipegs
