// SPDX-License-Identifier: Apache-2.0
// inria: cameras.json as INRIA's training and write_cameras write it.
//
// Layout  A list. "rotation" holds the rows of the camera-to-world matrix, which are the columns of world_to_camera.
//         "cx", "cy" are ours, and optional: a principal point off the centre, the centre of pixel i at i.
#include <fmt/format.h>

#include "scenes/cameras/forms.hpp"

namespace pipegs {
namespace {

glm::dmat3 read_rotation(const JsonNode& rows) {
  if (rows.size() != 3) rows.refuse("3 rows of 3 numbers");
  glm::dmat3 m;
  for (std::size_t r = 0; r < 3; ++r) m[static_cast<int>(r)] = triple(rows[r]);
  return checked_rotation(rows, m);
}

Camera read_camera(const JsonNode& entry, std::size_t index) {
  Camera camera;
  constexpr int kAnyId = 0x7fffffff;
  camera.id = entry.has("id") ? entry["id"].whole(-kAnyId, kAnyId) : static_cast<int>(index);
  camera.name = entry.has("img_name") ? entry["img_name"].text() : fmt::format("view_{}", index);
  camera.width = entry["width"].whole(1, kMaxImageSide);
  camera.height = entry["height"].whole(1, kMaxImageSide);
  camera.position = triple(entry["position"]);
  camera.world_to_camera = read_rotation(entry["rotation"]);
  camera.fx = entry["fx"].real(kPositive);
  camera.fy = entry["fy"].real(kPositive);
  camera.cx = entry.has("cx") ? entry["cx"].real() : (camera.width - 1) / 2.0;
  camera.cy = entry.has("cy") ? entry["cy"].real() : (camera.height - 1) / 2.0;
  return camera;
}

}  // namespace

std::vector<Camera> inria_cameras(const JsonNode& list) {
  if (list.size() == 0) list.fail("found an empty list, expected at least one camera");
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < list.size(); ++i) cameras.push_back(read_camera(list[i], i));
  return cameras;
}

}  // namespace pipegs
