// SPDX-License-Identifier: Apache-2.0
// pu_compensate_test: rtl/pu/project/pu_compensate.sv against its bit-accurate model, and the model against double
// precision.
#include "cpp_model/pu/project/pu_compensate.hpp"

#include "Vpu_compensate.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_compensate, Covariance, covariance, Covariance, compensated);

Covariance make(PuRandom& random, const Frame& frame) {
  Covariance c = pu_covariance(random.config, frame, random_squares(random, frame), random.center());
  if (random.chance(10)) c.sharp_m = 0;
  if (random.chance(10))
    c.sharp_m = c.det_m >> (random.config.mantissa_w - random.config.sharp_w()), c.sharp_e = c.det_e;
  if (random.chance(10)) c.opacity = random.integer(0, (1 << random.config.opacity_w()) - 1);
  return c;
}

// The frame's flag is a port of its own.
void check(bool flag, Pace source_pace, Pace sink_pace) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  auto run = stage_run<Stage>(make, [&](const Config& c, const Frame& f, const Covariance& in) {
    Frame frame = f;
    frame.tables.antialias = flag;
    return pu_compensate(c, frame, in);
  })(random, 400);
  Bench<Vpu_compensate> bench;
  bench.dut.antialias_i = flag;
  auto source = Stage::source(bench, config, source_pace);
  auto sink = Stage::sink(bench, config, sink_pace);
  bench.reset();
  const uint64_t start = bench.cycle;
  for (const auto& input : run.inputs) source.push(input);
  bench.run_until([&] { return sink.size() >= run.expected.size(); }, 100 * run.inputs.size());
  for (int i = 0; i < 10; ++i) bench.step();
  ASSERT_EQ(sink.size(), run.expected.size());
  EXPECT_EQ(bench.dut.busy_o, 0);
  for (size_t i = 0; i < run.expected.size(); ++i) {
    ASSERT_EQ(sink.at(i), run.expected[i])
        << "beat " << i << ", " << to_text(source_pace) << " to " << to_text(sink_pace) << ": "
        << first_difference(config, run.expected[i], sink.at(i));
  }
  if (source_pace != Pace::kAlways || sink_pace != Pace::kAlways) return;
  EXPECT_EQ(sink.cycles.front() - start, 4u) << "latency";
  EXPECT_LE((sink.cycles.back() - sink.cycles.front()) / (sink.size() - 1), 8u) << "its neighbours' pace";
}

TEST(PuCompensate, EqualsItsModelAtEveryPaceFlaggedOrNot) {
  for (const bool flag : {true, false}) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) check(flag, source_pace, sink_pace);
    }
  }
}

TEST(PuCompensate, IsWithinItsStatedErrorOfDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const double bound = 5.4e-5 + std::ldexp(0.5, -config.opacity_f);
  double worst = 0;
  int floored = 0;
  for (int i = 0; i < 20000; ++i) {
    Frame f = random.frame();
    f.tables.antialias = 1;
    const Covariance in = pu_covariance(config, f, random_squares(random, f), random.center());
    const double det = std::ldexp(static_cast<double>(in.det_m), static_cast<int>(in.det_e));
    const double sharp = std::ldexp(static_cast<double>(in.sharp_m),
                                    static_cast<int>(in.sharp_e) + config.mantissa_w - config.sharp_w());
    const double fall = -0.5 * std::log2(std::max(2.5e-5, sharp / det)),
                 all = std::ldexp(static_cast<double>(in.opacity), -config.opacity_f) + fall;
    const double found = std::ldexp(static_cast<double>(pu_compensate(config, f, in).opacity), -config.opacity_f);
    floored += sharp < 2.5e-5 * det;
    if (all < 15.99) worst = std::max(worst, std::abs(found - all));
    else EXPECT_GT(found, 15.9);
  }
  std::printf("pu_compensate: error %.3g of -log2(opacity), %d of 20000 at the floor\n", worst, floored);
  EXPECT_LT(worst, bound);
  EXPECT_GT(floored, 100);
}

}  // namespace
}  // namespace pipegs
