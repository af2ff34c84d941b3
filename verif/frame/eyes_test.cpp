// SPDX-License-Identifier: Apache-2.0
// eyes_test: two pictures by one walk of the scene (eyes = 2): each is what a frame of this eye alone gives, and what a
// camera in its place sees.
#include <gtest/gtest.h>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "cpp_model/frame_setup.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/config_file.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// Windows of four squares and of one, in order of depth and layer by layer.
const std::vector<std::vector<std::string>> kMachines = {{},
                                                         {"window=64"},
                                                         {"window=32", "units=2"},
                                                         {"order=0", "occlusion=0", "tight_boxes=0"},
                                                         {"aov_depth=1", "aov_index=1"}};

SimulateOptions with_eyes(const std::vector<std::string>& settings, double half_x, double half_y = 0) {
  SimulateOptions options;
  options.config = find_design_point("fast").config;
  config_set(options.config, "eyes=2");
  for (const std::string& setting : settings) config_set(options.config, setting);
  config_check(options.config);
  options.half_eye = {half_x, half_y};
  options.aovs = 15;
  return options;
}

void expect_same(const GoldenPicture& a, const GoldenPicture& b) {
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.aovs, b.aovs);
  EXPECT_EQ(a.stopped, b.stopped);
}

// As near as eyes are, far beyond the window, and so far apart that neither sees what the other does.
TEST(Eyes, ThePairIsTwoFrames) {
  const Scene scene = random_scene(90, 1500, 2);
  const Camera camera = test_camera(150, 90);
  for (const auto& settings : kMachines) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.03, 0.0}, {0.8, -0.3}, {50.0, 0.0}}) {
      SCOPED_TRACE(testing::Message() << x << "," << y << " " << (settings.empty() ? "" : settings.front()));
      SimulateOptions options = with_eyes(settings, x, y);
      Simulation both, left, right;
      simulate_golden(scene, camera, options, both);
      options.eyes = 1;
      simulate_golden(scene, camera, options, left);
      options.eyes = 2;
      simulate_golden(scene, camera, options, right);
      ASSERT_TRUE(both.golden.second && !left.golden.second && !right.golden.second);
      expect_same(both.golden, left.golden);
      expect_same(*both.golden.second, right.golden);
      EXPECT_EQ(both.golden.rank.size(), scene.gaussians.size());
    }
  }
}

// Eyes in one place are one camera, to the bit, on a machine that has one.
TEST(Eyes, InOnePlaceAreOneCamera) {
  const Scene scene = random_scene(91, 1500, 2);
  const Camera camera = test_camera(150, 90);
  SimulateOptions options = with_eyes({}, 0);
  Simulation both, one;
  simulate_golden(scene, camera, options, both);
  options.config.eyes = 1;
  simulate_golden(scene, camera, options, one);
  EXPECT_EQ(both.golden.pixels, one.golden.pixels);
  EXPECT_EQ(both.golden.second->pixels, one.golden.pixels);
}

// What is fetched is fetched once.
TEST(Eyes, ShareTheWalk) {
  const Scene scene = random_scene(92, 3000, 1);
  const Camera camera = test_camera(150, 90);
  SimulateOptions options = with_eyes({}, 0.02);
  Simulation both, left, right;
  simulate_golden(scene, camera, options, both);
  options.eyes = 1;
  simulate_golden(scene, camera, options, left);
  options.eyes = 2;
  simulate_golden(scene, camera, options, right);
  EXPECT_LT(both.golden.work.fetched, (left.golden.work.fetched + right.golden.work.fetched) * 6 / 10);
  EXPECT_EQ(both.golden.work.visible, left.golden.work.visible + right.golden.work.visible);
}

// A window that holds too much for both eyes is walked for each alone, and then nothing is fetched that a frame of this
// eye would not; one that holds too much for either goes by its parts. The pictures stay what they are.
TEST(Eyes, HaveWalksOfTheirOwnWhereAWindowIsFull) {
  const Scene scene = random_scene(95, 3000, 1);
  const Camera camera = test_camera(150, 90);
  SimulateOptions options = with_eyes({}, 0.05);
  options.walk_most = 0;
  Simulation whole;
  simulate_golden(scene, camera, options, whole);
  const Config& config = options.config;
  std::array<int, 3> seen = {};  // windows: together, by eye, by part
  for (const uint64_t most : {1, 200, 1500, 3000, 4500, 6000, 100000}) {
    SCOPED_TRACE(most);
    options.walk_most = most, options.eyes = 3;
    Simulation both, left, right;
    simulate_golden(scene, camera, options, both);
    expect_same(both.golden, whole.golden);
    expect_same(*both.golden.second, *whole.golden.second);
    options.eyes = 1;
    simulate_golden(scene, camera, options, left);
    options.eyes = 2;
    simulate_golden(scene, camera, options, right);
    bool all_alone = true;
    for (const uint64_t x : {0, 1}) {
      const uint64_t walk = golden_window(both.input, x, 0).walks.front();
      ++seen[walk == kWholeWalk ? 0 : walk_by_square(config, walk) ? 2 : 1];
      all_alone = all_alone && walk_eye(config, walk) != kAllEyes && !walk_by_square(config, walk);
    }
    if (all_alone) EXPECT_LE(both.golden.work.fetched, left.golden.work.fetched + right.golden.work.fetched);
  }
  for (const int some : seen) EXPECT_GT(some, 1);
}

TEST(Eyes, SeeWhatACameraInTheirPlaceSees) {
  const Scene scene = random_scene(93, 2500, 2);
  Camera camera = test_camera(150, 90, 120);
  const double turn = 0.3;  // about the axis down
  camera.world_to_camera = glm::dmat3(std::cos(turn), 0, -std::sin(turn), 0, 1, 0, std::sin(turn), 0, std::cos(turn));
  const SimulateOptions options = with_eyes({}, 0.15, 0.05);
  Simulation both;
  simulate_golden(scene, camera, options, both);
  for (const int eye : {0, 1}) {
    const Image truth = render_truth(scene, eye_camera(camera, options, eye), {});
    EXPECT_GT(psnr(eye == 0 ? both.golden.image : both.golden.second->image, truth), 45) << "eye " << eye;
  }
  EXPECT_LT(psnr(both.golden.image, both.golden.second->image), 35) << "the eyes were meant to see different things";
}

// A scene that was packed for eyes at their places does not know any others.
TEST(Eyes, TooFarApartAreRefused) {
  Simulation near, far;
  simulate_golden(random_scene(94, 100, 0), test_camera(64, 64), with_eyes({}, 0.03), near);
  EXPECT_NO_THROW(simulate_frame(near.packed, test_camera(64, 64), with_eyes({}, 1), far));
  EXPECT_THROW(simulate_frame(near.packed, test_camera(64, 64), with_eyes({}, 1e6), far), FrameError);
}

}  // namespace
}  // namespace pipegs
