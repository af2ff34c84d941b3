// SPDX-License-Identifier: Apache-2.0
// bit_length_test: rtl/lib/math/pipegs_bit_length.sv against std::bit_width.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "Vpipegs_bit_length.h"

namespace pipegs {
namespace {

TEST(BitLength, CountsTheBitsUpToTheHighest) {
  std::mt19937 rng(1);
  Vpipegs_bit_length dut;
  for (int i = 0; i < 20000; ++i) {
    const auto in = i == 0 ? 0u : static_cast<uint32_t>(rng()) >> rng() % 32;
    dut.in_i = in;
    dut.eval();
    ASSERT_EQ(dut.length_o, std::bit_width(in)) << "of " << in;
  }
}

}  // namespace
}  // namespace pipegs
