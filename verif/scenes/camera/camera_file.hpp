// SPDX-License-Identifier: Apache-2.0
// camera_file: cameras as other people's tools write them: the same views in every format, for the tests of readers.
//
// Idea    The formulas are written once more here, from each tool's own description, the other way round than the
//         readers have them: from our camera to the file.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "verif/scenes/colmap_file.hpp"

namespace pipegs::camera_file {

using Json = nlohmann::json;

inline Json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

// Camera-to-world with the axes of OpenGL, after `applied` of the world.
inline Json matrix_of(const Camera& camera, const glm::dmat3& applied = glm::dmat3(1)) {
  const glm::dmat3 axes = applied * glm::transpose(camera.world_to_camera) *
                          glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
  const glm::dvec3 place = applied * camera.position;
  Json rows = Json::array();
  for (int r = 0; r < 3; ++r) rows.push_back({axes[0][r], axes[1][r], axes[2][r], place[r]});
  rows.push_back({0, 0, 0, 1});
  return rows;
}

inline Json lens_of(const Camera& camera) {
  return {{"fl_x", camera.fx},     {"fl_y", camera.fy}, {"cx", camera.cx + 0.5},
          {"cy", camera.cy + 0.5}, {"w", camera.width}, {"h", camera.height}};
}

inline Json frames_of(const std::vector<Camera>& cameras, const glm::dmat3& applied = glm::dmat3(1)) {
  Json frames = Json::array();
  for (const Camera& camera : cameras)
    frames.push_back({{"file_path", camera.name}, {"transform_matrix", matrix_of(camera, applied)}});
  return frames;
}

// All views have the lens of the first.
inline Json nerfstudio(const std::vector<Camera>& cameras) {
  Json json = lens_of(cameras[0]);
  json["camera_model"] = "OPENCV";
  for (const char* k : {"k1", "k2", "p1", "p2"}) json[k] = 0.0;
  json["frames"] = frames_of(cameras);
  return json;
}

inline Json nerfstudio_per_frame(const std::vector<Camera>& cameras) {
  Json json = {{"frames", frames_of(cameras)}};
  for (std::size_t i = 0; i < cameras.size(); ++i) json["frames"][i].update(lens_of(cameras[i]));
  return json;
}

// The world with y and z exchanged, as nerfstudio turns COLMAP's.
inline Json nerfstudio_applied(const std::vector<Camera>& cameras) {
  const glm::dmat3 applied({1, 0, 0}, {0, 0, -1}, {0, 1, 0});
  Json json = lens_of(cameras[0]);
  json["applied_transform"] = {{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}};
  json["frames"] = frames_of(cameras, applied);
  return json;
}

inline Json instant_ngp(const std::vector<Camera>& cameras) {
  Json json = nerfstudio(cameras);
  json.erase("camera_model");
  json["camera_angle_x"] = 1.0;  // fl_x is what counts
  json["scale"] = 0.33;
  json["offset"] = {0.5, 0.5, 0.5};
  json["aabb_scale"] = 16;
  return json;
}

// No size, square pixels, a centred principal point.
inline Json blender(const std::vector<Camera>& cameras) {
  return {{"camera_angle_x", 2 * std::atan(cameras[0].width / 2.0 / cameras[0].fx)}, {"frames", frames_of(cameras)}};
}

inline glm::dvec3 turned(const glm::dvec3& v) { return {-v.x, -v.y, v.z}; }

// `side` of the picture is what the fov spans.
inline Json pose_of(const Camera& camera, int side) {
  const glm::dmat3 axes = glm::transpose(camera.world_to_camera);
  return {{"position", json_of(turned(camera.position))},
          {"target", json_of(turned(camera.position + axes[2] * 0.9))},
          {"up", json_of(-turned(axes[1]))},
          {"fov", glm::degrees(2 * std::atan(side / 2.0 / camera.fy))}};
}

inline Json playcanvas_frames(const std::vector<Camera>& cameras) {
  Json frames = Json::array();
  for (const Camera& camera : cameras) frames.push_back(pose_of(camera, camera.height));
  return {{"frameRate", 30}, {"frames", frames}};
}

// The cameras must not roll; pictures are wider than high.
inline Json supersplat_viewer(const std::vector<Camera>& cameras) {
  Json values = {{"position", Json::array()}, {"target", Json::array()}, {"fov", Json::array()}}, times = Json::array();
  for (const Camera& camera : cameras) {
    const Json pose = pose_of(camera, camera.width);
    for (const char* field : {"position", "target"}) {
      for (const Json& number : pose[field]) values[field].push_back(number);
    }
    values["fov"].push_back(pose["fov"]);
    times.push_back(30 * times.size());
  }
  Json start = pose_of(cameras[0], cameras[0].width);
  start.erase("up");
  return {{"version", 2},
          {"cameras", {{{"initial", start}}}},
          {"animTracks", {{{"name", "a"}, {"keyframes", {{"times", times}, {"values", values}}}}}}};
}

inline Json supersplat_editor(const std::vector<Camera>& cameras) {
  Json poses = Json::array();
  for (const Camera& camera : cameras) {
    Json pose = pose_of(camera, camera.width);
    pose.erase("up");
    pose["name"] = camera.name;
    poses.push_back(pose);
  }
  return {{"camera", {{"fov", 50}}}, {"poseSets", {{{"name", "set0"}, {"poses", poses}}}}};
}

// A unit quaternion of a rotation, w first.
inline glm::dvec4 quaternion_of(const glm::dmat3& m) {
  const auto r = [&](int row, int column) { return m[column][row]; };
  const double w = std::sqrt(std::max(0.0, 1 + r(0, 0) + r(1, 1) + r(2, 2))) / 2;
  return {w, (r(2, 1) - r(1, 2)) / (4 * w), (r(0, 2) - r(2, 0)) / (4 * w), (r(1, 0) - r(0, 1)) / (4 * w)};
}

inline ColmapModel colmap(const std::vector<Camera>& cameras) {
  ColmapModel model;
  const Camera& first = cameras[0];
  model.parameters = {first.fx, first.fy, first.cx + 0.5, first.cy + 0.5};
  model.lenses = {{.id = 7, .width = first.width, .height = first.height}};
  model.poses.clear();
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Camera& camera = cameras[i];
    model.poses.push_back({static_cast<std::uint32_t>(3 * i + 2), 7, quaternion_of(camera.world_to_camera),
                           -(camera.world_to_camera * camera.position), camera.name});
  }
  return model;
}

}  // namespace pipegs::camera_file
