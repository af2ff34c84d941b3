// SPDX-License-Identifier: Apache-2.0
// frame_setup_test: what cpp_model/frame_setup.cpp covers and what it refuses; its words are frame_words_test's matter.
#include "cpp_model/frame_setup.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include "verif/dopu/dopu_world.hpp"

namespace pipegs {
namespace {

struct FrameSetup : testing::Test {
  std::mt19937_64 rng{1};
  Config config;
  PackedScene packed = pack_scene(config, random_scene(rng, 100), 30);

  std::string error(const Camera& camera, const std::optional<WindowRange>& windows = {}) {
    try {
      frame_setup(config, packed, camera, windows);
    } catch (const FrameError& e) { return e.what(); }
    return "";
  }
};

TEST_F(FrameSetup, TheQuaternionIsTheRotation) {
  for (int i = 0; i < 2000; ++i) {
    const Camera camera = random_camera(rng, 640, 480);
    const Frame f = frame_setup(config, packed, camera);
    const auto real = [](int64_t field) { return std::ldexp(static_cast<double>(field), -18); };
    const auto& q = f.camera.quaternion;
    const glm::dmat3 matrix = glm::mat3_cast(glm::dquat(real(q.w), real(q.x), real(q.y), real(q.z)));
    for (int k = 0; k < 9; ++k) ASSERT_NEAR(matrix[k % 3][k / 3], camera.world_to_camera[k % 3][k / 3], 3e-5);
    std::vector<uint32_t> words(static_cast<size_t>(record_words<Frame>(config)));
    pack(config, f, words.data());  // throws when a field does not fit
  }
}

TEST_F(FrameSetup, CoversTheImageWithWindows) {
  Camera camera = random_camera(rng, 640, 480);
  camera.width = 1;
  camera.height = 65;
  Frame f = frame_setup(config, packed, camera);
  EXPECT_EQ(f.raster.windows.last_x, 0u);
  EXPECT_EQ(f.raster.windows.last_y, 1u);
  EXPECT_GE(f.tables.overflow, f.tables.pixels + 2 * 64 * 64 / 8);
  f = frame_setup(config, packed, camera, WindowRange{0, 1, 0, 1});
  EXPECT_EQ(f.raster.windows.first_y, 1u);
}

TEST_F(FrameSetup, RefusesWithOneLineWhatDoesNotFit) {
  const Camera good = random_camera(rng, 640, 480);
  EXPECT_EQ(error(good), "");
  Camera bad = good;
  bad.fx = 20000;
  EXPECT_NE(error(bad).find("the focal length fx is 20000"), std::string::npos) << error(bad);
  bad = good;
  bad.position.y = 1e9;
  EXPECT_NE(error(bad).find("the position y is 1e+09"), std::string::npos) << error(bad);
  bad = good;
  bad.fy = 1;
  EXPECT_NE(error(bad).find("guard band"), std::string::npos) << error(bad);
  bad = good;
  bad.fx = std::nan("");
  EXPECT_NE(error(bad), "");
  bad = good;
  bad.width = 0;
  EXPECT_NE(error(bad).find("the width is 0"), std::string::npos) << error(bad);
  EXPECT_NE(error(good, WindowRange{0, 0, 10, 0}).find("do not lie in 10 x 8 windows"), std::string::npos)
      << error(good, WindowRange{0, 0, 10, 0});
  Camera large = good;
  large.width = 65 * config.window, large.height = 64 * config.window, large.fx = large.fy = 4000;
  EXPECT_EQ(error(large), "");
  config.order = 1;
  packed = pack_scene(config, random_scene(rng, 100), 30);
  EXPECT_NE(error(large).find("4160 windows, but order = 1 has 4096 lists at most"), std::string::npos) << error(large);
  EXPECT_EQ(error(large, WindowRange{0, 0, 63, 63}), "");
  config.window = 16;  // a tile each: 2^14 lists
  packed = pack_scene(config, random_scene(rng, 100), 30);
  large.width = 128 * config.window, large.height = 128 * config.window;
  EXPECT_EQ(error(large), "");
  large.width += 1;
  EXPECT_NE(error(large).find("16512 windows, but order = 1 has 16384 lists at most"), std::string::npos)
      << error(large);
  config.units = 1;
  EXPECT_NE(error(good).find("another configuration"), std::string::npos);
}

}  // namespace
}  // namespace pipegs
