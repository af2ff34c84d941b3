// SPDX-License-Identifier: Apache-2.0
// frame_words_test: the driver's frame, in integers, equals the same in doubles word for word: on every camera that is
// there, on random ones of every kind, for every design point and other widths; what it refuses; and its bounds.
//
// Needs   the cameras of the shared folder, found by PIPEGS_SHARED or beside the repository, in one of the tests, which
//         is skipped with a message when they are not there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "scenes/generate/generate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/dopu/frame_reference.hpp"

namespace pipegs {
namespace {

uint64_t seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

// A scene of which a frame sees no more than unit, grid and places.
PackedScene bare_scene(const Config& config, int exponent, std::mt19937_64& rng) {
  PackedScene scene;
  scene.config = config;
  scene.scene_exponent = exponent;
  scene.sh_degree = static_cast<int>(rng() % 4);
  scene.antialiased = config.antialias != 0 && rng() % 2 != 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    scene.grid.low[axis] = static_cast<int64_t>(rng()) >> (65 - config.world_w);
    scene.grid.scale[axis] = rng() >> (64 - config.focal_w());
  }
  uint64_t at = 0;
  for (uint64_t* place : {&scene.layout.cells, &scene.layout.groups, &scene.layout.chunks, &scene.layout.gaussians,
                          &scene.layout.colors, &scene.layout.pixels}) {
    *place = at;
    at += 1 + rng() % 1000000;
  }
  return scene;
}

std::vector<Config> machines() {
  std::vector<Config> configs;
  for (const DesignPoint& point : design_points()) configs.push_back(point.config);
  for (const char* settings :
       {"tan_f=16", "tan_f=24", "alpha_cut=32", "alpha_cut=1023", "alpha_cut=512 antialias=1", "world_w=32",
        "world_w=44", "window=16 pixel_w=32", "order=2 late=1 tight_cull=1", "tight_cull=1 alpha_cut=33 tan_f=17"}) {
    Config config;
    std::istringstream text(settings);
    for (std::string one; text >> one;) config_set(config, one);
    configs.push_back(config);
  }
  return configs;
}

std::string outcome(const std::function<Frame()>& make, Frame& frame) {
  try {
    frame = make();
  } catch (const FrameError& error) { return error.what(); }
  return "";
}

// Both make the same frame, or refuse it; whether they made one. Of several reasons each names the one it met first.
bool expect_same(const PackedScene& scene, const Camera& camera, double near_plane,
                 const std::optional<WindowRange>& windows = {}) {
  Frame wanted, found;
  const Config& config = scene.config;
  const std::string why = outcome([&] { return reference_frame(config, scene, camera, windows, near_plane); }, wanted);
  const std::string refused = outcome([&] { return frame_setup(config, scene, camera, windows, near_plane); }, found);
  EXPECT_EQ(refused.empty(), why.empty()) << refused << why;
  if (why.empty()) {
    EXPECT_EQ(first_difference(config, wanted, found), "")
        << "camera " << camera.name << ", " << config_difference(config) << ", seed " << seed();
  }
  return why.empty();
}

void expect_same_everywhere(const std::vector<Camera>& cameras, std::mt19937_64& rng) {
  for (const Config& config : machines()) {
    int made = 0;
    for (const Camera& camera : cameras) {
      // The unit that the packer takes for this camera, and what a larger scene would need.
      const int least = static_cast<int>(std::ceil(std::log2(std::max(1e-3, camera_bound(camera)))));
      for (const int more : {1, 2, 5, 9}) {
        made += expect_same(bare_scene(config, least + more - (config.world_w - 3), rng), camera, kNearPlane);
      }
    }
    EXPECT_GT(made, 0);
  }
}

TEST(FrameWords, AreThoseOfOurOwnViews) {
  std::mt19937_64 rng(seed());
  expect_same_everywhere(generated_cameras(), rng);
}

TEST(FrameWords, AreThoseOfEverySharedView) {
  const char* set = std::getenv("PIPEGS_SHARED");
  const auto folder =
      (set != nullptr ? std::filesystem::path(set) : std::filesystem::path(PIPEGS_SOURCE_DIR) / ".." / "shared") /
      "scenes";
  std::mt19937_64 rng(seed());
  int files = 0;
  size_t views = 0;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!std::filesystem::exists(entry.path() / "cameras.json")) continue;
      const std::vector<Camera> cameras = read_cameras(entry.path() / "cameras.json");
      expect_same_everywhere(cameras, rng);
      ++files;
      views += cameras.size();
    }
  }
  if (files == 0) GTEST_SKIP() << "skipped: no cameras in " << folder << " (set PIPEGS_SHARED)";
  fmt::print("{} views of {} scenes\n", views, files);
}

// Attitudes in which entries of the rotation are 0, 1, equal or nearly so, sizes and focal lengths of every magnitude.
Camera hostile_camera(std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Camera camera = random_camera(rng, 1 + static_cast<int>(rng() % 4000), 1 + static_cast<int>(rng() % 4000));
  double q[4];
  for (double& component : q) component = normal(rng);
  switch (rng() % 5) {
    case 0:
      for (double& component : q) component = static_cast<double>(static_cast<int>(rng() % 3) - 1);
      break;
    case 1: q[rng() % 4] *= 1e-9; break;
    case 2: q[0] *= 1e-4, q[1 + rng() % 3] *= 1e-6; break;
    default: break;
  }
  double square = 0;
  for (const double component : q) square += component * component;
  if (square == 0) q[0] = square = 1;
  for (double& component : q) component /= std::sqrt(square);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double r[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                       2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                       2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
  for (int i = 0; i < 9; ++i) camera.world_to_camera[i % 3][i / 3] = r[i];
  const auto focal = [&](int size) {
    switch (rng() % 4) {
      case 0: return std::floor(size * (0.3 + 3 * uniform(rng)));            // whole
      case 1: return std::floor(size * (6 + 20 * uniform(rng))) / 8;         // a few bits
      case 2: return std::exp2(15 * uniform(rng)) * (1 + uniform(rng) / 9);  // too long, too short
      default: return size * (0.1 + 3 * uniform(rng));
    }
  };
  camera.fx = focal(camera.width), camera.fy = rng() % 2 == 0 ? camera.fx : focal(camera.height);
  camera.cx = rng() % 3 == 0 ? (camera.width - 1) / 2.0 : camera.width * normal(rng);
  for (int axis = 0; axis < 3; ++axis) {
    camera.position[axis] = rng() % 9 == 0 ? 0 : normal(rng) * std::exp(4 * normal(rng));
    if (rng() % 4 == 0) camera.position[axis] = std::ldexp(std::round(std::ldexp(camera.position[axis], 9)), -9);
  }
  return camera;
}

TEST(FrameWords, AreThoseOfRandomCameras) {
  std::mt19937_64 rng(seed());
  const std::vector<Config> configs = machines();
  constexpr int kRounds = 100000;
  int made = 0;
  for (int i = 0; i < kRounds && !testing::Test::HasFailure(); ++i) {
    const Config& config = configs[static_cast<size_t>(i / 500) % configs.size()];
    const PackedScene scene = bare_scene(config, static_cast<int>(rng() % 20) - config.world_w, rng);
    const double near_plane = i % 7 == 0 ? std::exp(static_cast<double>(rng() % 1000) / 100 - 5) : kNearPlane;
    const Camera camera = hostile_camera(rng);
    std::optional<WindowRange> windows;
    if (i % 5 == 0) {
      const auto some = [&](int size) {
        return static_cast<int>(rng() % static_cast<uint64_t>(size / config.window + 2));
      };
      windows = WindowRange{some(camera.width) / 2, some(camera.height) / 2, some(camera.width), some(camera.height)};
    }
    made += expect_same(scene, camera, near_plane, windows);
  }
  EXPECT_GT(made, kRounds / 3);
  EXPECT_LT(made, kRounds);
}

// A tie goes away from 0 in every field that is rounded to nearest.
TEST(FrameWords, RoundTiesAwayFromZero) {
  std::mt19937_64 rng(seed());
  const Config config;
  const PackedScene scene = bare_scene(config, -20, rng);
  for (int i = 0; i < 1000; ++i) {
    Camera camera = random_camera(rng, 640, 480);
    const auto tie = [&](int fraction, int64_t range) {
      return std::ldexp(
          static_cast<double>(static_cast<int64_t>(rng() % static_cast<uint64_t>(range)) - range / 2) + 0.5, -fraction);
    };
    for (int axis = 0; axis < 3; ++axis) camera.position[axis] = tie(20, 1 << 30);
    camera.cx = tie(config.center_f(), 1 << 24), camera.cy = tie(config.center_f(), 1 << 10);
    camera.fx = 512 + std::abs(tie(config.focal_f(), 1 << 20));
    ASSERT_TRUE(expect_same(scene, camera, std::abs(tie(20, 1 << 25))));
  }
}

// Beside long doubles: what the header of pipegs_frame.h promises.
TEST(FrameWords, KeepTheBoundsThatTheDriverStates) {
  std::mt19937_64 rng(seed());
  Config config;
  for (int i = 0; i < 20000; ++i) {
    if (i % 100 == 0) {
      config.alpha_cut = 32 + static_cast<int>(rng() % 992), config.tight_cull = 1;
      config.tan_f = 16 + static_cast<int>(rng() % 9);
    }
    const PackedScene scene = bare_scene(config, -25, rng);
    Camera camera = random_camera(rng, 1 + static_cast<int>(rng() % 4000), 480);
    camera.fx = std::exp2(static_cast<double>(rng() % 14000) / 1000);
    if (kGuardBand * camera.width / (2 * camera.fx) >= 10) continue;
    camera.fy = 500, camera.position = {1, 2, 3};
    const Frame frame = frame_setup(config, scene, camera);
    const long double focal = std::ldexp(static_cast<long double>(frame.lens.focal_x), -14),
                      slope = std::ldexp(static_cast<long double>(frame.lens.limit_x + 1), -config.tan_f),
                      logarithm = 2 * std::log(static_cast<long double>(config.alpha_cut));
    const long double reach = std::ldexp(std::sqrt(logarithm) * focal * std::sqrt(1 + slope * slope), 14);
    ASSERT_GE(static_cast<long double>(frame.lens.reach_x), reach);
    ASSERT_LE(static_cast<long double>(frame.lens.reach_x), reach + 2.001L);
    const long double spread = std::max(1.0L, logarithm * focal * focal * (1 + std::ldexp(1.0L, -8)));
    const long double field = std::ldexp(256.0L + static_cast<long double>(frame.lens.spread_x & 255),
                                         static_cast<int>(frame.lens.spread_x >> 8) - 8);
    ASSERT_GE(field, spread);
    ASSERT_LE(field, spread * (1 + std::ldexp(1.0L, -8)));
  }
}

// Where the scene, pixels and overflow areas lie, in bytes, and how large they are.
TEST(FrameWords, GiveTheAreasTheirSizes) {
  std::mt19937_64 rng(seed());
  for (const Config& config : machines()) {
    const PackedScene scene = bare_scene(config, -25, rng);
    Camera camera = random_camera(rng, 700, 300);
    camera.position = {1, 2, 3};
    const pipegs_scene packed = driver_scene(scene);
    const pipegs_camera taken = driver_camera(camera, kNearPlane);
    const pipegs_configuration machine = driver_configuration(config);
    pipegs_memory memory = pipegs_place(&machine, &packed, &taken, 0x12340000, 0x100000);
    pipegs_job job = {};
    ASSERT_EQ(pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_OK);
    const uint64_t base = 0x12340000;
    EXPECT_EQ(job.frame.tables_cells, base + 64 * scene.layout.cells);
    EXPECT_EQ(job.frame.tables_colors, base + 64 * scene.layout.colors);
    EXPECT_EQ(job.frame.tables_cells + job.areas.cells, job.frame.tables_groups);
    EXPECT_EQ(job.frame.tables_groups + job.areas.groups, job.frame.tables_chunks);
    EXPECT_EQ(job.frame.tables_chunks + job.areas.chunks, job.frame.tables_gaussians);
    EXPECT_EQ(job.frame.tables_gaussians + job.areas.gaussians, job.frame.tables_colors);
    EXPECT_EQ(job.frame.tables_colors + job.areas.colors, job.frame.tables_pixels);
    const uint64_t side = static_cast<uint64_t>(config.window),
                   windows = ((700 + side - 1) / side) * ((300 + side - 1) / side);
    EXPECT_EQ(job.areas.pixels, windows * side * side * static_cast<uint64_t>(config.pixel_w) / 8);
    EXPECT_GE(job.frame.tables_overflow, job.frame.tables_pixels + job.areas.pixels);
    EXPECT_EQ(job.areas.overflow, 0x100000u);
    const pipegs_memory good = memory;
    const auto refused = [&] {
      const pipegs_setup setup = pipegs_setup_job(&machine, &packed, &taken, nullptr, &memory, &job);
      memory = good;
      return setup == PIPEGS_SETUP_MEMORY;
    };
    EXPECT_FALSE(refused());
    memory.scene += 32;
    EXPECT_TRUE(refused());
    memory.pixels += 1;
    EXPECT_TRUE(refused());
    memory.overflow += 64;
    EXPECT_TRUE(refused());
    memory.overflow_size = 100;
    EXPECT_TRUE(refused());
    memory.overflow = uint64_t{64} << config.address_w();
    EXPECT_TRUE(refused());
    memory.pixels = (uint64_t{64} << config.address_w()) - 64;
    EXPECT_TRUE(refused());
    pipegs_configuration other = machine;
    ++other.pos_w;
    EXPECT_EQ(pipegs_setup_job(&other, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_SCENE);
    other = machine;
    other.config_hash ^= 1, other.units ^= 7;  // what no record depends on
    EXPECT_EQ(pipegs_setup_job(&other, &packed, &taken, nullptr, &memory, &job), PIPEGS_SETUP_OK);
  }
}

}  // namespace
}  // namespace pipegs
