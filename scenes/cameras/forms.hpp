// SPDX-License-Identifier: Apache-2.0
// forms: the readers behind read_cameras (camera.hpp), one for each format; docs/your_camera.md has the table.
//
// Rule    All give cameras in the world of the scene's file, x right, y down, z forward, pixel i with its centre at i.
//         A camera is complete: what a format leaves out comes of the CameraReading, or is an InputError.
// Names   inria: cameras.json. transforms: nerfstudio, instant-ngp, Blender. playcanvas: frames lists, SuperSplat's
//         viewer and editor. COLMAP's folder or one of its files: scenes/colmap/.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/camera.hpp"

namespace pipegs {

std::vector<Camera> inria_cameras(const std::string& file, const nlohmann::json& list);
std::vector<Camera> transforms_cameras(const std::string& file, const nlohmann::json& json,
                                       const CameraReading& reading);
std::vector<Camera> playcanvas_cameras(const std::string& file, const nlohmann::json& json,
                                       const CameraReading& reading);
// Width and height of a PNG file; nothing when there is none at `path`.
bool png_size(const std::filesystem::path& path, int& width, int& height);

}  // namespace pipegs
