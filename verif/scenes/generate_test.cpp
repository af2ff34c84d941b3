// SPDX-License-Identifier: Apache-2.0
// Against scenes/generate/generate: the same bits every time, the statistics of a trained scene, any count.
//
// Idea    kHash pins seed 1 bit by bit. When the scene is changed on purpose, the failing test
//         prints the new value to paste here; when nothing was changed, something is not portable.
#include "scenes/generate/generate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "cpp_model/float/truth.hpp"
#include "scenes/info.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kHash = 0x18e826bf9f405068;

std::uint64_t hash(const Scene& scene) {
  std::uint64_t h = 0xcbf29ce484222325u;  // FNV-1a
  const auto eat = [&](const void* data, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) h = (h ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  };
  eat(scene.gaussians.data(), scene.gaussians.size() * sizeof(Gaussian));
  eat(scene.sh_rest.data(), scene.sh_rest.size() * sizeof(float));
  return h;
}

TEST(Generate, IsTheSameSceneEveryTime) {
  const std::uint64_t found = hash(generate_scene(1, 6000));
  EXPECT_EQ(found, hash(generate_scene(1, 6000)));
  EXPECT_NE(found, hash(generate_scene(2, 6000)));
  EXPECT_EQ(found, kHash) << std::hex << "hash of seed 1 is 0x" << found;
}

TEST(Generate, GivesExactlyTheCountAskedFor) {
  for (const std::size_t count : {0u, 1u, 2u, 10u, 77u, 500u, 3001u}) {
    const Scene scene = generate_scene(3, count);
    EXPECT_EQ(scene.gaussians.size(), count);
    EXPECT_EQ(scene.sh_rest.size(), count * 45);
    EXPECT_EQ(inspect(scene).usable, count);
  }
}

TEST(Generate, HasTheStatisticsOfATrainedScene) {
  const Scene scene = generate_scene(1);
  const SceneInfo info = inspect(scene);
  EXPECT_EQ(info.usable, kGeneratedCount);
  EXPECT_EQ(info.sh_degree, 3);
  EXPECT_LT(info.lowest.x, -1500);  // unbounded
  EXPECT_GT(info.highest.x, 1500);
  EXPECT_GT(info.scale[6] / info.scale[0], 1e4);  // near and far
  EXPECT_LT(info.opacity[1], 0.05);               // faint ones
  EXPECT_GT(info.opacity[4], 0.9);                // solid ones
  EXPECT_GT(info.anisotropy[5], 20);              // needles
  EXPECT_LT(info.anisotropy[6], 200);
  EXPECT_LT(info.faint_share, 0.01);
}

TEST(Generate, FillsEveryViewWithLight) {
  const Scene scene = generate_scene(1);
  for (Camera camera : generated_cameras()) {
    EXPECT_EQ(camera.width, 1024);
    EXPECT_EQ(camera.height, 768);
    camera.width /= 4;  // a quarter of the resolution is enough to see a hole
    camera.height /= 4;
    camera.fx /= 4;
    camera.fy /= 4;
    camera.cx = (camera.width - 1) / 2.0;
    camera.cy = (camera.height - 1) / 2.0;
    const Image image = render_truth(scene, camera, {});
    double through = 0, worst = 0, light = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      through += image.transmittance[i];
      worst = std::max(worst, image.transmittance[i]);
      light += image.rgb[i].y;
    }
    const auto pixels = static_cast<double>(image.rgb.size());
    EXPECT_LT(through / pixels, 0.02) << camera.name;
    EXPECT_LT(worst, 0.5) << camera.name;
    EXPECT_GT(light / pixels, 0.25) << camera.name;
    EXPECT_LT(light / pixels, 0.75) << camera.name;
  }
}

}  // namespace
}  // namespace pipegs
