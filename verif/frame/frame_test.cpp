// SPDX-License-Identifier: Apache-2.0
// frame_test: whole frames through the RTL, every stream and every pixel against the golden model.
//
// The RTL of each configuration is built before the tests run (verif/frame/CMakeLists.txt). A failure prints the first
// differing Gaussian, pixel and field.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "sim/compare/simulate.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

// Runs one frame and expects equality; returns the frame's pixels.
std::vector<uint64_t> expect_equal(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                                   Simulation& result) {
  simulate_golden(scene, camera, options, result);
  simulate_rtl(options, result);
  EXPECT_EQ(result.mismatches, 0u) << config_difference(options.config) << ", seed " << options.rtl.seed << ": window "
                                   << result.first_mismatch->window_x << "," << result.first_mismatch->window_y << ": "
                                   << result.first_mismatch->what;
  for (const auto* units : {&result.rtl.dopu, &result.rtl.pu, &result.rtl.su, &result.rtl.ru}) {
    for (const UnitCycles& unit : *units)
      EXPECT_EQ(unit.busy + unit.starved + unit.blocked + unit.memory, result.rtl.cycles);
  }
  return result.golden.pixels;
}

std::vector<uint64_t> expect_equal(const Scene& scene, const Camera& camera, const SimulateOptions& options) {
  Simulation result;
  return expect_equal(scene, camera, options, result);
}

void expect_equal_on_all_machines(const Scene& scene, const Camera& camera) {
  std::map<int, std::vector<uint64_t>> first;  // of each order
  for (const size_t i : todays()) {
    const SimulateOptions options = machine(i);
    const std::vector<uint64_t> pixels = expect_equal(scene, camera, options);
    // The grid changes the layers and so the order; cuts, widths and the oriented box change the picture. Units, pixels
    // per row and stores must not change a bit.
    if (options.config.grid != Config{}.grid || options.config.alpha_cut != Config{}.alpha_cut ||
        options.config.alpha_w != Config{}.alpha_w || options.config.oriented())
      continue;
    const auto& [order, equal] = *first.emplace(options.config.order, pixels).first;
    EXPECT_EQ(pixels, equal) << "the image depends on the machine: " << config_difference(options.config);
  }
}

TEST(Frame, AnEmptySceneIsBlackAndTransparent) {
  const Camera camera = test_camera(100, 70);
  expect_equal_on_all_machines(scene_of({}), camera);
  Simulation result;
  for (const uint64_t pixel : expect_equal(scene_of({}), camera, machine(kDop), result))
    ASSERT_EQ(pixel, uint64_t{0x8000} << 48);
}

TEST(Frame, OneGaussian) {
  Simulation result;
  expect_equal(scene_of({gaussian_at({0.1f, 0.05f, 2})}), test_camera(64, 64), machine(kDop), result);
  EXPECT_EQ(result.golden.work.records, 1u);
  EXPECT_GT(result.golden.work.blended, 0u);
  expect_equal_on_all_machines(scene_of({gaussian_at({0.1f, 0.05f, 2})}), test_camera(64, 64));
}

TEST(Frame, SizesThatAreNoMultipleOfAnything) {
  const Scene scene = random_scene(3, 400, 1);
  for (const auto& [width, height] : {std::pair{1, 1}, {17, 33}, {65, 63}, {130, 9}}) {
    SCOPED_TRACE(fmt::format("{}x{}", width, height));
    expect_equal_on_all_machines(scene, test_camera(width, height, 60));
  }
}

TEST(Frame, EverythingInOneRegion) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 600; ++i)
    gaussians.push_back(gaussian_at({0.001f * (i % 7), 0.001f * (i % 5), 2 + 0.003f * i}, 0.004f, 0.02 + 0.001 * i));
  expect_equal_on_all_machines(scene_of(gaussians), test_camera(64, 64));
}

TEST(Frame, AllDepthsEqualAreOrderedByIndex) {
  std::vector<Gaussian> gaussians;
  std::mt19937 rng(5);
  for (int i = 0; i < 900; ++i) {
    gaussians.push_back(gaussian_at(
        {(static_cast<float>(rng() % 2000) - 1000) / 1000, (static_cast<float>(rng() % 2000) - 1000) / 1000, 2}, 0.03f,
        0.5, {static_cast<float>(rng() % 100) / 50 - 1, 0, static_cast<float>(rng() % 100) / 50 - 1}));
  }
  expect_equal_on_all_machines(scene_of(gaussians), test_camera(96, 96));
}

TEST(Frame, CameraInsideGaussiansAndScreenFillingSplats) {
  std::vector<Gaussian> gaussians = random_scene(9, 200, 0).gaussians;
  for (const float z : {-0.5f, 0.0f, 0.19f, 0.2f, 0.21f, 0.3f, 1.0f})
    gaussians.push_back(gaussian_at({0, 0, z}, 3.0f, 0.3));
  gaussians.push_back(gaussian_at({40, 10, 0.25f}, 20.0f, 0.6));
  expect_equal_on_all_machines(scene_of(gaussians), test_camera(128, 96));
}

TEST(Frame, NeedlesFlatSplatsAndExtremeOpacities) {
  Scene scene = random_scene(11, 300, 0);
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    Gaussian& gaussian = scene.gaussians[i];
    if (i % 3 == 0) gaussian.log_scale = {gaussian.log_scale.z + 2, gaussian.log_scale.z - 12, -INFINITY};
    if (i % 4 == 0) gaussian.opacity_logit = i % 8 == 0 ? INFINITY : -5.5373f;  // opacity 1 and just about 1/255
  }
  expect_equal_on_all_machines(scene, test_camera(128, 128));
}

// On `fast`, whose windows of 128 pixels go whole, by parts, or some so and some so: every beat as the golden model
// says, and the same picture.
void expect_equal_in_parts(const Scene& scene, const Camera& camera) {
  SimulateOptions options = machine(kFast);
  std::vector<uint64_t> whole;
  for (const uint64_t most : {0, 1, 1500}) {
    SCOPED_TRACE(fmt::format("at most {}", most));
    options.walk_most = most;
    const std::vector<uint64_t> pixels = expect_equal(scene, camera, options);
    if (most == 0) whole = pixels;
    EXPECT_EQ(pixels, whole);
  }
}

TEST(Frame, WindowsWalkedPartByPart) {
  for (const uint64_t seed : {21, 22}) {  // the picture ends within a part, and with the first one of its window
    Scene scene = random_scene(seed, 3000, 1);
    for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale -= 1;
    expect_equal_in_parts(scene, seed == 21 ? test_camera(300, 150) : test_camera(180, 260, 300));
  }
}

TEST(Frame, PartsOfWhichOneHoldsAllOrNothing) {
  std::vector<Gaussian> corner, hole, fronts;
  for (int i = 0; i < 2500; ++i) {
    const float x = 0.01f * static_cast<float>(i % 50), y = 0.01f * static_cast<float>(i / 50);
    corner.push_back(gaussian_at({0.1f + x, 0.1f + y, 2}, 0.01f, 0.2));          // one depth; the last part
    hole.push_back(gaussian_at({-0.1f - x, -0.1f - y, 3 - 0.001f * i}, 0.01f));  // the last one is the first to be seen
  }
  // Opaque at once, and much behind: parts close while their chunks and ends are on their way.
  for (int i = 0; i < 1500; ++i)
    fronts.push_back(gaussian_at({0.02f * static_cast<float>(i % 39) - 0.4f, 0.02f * static_cast<float>(i / 39) - 0.4f,
                                  i < 40 ? 1.0f : 2 + 0.002f * i},
                                 i < 40 ? 0.3f : 0.02f, 0.999));
  for (const auto& gaussians : {corner, hole, fronts})
    expect_equal_in_parts(scene_of(gaussians), test_camera(128, 128));
}

TEST(Frame, AnAntialiasedSceneOnTheMachineThatCompensates) {
  Scene scene = random_scene(15, 400, 1);
  const Camera camera = test_camera(96, 70);
  const std::vector<uint64_t> plain = expect_equal(scene, camera, machine(kOdd));
  scene.antialiased = true;
  EXPECT_NE(expect_equal(scene, camera, machine(kOdd)), plain);
}

TEST(Frame, BadGaussiansAreLeftOutAndCounted) {
  Scene scene = random_scene(13, 200, 0);
  scene.gaussians[3].mean.x = NAN;
  scene.gaussians[4].log_scale.y = INFINITY;
  scene.gaussians[5].rotation = glm::vec4(0);
  Simulation result;
  expect_equal(scene, test_camera(64, 64), machine(kDop), result);
  EXPECT_EQ(result.packed.counts.non_finite, 2u);
  EXPECT_EQ(result.packed.counts.zero_quaternion, 1u);
}

TEST(Frame, EveryShDegree) {
  for (int degree = 0; degree <= 3; ++degree) {
    SCOPED_TRACE(degree);
    expect_equal_on_all_machines(random_scene(20 + static_cast<uint64_t>(degree), 500, degree), test_camera(128, 64));
  }
}

TEST(Frame, TinyStoresOverflowAndChangeNothing) {
  const Scene scene = random_scene(31, 4000, 2);
  const Camera camera = test_camera(192, 130);
  Simulation large, tiny;
  const std::vector<uint64_t> expected = expect_equal(scene, camera, machine(kDop), large);
  EXPECT_EQ(expect_equal(scene, camera, machine(kTiny), tiny), expected);
  EXPECT_GT(tiny.rtl.overflow_lines, 1000u) << "the stores were meant to overflow";
}

// So many at one depth that no watermark lets the default machine release one before it has no room left.
TEST(Frame, MoreThanTheDefaultMachineHoldsOfOneDepth) {
  std::vector<Gaussian> gaussians;
  std::mt19937 rng(7);
  for (int i = 0; i < 10000; ++i) {
    gaussians.push_back(
        gaussian_at({(static_cast<float>(rng() % 200) - 100) / 1000, (static_cast<float>(rng() % 200) - 100) / 1000, 2},
                    0.03f, 0.02));
  }
  Simulation result;
  expect_equal(scene_of(gaussians), test_camera(64, 64), machine(kFast), result);
  EXPECT_GT(result.rtl.overflow_lines, 1000u) << "the Sorting Units were meant to spill";
}

TEST(Frame, TheImageDoesNotDependOnTheMemory) {
  const Scene scene = random_scene(41, 3000, 3);
  const Camera camera = test_camera(192, 192, 150);
  std::vector<uint64_t> first;
  for (const auto& [latency, bandwidth, jitter, queue, seed] :
       {std::tuple{1, 64.0, 0, 256, 1}, {100, 51.2, 50, 64, 2}, {400, 6.4, 400, 4, 3}, {30, 25.6, 200, 1, 4}}) {
    for (const size_t number : {kDop, kTiny}) {
      SimulateOptions options = machine(number);
      options.memory = {.latency = latency,
                        .bytes_per_cycle = bandwidth,
                        .jitter = jitter,
                        .queue = queue,
                        .seed = static_cast<uint64_t>(seed)};
      options.rtl.seed = static_cast<uint64_t>(seed);
      const std::vector<uint64_t> pixels = expect_equal(scene, camera, options);
      if (first.empty()) first = pixels;
      EXPECT_EQ(pixels, first);
    }
  }
}

TEST(Frame, AnOpaqueFrontStopsFetchingTheRest) {
  Scene scene = random_scene(51, 3000, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.mean.z = std::abs(gaussian.mean.z) + 5;
  Simulation open, hidden;
  const Camera camera = test_camera(64, 64);
  expect_equal(scene, camera, machine(kDop), open);
  for (int i = 0; i < 60; ++i) scene.gaussians.push_back(gaussian_at({0, 0, 1.0f + 0.01f * i}, 6.0f, 0.999));
  expect_equal(scene, camera, machine(kDop), hidden);
  const auto geometry = [](const Simulation& s) { return s.traffic[3].bytes_read; };
  EXPECT_LT(geometry(hidden), geometry(open));
}

}  // namespace
}  // namespace pipegs
