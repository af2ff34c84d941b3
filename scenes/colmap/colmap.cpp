// SPDX-License-Identifier: Apache-2.0
// colmap: lenses and poses become cameras, and the folder is looked through; see colmap.hpp.
//
// Rule    Every pose names a lens that is there and a photograph that is there, each id and each name once; at least
//         two photographs of a folder to train on, because one is held out; at least one camera has a point before it.
#include "scenes/colmap/colmap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/ply/ply_file.hpp"
#include "scenes/text/foreign.hpp"
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

std::string read_file(const fs::path& path) {
  std::string bytes = read_text_file(path, "a file of COLMAP's model", kMostBytes);
  const bool text = path.extension() == ".txt";
  // Binary files may begin with anything, a text with the comment by which it is known elsewhere.
  const bool comment = text && without_mark(bytes).starts_with("#");
  if (bytes.starts_with("version https://") || bytes.starts_with("<") || (text && !comment && !bytes.empty()))
    refuse_foreign(path.string(), bytes, "a file of COLMAP's model");
  return bytes;
}

// Names as Windows writes them, or as paths of the computer that they come from.
void take_names(std::vector<ColmapPose>& poses, Findings& findings) {
  std::size_t turned = 0, whole = 0;
  for (ColmapPose& pose : poses) {
    turned += pose.name.find('\\') != std::string::npos;
    std::replace(pose.name.begin(), pose.name.end(), '\\', '/');
    const bool drive = pose.name.size() > 2 && pose.name.compare(1, 2, ":/") == 0;
    if (!drive && !pose.name.starts_with('/')) continue;
    pose.name = fs::path(pose.name).filename().string();
    ++whole;
  }
  if (turned > 0)
    findings.emplace_back("backslashes",
                          fmt::format("backslashes in {} names of photographs are taken as slashes", turned));
  if (whole > 0)
    findings.emplace_back("whole_paths",
                          fmt::format("{} names of photographs are whole paths: their last part is taken", whole));
}

std::vector<Camera> cameras_of(const fs::path& lens_file, const fs::path& pose_file, bool ignore_distortion,
                               Findings& findings) {
  std::vector<ColmapPose> poses = parse_colmap_poses(pose_file.string(), read_file(pose_file), &findings);
  take_names(poses, findings);
  const auto lenses =
      parse_colmap_lenses(lens_file.string(), read_file(lens_file), ignore_distortion, &poses, &findings);
  return colmap_cameras(pose_file.string(), lenses, poses);
}

// The points of points3D.ply, which INRIA's training leaves.
std::vector<ScenePoint> read_ply_points(const fs::path& path) {
  PlySource source(path);
  const PlyHeader header = read_ply_header(source);
  std::vector<ScenePoint> points;
  for (const PlyElement& element : header.elements) {
    static constexpr std::array kNames = {"x", "y", "z", "red", "green", "blue"};
    std::vector<int> slots;
    std::array<bool, kNames.size()> present{};
    for (const PlyProperty& property : element.properties) {
      const auto known = std::find(kNames.begin(), kNames.end(), property.name);
      const bool wanted = element.name == "vertex" && !property.is_list && known != kNames.end();
      slots.push_back(wanted ? static_cast<int>(known - kNames.begin()) : kSkip);
      if (wanted) present[static_cast<std::size_t>(slots.back())] = true;
    }
    std::vector<float> row(kNames.size(), 128.0f);  // grey without colours
    if (element.name == "vertex" && !(present[0] && present[1] && present[2]))
      throw InputError(path.string(), fmt::format("line {}, element vertex", element.line), "x, y or z is missing");
    read_rows(source, header.format, element, slots, row, [&](std::size_t i) {
      if (element.name != "vertex") return;
      ScenePoint point{{row[0], row[1], row[2]}, {}};
      for (int k = 0; k < 3; ++k) {
        if (!(std::abs(point.position[k]) <= kFarthestPoint))
          throw InputError(
              path.string(), fmt::format("vertex {}, position", i),
              fmt::format("found {}, expected a number of at most {:g}", point.position[k], kFarthestPoint));
        point.color[k] = static_cast<std::uint8_t>(std::clamp(row[static_cast<std::size_t>(3 + k)], 0.0f, 255.0f));
      }
      points.push_back(point);
    });
  }
  return points;
}

std::vector<ScenePoint> read_points(const fs::path& model, fs::path& file, Findings& findings) {
  std::error_code ignored;
  const bool own = fs::exists(model / "points3D.bin", ignored) || fs::exists(model / "points3D.txt", ignored);
  if (!own && fs::exists(model / "points3D.ply", ignored)) {
    file = model / "points3D.ply";
    findings.emplace_back("ply_points", "the points are those of points3D.ply: there is no points3D.bin or .txt");
    return read_ply_points(file);
  }
  file = model_file(model, "points3D");
  return parse_colmap_points(file.string(), read_file(file), &findings);
}

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Names in the folder of photographs, with slashes, by what they are without folder and ending, in small letters.
using Photographs = std::multimap<std::string, std::string>;

std::string stem_of(const fs::path& name) { return lower(name.stem().string()); }

Photographs photographs_in(const fs::path& images) {
  std::error_code ignored;
  Photographs found;
  for (const auto& entry : fs::recursive_directory_iterator(images, ignored)) {
    const fs::path name = entry.path().lexically_relative(images);
    if (entry.is_regular_file(ignored)) found.emplace(stem_of(name), name.string());
  }
  return found;
}

// The photograph that is meant by a name under which there is none: in the same folder, or in all of them, the only one
// that has it but for its ending and its letters' case. Empty without one.
std::string photograph_like(const Photographs& photographs, const fs::path& name) {
  const auto [first, last] = photographs.equal_range(stem_of(name));
  const auto in_folder = [&](const auto& one) {
    return lower(fs::path(one.second).parent_path().string()) == lower(name.parent_path().string());
  };
  const auto near = std::find_if(first, last, in_folder);
  if (near != last && std::count_if(first, last, in_folder) == 1) return near->second;
  return std::distance(first, last) == 1 ? first->second : "";
}

// Each camera's photograph is that of its name, or one like it that is no other's.
void find_photographs(const Photographs& photographs, const fs::path& pose_file, ColmapFolder& folder,
                      Findings& findings) {
  std::error_code ignored;
  std::size_t renamed = 0;
  std::set<std::string> taken;
  std::vector<Camera*> others;
  for (Camera& camera : folder.cameras) {
    if (fs::is_regular_file(folder.images / camera.name, ignored))
      taken.insert(fs::path(camera.name).lexically_normal().string());
    else others.push_back(&camera);
  }
  for (Camera* camera : others) {
    const std::string found = photograph_like(photographs, camera->name);
    if (found.empty() || !taken.insert(found).second)
      throw InputError(pose_file.string(), fmt::format("image {}", quote(camera->name)),
                       fmt::format("found no photograph of this name in {}", quote(folder.images.string())));
    camera->name = found;
    ++renamed;
  }
  if (renamed > 0)
    findings.emplace_back("other_ending",
                          fmt::format("{} of {} photographs have another folder, ending or case than the model says",
                                      renamed, folder.cameras.size()));
  if (photographs.size() > folder.cameras.size())
    findings.emplace_back("more_photographs",
                          fmt::format("{} of {} files in images belong to no camera of the model and are "
                                      "left out",
                                      photographs.size() - folder.cameras.size(), photographs.size()));
}

// Names in test.txt, which say what INRIA's training holds out.
std::vector<std::string> read_held_out(const fs::path& model, const std::vector<Camera>& cameras, Findings& findings) {
  std::error_code ignored;
  const fs::path path = model / "test.txt";
  if (!fs::is_regular_file(path, ignored)) return {};
  const std::string text = read_text_file(path, "names of photographs", kMostBytes);
  std::set<std::string> named;
  for (const std::string_view line : lines_of(text)) named.emplace(line);
  std::vector<std::string> held_out;
  for (const Camera& camera : cameras) {
    const fs::path name(camera.name);
    if (named.contains(camera.name) || named.contains(name.stem().string()) || named.contains(name.filename().string()))
      held_out.push_back(camera.name);
  }
  if (held_out.empty() || held_out.size() == cameras.size())
    findings.emplace_back("test_list",
                          fmt::format("test.txt names {} of {} photographs: every eighth is held out instead",
                                      held_out.size(), cameras.size()));
  else
    findings.emplace_back(
        "test_list",
        fmt::format("the {} photographs that test.txt names are held out, not every eighth", held_out.size()));
  return held_out.size() == cameras.size() ? std::vector<std::string>() : held_out;
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

std::vector<Camera> colmap_folder_cameras(const fs::path& path, bool ignore_distortion, Findings& findings) {
  const bool folder = is_folder(path);
  const fs::path model = folder ? model_of(path) : path.parent_path();
  const auto file = [&](const std::string& name) {
    return folder ? model_file(model, name) : model / (name + path.extension().string());
  };
  const std::vector<Camera> cameras = cameras_of(file("cameras"), file("images"), ignore_distortion, findings);
  if (cameras.empty()) throw InputError(file("images").string(), "", "found no photograph, expected at least one");
  return cameras;
}

ColmapFolder read_colmap(const fs::path& folder, bool ignore_distortion, Findings& findings) {
  const fs::path model = model_of(folder);
  if (model == folder) throw InputError(folder.string(), "", "found no folder sparse/0, expected COLMAP's model there");
  const fs::path lens_file = model_file(model, "cameras"), pose_file = model_file(model, "images");
  ColmapFolder found;
  found.images = folder / "images";
  if (!is_folder(found.images))
    throw InputError(folder.string(), "", "found no folder images, expected the photographs there");
  found.cameras = cameras_of(lens_file, pose_file, ignore_distortion, findings);
  if (found.cameras.size() < 2) {
    throw InputError(pose_file.string(), "",
                     fmt::format("found {} photographs, expected at least two", found.cameras.size()));
  }
  find_photographs(photographs_in(found.images), pose_file, found, findings);
  found.held_out = read_held_out(model, found.cameras, findings);
  fs::path point_file;
  found.points = read_points(model, point_file, findings);
  if (found.points.size() < kFewestPoints)
    throw InputError(point_file.string(), "",
                     fmt::format("found {} points, expected at least {}", found.points.size(), kFewestPoints));
  check_something_seen(point_file, found);
  return found;
}

}  // namespace pipegs
