// SPDX-License-Identifier: Apache-2.0
// pu_phases_test: rtl/pu/pu_phases.sv, the clockwork of the eight-cycle stages, against the promises of its head.
#include "Vpu_phases.h"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

constexpr int kDepth = 1, kClaim = 4;  // the module's defaults

// Plays the stage: a record is its number; what the output register holds follows claim_o.
TEST(PuPhases, EveryRecordGoesThroughAllPhasesInOrderAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Vpu_phases> bench;
      auto& dut = bench.dut;
      dut.in_valid_i = dut.out_ready_i = 0;
      bench.reset();
      int held = -1, next = 0, out = -1, left = 0;  // record held, next one, in the output register, seen at the output
      int next_phase = 0, last_phase = -1;          // expected now and seen at level Depth
      bool out_full = false;
      for (int cycle = 0; cycle < 4000; ++cycle) {
        if (!dut.in_valid_i) dut.in_valid_i = goes(source_pace, bench.rng);
        dut.out_ready_i = goes(sink_pace, bench.rng);
        dut.clk_i = 0;
        dut.eval();
        const unsigned level1 = (dut.slots_o >> (4 * (kDepth - 1))) & 15;
        ASSERT_EQ(dut.held_o, held >= 0) << "cycle " << cycle;
        if (held >= 0) { ASSERT_EQ(dut.phase_o, 1 << next_phase) << "cycle " << cycle; }
        ASSERT_EQ(dut.out_valid_o, out_full) << "cycle " << cycle;
        ASSERT_EQ(dut.busy_o, held >= 0 || out_full || (level1 >> 3)) << "cycle " << cycle;
        const bool taken = out_full && dut.out_ready_i;
        if (taken) { ASSERT_EQ(out, left++) << "cycle " << cycle; }
        if (dut.claim_o) {
          ASSERT_TRUE(held >= 0 && next_phase == kClaim && (!out_full || taken)) << "cycle " << cycle;
          out = held;
        }
        if (taken) out_full = false;
        if (dut.step_o && (level1 >> 3)) {
          ASSERT_EQ(static_cast<int>(level1 & 7), (last_phase + 1) % 8) << "cycle " << cycle;
          last_phase = static_cast<int>(level1 & 7);
          if (last_phase == 7) out_full = true;
        }
        if (!dut.step_o) {
          ASSERT_TRUE(next_phase == kClaim && out_full) << "stalls only for the output, cycle " << cycle;
        }
        if (dut.step_o && held >= 0 && ++next_phase == 8) held = -1;
        if (dut.take_o) {
          ASSERT_TRUE(dut.in_valid_i && dut.in_ready_o && held < 0) << "cycle " << cycle;
          held = next++;
          next_phase = 0;
        }
        const bool taken_in = dut.take_o;
        bench.step();
        if (taken_in) dut.in_valid_i = 0;
      }
      EXPECT_GT(left, source_pace == Pace::kAlways && sink_pace == Pace::kAlways ? 490 : 300);
    }
  }
}

}  // namespace
}  // namespace pipegs
