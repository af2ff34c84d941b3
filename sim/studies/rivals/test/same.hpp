// SPDX-License-Identifier: Apache-2.0
// same.hpp: two frames' counts are the same, each named where they are not.
#pragma once

#include <gtest/gtest.h>

#include "sim/studies/rivals/report.hpp"

namespace pipegs {

inline void expect_same_rows(const FrameCounts& found, const FrameCounts& wanted) {
  const auto rows = count_rows(found, {}), other = count_rows(wanted, {});
  ASSERT_EQ(rows.size(), other.size());
  for (size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].value, other[i].value) << rows[i].section << " " << rows[i].key << ": " << rows[i].what;
}

inline void expect_same_tiles(const std::vector<TileCounts>& found, const std::vector<TileCounts>& wanted) {
  ASSERT_EQ(found.size(), wanted.size());
  for (size_t t = 0; t < found.size(); ++t) {
    SCOPED_TRACE(t);
    FrameCounts tile, other;
    tile.total = found[t], other.total = wanted[t];
    expect_same_rows(tile, other);
  }
}

inline void expect_same_lists(const ListCounts& found, const ListCounts& wanted) {
  SCOPED_TRACE(found.side);
  EXPECT_EQ(found.side, wanted.side);
  EXPECT_EQ(found.columns, wanted.columns);
  EXPECT_EQ(found.rows, wanted.rows);
  for (const Cover cover : kAllCovers)
    EXPECT_EQ(found.lengths[cover], wanted.lengths[cover]) << static_cast<int>(cover);
}

inline void expect_same(const FrameCounts& found, const FrameCounts& wanted) {
  EXPECT_EQ(found.width, wanted.width);
  EXPECT_EQ(found.height, wanted.height);
  expect_same_rows(found, wanted);
  for (size_t i = 0; i < kListSides.size(); ++i) expect_same_lists(found.lists[i], wanted.lists[i]);
  EXPECT_EQ(found.voxels.edge, wanted.voxels.edge);
  ASSERT_EQ(found.voxels.groups.size(), wanted.voxels.groups.size());
  for (size_t g = 0; g < found.voxels.groups.size(); ++g) {
    const GroupCounts &group = found.voxels.groups[g], &other = wanted.voxels.groups[g];
    EXPECT_EQ(group.voxels, other.voxels) << g;
    EXPECT_EQ(group.filtered.fetched, other.filtered.fetched) << g;
    EXPECT_EQ(group.filtered.coarse, other.filtered.coarse) << g;
    EXPECT_EQ(group.filtered.fine, other.filtered.fine) << g;
  }
  expect_same_tiles(found.tiles, wanted.tiles);
}

}  // namespace pipegs
