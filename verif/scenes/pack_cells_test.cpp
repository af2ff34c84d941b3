// SPDX-License-Identifier: Apache-2.0
// pack_cells_test: cpp_model/pack/pack_cells.cpp by hand, on random boxes, and in a packed scene.
#include "cpp_model/pack/pack_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "verif/dopu/dopu_world.hpp"

namespace pipegs {
namespace {

using Counts = std::vector<uint64_t>;
constexpr uint64_t kFew = 8;  // an entry of so many groups stays as it is

Node cube(int64_t x, uint64_t half = 1, uint64_t half_exp = 0) {
  return {.center_x = x, .half_x = half, .half_y = half, .half_z = half, .half_exp = half_exp, .count = 1};
}
std::vector<Node> line_of(size_t count) {
  std::vector<Node> groups;
  for (size_t i = 0; i < count; ++i) groups.push_back(cube(10 * static_cast<int64_t>(i)));
  return groups;
}

// Cells of so many groups each, and of the table that they become the groups of each entry. Expects that each group is
// in one entry, in order, and that those behind the last one are empty.
Counts entries_of(const Counts& cells, const std::vector<Node>& groups, size_t entries) {
  std::vector<Node> grid;
  uint64_t first = 0, next = 0;
  for (const uint64_t count : cells) grid.push_back({.first = first, .count = count}), first += count;
  Counts counts;
  const std::vector<Node> table = cell_table(grid, groups, entries);
  EXPECT_EQ(table.size(), entries);
  for (size_t i = 0; i < table.size() && table[i].count != 0; next += table[i++].count) {
    EXPECT_EQ(table[i].first, next);
    counts.push_back(table[i].count);
  }
  EXPECT_EQ(next, first) << "all are in front of the first empty one";
  return counts;
}

TEST(PackCells, ACellIsCutWhereItsClustersPart) {
  for (const uint64_t cut : {3u, 7u}) {
    std::vector<Node> groups = line_of(10);
    for (size_t i = 0; i < 10; ++i) groups[i].half_z = 0, groups[i].center_x += i < cut ? 0 : 100000;  // squares
    for (int turn = 0; turn < 3; ++turn) {
      EXPECT_EQ(entries_of({10}, groups, 64), (Counts{cut, 10 - cut})) << turn;
      for (Node& g : groups) g = {g.center_z, g.center_x, g.center_y, g.half_z, g.half_x, g.half_y};
    }
    for (size_t i = 0; i < 10; ++i) groups[i] = cube(0, 1, i < cut ? 20 : 0);  // in one place, large and small ones
    EXPECT_EQ(entries_of({10}, groups, 64), (Counts{cut, 10 - cut}));
  }
}

TEST(PackCells, ACellOfFewGroupsStaysWhole) {
  EXPECT_EQ(entries_of({0, kFew, 0, kFew, 1, 0}, line_of(17), 64), (Counts{kFew, kFew, 1}));
}

// Equal groups in a line cost least in two halves.
TEST(PackCells, TheLargestIsCutFirstAndOfEqualOnesTheFirst) {
  EXPECT_EQ(entries_of({12, 0, 40, 20}, line_of(72), 3), (Counts{12, 40, 20}));
  EXPECT_EQ(entries_of({12, 0, 40, 20}, line_of(72), 5), (Counts{12, 10, 10, 20, 20}));
  EXPECT_EQ(entries_of({12, 0, 40, 20}, line_of(72), 64), (Counts{6, 6, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5}));
}

TEST(PackCells, EveryCellThatHoldsAGroupNeedsAnEntry) {
  EXPECT_EQ(entries_of({0, 0}, {}, 2), Counts{});
  EXPECT_THROW(entries_of({1, 0, 2, 3}, line_of(6), 2), std::invalid_argument);
}

TEST(PackCells, RandomBoxesFillTheTableAndNoEntryIsOfTwoCells) {
  std::mt19937_64 rng(1);
  for (int round = 0; round < 300; ++round) {
    Counts cells(1 + rng() % 20);
    for (uint64_t& count : cells) count = 1 + rng() % 60;
    std::vector<Node> groups(1200);
    for (Node& group : groups) group = cube(static_cast<int64_t>(rng() % 4000) - 2000, rng() % 100, rng() % 8);
    const size_t entries = cells.size() + rng() % 80;
    const Counts counts = entries_of(cells, groups, entries);
    size_t cell = 0;
    for (const uint64_t count : counts) {
      ASSERT_LE(count, cells[cell]);
      ASSERT_TRUE(count <= kFew || counts.size() == entries) << "a place is left to cut " << count;
      if ((cells[cell] -= count) == 0) ++cell;
    }
  }
}

TEST(PackCells, ALargerTableChangesNothingElseInAScene) {
  std::mt19937_64 rng(2);
  const Scene scene = random_scene(rng, 20000);
  Config config;
  config.late = config.quads = config.tight_boxes = 1, config.order = 2, config.window = 128, config.group = 2;
  config.nearest_nodes = 256;  // an entry for each cell of the grid
  const PackedScene one = pack_scene(config, scene, 10);
  config.nearest_nodes = 1024;
  const PackedScene four = pack_scene(config, scene, 10);
  EXPECT_EQ(one.cells.size(), 64u);
  EXPECT_EQ(four.cells.size(), 256u);
  EXPECT_LT(std::ranges::count(four.cells, 0u, &Node::count), 150) << "cells were meant to be cut";
  EXPECT_EQ(one.chunks, four.chunks);
  EXPECT_EQ(one.groups, four.groups);
  EXPECT_EQ(one.slot_to_index, four.slot_to_index);
  for (size_t i = 0; i < one.gaussians.size(); ++i) ASSERT_EQ(one.gaussians[i], four.gaussians[i]) << "slot " << i;
}

}  // namespace
}  // namespace pipegs
