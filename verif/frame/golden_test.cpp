// golden_test: the whole golden model against the float64 truth, and what it must not depend on.
#include <gtest/gtest.h>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "sim/simulate.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

TEST(Golden, ComesCloseToTheTruthInTheSameOrder) {
  for (const auto& [alpha_w, color_w, decibel] : {std::tuple{8, 12, 50.0}, {10, 14, 58.0}, {12, 16, 64.0}}) {
    SimulateOptions options;
    options.config.alpha_w = alpha_w;
    options.config.color_w = color_w;
    const Scene scene = random_scene(1, 3000, 3);
    const Camera camera = test_camera(160, 120, 120);
    Simulation result;
    simulate_golden(scene, camera, options, result);
    simulate_truth(scene, camera, options, result);
    EXPECT_GT(result.psnr_numeric, decibel) << "alpha " << alpha_w << " bit";
    RecordProperty("psnr_alpha_" + std::to_string(alpha_w), std::to_string(result.psnr_numeric));
  }
}

TEST(Golden, DoesNotDependOnThreadsUnitsOrStores) {
  const Scene scene = random_scene(2, 2000, 1);
  const Camera camera = test_camera(200, 140);
  SimulateOptions options;
  Simulation first;
  simulate_golden(scene, camera, options, first);
  options.config.units = 1;
  options.config.alpha_lines = 64;
  options.config.pixels_per_row = 1;
  Simulation second;
  simulate_golden(scene, camera, options, second);
  EXPECT_EQ(first.golden.pixels, second.golden.pixels);
  EXPECT_EQ(golden_frame(first.input, {.threads = 1, .progress = {}}).pixels, first.golden.pixels);
}

TEST(Golden, OneWindowIsTheCropOfTheFrame) {
  const Scene scene = random_scene(4, 2000, 0);
  const Camera camera = test_camera(200, 140);
  SimulateOptions options;
  Simulation all, one;
  simulate_golden(scene, camera, options, all);
  options.window = {1, 1};
  simulate_golden(scene, camera, options, one);
  EXPECT_EQ(max_abs_error(crop_window(all.golden.image, options), crop_window(one.golden.image, options)), 0);
}

TEST(Golden, RanksEveryGaussianEvenWhenTheLastOnesAreLeftOut) {
  Scene scene = random_scene(8, 300, 0);
  for (size_t i = 290; i < 300; ++i) scene.gaussians[i].opacity_logit = -20;  // below 1/255: not packed
  SimulateOptions options;
  Simulation result;
  simulate_golden(scene, test_camera(64, 64), options, result);
  EXPECT_EQ(result.golden.rank.size(), scene.gaussians.size());
  simulate_truth(scene, test_camera(64, 64), options, result);
  EXPECT_GT(result.psnr_numeric, 50);
}

TEST(Golden, TransmittanceAndWeightsSumToOne) {
  // A white scene: every colour is 1, so accumulated colour = sum of weights = 1 - T up to the colour's own rounding.
  Scene scene = random_scene(6, 1500, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.sh_dc = glm::vec3(0.5f / 0.28209479177387814f);
  Simulation result;
  simulate_golden(scene, test_camera(128, 128), SimulateOptions{}, result);
  for (size_t i = 0; i < result.golden.image.rgb.size(); ++i) {
    ASSERT_NEAR(result.golden.image.rgb[i].r, 1 - result.golden.image.transmittance[i], 0.01) << "pixel " << i;
  }
}

TEST(Golden, EveryWindowSideGivesThePictureWithinTheRoundingOfItsAnchors) {
  const Scene scene = random_scene(7, 1500, 0);
  const Camera camera = test_camera(130, 100);
  SimulateOptions options;
  Simulation reference;
  simulate_golden(scene, camera, options, reference);
  for (const int side : {16, 32}) {
    options.config.window = side;
    Simulation result;
    simulate_golden(scene, camera, options, result);
    EXPECT_GT(psnr(result.golden.image, reference.golden.image), 60) << "window " << side;
  }
}

}  // namespace
}  // namespace pipegs
