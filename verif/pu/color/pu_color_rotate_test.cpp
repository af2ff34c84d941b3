// SPDX-License-Identifier: Apache-2.0
// pu_color_rotate_test: rtl/pu/color/pu_color_rotate.sv against its bit-accurate model, and the model against
// double precision.
#include "cpp_model/pu/color/pu_color_rotate.hpp"

#include "Vpu_color_rotate.h"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

void run(const Frame& frame, Pace source_pace, Pace sink_pace, int count, bool check_pace) {
  Bench<Vpu_color_rotate> bench;
  RecordSource<ViewDirection, decltype(bench.dut.direction_i)> in(
      bench, kConfig, bench.dut.direction_valid_i, bench.dut.direction_ready_o, bench.dut.direction_i, source_pace);
  RecordSink<WorldDirection, decltype(bench.dut.world_o)> out(bench, kConfig, bench.dut.world_valid_o,
                                                              bench.dut.world_ready_i, bench.dut.world_o, sink_pace);
  write_frame(kConfig, bench.dut, frame);
  bench.reset();
  std::vector<ViewDirection> sent;
  for (int i = 0; i < count; ++i) in.push(sent.emplace_back(random_direction(kConfig, bench.rng)));
  bench.run_until([&] { return out.size() == sent.size(); });
  for (size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(first_difference(kConfig, pu_color_rotate(kConfig, frame, sent[i]), out.at(i)), "")
        << to_text(kConfig, sent[i]) << " cycle " << out.cycles[i] << " seed " << bench.seed;
  }
  if (check_pace) { EXPECT_EQ(out.cycles.back() - out.cycles.front(), 6u * (sent.size() - 1)); }
}

TEST(PuColorRotate, ModelIsCloseToDouble) {
  std::mt19937_64 rng(test_seed());
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    Frame frame;
    set_rotation(kConfig, frame, rng);
    const ViewDirection view = random_direction(kConfig, rng);
    const WorldDirection world = pu_color_rotate(kConfig, frame, view);
    const glm::dvec3 exact = to_world(kConfig, frame, {view.x, view.y, view.z});
    const glm::dvec3 error = glm::abs(glm::dvec3(world.x, world.y, world.z) * 0.5 - exact);
    worst = std::max({worst, error.x, error.y, error.z});
    ASSERT_EQ(static_cast<double>(world.length2),
              glm::dot(glm::dvec3(view.x, view.y, view.z), glm::dvec3(view.x, view.y, view.z)));
  }
  std::printf("pu_color_rotate: worst error %.3f units of the view direction\n", worst);
  EXPECT_LT(worst, 1.7);  // 2^-17.2 of a length of up to 2^17.8, and the last half unit
}

TEST(PuColorRotate, EqualsItsModelAtEveryPace) {
  std::mt19937_64 rng(test_seed());
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Frame frame;
      set_rotation(kConfig, frame, rng);
      run(frame, source_pace, sink_pace, 400, false);
    }
  }
}

TEST(PuColorRotate, SaturatesWhenTheMatrixIsNoRotation) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 10; ++i) run(random_record<Frame>(kConfig, rng), Pace::kAlways, Pace::kAlways, 200, false);
}

TEST(PuColorRotate, TakesOneDirectionInSixCycles) {
  std::mt19937_64 rng(test_seed());
  Frame frame;
  set_rotation(kConfig, frame, rng);
  run(frame, Pace::kAlways, Pace::kAlways, 100, true);
}

}  // namespace
}  // namespace pipegs
