// SPDX-License-Identifier: Apache-2.0
// dopu_axis_test: rtl/dopu/dopu_axis.sv against its bit-accurate model.
#include "Vdopu_axis.h"
#include "cpp_model/dopu/dopu_axis.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

int axis_of(Vdopu_axis& dut, const Config& config, int64_t x, int64_t y, int64_t z) {
  const uint64_t mask = (uint64_t{1} << config.rot_w()) - 1;
  dut.forward_x_i = static_cast<uint64_t>(x) & mask;
  dut.forward_y_i = static_cast<uint64_t>(y) & mask;
  dut.forward_z_i = static_cast<uint64_t>(z) & mask;
  dut.eval();
  return dut.axis_o;
}

TEST(DopuAxis, TakesTheLongestComponentAndTheLowestOfEqualOnes) {
  const Config config = test_config();
  VerilatedContext context;
  Vdopu_axis dut(&context);
  const int64_t one = int64_t{1} << config.rot_f();
  EXPECT_EQ(axis_of(dut, config, one, 0, 0), 0);
  EXPECT_EQ(axis_of(dut, config, 0, -one, 0), 1);
  EXPECT_EQ(axis_of(dut, config, 0, 0, -one), 2);
  EXPECT_EQ(axis_of(dut, config, 5, -5, 5), 0);
  EXPECT_EQ(axis_of(dut, config, 4, -5, 5), 1);
  EXPECT_EQ(axis_of(dut, config, 0, 0, 0), 0);
}

TEST(DopuAxis, EqualsItsModel) {
  const Config config = test_config();
  VerilatedContext context;
  Vdopu_axis dut(&context);
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 20000; ++i) {
    Frame frame = random_record<Frame>(config, rng);
    if (i % 3 == 0) frame.camera.rotation.w21 = rng() % 2 == 0 ? frame.camera.rotation.w20 : -frame.camera.rotation.w22;
    if (frame.camera.rotation.w21 == int64_t{1} << (config.rot_w() - 1)) continue;
    ASSERT_EQ(axis_of(dut, config, frame.camera.rotation.w20, frame.camera.rotation.w21, frame.camera.rotation.w22),
              dopu_axis(frame))
        << to_text(config, frame);
  }
}

}  // namespace
}  // namespace pipegs
