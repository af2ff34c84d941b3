// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/counts: scenes that are counted by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/studies/rivals/counts.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

uint64_t pairs(const FrameCounts& counts, size_t side, Cover cover) {
  return list_sums(counts.lists[side].lengths[cover]).pairs;
}

// A round one of variance 1.3 px^2 at pixel (31.5, 31.5), where four tiles meet: alpha >= 1/255 up to 3.72 px, which
// are in each tile pixels at 0.5 to 3.5 in x and y, of which eleven lie within the circle.
TEST(RivalsByHand, OneOnTheCornerOfFourTiles) {
  const FrameCounts counts = count_frame(scene_of({gaussian_at({0, 0, 1}, 0.01f, 0.8)}), test_camera(64, 64), {});
  for (const Cover cover : {Cover::kSquare, Cover::kAxis, Cover::kOriented, Cover::kExact}) {
    SCOPED_TRACE(static_cast<int>(cover));
    EXPECT_EQ(pairs(counts, 0, cover), 4u);
    EXPECT_EQ(pairs(counts, 1, cover), 4u);
    EXPECT_EQ(pairs(counts, 2, cover), 1u);
    EXPECT_EQ(pairs(counts, 3, cover), 1u);
    EXPECT_EQ(counts.gaussians.listed[cover], 1u);
    EXPECT_EQ(counts.total.walk[cover].open, 4u);
    EXPECT_EQ(counts.total.walk[cover].alive, 4u * 256);
    EXPECT_EQ(counts.lists[0].lengths[cover][5], 1u);
    EXPECT_EQ(counts.lists[0].lengths[cover][4], 0u);
  }
  EXPECT_EQ(counts.gaussians.blended, 1u);
  EXPECT_EQ(counts.gaussians.in_two, 1u);
  EXPECT_EQ(counts.gaussians.rows, 8u);
  EXPECT_EQ(counts.total.reached, 44u);
  EXPECT_EQ(counts.total.blends, 44u);
  EXPECT_EQ(counts.total.stops, 0u);
  for (const PartCounts& parts : {counts.total.oriented_8x8, counts.total.exact_8x8, counts.total.exact_4x4}) {
    EXPECT_EQ(parts.all, 4u);
    EXPECT_EQ(parts.live, 4u);
  }
  EXPECT_EQ(counts.total.exact_16x1.all, 16u);
  EXPECT_EQ(counts.total.exact_8x1.all, 16u);
  EXPECT_EQ(counts.masks.axis, 4u);
  EXPECT_EQ(counts.masks.oriented, 4u);
  EXPECT_EQ(counts.neighbours.pairs, 0u);
}

// Sigma 30 px along the diagonal of a picture of 16x16 tiles, 0.56 px across. The square of 91 px has 12x12 tiles, the
// box in x and y of 63.7 px 8x8. The oriented one ends 90.0 px from the middle: eight tiles on the diagonal, both
// neighbours at the seven corners between them, and at each end the two whose corner its own corner reaches.
// alpha >= 1/255 ends at 97.8 px: two tiles more on the diagonal, none at the corners beyond the seven.
TEST(RivalsByHand, ANeedleOnTheDiagonal) {
  Gaussian needle = gaussian_at({0, 0, 1}, 0.3f, 0.8);
  needle.log_scale.y = needle.log_scale.z = std::log(0.001f);
  needle.rotation = {std::cos(std::acos(-1.0f) / 8), 0, 0, std::sin(std::acos(-1.0f) / 8)};
  const FrameCounts counts = count_frame(scene_of({needle}), test_camera(256, 256), {});
  EXPECT_EQ(pairs(counts, 0, Cover::kSquare), 144u);
  EXPECT_EQ(pairs(counts, 0, Cover::kAxis), 64u);
  EXPECT_EQ(pairs(counts, 0, Cover::kOriented), 8u + 2 * 7 + 2 * 2);
  EXPECT_EQ(pairs(counts, 0, Cover::kExact), 10u + 2 * 7);
  EXPECT_EQ(counts.lists[0].lengths.oriented[3 * 16 + 3], 0u);
  EXPECT_EQ(counts.lists[0].lengths.exact[3 * 16 + 3], 1u);
}

// Each wall leaves 0.05 to 0.06 of what is behind it, so the fourth stops every pixel and nothing after it counts.
TEST(RivalsByHand, WallsStopTilesForWhatIsBehindThem) {
  std::vector<Gaussian> gaussians = {gaussian_at({0, 0, 9}, 0.02f, 0.8)};
  for (int i = 4; i > 0; --i) gaussians.push_back(gaussian_at({0, 0, 2 + 0.1f * static_cast<float>(i)}, 3, 0.95));
  const FrameCounts counts = count_frame(scene_of(gaussians), test_camera(40, 24), {});
  const uint64_t tiles = 3 * 2, pixels = 40 * 24;
  EXPECT_EQ(counts.gaussians.listed.exact, 5u);
  EXPECT_EQ(counts.gaussians.blended, 3u);
  EXPECT_EQ(counts.total.walk.square.open, 4 * tiles);
  EXPECT_EQ(counts.total.walk.exact.open, 4 * tiles);
  EXPECT_EQ(counts.total.walk.exact.alive, 4 * pixels);
  EXPECT_EQ(counts.total.blends, 3 * pixels);
  EXPECT_EQ(counts.total.stops, pixels);
  EXPECT_GT(counts.total.reached, 4 * pixels);
  // Of 3x2 tiles the last column and the last row have two parts of 8x8 and one row of parts in the image.
  EXPECT_EQ(counts.total.exact_8x8.open, 4u * (5 * 3));
  EXPECT_GT(counts.total.exact_8x8.all, counts.total.exact_8x8.tile_open);
  // The voxel of the small one, 8 to 10 in z, lies behind them: its groups have stopped.
  EXPECT_GT(counts.voxels.pairs, counts.voxels.open_pairs);
  EXPECT_EQ(counts.voxels.all.fetched - counts.voxels.open.fetched, counts.voxels.pairs - counts.voxels.open_pairs);
}

// More of them than a thread takes at a time.
TEST(RivalsByHand, NeighboursInOneTileShareIt) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 5000; ++i) gaussians.push_back(gaussian_at({0, 0, 2 + 0.001f * static_cast<float>(i)}, 0.001f));
  const NeighbourCounts found = count_frame(scene_of(gaussians), test_camera(16, 16), {}).neighbours;
  EXPECT_EQ(found.pairs, 4999u);
  EXPECT_EQ(found.tiles, 4999u);
  EXPECT_EQ(found.shared, 4999u);
}

TEST(RivalsByHand, SumsOverLists) {
  const ListSums sums = list_sums({0, 1, 16, 17, 128, 129, 1024, 1025, 0});
  EXPECT_EQ(sums.pairs, 2340u);
  EXPECT_EQ(sums.nonempty, 7u);
  EXPECT_EQ(sums.longest, 1025u);
  EXPECT_EQ(sums.long_lists, 5u);
  EXPECT_EQ(sums.long_pairs, 2323u);
  EXPECT_EQ(sums.chunks, 1u + 1 + 2 + 8 + 9 + 64 + 65);
  EXPECT_EQ(sums.steps, 17u + 128 + 2 * 129 + 2 * 1024 + 3 * 1025);
  EXPECT_EQ(sums.histogram, (std::vector<uint64_t>{1, 0, 0, 0, 2, 0, 0, 2, 0, 0, 2}));
  EXPECT_EQ(list_sums({9, 10}, 4, 2).steps, 2u * 9 + 2 * 10);
  EXPECT_EQ(list_sums({}).histogram.size(), 0u);
}

}  // namespace
}  // namespace pipegs
