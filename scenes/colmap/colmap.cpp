// SPDX-License-Identifier: Apache-2.0
// colmap: lenses and poses become cameras, and the folder is looked through; see colmap.hpp.
//
// Rule    Every pose names a lens that is there and a photograph that is there, each id and each name once; at least
//         two photographs of a folder to train on, because one is held out; at least one camera has a point before it.
#include "scenes/colmap/colmap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 32;

void check_pose(const std::string& file, const std::string& where, const ColmapPose& pose) {
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(pose.translation[i]) <= kFarthestPoint))
      throw InputError(file, where + ", translation",
                       fmt::format("found {}, expected a number of at most {:g}", pose.translation[i], kFarthestPoint));
  }
  const double length = glm::length(pose.rotation);
  if (!(std::abs(length - 1) <= 1e-3))
    throw InputError(file, where + ", rotation",
                     fmt::format("found a quaternion of length {:.6g}, expected 1 to within 0.001", length));
  const fs::path name(pose.name);
  const bool inside =
      !pose.name.empty() && name.is_relative() && std::find(name.begin(), name.end(), fs::path("..")) == name.end();
  if (!inside)
    throw InputError(file, where + ", name",
                     fmt::format("found {}, expected the name of a file in the folder images", quote(pose.name)));
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// Where the model lies in a folder.
fs::path model_of(const fs::path& folder) {
  for (const char* inside : {"sparse/0", "sparse"}) {
    if (is_folder(folder / inside)) return folder / inside;
  }
  return folder;
}

// The file `name` of the model, .bin before .txt as COLMAP itself reads them.
fs::path model_file(const fs::path& model, const std::string& name) {
  std::error_code ignored;
  for (const char* ending : {".bin", ".txt"}) {
    if (fs::exists(model / (name + ending), ignored)) return model / (name + ending);
  }
  throw InputError(model.string(), "",
                   fmt::format("found a folder without {0}.bin and {0}.txt, expected COLMAP's model in it, in its "
                               "sparse or in its sparse/0",
                               name));
}

std::string read_file(const fs::path& path) { return read_text_file(path, "a file of COLMAP's model", kMostBytes); }

std::vector<Camera> cameras_of(const fs::path& lens_file, const fs::path& pose_file, bool ignore_distortion) {
  const auto lenses = parse_colmap_lenses(lens_file.string(), read_file(lens_file), ignore_distortion);
  return colmap_cameras(pose_file.string(), lenses, parse_colmap_poses(pose_file.string(), read_file(pose_file)));
}

void check_something_seen(const fs::path& file, const ColmapFolder& folder) {
  for (const Camera& camera : folder.cameras) {
    for (const ScenePoint& point : folder.points) {
      if ((camera.world_to_camera * (point.position - camera.position)).z > 0) return;
    }
  }
  throw InputError(file.string(), "", "all points lie behind all cameras, expected some before one");
}

}  // namespace

std::vector<Camera> colmap_cameras(const std::string& file, const std::vector<ColmapLens>& lenses,
                                   const std::vector<ColmapPose>& poses) {
  std::map<std::uint32_t, const ColmapLens*> by_id;
  for (const ColmapLens& lens : lenses) by_id[lens.id] = &lens;
  std::set<std::string> names;
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const ColmapPose& pose = poses[i];
    const std::string where = fmt::format("image {}", i);
    check_pose(file, where, pose);
    const auto lens = by_id.find(pose.lens);
    if (lens == by_id.end())
      throw InputError(file, where + ", camera id", fmt::format("found {}, expected one of cameras", pose.lens));
    if (!names.insert(pose.name).second)
      throw InputError(file, where + ", name", fmt::format("found a second {}, expected one", quote(pose.name)));
    const ColmapLens& of = *lens->second;
    Camera camera;
    camera.name = pose.name;
    camera.width = of.width;
    camera.height = of.height;
    const glm::dvec4 q = pose.rotation / glm::length(pose.rotation);
    camera.world_to_camera = glm::mat3_cast(glm::dquat(q[0], q[1], q[2], q[3]));
    camera.position = -(glm::transpose(camera.world_to_camera) * pose.translation);
    camera.fx = of.fx;
    camera.fy = of.fy;
    camera.cx = of.cx - 0.5;
    camera.cy = of.cy - 0.5;
    cameras.push_back(camera);
  }
  std::sort(cameras.begin(), cameras.end(), [](const Camera& a, const Camera& b) { return a.name < b.name; });
  for (std::size_t i = 0; i < cameras.size(); ++i) cameras[i].id = static_cast<int>(i);
  return cameras;
}

bool is_colmap_name(const fs::path& path) {
  const std::string ending = path.extension().string(), stem = path.stem().string();
  return (ending == ".bin" || ending == ".txt") && (stem == "cameras" || stem == "images");
}

std::vector<Camera> colmap_folder_cameras(const fs::path& path, bool ignore_distortion) {
  const bool folder = is_folder(path);
  const fs::path model = folder ? model_of(path) : path.parent_path();
  const auto file = [&](const std::string& name) {
    return folder ? model_file(model, name) : model / (name + path.extension().string());
  };
  const std::vector<Camera> cameras = cameras_of(file("cameras"), file("images"), ignore_distortion);
  if (cameras.empty()) throw InputError(file("images").string(), "", "found no photograph, expected at least one");
  return cameras;
}

ColmapFolder read_colmap(const fs::path& folder) {
  const fs::path model = model_of(folder);
  if (model == folder) throw InputError(folder.string(), "", "found no folder sparse/0, expected COLMAP's model there");
  const fs::path lens_file = model_file(model, "cameras"), pose_file = model_file(model, "images"),
                 point_file = model_file(model, "points3D");
  ColmapFolder found;
  found.images = folder / "images";
  if (!is_folder(found.images))
    throw InputError(folder.string(), "", "found no folder images, expected the photographs there");
  found.cameras = cameras_of(lens_file, pose_file, false);
  if (found.cameras.size() < 2) {
    throw InputError(pose_file.string(), "",
                     fmt::format("found {} photographs, expected at least two", found.cameras.size()));
  }
  for (const Camera& camera : found.cameras) {
    std::error_code ignored;
    if (!fs::is_regular_file(found.images / camera.name, ignored))
      throw InputError(pose_file.string(), fmt::format("image {}", quote(camera.name)),
                       fmt::format("found no photograph of this name in {}", quote(found.images.string())));
  }
  found.points = parse_colmap_points(point_file.string(), read_file(point_file));
  if (found.points.size() < kFewestPoints)
    throw InputError(point_file.string(), "",
                     fmt::format("found {} points, expected at least {}", found.points.size(), kFewestPoints));
  check_something_seen(point_file, found);
  return found;
}

}  // namespace pipegs
