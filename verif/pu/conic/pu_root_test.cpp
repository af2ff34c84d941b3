// SPDX-License-Identifier: Apache-2.0
// pu_root_test: rtl/pu/conic/pu_root.sv against its bit-accurate model, and the model against the definition of
// a square root.
#include "cpp_model/pu/conic/pu_root.hpp"
#include "verif/support/bench.hpp"
#include "Vpu_root.h"

namespace pipegs {
namespace {

TEST(PuRoot, IsTheFloorOfTheRoot) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 100000; ++i) {
    const uint64_t x = i < 1000 ? i : (rng() & ((uint64_t{1} << kRadicandW) - 1)) >> (rng() % kRadicandW),
                   root = pu_root(x);
    ASSERT_TRUE(root * root <= x && (root + 1) * (root + 1) > x) << x;
  }
}

TEST(PuRoot, EqualsItsModelAndHolds) {
  Vpu_root dut;
  std::mt19937_64 rng(test_seed());
  auto tick = [&](bool load, bool step) {
    dut.load_i = load, dut.step_i = step;
    dut.clk_i = 0, dut.eval();
    dut.clk_i = 1, dut.eval();
  };
  for (int i = 0; i < 20000; ++i) {
    const uint32_t x = i == 0 ? 0 : i == 1 ? (1u << kRadicandW) - 1 : rng() & ((1u << kRadicandW) - 1);
    dut.radicand_i = x;
    tick(true, rng() % 2);
    dut.radicand_i = rng() & ((1u << kRadicandW) - 1);
    for (int done = 0; done < 7;) {
      const bool step = rng() % 4 != 0;
      tick(false, step);
      done += step;
    }
    tick(false, false);
    ASSERT_EQ(dut.root_o, pu_root(x)) << x;
  }
}

}  // namespace
}  // namespace pipegs
