// SPDX-License-Identifier: Apache-2.0
// Hard orders and loads: overflow, imbalance, ties, popping, depth bits, sizes of the machine (T16 to T20, T29 of
// docs/numerics/stability.md).
#include <cmath>

#include "cpp_model/float/metrics.hpp"
#include "scenes/generate/generate.hpp"
#include "scenes/input_error.hpp"
#include "verif/stability/support/stability.hpp"

namespace pipegs {
namespace {

SimulateOptions tiny_machine() { return stable_machine({"units=1", "alpha_lines=64", "records=16"}); }

std::vector<uint64_t> rtl_pixels(const Scene& scene, const Camera& camera, const SimulateOptions& options,
                                 Simulation& simulation) {
  simulate_golden(scene, camera, options, simulation);
  expect_rtl_equal(testing::UnitTest::GetInstance()->current_test_info()->name(), options, simulation);
  return simulation.golden.pixels;
}

// Every store overflows: bytes and cycles, no pixel. Beyond the index the packer refuses in one line.
TEST(Stability, T16_OverflowChangesNothing) {
  const Scene scene = random_scene(116, 1500, 0);
  const Camera camera = test_camera(100, 64);
  Simulation large, small, none, one;
  const std::vector<uint64_t> expected = rtl_pixels(scene, camera, stable_machine(), large);
  EXPECT_EQ(rtl_pixels(scene, camera, tiny_machine(), small), expected);
  EXPECT_GT(small.rtl.overflow_lines, 100u);
  rtl_pixels(scene_of({}), camera, tiny_machine(), none);
  rtl_pixels(scene_of({gaussian_at({0, 0, 1}, 30.0f)}), test_camera(300, 200), tiny_machine(), one);
  EXPECT_EQ(one.golden.work.records, 20u) << "one Gaussian in every window";
  SimulateOptions narrow = stable_machine({"index_w=16"});
  Simulation refused;
  try {
    simulate_golden(scene_of(std::vector<Gaussian>((size_t{1} << 16) + 1, gaussian_at({0, 0, 1}))), camera, narrow,
                    refused);
    FAIL() << "65537 Gaussians in an index of 16 bits";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("at most 65536 fit"), std::string::npos) << error.what();
  }
}

// A thousand Gaussians in one region beside windows with one: queues fill and wait, nothing is lost.
TEST(Stability, T17_OneTileHoldsAlmostAll) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 1200; ++i)
    gaussians.push_back(gaussian_at(
        {0.0007f * static_cast<float>(i % 11), 0.0007f * static_cast<float>(i % 7), 2 + 0.002f * static_cast<float>(i)},
        0.003f, 0.02 + 0.0005 * (i % 50)));
  for (int i = 0; i < 6; ++i) gaussians.push_back(gaussian_at({0.4f * static_cast<float>(i - 3), 0.3f, 2}, 0.01f));
  expect_stable("T17", scene_of(gaussians), test_camera(130, 70));
}

// Equal depths are drawn in the order of the file, whatever the memory, the units and the seed.
TEST(Stability, T18_EqualDepthsHaveOneOrder) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 400; ++i)
    gaussians.push_back(
        gaussian_at({0.05f * static_cast<float>(i % 20 - 10), 0.05f * static_cast<float>(i / 20 - 10), 2}, 0.06f, 0.5,
                    {static_cast<float>(i % 3), static_cast<float>(i % 5) - 2, 0}));
  const Scene scene = scene_of(gaussians);
  const Camera camera = test_camera(70, 70);
  std::vector<uint64_t> first;
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    SimulateOptions options = seed == 3 ? tiny_machine() : stable_machine();
    options.rtl.seed = options.memory.seed = seed;
    Simulation simulation;
    const std::vector<uint64_t> pixels = rtl_pixels(scene, camera, options, simulation);
    if (first.empty()) first = pixels;
    EXPECT_EQ(pixels, first);
    for (uint32_t i = 1; i < 400; ++i) ASSERT_LT(simulation.golden.rank[i - 1], simulation.golden.rank[i]);
  }
  expect_stable("T18", scene, camera);
}

// Pairs that are drawn against the order of depth, and pairs that change their order when the camera turns by half a
// degree.
TEST(Stability, T19_PoppingOfLayersAndOfDepth) {
  const Scene scene = random_scene(119, 700, 0);
  Camera cameras[2] = {test_camera(128, 96, 110), test_camera(128, 96, 110)};
  for (int v = 0; v < 2;
       ++v) {  // turned against the grid, so that a slab's far end lies behind the next slab's near one
    const double turn = glm::radians(35 + 0.5 * v);
    cameras[v].world_to_camera = {{std::cos(turn), 0, -std::sin(turn)}, {0, 1, 0}, {std::sin(turn), 0, std::cos(turn)}};
  }
  std::printf(
      "T19 design point: pairs out of depth order; pairs that swap between two views half a degree apart, of them not "
      "by "
      "depth\n");
  for (const SimulateOptions& options : stable_machines()) {
    std::vector<uint32_t> rank[2];
    std::vector<double> depth[2];
    std::vector<bool> drawn(scene.gaussians.size(), true);
    for (int v = 0; v < 2; ++v) {
      Simulation simulation;
      simulate_golden(scene, cameras[v], options, simulation);
      rank[v] = simulation.golden.rank;
      std::vector<bool> here(scene.gaussians.size(), false);
      for (uint64_t y = 0; y <= simulation.input.frame.raster.windows.last_y; ++y) {
        for (uint64_t x = 0; x <= simulation.input.frame.raster.windows.last_x; ++x) {
          for (const GoldenLayer& layer : golden_window(simulation.input, x, y).layers) {
            for (const GoldenSplat& splat : layer.splats) here[splat.splat.index] = true;
          }
        }
      }
      for (size_t i = 0; i < drawn.size(); ++i) drawn[i] = drawn[i] && here[i];
      for (const Gaussian& g : scene.gaussians) depth[v].push_back((cameras[v].world_to_camera * glm::dvec3(g.mean)).z);
    }
    size_t misordered = 0, swapped = 0, not_by_depth = 0;
    for (size_t i = 0; i < drawn.size(); ++i) {
      for (size_t k = 0; k < i; ++k) {
        if (!drawn[i] || !drawn[k]) continue;
        // Keys of 18 mantissa bits: nearer pairs are ties.
        const bool tie =
            std::abs(depth[0][i] / depth[0][k] - 1) < 0x1p-17 || std::abs(depth[1][i] / depth[1][k] - 1) < 0x1p-17;
        if (tie) continue;
        const bool before[2] = {rank[0][i] < rank[0][k], rank[1][i] < rank[1][k]},
                   nearer[2] = {depth[0][i] < depth[0][k], depth[1][i] < depth[1][k]};
        misordered += before[0] != nearer[0];
        swapped += before[0] != before[1];
        not_by_depth += before[0] != before[1] && nearer[0] == nearer[1];
      }
    }
    std::printf("T19 %s: %zu; %zu, %zu\n", options.config.has_watermarks() ? "exact" : "dop", misordered, swapped,
                not_by_depth);
    if (options.config.has_watermarks()) {
      EXPECT_EQ(misordered, 0u);
      EXPECT_EQ(not_by_depth, 0u);
    } else {
      EXPECT_GT(misordered, 0u) << "layers of a turned grid should show";
    }
  }
}

// Fewer depth bits, more ties: the order error against depth bits, golden only for the widths that are not built.
TEST(Stability, T20_DepthBits) {
  Scene scene = random_scene(120, 1200, 0);
  for (Gaussian& g :
       scene.gaussians) {  // all within a twentieth of their depth: far splats that share what few bits there are
    const float z = std::abs(g.mean.z), to = 10 + 0.5f * (z - std::floor(z));
    g.mean *= to / z;
    g.mean.z = to;
    g.log_scale += std::log(to / z);
  }
  const Camera camera = test_camera(128, 96, 110);
  double last = 0;
  for (const int bits : {12, 14, 16, 18, 20, 24, 30}) {
    SimulateOptions options = stable_machine(kExact);
    options.config.depth_w = bits;
    Simulation simulation;
    simulate_golden(scene, camera, options, simulation);
    simulate_truth(scene, camera, options, simulation);
    const double order = std::min(simulation.psnr_order, 200.0);
    std::printf("T20 depth_w %d: order error %.1f dB, with the numeric one %.1f dB\n", bits, order,
                psnr(simulation.golden.image, simulation.truth_exact));
    EXPECT_GE(order, last - 1) << bits << " bits";
    last = order;
    if (bits == Config{}.depth_w) {
      EXPECT_GT(order, 60);
      expect_rtl_equal("T20", options, simulation);
    }
  }
}

// One, two and four units, one and two pixels a row: the same pixels.
TEST(Stability, T29_SizesOfTheMachine) {
  const Scene scene = random_scene(129, 500, 1);
  const Camera camera = test_camera(140, 70);
  Simulation four, two, one, quarter;
  const std::vector<uint64_t> exact = rtl_pixels(scene, camera, stable_machine(kExact), four);
  EXPECT_EQ(
      rtl_pixels(scene, camera,
                 stable_machine({"units=2", "late=1", "order=2", "records=16", "bus_w=128", "clock_gates=0"}), two),
      exact);
  const std::vector<uint64_t> layered = rtl_pixels(scene, camera, stable_machine(), one);
  EXPECT_EQ(rtl_pixels(scene, camera, tiny_machine(), quarter), layered);
  expect_stable("T29", scene, camera, {.rtl = false});
}

}  // namespace
}  // namespace pipegs
