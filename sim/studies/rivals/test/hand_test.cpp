// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/counts: scenes that are counted by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/studies/rivals/counts.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

uint64_t pairs(const FrameCounts& counts, size_t side, Cover cover) {
  const std::vector<uint32_t>& lengths = counts.lists[side].lengths[cover];
  return std::accumulate(lengths.begin(), lengths.end(), uint64_t{0});
}

TileCounts total(const FrameCounts& counts) {
  TileCounts sum;
  for (const TileCounts& tile : counts.tiles) {
    for (const Cover cover : kAllCovers) sum.open[cover] += tile.open[cover];
    sum.oriented_8x8 += tile.oriented_8x8, sum.exact_8x8 += tile.exact_8x8, sum.exact_4x4 += tile.exact_4x4;
  }
  return sum;
}

// A round one of variance 1.3 px^2 at pixel (31.5, 31.5), where four tiles meet: alpha >= 1/255 up to 3.72 px.
TEST(RivalsByHand, OneOnTheCornerOfFourTiles) {
  const FrameCounts counts = count_frame(scene_of({gaussian_at({0, 0, 1}, 0.01f, 0.8)}), test_camera(64, 64), {});
  const TileCounts sum = total(counts);
  for (const Cover cover : kAllCovers) {
    SCOPED_TRACE(static_cast<int>(cover));
    EXPECT_EQ(pairs(counts, kLists16, cover), 4u);
    EXPECT_EQ(pairs(counts, kLists64, cover), 1u);
    EXPECT_EQ(counts.listed[cover], 1u);
    EXPECT_EQ(sum.open[cover], 4u);
    EXPECT_EQ(counts.lists[kLists16].lengths[cover][5], 1u);
    EXPECT_EQ(counts.lists[kLists16].lengths[cover][4], 0u);
  }
  EXPECT_EQ(sum.oriented_8x8, 4u);
  EXPECT_EQ(sum.exact_8x8, 4u);
  EXPECT_EQ(sum.exact_4x4, 4u);
  EXPECT_EQ(counts.neighbours, NeighbourCounts{});
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
  const TileCounts sum = total(counts);
  const uint64_t tiles = 3 * 2;
  EXPECT_EQ(counts.listed.exact, 5u);
  EXPECT_EQ(sum.open.square, 4 * tiles);
  EXPECT_EQ(sum.open.exact, 4 * tiles);
  // Of 3x2 tiles the last column and the last row have two parts of 8x8 and one row of parts in the image.
  EXPECT_EQ(sum.exact_8x8, 4u * (5 * 3));
  // The voxel of the small one, 8 to 10 in z, lies behind them: its groups have stopped.
  EXPECT_EQ(counts.voxels.front().sum().fetched, 4u);
}

// More of them than a thread takes at a time.
TEST(RivalsByHand, NeighboursInOneTileShareIt) {
  std::vector<Gaussian> gaussians;
  for (int i = 0; i < 5000; ++i) gaussians.push_back(gaussian_at({0, 0, 2 + 0.001f * static_cast<float>(i)}, 0.001f));
  const NeighbourCounts found = count_frame(scene_of(gaussians), test_camera(16, 16), {}).neighbours;
  EXPECT_EQ(found.tiles, 4999u);
  EXPECT_EQ(found.shared, 4999u);
}

}  // namespace
}  // namespace pipegs
