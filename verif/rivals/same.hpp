// SPDX-License-Identifier: Apache-2.0
// same.hpp: two frames' counts are the same, each named where they are not.
#pragma once

#include <gtest/gtest.h>

#include "sim/study/rivals/report.hpp"

namespace pipegs {

inline void expect_same_rows(const FrameCounts& found, const FrameCounts& wanted) {
  const auto rows = count_rows(found, {}), other = count_rows(wanted, {});
  ASSERT_EQ(rows.size(), other.size());
  for (size_t i = 0; i < rows.size(); ++i)
    EXPECT_EQ(rows[i].value, other[i].value) << rows[i].section << " " << rows[i].key << ": " << rows[i].what;
}

inline void expect_same(const FrameCounts& found, const FrameCounts& wanted) {
  EXPECT_EQ(found.width, wanted.width);
  EXPECT_EQ(found.height, wanted.height);
  expect_same_rows(found, wanted);
  for (size_t i = 0; i < kListSides.size(); ++i) {
    const ListCounts &lists = found.lists[i], &other = wanted.lists[i];
    SCOPED_TRACE(lists.side);
    EXPECT_EQ(lists.side, other.side);
    EXPECT_EQ(lists.columns, other.columns);
    EXPECT_EQ(lists.rows, other.rows);
    for (const Cover cover : {Cover::kSquare, Cover::kAxis, Cover::kOriented, Cover::kExact})
      EXPECT_EQ(lists.lengths[cover], other.lengths[cover]) << static_cast<int>(cover);
  }
  EXPECT_EQ(found.voxels.edge, wanted.voxels.edge);
  ASSERT_EQ(found.voxels.groups.size(), wanted.voxels.groups.size());
  for (size_t g = 0; g < found.voxels.groups.size(); ++g) {
    const GroupCounts &group = found.voxels.groups[g], &other = wanted.voxels.groups[g];
    EXPECT_EQ(group.voxels, other.voxels) << g;
    EXPECT_EQ(group.filtered.fetched, other.filtered.fetched) << g;
    EXPECT_EQ(group.filtered.coarse, other.filtered.coarse) << g;
    EXPECT_EQ(group.filtered.fine, other.filtered.fine) << g;
  }
  ASSERT_EQ(found.tiles.size(), wanted.tiles.size());
  for (size_t t = 0; t < found.tiles.size(); ++t) {
    SCOPED_TRACE(t);
    FrameCounts tile, other;
    tile.total = found.tiles[t], other.total = wanted.tiles[t];
    expect_same_rows(tile, other);
  }
}

}  // namespace pipegs
