// SPDX-License-Identifier: Apache-2.0
// first_line_test: rtl/lib/pipegs_first_line.sv against a loop.
#include "Vpipegs_first_line.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(FirstLine, GivesTheLineOfTheLowestValidPort) {
  constexpr int kPorts = 5;
  const int width = test_config().address_w();
  Vpipegs_first_line dut;
  std::mt19937_64 rng(test_seed());
  for (int round = 0; round < 2000; ++round) {
    Words words(port_words<decltype(dut.line_i)>() + 2);
    uint64_t lines[kPorts], expected = 0;
    dut.valid_i = static_cast<CData>(rng() & rng() & ((1 << kPorts) - 1));
    for (int i = kPorts; i-- > 0;) {
      lines[i] = rng() & ((uint64_t{1} << width) - 1);
      put_bits(words.data(), i * width, width, lines[i]);
      if (dut.valid_i >> i & 1) expected = lines[i];
    }
    write_port(dut.line_i, words.data());
    dut.eval();
    ASSERT_EQ(dut.valid_o, dut.valid_i != 0);
    ASSERT_EQ(dut.line_o, expected) << "valid " << int{dut.valid_i};
  }
}

}  // namespace
}  // namespace pipegs
