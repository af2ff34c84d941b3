// SPDX-License-Identifier: Apache-2.0
// colmap: photographs with poses and points, as COLMAP leaves them in a folder.
//
// Layout  FOLDER/sparse/0 (or FOLDER/sparse) holds cameras, images and points3D, each .bin or .txt; FOLDER/images the
//         photographs by the names that `images` gives them.
// Idea    COLMAP's q, t: camera_space = R(q) p + t, so the camera stands at -R^T t. Its pixel i has its centre at
//         i + 0.5, ours at i: both principal points are half a pixel less here.
// Rule    PINHOLE and SIMPLE_PINHOLE only: a lens that bends rays is taken out before (colmap image_undistorter). Where
//         that is to be ignored, or all its distortion is 0, SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV are pinholes
//         with their focal lengths.
//         Cameras come in the order of their photographs' names, whatever order the file has.
// Errors  InputError with file, element and field; whether the photographs are there is seen here, what is in them not.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/check/finding.hpp"

namespace pipegs {

struct ScenePoint {
  glm::dvec3 position;
  glm::u8vec3 color;
};

// A lens as a pinhole, in COLMAP's pixels.
struct ColmapLens {
  std::uint32_t id = 0;
  int width = 0, height = 0;
  double fx = 0, fy = 0, cx = 0, cy = 0;
};

struct ColmapPose {
  std::uint32_t id = 0, lens = 0;
  glm::dvec4 rotation{0};  // w, x, y, z
  glm::dvec3 translation{0};
  std::string name;  // of the photograph
};

struct ColmapFolder {
  std::vector<Camera> cameras;  // named as their photographs, with the ending
  std::vector<ScenePoint> points;
  std::filesystem::path images;
  std::vector<std::string> held_out;  // names in the model's test.txt, if there is one
};

inline constexpr std::size_t kFewestPoints = 4;  // three neighbours of each are needed
inline constexpr double kFarthestPoint = 1e9;    // of a coordinate: its square is far from the end of a float

// A folder of photographs to train on: all of it must be there.
ColmapFolder read_colmap(const std::filesystem::path& folder, bool ignore_distortion, Findings& findings);
inline ColmapFolder read_colmap(const std::filesystem::path& folder) {
  Findings dropped;
  return read_colmap(folder, false, dropped);
}

// The cameras alone, without points and photographs. `path` is a folder, whose model may lie in sparse/0, in sparse or
// in it, or cameras.bin, cameras.txt, images.bin or images.txt of a model.
std::vector<Camera> colmap_folder_cameras(const std::filesystem::path& path, bool ignore_distortion,
                                          Findings& findings);
// Whether COLMAP gives a file this name; its binary files have nothing else by which to tell them.
bool is_colmap_name(const std::filesystem::path& path);

// The parts, of a file's bytes; `file` is their name in errors and says by its ending, .txt or .bin, what they are.
// Lenses that no pose names are left out, with a finding; without poses all are wanted.
std::vector<ColmapLens> parse_colmap_lenses(const std::string& file, std::string_view bytes,
                                            bool ignore_distortion = false,
                                            const std::vector<ColmapPose>* poses = nullptr,
                                            Findings* findings = nullptr);
std::vector<ColmapPose> parse_colmap_poses(const std::string& file, std::string_view bytes,
                                           Findings* findings = nullptr);
std::vector<ScenePoint> parse_colmap_points(const std::string& file, std::string_view bytes,
                                            Findings* findings = nullptr);
// Cameras of lenses and poses; `file` is that of the poses.
std::vector<Camera> colmap_cameras(const std::string& file, const std::vector<ColmapLens>& lenses,
                                   const std::vector<ColmapPose>& poses);

}  // namespace pipegs
