// SPDX-License-Identifier: Apache-2.0
// colmap_folder: the cameras of COLMAP's model, without its points and photographs, wherever it lies in a folder.
//
// Rule    sparse/0 of the folder, else its sparse, else the folder itself; of a file the folder round it. .bin before
//         .txt, as COLMAP itself reads them. Cameras come in the order of their photographs' names.
#include <fmt/format.h>

#include <array>
#include <set>

#include "scenes/cameras/forms.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 32;
constexpr std::array kNames = {"cameras", "images"};

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

fs::path model_of(const fs::path& path) {
  if (!is_folder(path)) return path.parent_path();
  for (const char* inside : {"sparse/0", "sparse"}) {
    if (is_folder(path / inside)) return path / inside;
  }
  return path;
}

// The file of the model that has this name, in the form of the file that was named.
fs::path file_of(const fs::path& path, const fs::path& model, const std::string& name) {
  std::error_code ignored;
  if (!is_folder(path)) return model / (name + path.extension().string());
  for (const char* ending : {".bin", ".txt"}) {
    if (fs::exists(model / (name + ending), ignored)) return model / (name + ending);
  }
  throw InputError(path.string(), "",
                   fmt::format("found a folder without {0}.bin and {0}.txt, expected COLMAP's model in it, in its "
                               "sparse or in its sparse/0",
                               name));
}

}  // namespace

bool is_colmap_name(const fs::path& path) {
  const std::string ending = path.extension().string(), stem = path.stem().string();
  return (ending == ".bin" || ending == ".txt") && (stem == kNames[0] || stem == kNames[1]);
}

std::vector<Camera> colmap_folder_cameras(const fs::path& path, const CameraReading& reading) {
  const fs::path model = model_of(path), lens_file = file_of(path, model, kNames[0]),
                 pose_file = file_of(path, model, kNames[1]);
  const auto text_of = [](const fs::path& file) {
    return read_text_file(file, "a file of COLMAP's model", kMostBytes);
  };
  const std::vector<ColmapLens> lenses =
      parse_colmap_lenses(lens_file.string(), text_of(lens_file), reading.ignore_distortion);
  std::set<std::uint32_t> ids;
  for (const ColmapLens& lens : lenses) {
    if (!ids.insert(lens.id).second)
      throw InputError(lens_file.string(), "", fmt::format("found camera id {} twice, expected it once", lens.id));
  }
  const std::vector<Camera> cameras =
      colmap_cameras(pose_file.string(), lenses, parse_colmap_poses(pose_file.string(), text_of(pose_file)));
  if (cameras.empty()) throw InputError(pose_file.string(), "", "found no photograph, expected at least one");
  return cameras;
}

}  // namespace pipegs
