// SPDX-License-Identifier: Apache-2.0
// split_scene.cpp: split_scene GAUSSIANS FOLDER WxH...: our own scene in so many Gaussians, to measure what large ones
// take, as FOLDER/scene.ply of SH degree 1, and its views at each of these sizes as FOLDER/cameras.json.
//
// Errors  Exit code 2: bad use, in one line.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "scenes/generate/generate.hpp"
#include "scenes/ply/ply.hpp"
#include "scenes/text/number.hpp"
#include "sim/command/picture_size.hpp"

namespace pipegs {
namespace {

void split(int argc, char** argv) {
  if (argc < 4) throw ConfigError("expected GAUSSIANS FOLDER WxH...");
  const auto gaussians = parse_integer<std::size_t>(argv[1], 1, std::size_t{1} << 24);
  const std::filesystem::path folder = argv[2];
  std::vector<Camera> cameras;
  for (int i = 3; i < argc; ++i) {
    const PictureSize size = picture_size("WxH", argv[i]);
    for (const Camera& camera : generated_cameras()) {
      cameras.push_back(resized(camera, size.width, size.height));
      cameras.back().name += fmt::format("_{}", argv[i]);
      cameras.back().id = static_cast<int>(cameras.size()) - 1;
    }
  }
  const Scene parts = split_scene(generate_scene(1), gaussians, 1, 1);
  std::filesystem::create_directories(folder);
  write_ply(folder / "scene.ply", parts);
  write_cameras(folder / "cameras.json", cameras);  // last: who finds it finds the scene
}

}  // namespace
}  // namespace pipegs

int main(int argc, char** argv) {
  try {
    pipegs::split(argc, argv);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "split_scene: {}\n", error.what());
    return 2;
  }
}
