// SPDX-License-Identifier: Apache-2.0
// forms: the readers behind read_cameras (camera.hpp), one for each format; docs/your_camera.md has the table.
//
// Rule    All give cameras in the world of the scene's file, x right, y down, z forward, pixel i with its centre at i.
//         A camera is complete: what a format leaves out comes of the CameraReading, or is an InputError.
// Names   inria: cameras.json. transforms: nerfstudio, instant-ngp, Blender. playcanvas: frames lists, SuperSplat's
//         viewer and editor. colmap: a folder or one of its files (scenes/colmap/ reads them).
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
// `path` is a folder, or cameras.bin, cameras.txt, images.bin or images.txt in it.
std::vector<Camera> colmap_folder_cameras(const std::filesystem::path& path, const CameraReading& reading);
// Whether COLMAP gives a file this name; its binary files have nothing else by which to tell them.
bool is_colmap_name(const std::filesystem::path& path);

// Width and height of a PNG file; nothing when there is none at `path`.
bool png_size(const std::filesystem::path& path, int& width, int& height);

}  // namespace pipegs
