// SPDX-License-Identifier: Apache-2.0
// ru_join_test: two of rtl/ru/write/ru_join.sv, wired as raster wires them, between two streams of rows and a memory.
#include <array>

#include "verif/support/bench.hpp"
#include "Vru_join.h"

namespace pipegs {
namespace {

// Combinational: evaluated until both agree.
struct Pair {
  Pair() {
    side[0].odd_i = 0;
    side[1].odd_i = 1;
  }
  void eval() {
    for (int round = 0; round < 3; ++round) {
      for (int i = 0; i < 2; ++i) {
        side[i].pair_valid_i = side[1 - i].pair_valid_o;
        side[i].pair_taken_i = side[1 - i].pair_taken_o;
        side[i].pair_row_i = side[1 - i].pair_row_o;
        side[i].eval();
      }
    }
  }
  Vru_join side[2];
};

TEST(RuJoin, ALineLeavesWithBothOfItsRows) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 2000; ++i) {
    Pair pair;
    const bool wide = rng() % 4 != 0;
    const int left = static_cast<int>(rng() % 2);  // whose rows are the low halves
    std::array<uint32_t, 16> data[2];
    bool valid[2], ready[2];
    for (int k = 0; k < 2; ++k) {
      for (size_t j = 0; j < 8; ++j) data[k][j] = data[k][j + 8] = static_cast<uint32_t>(rng());
      auto& side = pair.side[k];
      side.joined_i = 1;
      side.wide_i = wide;
      side.in_valid_i = valid[k] = rng() % 2 != 0;
      side.in_halves_i = k == left ? 1 : 2;
      side.out_ready_i = ready[k] = rng() % 2 != 0;
      write_port(side.in_data_i, data[k].data());
    }
    pair.eval();
    const bool both = valid[0] && valid[1];
    ASSERT_EQ(pair.side[0].out_valid_o, both);
    ASSERT_EQ(pair.side[1].out_valid_o, 0);
    for (int k = 0; k < 2; ++k) ASSERT_EQ(pair.side[k].in_ready_o, both && ready[0]) << "side " << k;
    if (!both) continue;
    ASSERT_EQ(pair.side[0].out_halves_o, wide ? 3 : 1);
    std::array<uint32_t, 18> line;
    read_port(pair.side[0].out_data_o, line.data());
    ASSERT_TRUE(std::equal(line.begin(), line.begin() + 8, data[left].begin()));
    ASSERT_TRUE(std::equal(line.begin() + 8, line.begin() + 16, data[1 - left].begin()));
  }
}

TEST(RuJoin, ByWindowsEachWritesItsOwn) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 500; ++i) {
    Pair pair;
    std::array<uint32_t, 16> data[2];
    for (int k = 0; k < 2; ++k) {
      for (uint32_t& word : data[k]) word = static_cast<uint32_t>(rng());
      auto& side = pair.side[k];
      side.joined_i = side.wide_i = 0;
      side.in_valid_i = rng() % 2;
      side.in_halves_i = 1 + rng() % 3;
      side.out_ready_i = rng() % 2;
      write_port(side.in_data_i, data[k].data());
    }
    pair.eval();
    for (int k = 0; k < 2; ++k) {
      const auto& side = pair.side[k];
      ASSERT_EQ(side.out_valid_o, side.in_valid_i);
      ASSERT_EQ(side.in_ready_o, side.out_ready_i);
      ASSERT_EQ(side.out_halves_o, side.in_halves_i);
      std::array<uint32_t, 18> line;
      read_port(side.out_data_o, line.data());
      ASSERT_TRUE(std::equal(data[k].begin(), data[k].end(), line.begin()));
    }
  }
}

}  // namespace
}  // namespace pipegs
