// SPDX-License-Identifier: Apache-2.0
// forms: the readers behind read_cameras (camera.hpp), one for each format; docs/your_camera.md has the table.
//
// Rule    All give cameras in the world of the scene's file, x right, y down, z forward, pixel i with its centre at i.
//         A camera is complete: what a format leaves out comes of the CameraReading, or is an InputError.
//         A rotation within 1e-4 of orthonormal is accepted and brought to the nearest orthonormal matrix in double;
//         what is further off, singular, scaled or mirrored is refused.
// Names   inria: cameras.json. transforms: nerfstudio, instant-ngp, Blender. nerfstudio_exported: ns-export cameras, a
//         list with "transform"; nerfstudio_path: camera_path.json of its viewer. playcanvas: frames lists,
//         SuperSplat's viewer and editor. COLMAP's folder or one of its files: scenes/colmap/.
// Errors  InputError: "cameras.json: [0].fx: found '-50', expected a number above 0".
#pragma once

#include <vector>

#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"
#include "scenes/text/json_node.hpp"

namespace pipegs {

// As read_cameras of camera.hpp, which drops the findings.
std::vector<Camera> read_cameras(const std::filesystem::path& path, const CameraReading& reading, Findings& findings);

std::vector<Camera> inria_cameras(const JsonNode& list);
std::vector<Camera> transforms_cameras(const JsonNode& json, const CameraReading& reading, Findings& findings);
std::vector<Camera> nerfstudio_exported_cameras(const JsonNode& list, const CameraReading& reading, Findings& findings);
std::vector<Camera> nerfstudio_path_cameras(const JsonNode& json, const CameraReading& reading);
std::vector<Camera> playcanvas_cameras(const JsonNode& json, const CameraReading& reading);

glm::dvec3 triple(const JsonNode& numbers);
// The nearest rotation to a matrix whose columns are the rows of camera-to-world, which is world_to_camera.
glm::dmat3 checked_rotation(const JsonNode& place, const glm::dmat3& world_to_camera);
// Width and height of a view whose file has none.
void take_size(const JsonNode& place, const CameraReading& reading, Camera& camera);

}  // namespace pipegs
