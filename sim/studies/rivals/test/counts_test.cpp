// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/counts: every count of random scenes against brute force, scenes that are
// counted by hand, and what holds for any scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "sim/studies/rivals/test/brute.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

void expect_same(const FrameCounts& found, const FrameCounts& wanted) {
  EXPECT_EQ(found.width, wanted.width);
  EXPECT_EQ(found.height, wanted.height);
  EXPECT_EQ(found.scene, wanted.scene);
  EXPECT_EQ(found.listed, wanted.listed);
  for (size_t i = 0; i < kListSides.size(); ++i) EXPECT_EQ(found.lists[i], wanted.lists[i]) << kListSides[i];
  EXPECT_EQ(found.neighbours, wanted.neighbours);
  ASSERT_EQ(found.tiles.size(), wanted.tiles.size());
  for (size_t t = 0; t < found.tiles.size(); ++t) EXPECT_EQ(found.tiles[t], wanted.tiles[t]) << t;
  ASSERT_EQ(found.voxels.size(), wanted.voxels.size());
  for (size_t v = 0; v < found.voxels.size(); ++v) EXPECT_EQ(found.voxels[v].groups, wanted.voxels[v].groups) << v;
}

// Walls in front of a part of the picture, so that tiles become opaque; with wide ones a whole group of pixels.
void wall_off(Scene& scene, float middle, float size) {
  for (const float z : {0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1.0f})
    scene.gaussians.push_back(gaussian_at({middle * z, -0.2f, z}, size * z, 0.98));
}

TEST(RivalCounts, AreThoseOfEveryPixelTileAndRay) {
  struct Case {
    uint64_t seed;
    int width, height;
    CountOptions options;
  };
  for (const Case& one : {Case{1, 70, 80, {}},
                          {2, 37, 41, {.voxels = {0.7}}},
                          {3, 16, 16, {.near_plane = 1, .voxels = {5}}},
                          {5, 50, 40, {.near_plane = 0.55, .voxels = {0.3}}},
                          {4, 131, 20, {.voxels = {1.1, 0.4}}}}) {
    SCOPED_TRACE(one.seed);
    Scene scene = random_scene(one.seed, 60, 0);
    scene.gaussians[7].mean.x = std::nanf("");
    scene.gaussians[11].rotation = glm::vec4(0);
    scene.antialiased = one.seed == 2;
    if (one.seed == 4) wall_off(scene, -1.7f, 3);
    else if (one.seed != 3) wall_off(scene, -0.6f, 0.6f);
    Camera camera = test_camera(one.width, one.height, 40);
    camera.position = {0.1, -0.2, 0.05};
    camera.cx += 3.25;
    const glm::dvec3 z = glm::normalize(glm::dvec3(0.1, 0.05, 1)), x = glm::normalize(glm::cross({0, 1, 0}, z));
    camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
    const FrameCounts found = count_frame(scene, camera, one.options);
    expect_same(found, brute_counts(scene, camera, one.options));
    if (one.seed == 1) {  // the case is worth comparing
      const auto sum = [&](const auto& count) {
        return std::accumulate(found.tiles.begin(), found.tiles.end(), uint64_t{0},
                               [&](uint64_t before, const TileCounts& tile) { return before + count(tile); });
      };
      const auto& lengths = found.lists[kLists16].lengths.oriented;
      const uint64_t open = sum([](const TileCounts& tile) { return tile.open.oriented; });
      EXPECT_LT(open, std::accumulate(lengths.begin(), lengths.end(), uint64_t{0}));  // tiles become opaque
      EXPECT_LT(sum([](const TileCounts& tile) { return tile.oriented_8x8; }), 4 * open);
      const FilterCounts streamed = found.voxels.front().sum();
      EXPECT_LT(streamed.coarse, streamed.fetched);
      EXPECT_LT(streamed.fine, streamed.coarse);
      EXPECT_GT(streamed.fine, 0u);
      EXPECT_GT(found.neighbours.shared, 0u);
      EXPECT_LT(found.neighbours.shared, found.neighbours.tiles);
    }
  }
}

uint64_t pairs(const FrameCounts& counts, Cover cover) {
  const std::vector<uint32_t>& lengths = counts.lists[kLists16].lengths[cover];
  return std::accumulate(lengths.begin(), lengths.end(), uint64_t{0});
}

// Sigma 30 px along the diagonal of a picture of 16x16 tiles, 0.56 px across. The square of 91 px has 12x12 tiles, the
// box in x and y of 63.7 px 8x8. The oriented one ends 90.0 px from the middle: eight tiles on the diagonal, both
// neighbours at the seven corners between them, and at each end the two whose corner its own corner reaches.
// alpha >= 1/255 ends at 97.8 px: two tiles more on the diagonal, none at the corners beyond the seven.
TEST(RivalCounts, OfANeedleOnTheDiagonal) {
  Gaussian needle = gaussian_at({0, 0, 1}, 0.3f, 0.8);
  needle.log_scale.y = needle.log_scale.z = std::log(0.001f);
  needle.rotation = {std::cos(std::acos(-1.0f) / 8), 0, 0, std::sin(std::acos(-1.0f) / 8)};
  const FrameCounts counts = count_frame(scene_of({needle}), test_camera(256, 256), {});
  EXPECT_EQ(pairs(counts, Cover::kSquare), 144u);
  EXPECT_EQ(pairs(counts, Cover::kAxis), 64u);
  EXPECT_EQ(pairs(counts, Cover::kOriented), 8u + 2 * 7 + 2 * 2);
  EXPECT_EQ(pairs(counts, Cover::kExact), 10u + 2 * 7);
  EXPECT_EQ(counts.lists[kLists16].lengths.oriented[3 * 16 + 3], 0u);
  EXPECT_EQ(counts.lists[kLists16].lengths.exact[3 * 16 + 3], 1u);
}

// Each wall leaves 0.05 to 0.06 of what is behind it, so the fourth stops every pixel and nothing after it counts.
TEST(RivalCounts, WallsStopTilesForWhatIsBehindThem) {
  std::vector<Gaussian> gaussians = {gaussian_at({0, 0, 9}, 0.02f, 0.8)};
  for (int i = 4; i > 0; --i) gaussians.push_back(gaussian_at({0, 0, 2 + 0.1f * static_cast<float>(i)}, 3, 0.95));
  const FrameCounts counts = count_frame(scene_of(gaussians), test_camera(40, 24), {});
  uint64_t square = 0, exact = 0, parts = 0;
  for (const TileCounts& tile : counts.tiles)
    square += tile.open.square, exact += tile.open.exact, parts += tile.exact_8x8;
  EXPECT_EQ(counts.listed.exact, 5u);
  EXPECT_EQ(square, 4u * (3 * 2));
  EXPECT_EQ(exact, 4u * (3 * 2));
  // Of 3x2 tiles the last column and the last row have two parts of 8x8 and one row of parts in the image.
  EXPECT_EQ(parts, 4u * (5 * 3));
  // The voxel of the small one, 8 to 10 in z, lies behind them: its groups have stopped.
  EXPECT_EQ(counts.voxels.front().sum().fetched, 4u);
}

// More of them than a thread takes at a time.
TEST(RivalCounts, NeighboursInOneTileShareIt) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 5000; ++i) gaussians.push_back(gaussian_at({0, 0, 2 + 0.001f * static_cast<float>(i)}, 0.001f));
  const NeighbourCounts found = count_frame(scene_of(gaussians), test_camera(16, 16), {}).neighbours;
  EXPECT_EQ(found.tiles, 4999u);
  EXPECT_EQ(found.shared, 4999u);
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
    EXPECT_EQ(counts.listed, ByCover<uint64_t>{});
    EXPECT_EQ(counts.tiles, std::vector<TileCounts>(6));
    EXPECT_EQ(counts.lists[kLists16].lengths.exact, std::vector<uint32_t>(6));
    EXPECT_EQ(counts.voxels.front().sum().coarse, 0u);
  }
}

TEST(RivalCounts, RefuseVoxelsWithoutEdge) {
  const Scene scene = scene_of({gaussian_at({0, 0, 3})});
  for (const double voxel : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(count_frame(scene, test_camera(16, 16), {.voxels = {1, voxel}}), std::invalid_argument);
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
