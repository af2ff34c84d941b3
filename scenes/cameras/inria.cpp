// SPDX-License-Identifier: Apache-2.0
// inria: cameras.json as INRIA's training and write_cameras write it.
//
// Layout  A list. "rotation" holds the rows of the camera-to-world matrix, which are the columns of world_to_camera.
//         "cx", "cy" are ours, and optional: a principal point off the centre, the centre of pixel i at i.
#include <fmt/format.h>

#include "scenes/cameras/entry.hpp"
#include "scenes/cameras/forms.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

glm::dmat3 read_rotation(const CameraEntry& entry) {
  const Json& value = entry.at("rotation");
  if (!value.is_array() || value.size() != 3)
    entry.fail("rotation", fmt::format("found {}, expected 3 rows of 3 numbers", quote(json_text(value))));
  glm::dmat3 m;
  for (int r = 0; r < 3; ++r)
    m[r] = entry.triple(value[static_cast<std::size_t>(r)], fmt::format("rotation row {}", r));
  return checked_rotation(entry, "rotation", m);
}

Camera read_camera(const CameraEntry& entry, std::size_t index) {
  entry.must_be_object();
  Camera camera;
  constexpr int kAnyId = 0x7fffffff;
  camera.id = entry.find("id") != nullptr ? entry.integer("id", -kAnyId, kAnyId) : static_cast<int>(index);
  camera.name = entry.text_or("img_name", fmt::format("view_{}", index));
  camera.width = entry.integer("width", 1, kMaxImageSide);
  camera.height = entry.integer("height", 1, kMaxImageSide);
  camera.position = entry.triple("position");
  camera.world_to_camera = read_rotation(entry);
  camera.fx = entry.number("fx", kPositive);
  camera.fy = entry.number("fy", kPositive);
  camera.cx = entry.number_or("cx", (camera.width - 1) / 2.0);
  camera.cy = entry.number_or("cy", (camera.height - 1) / 2.0);
  return camera;
}

}  // namespace

std::vector<Camera> inria_cameras(const std::string& file, const Json& list) {
  if (list.empty()) throw InputError(file, "top level", "found an empty list, expected at least one camera");
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < list.size(); ++i)
    cameras.push_back(read_camera({file, fmt::format("camera {}", i), list[i]}, i));
  return cameras;
}

}  // namespace pipegs
