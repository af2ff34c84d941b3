// SPDX-License-Identifier: Apache-2.0
// pu_color_normalise_test: rtl/pu/color/pu_color_normalise.sv against its bit-accurate model, and the model
// against double precision.
#include "cpp_model/pu/color/pu_color_normalise.hpp"

#include "Vpu_color_normalise.h"
#include "cpp_model/pu/color/pu_color_rotate.hpp"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

WorldDirection random_world(std::mt19937_64& rng) {
  Frame frame;
  set_rotation(kConfig, frame, rng);
  WorldDirection world = pu_color_rotate(kConfig, frame, random_direction(kConfig, rng));
  if (rng() % 16 == 0) world = random_record<WorldDirection>(kConfig, rng);  // a length that does not fit: saturates
  return world;
}

TEST(PuColorNormalise, UnitVectorIsCloseToDouble) {
  std::mt19937_64 rng(test_seed());
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    Frame frame;
    set_rotation(kConfig, frame, rng);
    const ViewDirection view = random_direction(kConfig, rng);
    const glm::dvec3 v(view.x, view.y, view.z);
    if (glm::length(v) < 65536) continue;  // not block-normalised: correct, but coarse
    const UnitDirection unit = pu_color_normalise(kConfig, pu_color_rotate(kConfig, frame, view));
    const glm::dvec3 exact = glm::normalize(to_world(kConfig, frame, v));
    const glm::dvec3 error =
        glm::abs(glm::dvec3(unit.x, unit.y, unit.z) * std::ldexp(1.0, -kConfig.unit_direction_f()) - exact);
    worst = std::max({worst, error.x, error.y, error.z});
  }
  std::printf("pu_color_normalise: worst error of a component 2^%.2f, rotation included\n", std::log2(worst));
  EXPECT_LT(worst, std::exp2(-15));
}

TEST(PuColorNormalise, ZeroStaysZero) {
  const UnitDirection unit = pu_color_normalise(kConfig, {});
  EXPECT_EQ(unit, UnitDirection{});
}

void run(Pace source_pace, Pace sink_pace, int count, bool check_pace) {
  Bench<Vpu_color_normalise> bench;
  RecordSource<WorldDirection, decltype(bench.dut.world_i)> in(bench, kConfig, bench.dut.world_valid_i,
                                                               bench.dut.world_ready_o, bench.dut.world_i, source_pace);
  RecordSink<UnitDirection, decltype(bench.dut.unit_o)> out(bench, kConfig, bench.dut.unit_valid_o,
                                                            bench.dut.unit_ready_i, bench.dut.unit_o, sink_pace);
  bench.reset();
  std::vector<WorldDirection> sent;
  for (int i = 0; i < count; ++i) in.push(sent.emplace_back(random_world(bench.rng)));
  bench.run_until([&] { return out.size() == sent.size(); });
  for (size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(first_difference(kConfig, pu_color_normalise(kConfig, sent[i]), out.at(i)), "")
        << to_text(kConfig, sent[i]) << " cycle " << out.cycles[i] << " seed " << bench.seed;
  }
  if (check_pace) { EXPECT_EQ(out.cycles.back() - out.cycles.front(), 5u * (sent.size() - 1)); }
}

TEST(PuColorNormalise, EqualsItsModelAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) run(source_pace, sink_pace, 1000, false);
  }
}

TEST(PuColorNormalise, TakesOneDirectionInFiveCycles) { run(Pace::kAlways, Pace::kAlways, 100, true); }

}  // namespace
}  // namespace pipegs
