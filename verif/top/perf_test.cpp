// SPDX-License-Identifier: Apache-2.0
// perf_test: rtl/pipegs_perf.sv against four numbers: they sum to the running cycles and a restart clears them.
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_perf.h"

namespace pipegs {
namespace {

TEST(Perf, CountsEachStateWhileRunningAndARestartClears) {
  const Config config = test_config();
  Bench<Vpipegs_perf> bench;
  auto& dut = bench.dut;
  dut.restart_i = dut.running_i = dut.state_i = 0;
  bench.reset();
  uint64_t counts[4] = {}, running = 0, most = 0;
  bool restart = false, runs = false;  // of the cycle before: counted one cycle later
  int state = 0;
  for (int cycle = 0; cycle < 20000; ++cycle) {
    dut.restart_i = bench.rng() % 500 == 0;
    dut.running_i = cycle / 64 % 3 == 0 ? 1 : bench.rng() % 2;
    dut.state_i = cycle / 300 % 2 == 0 ? bench.rng() % 4 : cycle / 600 % 4;
    bench.step();
    if (restart) {
      for (uint64_t& count : counts) count = 0;
      running = 0;
    } else if (runs) {
      ++counts[state];
      ++running;
    }
    restart = dut.restart_i, runs = dut.running_i, state = dut.state_i;
    most = std::max(most, running);
    Words words(port_words<decltype(dut.counts_o)>() + 1);
    read_port(dut.counts_o, words.data());
    uint64_t sum = 0;
    for (int i = 0; i < 4; ++i) {
      const uint64_t found = get_bits(words.data(), i * config.perf_w(), config.perf_w());
      ASSERT_EQ(found, counts[i]) << "count " << i << ", cycle " << bench.cycle << ", seed " << bench.seed;
      sum += found;
    }
    ASSERT_EQ(sum, running) << "cycle " << bench.cycle;
  }
  EXPECT_GT(most, 500u);
}

}  // namespace
}  // namespace pipegs
