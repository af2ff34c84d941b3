// multiply_test: rtl/lib/multiply.sv against the operator *, for every pair of its default eight bits.
#include <gtest/gtest.h>
#include <verilated.h>

#include "Vmultiply.h"

namespace pipegs {
namespace {

TEST(Multiply, EveryPairOfEightBits) {
  VerilatedContext context;
  Vmultiply dut(&context);
  for (int left = -128; left < 128; ++left) {
    for (int right = -128; right < 128; ++right) {
      dut.left_i = static_cast<CData>(left);
      dut.right_i = static_cast<CData>(right);
      dut.eval();
      ASSERT_EQ(static_cast<int16_t>(dut.out_o), left * right) << left << " x " << right;
    }
  }
}

}  // namespace
}  // namespace pipegs
