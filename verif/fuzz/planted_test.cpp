// SPDX-License-Identifier: Apache-2.0
// What the sanitizers must see: mistakes that are in no other test, run one by one to be sure that the checks are on.
#include <gtest/gtest.h>

#include <limits>

#include "scenes/text/csv.hpp"
#include "verif/fuzz/keep.hpp"

namespace pipegs {
namespace {

TEST(Planted, DISABLED_Overflow) {
  Kept<1> kept;
  parse_csv("a.csv", "name\none\ntwo\n", "name", [&](const CsvRow& row) { kept.add(row.text("name")); });
}

TEST(Planted, DISABLED_Sum) {
  int sum = std::numeric_limits<int>::max() - 1;
  parse_csv("a.csv", "count\n1\n1\n", "count", [&](const CsvRow& row) { sum += row.integer<int>("count"); });
  EXPECT_LT(sum, 0);
}

}  // namespace
}  // namespace pipegs
