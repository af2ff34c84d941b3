// SPDX-License-Identifier: Apache-2.0
// colmap_file: COLMAP's three files as a test writes them, both kinds, and the folder round them.
//
// Use     ColmapModel model;  ... change what the test is about ...;  model.write(folder)
// Idea    The model as it is has two photographs of four points; each field can be set to what no file should hold.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scenes/colmap/colmap.hpp"

namespace pipegs {

template <class... Values>
std::string bytes_of(const Values&... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}

struct ColmapModel {
  int model = 1;  // PINHOLE
  std::vector<double> parameters = {30, 31, 20, 15};
  std::vector<ColmapLens> lenses = {{.id = 7, .width = 40, .height = 30}};
  // The second one looks along +x from (-2, 0, 0): its axis x is the world's -z.
  std::vector<ColmapPose> poses = {{2, 7, {0.70710678118654752, 0, -0.70710678118654752, 0}, {0, 0, 2}, "b.png"},
                                   {1, 7, {1, 0, 0, 0}, {0, 0, 3}, "a.png"}};
  std::vector<ScenePoint> points = {
      {{0, 0, 0}, {255, 0, 51}}, {{1, 0, 0}, {0, 0, 0}}, {{0, 1, 0}, {9, 9, 9}}, {{0, 0, 1}, {1, 2, 3}}};

  std::string cameras_bin() const {
    std::string bytes = bytes_of(std::uint64_t{lenses.size()});
    for (const ColmapLens& lens : lenses) {
      bytes +=
          bytes_of(lens.id, model, static_cast<std::uint64_t>(lens.width), static_cast<std::uint64_t>(lens.height));
      for (const double parameter : parameters) bytes += bytes_of(parameter);
    }
    return bytes;
  }
  std::string images_bin() const {
    std::string bytes = bytes_of(std::uint64_t{poses.size()});
    for (const ColmapPose& pose : poses) {
      bytes += bytes_of(pose.id, pose.rotation[0], pose.rotation[1], pose.rotation[2], pose.rotation[3]);
      bytes += bytes_of(pose.translation.x, pose.translation.y, pose.translation.z, pose.lens) + pose.name + '\0';
      bytes += bytes_of(std::uint64_t{1}, 3.5, 4.5, std::int64_t{-1});  // one 2D point
    }
    return bytes;
  }
  std::string points_bin() const {
    std::string bytes = bytes_of(std::uint64_t{points.size()});
    for (const ScenePoint& point : points) {
      bytes += bytes_of(std::uint64_t{5}, point.position.x, point.position.y, point.position.z);
      bytes += bytes_of(point.color.x, point.color.y, point.color.z, 0.5);
      bytes += bytes_of(std::uint64_t{2}, 1, 0, 2, 0);  // a track of two
    }
    return bytes;
  }
  std::string cameras_txt() const {
    std::string text = "# Camera list\n";
    for (const ColmapLens& lens : lenses) {
      text += fmt::format("{} {} {} {}", lens.id, model == 1 ? "PINHOLE" : "SIMPLE_PINHOLE", lens.width, lens.height);
      for (const double parameter : parameters) text += fmt::format(" {}", parameter);
      text += "\n";
    }
    return text;
  }
  std::string images_txt() const {
    std::string text = "# Image list\r\n";
    for (const ColmapPose& pose : poses) {
      text += fmt::format("{} {} {} {} {} {} {} {} {} {}\n", pose.id, pose.rotation[0], pose.rotation[1],
                          pose.rotation[2], pose.rotation[3], pose.translation.x, pose.translation.y,
                          pose.translation.z, pose.lens, pose.name);
      text += pose.id == 1 ? "\n" : "3.5 4.5 -1\n";  // no 2D points: an empty line
    }
    return text;
  }
  std::string points_txt() const {
    std::string text;
    for (const ScenePoint& point : points)
      text += fmt::format("5 {} {} {} {} {} {} 0.5 1 0 2 0\n", point.position.x, point.position.y, point.position.z,
                          point.color.x, point.color.y, point.color.z);
    return text;
  }

  // FOLDER/sparse/0 and an empty file for each photograph.
  void write(const std::filesystem::path& folder, bool as_text = false) const {
    const std::filesystem::path sparse = folder / "sparse" / "0";
    std::filesystem::create_directories(sparse);
    std::filesystem::create_directories(folder / "images");
    const auto put = [](const std::filesystem::path& path, const std::string& content) {
      std::ofstream(path, std::ios::binary) << content;
    };
    put(sparse / (as_text ? "cameras.txt" : "cameras.bin"), as_text ? cameras_txt() : cameras_bin());
    put(sparse / (as_text ? "images.txt" : "images.bin"), as_text ? images_txt() : images_bin());
    put(sparse / (as_text ? "points3D.txt" : "points3D.bin"), as_text ? points_txt() : points_bin());
    for (const ColmapPose& pose : poses) put(folder / "images" / pose.name, "");
  }
};

}  // namespace pipegs
