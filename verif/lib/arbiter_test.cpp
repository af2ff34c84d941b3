// SPDX-License-Identifier: Apache-2.0
// arbiter_test: rtl/lib/pipegs_arbiter.sv against the round-robin rule, for random requests.
#include "verif/support/bench.hpp"
#include "Vpipegs_arbiter.h"

namespace pipegs {
namespace {

constexpr int kPorts = 4;  // the module's default

// A request stays until it is granted and used, or may be withdrawn before.
void grants_by_the_rule(bool withdrawn) {
  Bench<Vpipegs_arbiter> bench;
  bench.dut.request_i = 0;
  bench.dut.advance_i = 0;
  bench.reset();
  int last = 0, shown = -1;
  uint32_t requests = 0;
  for (int i = 0; i < 2000; ++i) {
    if (withdrawn) requests &= static_cast<uint32_t>(bench.rng() | bench.rng());
    requests |= static_cast<uint32_t>(bench.rng() & bench.rng() & 0xf);
    bench.dut.request_i = static_cast<CData>(requests);
    bench.dut.advance_i = bench.rng() % 2;
    bench.dut.clk_i = 0;
    bench.dut.eval();
    int expected = -1;
    for (int k = 1; k <= kPorts && expected < 0; ++k) {
      if (requests >> ((last + k) % kPorts) & 1) expected = (last + k) % kPorts;
    }
    if (shown >= 0 && (requests >> shown & 1)) expected = shown;
    ASSERT_EQ(bench.dut.grant_o, expected < 0 ? 0 : 1 << expected) << "cycle " << i << ", requests " << requests;
    if (expected >= 0) { ASSERT_EQ(bench.dut.port_o, expected); }
    const bool used = expected >= 0 && bench.dut.advance_i;
    shown = expected >= 0 && !used ? expected : -1;
    if (used) {
      last = expected;
      requests &= ~(1u << expected);
    }
    bench.dut.clk_i = 1;
    bench.dut.eval();
  }
}

TEST(Arbiter, GrantsTheNextRequestAfterTheLastUsedOneAndKeepsAnUnusedGrant) { grants_by_the_rule(false); }

TEST(Arbiter, AWithdrawnRequestGivesItsGrantAway) { grants_by_the_rule(true); }

TEST(Arbiter, NoRequestWaitsForMoreThanTheOtherPorts) {
  Bench<Vpipegs_arbiter> bench;
  bench.dut.request_i = 0xf;
  bench.dut.advance_i = 1;
  bench.reset();
  std::vector<int> grants(kPorts);
  for (int i = 0; i < 40; ++i) {
    bench.step();
    ++grants[bench.dut.port_o];
  }
  for (const int count : grants) EXPECT_EQ(count, 10);
}

}  // namespace
}  // namespace pipegs
