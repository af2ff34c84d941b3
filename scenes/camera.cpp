// SPDX-License-Identifier: Apache-2.0
// camera: reading and writing cameras.json; see camera.hpp.
//
// Idea    Nothing is trusted: each field is looked up, its type and range checked, and the error
//         names "camera <index>, <field>". The rotation is brought to the nearest orthonormal
//         matrix by Newton's iteration R <- (R + R^-T) / 2, which favours no axis (Gram-Schmidt
//         would put the whole error on the last one).
#include "scenes/camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;
constexpr double kOrthonormalTolerance = 1e-4;

// One camera of the file, with what an error message needs.
struct Entry {
  const std::string& file;
  std::size_t index;
  const Json& json;

  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    throw InputError(file, fmt::format("camera {}, {}", index, field), what);
  }
  const Json& at(const std::string& field) const {
    const auto found = json.find(field);
    if (found == json.end()) fail(field, "missing, expected a value");
    return *found;
  }
  double number(const Json& value, const std::string& field, const RealRange& range = kFinite) const {
    try {
      return json_real(value, range);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  int integer(const std::string& field, int lowest, int highest) const {
    try {
      return json_integer(at(field), lowest, highest);
    } catch (const NumberError& error) { fail(field, error.what()); }
  }
  double focal(const std::string& field) const { return number(at(field), field, kPositive); }
  glm::dvec3 row(const Json& value, const std::string& field) const {
    if (!value.is_array() || value.size() != 3) {
      fail(field, fmt::format("found {}, expected 3 numbers", quote(json_text(value))));
    }
    return {number(value[0], field), number(value[1], field), number(value[2], field)};
  }
};

glm::dmat3 nearest_rotation(glm::dmat3 m) {
  for (int i = 0; i < 6; ++i) m = (m + glm::transpose(glm::inverse(m))) * 0.5;
  return m;
}

glm::dmat3 read_rotation(const Entry& entry) {
  const Json& value = entry.at("rotation");
  if (!value.is_array() || value.size() != 3) {
    entry.fail("rotation", fmt::format("found {}, expected 3 rows of 3 numbers", quote(json_text(value))));
  }
  glm::dmat3 m;
  for (int r = 0; r < 3; ++r) m[r] = entry.row(value[static_cast<std::size_t>(r)], fmt::format("rotation row {}", r));
  double worst = 0;
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) worst = std::max(worst, std::abs(glm::dot(m[r], m[s]) - (r == s ? 1 : 0)));
  }
  if (!(worst <= kOrthonormalTolerance)) {
    entry.fail("rotation", fmt::format("rows are orthonormal to {:.3g}, expected {:g}", worst, kOrthonormalTolerance));
  }
  if (!(glm::determinant(m) > 0)) { entry.fail("rotation", "determinant is -1 (a mirrored frame), expected +1"); }
  return nearest_rotation(m);
}

Camera read_camera(const Entry& entry) {
  if (!entry.json.is_object())
    entry.fail("entry", fmt::format("found {}, expected an object", quote(json_text(entry.json))));
  Camera camera;
  constexpr int kAnyId = 0x7fffffff;
  camera.id = entry.json.contains("id") ? entry.integer("id", -kAnyId, kAnyId) : static_cast<int>(entry.index);
  if (entry.json.contains("img_name")) {
    const Json& name = entry.at("img_name");
    if (!name.is_string()) entry.fail("img_name", fmt::format("found {}, expected a string", quote(json_text(name))));
    camera.name = name.get<std::string>();
  } else {
    camera.name = fmt::format("view_{}", entry.index);
  }
  camera.width = entry.integer("width", 1, kMaxImageSide);
  camera.height = entry.integer("height", 1, kMaxImageSide);
  camera.position = entry.row(entry.at("position"), "position");
  camera.world_to_camera = read_rotation(entry);
  camera.fx = entry.focal("fx");
  camera.fy = entry.focal("fy");
  // INRIA's file has no principal point; ours may, in pixels with the centre of pixel i at i.
  camera.cx = entry.json.contains("cx") ? entry.number(entry.at("cx"), "cx") : (camera.width - 1) / 2.0;
  camera.cy = entry.json.contains("cy") ? entry.number(entry.at("cy"), "cy") : (camera.height - 1) / 2.0;
  return camera;
}

std::vector<Camera> cameras_of(const std::string& file, const Json& json) {
  if (!json.is_array()) throw InputError(file, "top level", "found no array, expected a list of cameras");
  if (json.empty()) throw InputError(file, "top level", "found an empty list, expected at least one camera");
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < json.size(); ++i) cameras.push_back(read_camera(Entry{file, i, json[i]}));
  return cameras;
}

}  // namespace

std::vector<Camera> parse_cameras(const std::string& file, std::string_view text) {
  return cameras_of(file, parse_json<Json>(file, text));
}

std::vector<Camera> read_cameras(const std::filesystem::path& path) {
  return cameras_of(path.string(), read_json<Json>(path, "a cameras.json"));
}

void write_cameras(const std::filesystem::path& path, const std::vector<Camera>& cameras) {
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
  Camera small = camera;
  const auto side = [scale](int pixels) { return std::max(1, static_cast<int>(std::lround(scale * pixels))); };
  small.width = side(camera.width);
  small.height = side(camera.height);
  const double x = static_cast<double>(small.width) / camera.width,
               y = static_cast<double>(small.height) / camera.height;
  small.fx = camera.fx * x;
  small.fy = camera.fy * y;
  small.cx = (camera.cx + 0.5) * x - 0.5;  // a pixel's centre is its number, its edges half a pixel away
  small.cy = (camera.cy + 0.5) * y - 0.5;
  return small;
}

}  // namespace pipegs
