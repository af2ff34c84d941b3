// SPDX-License-Identifier: Apache-2.0
// camera: what is made of a camera, and cameras.json as it is written; see camera.hpp.
#include "scenes/camera.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "scenes/atomic_file.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

// Another number of pixels, each of the old ones `x` of the new ones wide and `y` high; what lies in the middle stays
// there. A pixel's centre is its number, its edges half a pixel away.
Camera with_pixels(Camera camera, int width, int height, double x, double y) {
  camera.cx = (camera.cx + 0.5 - camera.width / 2.0) * x + width / 2.0 - 0.5;
  camera.cy = (camera.cy + 0.5 - camera.height / 2.0) * y + height / 2.0 - 0.5;
  camera.fx *= x;
  camera.fy *= y;
  camera.width = width;
  camera.height = height;
  return camera;
}

double share(int part, int whole) { return static_cast<double>(part) / whole; }

}  // namespace

void write_cameras(const std::filesystem::path& path, const std::vector<Camera>& cameras) {
  using Json = nlohmann::json;
  Json json = Json::array();
  for (const Camera& camera : cameras) {
    Json rotation = Json::array();
    for (int r = 0; r < 3; ++r) {
      const glm::dvec3 row = camera.world_to_camera[r];
      rotation.push_back({row.x, row.y, row.z});
    }
    json.push_back({{"id", camera.id},
                    {"img_name", camera.name},
                    {"width", camera.width},
                    {"height", camera.height},
                    {"position", {camera.position.x, camera.position.y, camera.position.z}},
                    {"rotation", rotation},
                    {"fx", camera.fx},
                    {"fy", camera.fy}});
    if (camera.cx != (camera.width - 1) / 2.0) json.back()["cx"] = camera.cx;
    if (camera.cy != (camera.height - 1) / 2.0) json.back()["cy"] = camera.cy;
  }
  AtomicFile out(path);
  std::ofstream stream(out.temporary(), std::ios::binary);
  stream << json_text(json, 1) << '\n';
  stream.close();
  if (!stream) throw OwnFailure(path.string() + ": cannot write");
  out.commit();
}

Camera resized(Camera camera, int width, int height) {
  const double by = share(width, camera.width);
  return with_pixels(camera, width, height, by, by);
}

Camera look_at(const std::string& name, int id, int width, int height, const glm::dvec3& position,
               const glm::dvec3& target, double horizontal_fov_degrees) {
  const glm::dvec3 forward = glm::normalize(target - position);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward));
  const glm::dvec3 down = glm::cross(forward, right);
  Camera camera;
  camera.name = name;
  camera.id = id;
  camera.width = width;
  camera.height = height;
  camera.position = position;
  camera.world_to_camera = glm::transpose(glm::dmat3(right, down, forward));
  camera.fx = camera.fy = width / (2 * std::tan(glm::radians(horizontal_fov_degrees) / 2));
  camera.cx = (width - 1) / 2.0;
  camera.cy = (height - 1) / 2.0;
  return camera;
}

Camera scaled_camera(const Camera& camera, double scale) {
  const auto side = [scale](int pixels) { return std::max(1, static_cast<int>(std::lround(scale * pixels))); };
  const int width = side(camera.width), height = side(camera.height);
  return with_pixels(camera, width, height, share(width, camera.width), share(height, camera.height));
}

}  // namespace pipegs
