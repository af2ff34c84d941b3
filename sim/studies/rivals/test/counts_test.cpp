// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/counts: every count of random scenes against brute force, the blends against the truth,
// and what holds for any scene.
#include <algorithm>
#include <cmath>
#include <random>

#include "cpp_model/float/truth.hpp"
#include "verif/frame/scenes.hpp"
#include "sim/studies/rivals/test/brute.hpp"
#include "sim/studies/rivals/test/same.hpp"

namespace pipegs {
namespace {

constexpr Cover kAll[] = {Cover::kSquare, Cover::kAxis, Cover::kOriented, Cover::kExact};

// Walls in front of a part of the picture, so that tiles become opaque.
void wall_off(Scene& scene) {
  for (const float z : {0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1.0f})
    scene.gaussians.push_back(gaussian_at({-0.6f * z, -0.2f, z}, 0.6f * z, 0.98));
}

TEST(RivalCounts, AreThoseOfEveryPixelTileAndRay) {
  struct Case {
    uint64_t seed;
    int width, height;
    CountOptions options;
  };
  for (const Case& one : {Case{1, 70, 50, {}},
                          {2, 37, 41, {.voxel = 0.7, .group = 32}},
                          {3, 16, 16, {.near_plane = 1, .voxel = 5}},
                          {5, 50, 40, {.near_plane = 0.55, .voxel = 0.3}},
                          {4, 131, 20, {.voxel = 1.1, .group = 48}}}) {
    SCOPED_TRACE(one.seed);
    Scene scene = random_scene(one.seed, 60, 0);
    scene.gaussians[7].mean.x = std::nanf("");
    scene.gaussians[11].rotation = glm::vec4(0);
    scene.antialiased = one.seed == 2;
    if (one.seed != 3) wall_off(scene);
    Camera camera = test_camera(one.width, one.height, 40);
    camera.position = {0.1, -0.2, 0.05};
    camera.cx += 3.25;
    const glm::dvec3 z = glm::normalize(glm::dvec3(0.1, 0.05, 1)), x = glm::normalize(glm::cross({0, 1, 0}, z));
    camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
    const FrameCounts found = count_frame(scene, camera, one.options);
    expect_same(found, brute_counts(scene, camera, one.options));
    EXPECT_EQ(found.gaussians.scene, found.gaussians.valid + 2);
    if (one.seed == 1) {  // the case is worth comparing
      EXPECT_GT(found.total.stops, 0u);
      EXPECT_LT(found.total.oriented_8x8.live, found.total.oriented_8x8.open);
      EXPECT_LT(found.total.oriented_8x8.open, found.total.oriented_8x8.tile_open);
      EXPECT_LT(found.total.oriented_8x8.tile_open, found.total.oriented_8x8.all);
      EXPECT_LT(found.voxels.open.fetched, found.voxels.all.fetched);
      EXPECT_LT(found.voxels.all.coarse, found.voxels.all.fetched);
      EXPECT_LT(found.voxels.all.fine, found.voxels.all.coarse);
      EXPECT_GT(found.neighbours.shared, 0u);
    }
  }
}

TEST(RivalCounts, BlendWhatTheTruthBlends) {
  Scene scene = random_scene(5, 2000, 1);
  const Camera camera = test_camera(130, 90);
  const Image image = render_truth(scene, camera, {});
  uint64_t blended = 0;
  for (const auto count : image.blended) blended += count;
  EXPECT_EQ(count_frame(scene, camera, {}).total.blends, blended);
}

TEST(RivalCounts, DependNeitherOnThreadsNorOnTheOrderInTheFile) {
  Scene scene = random_scene(6, 5000, 0);
  const Camera camera = test_camera(100, 70);
  const FrameCounts wanted = count_frame(scene, camera, {.threads = 1});
  expect_same(count_frame(scene, camera, {.threads = 3}), wanted);
  std::shuffle(scene.gaussians.begin(), scene.gaussians.end(), std::mt19937_64(7));
  expect_same(count_frame(scene, camera, {}), wanted);
}

TEST(RivalCounts, OfAnEmptyPictureAreNone) {
  for (const Scene& scene : {scene_of({}), scene_of({gaussian_at({0, 0, -3}), gaussian_at({0, 0, 0.1f})})}) {
    const FrameCounts counts = count_frame(scene, test_camera(33, 20), {});
    EXPECT_EQ(counts.gaussians.in_front, 0u);
    EXPECT_EQ(counts.tiles.size(), 6u);
    EXPECT_EQ(counts.total.reached, 0u);
    for (const Cover cover : kAll) EXPECT_EQ(list_sums(counts.lists[0].lengths[cover]).nonempty, 0u);
    EXPECT_EQ(counts.voxels.occupied, scene.gaussians.empty() ? 0u : 2u);
    EXPECT_EQ(counts.voxels.all.coarse, 0u);
  }
}

TEST(RivalCounts, OtherVoxelsAreThoseOfTheirEdge) {
  const Scene scene = random_scene(6, 80, 0);
  const FrameCounts both = count_frame(scene, test_camera(70, 50), {.voxel = 2, .other_voxels = {0.5}, .group = 32});
  ASSERT_EQ(both.other_voxels.size(), 1u);
  FrameCounts found = both;
  found.voxels = both.other_voxels.front();
  expect_same(found, count_frame(scene, test_camera(70, 50), {.voxel = 0.5, .group = 32}));
  EXPECT_NE(both.voxels.occupied, both.other_voxels.front().occupied);
}

TEST(RivalCounts, RefuseParametersWithoutMeaning) {
  const Scene scene = scene_of({gaussian_at({0, 0, 3})});
  for (const double voxel : {0.0, -1.0, std::nan("")})
    for (const CountOptions& options : {CountOptions{.voxel = voxel}, CountOptions{.other_voxels = {1, voxel}}})
      EXPECT_THROW(count_frame(scene, test_camera(16, 16), options), std::invalid_argument);
  for (const int group : {0, -16, 8, 24})
    EXPECT_THROW(count_frame(scene, test_camera(16, 16), {.group = group}), std::invalid_argument);
}

TEST(RivalCounts, ProgressRisesToOne) {
  double last = 0;
  count_frame(random_scene(9, 50, 0), test_camera(64, 64), {.progress = [&](double share) {
                EXPECT_GT(share, last);
                last = share;
              }});
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace pipegs
