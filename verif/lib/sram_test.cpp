// SPDX-License-Identifier: Apache-2.0
// sram_test: rtl/lib/sram.sv against an array.
#include "verif/support/bench.hpp"
#include "Vsram.h"

namespace pipegs {
namespace {

constexpr uint32_t kDepth = 64;  // the module's default

TEST(Sram, ReadsWhatWasWrittenAndHoldsItAndGivesTheOldWordOnACollision) {
  Bench<Vsram> bench;
  std::vector<uint32_t> model(kDepth);
  bench.dut.read_i = 0;
  for (uint32_t i = 0; i < kDepth; ++i) {
    model[i] = static_cast<uint32_t>(bench.rng());
    bench.dut.write_i = 1;
    bench.dut.waddr_i = i;
    bench.dut.wdata_i = model[i];
    bench.dut.clk_i = 0, bench.dut.eval(), bench.dut.clk_i = 1, bench.dut.eval();
  }
  uint32_t shown = 0;
  bool known = false;
  for (int i = 0; i < 5000; ++i) {
    bench.dut.write_i = bench.rng() % 2;
    bench.dut.read_i = bench.rng() % 2;
    bench.dut.waddr_i = bench.rng() % kDepth;
    bench.dut.raddr_i = bench.rng() % 4 == 0 ? bench.dut.waddr_i : static_cast<CData>(bench.rng() % kDepth);
    bench.dut.wdata_i = static_cast<uint32_t>(bench.rng());
    bench.dut.clk_i = 0, bench.dut.eval(), bench.dut.clk_i = 1, bench.dut.eval();
    if (bench.dut.read_i) shown = model[bench.dut.raddr_i], known = true;
    if (bench.dut.write_i) model[bench.dut.waddr_i] = bench.dut.wdata_i;
    if (known) { ASSERT_EQ(bench.dut.rdata_o, shown) << "access " << i; }
  }
}

}  // namespace
}  // namespace pipegs
