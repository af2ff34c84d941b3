// SPDX-License-Identifier: Apache-2.0
// pu_payload_test: rtl/pu/pu_payload.sv: whoever leaves shows the payload with which it began to walk.
#include <algorithm>
#include <deque>

#include "Vpu_payload.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

constexpr size_t kPlaces = 2;  // the module's default

// Gaussians between the ports, as pu_intersect holds them.
void run(unsigned walk_in, unsigned leave_in, size_t& most) {
  Bench<Vpu_payload> bench;
  auto& dut = bench.dut;
  auto one_in = [&](unsigned n) { return bench.rng() % n == 0; };
  std::deque<uint32_t> walking;
  dut.walk_i = dut.leave_i = 0;
  bench.reset();
  bool shown = false;
  uint32_t expected = 0;
  for (int i = 0; i < 20000; ++i) {
    dut.leave_i = !walking.empty() && one_in(leave_in);
    dut.walk_i = walking.size() < kPlaces + dut.leave_i && one_in(walk_in);
    dut.payload_i = static_cast<uint32_t>(bench.rng());
    dut.clk_i = 0;
    dut.eval();
    if (shown) { ASSERT_EQ(dut.payload_o, expected) << "cycle " << i << ", seed " << bench.seed; }
    if (dut.leave_i) {
      expected = walking.front(), shown = true;
      walking.pop_front();
    }
    if (dut.walk_i) walking.push_back(dut.payload_i);
    most = std::max(most, walking.size());
    dut.clk_i = 1;
    dut.eval();
  }
}

TEST(PuPayload, GivesEveryGaussianItsOwn) {
  size_t most = 0;
  for (const unsigned walk : {1u, 2u, 8u}) {
    for (const unsigned leave : {1u, 2u, 8u}) run(walk, leave, most);
  }
  EXPECT_EQ(most, kPlaces) << "it is full at times";
}

TEST(PuPayload, SaysSoWhenThereAreTooMany) {
#ifdef PIPEGS_NETLIST
  GTEST_SKIP() << "gates assert nothing";
#endif
  Bench<Vpu_payload> bench;
  bench.dut.walk_i = bench.dut.leave_i = 0;
  bench.reset();
  bench.dut.walk_i = 1;
  for (size_t i = 0; i < kPlaces; ++i) bench.step();
  EXPECT_THROW(bench.step(), std::runtime_error);
}

}  // namespace
}  // namespace pipegs
