// SPDX-License-Identifier: Apache-2.0
// frame_words_test: the driver's frame, in integers, equals the same in doubles word for word: on every camera that is
// there and on random ones of every kind, for every design point and other widths.
//
// Needs   the cameras of the shared folder, found by PIPEGS_SHARED or beside the repository, in one of the tests, which
//         is skipped with a message when they are not there.
#include <gtest/gtest.h>

#include "cpp_model/float/projection.hpp"
#include "scenes/generate/generate.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/dopu/frame_reference.hpp"
#include "verif/support/shared.hpp"

namespace pipegs {
namespace {

// Both make the same frame, or refuse it; whether they made one.
bool expect_same(const PackedScene& scene, const Camera& camera, double near_plane,
                 const std::optional<WindowRange>& windows = {}) {
  const Config& config = scene.config;
  const std::optional<Frame> wanted = reference_frame(config, scene, camera, windows, near_plane);
  std::optional<Frame> found;
  std::string refused;
  try {
    found = frame_setup(config, scene, camera, windows, near_plane);
  } catch (const FrameError& error) { refused = error.what(); }
  EXPECT_EQ(found.has_value(), wanted.has_value()) << refused;
  if (found && wanted) {
    EXPECT_EQ(first_difference(config, *wanted, *found), "")
        << "camera " << camera.name << ", " << config_difference(config) << ", seed " << frame_seed();
  }
  return found.has_value();
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
  std::mt19937_64 rng(frame_seed());
  expect_same_everywhere(generated_cameras(), rng);
}

TEST(FrameWords, AreThoseOfEverySharedView) {
  const auto folder = shared_folder() / "scenes";
  std::mt19937_64 rng(frame_seed());
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
  const int width = 1 + static_cast<int>(rng() % 4000), height = 1 + static_cast<int>(rng() % 4000);
  Camera camera = random_camera(rng, width, height);
  double q[4];
  for (double& component : q) component = draw_normal(rng);
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
  camera.world_to_camera = rotation_matrix({q[0], q[1], q[2], q[3]});
  const auto focal = [&](int size) {
    const double length = draw_unit(rng), more = draw_unit(rng);
    switch (rng() % 4) {
      case 0: return std::floor(size * (0.3 + 3 * length));     // whole
      case 1: return std::floor(size * (6 + 20 * length)) / 8;  // a few bits
      case 2: return std::exp2(15 * length) * (1 + more / 9);   // too long, too short
      default: return size * (0.1 + 3 * length);
    }
  };
  camera.fx = focal(camera.width), camera.fy = rng() % 2 == 0 ? camera.fx : focal(camera.height);
  camera.cx = rng() % 3 == 0 ? (camera.width - 1) / 2.0 : camera.width * draw_normal(rng);
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::exp(4 * draw_normal(rng));
    camera.position[axis] = rng() % 9 == 0 ? 0 : size * draw_normal(rng);
    if (rng() % 4 == 0) camera.position[axis] = std::ldexp(std::round(std::ldexp(camera.position[axis], 9)), -9);
  }
  return camera;
}

TEST(FrameWords, AreThoseOfRandomCameras) {
  std::mt19937_64 rng(frame_seed());
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
  std::mt19937_64 rng(frame_seed());
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

}  // namespace
}  // namespace pipegs
