// SPDX-License-Identifier: Apache-2.0
// pu_color_sum_test: rtl/pu/color/pu_color_sum.sv against its bit-accurate model, and the model against double
// precision.
#include "cpp_model/pu/color/pu_color_sum.hpp"

#include "Vpu_color_sum.h"
#include "cpp_model/pu/color/pu_color_basis.hpp"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

ShBasis random_basis(std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  const glm::dvec3 d = glm::normalize(glm::dvec3(normal(rng), normal(rng), normal(rng))) * 65536.0;
  if (rng() % 8 == 0) return random_record<ShBasis>(kConfig, rng);
  return pu_color_basis({.x = std::llround(d.x), .y = std::llround(d.y), .z = std::llround(d.z)});
}

TEST(PuColorSum, ModelIsCloseToDoubleForTheSameBasis) {
  if (!kConfig.saturation) GTEST_SKIP() << "random colours wrap";
  std::mt19937_64 rng(test_seed());
  double worst = 0, squares = 0;
  const int count = 200000;
  for (int i = 0; i < count; ++i) {
    const Frame frame{.tables = {.sh_degree = static_cast<uint64_t>(kConfig.sh_degree)}};
    const auto line = random_line(kConfig, rng, 16, 25);
    ColorTask task = random_record<ColorTask>(kConfig, rng);
    task.kind = kData;
    const ShBasis basis = random_basis(rng);
    const auto b = functions(basis);
    const int degree = color_degree(kConfig, frame), bands = (degree + 1) * (degree + 1) - 1;
    double exact = std::ldexp(task.base_g, 3 - kConfig.base_w);
    for (int k = 0; k < bands; ++k) {
      exact += coefficient(kConfig, frame, line.data(), task.quarter, k, 1) * std::ldexp(b[k], -kConfig.basis_f());
    }
    const double unit = std::ldexp(1.0, 2 - kConfig.color_w);
    exact = std::clamp(exact, 0.0, 4 - unit) / unit;
    const double error =
        std::abs(static_cast<double>(pu_color_sum(kConfig, frame, task, line.data(), basis).green) - exact);
    worst = std::max(worst, error);
    squares += error * error;
  }
  std::printf("pu_color_sum: worst error %.3f units of the colour, rms %.3f\n", worst, std::sqrt(squares / count));
  EXPECT_LE(worst, 0.5 + 0.125 + 1e-9);
}

TEST(PuColorSum, CountsSaturatedChannels) {
  const Frame frame{.tables = {.sh_degree = static_cast<uint64_t>(kConfig.sh_degree)}};
  std::array<uint32_t, 16> line{};
  line[0] = 31 | 0x3ffu << kConfig.sh_e_w;  // the first red coefficient is large
  ShBasis basis;
  basis.b1 = 32000;
  ColorCounts counts;
  const Colored colored = pu_color_sum(kConfig, frame, {}, line.data(), basis, &counts);
  if (kConfig.sh_degree == 0 || kConfig.sh_m_w != 11) GTEST_SKIP() << "written for the default widths";
  if (kConfig.saturation) EXPECT_EQ(colored.red, (uint64_t{1} << kConfig.color_w) - 1);
  EXPECT_EQ(counts.saturated, 1u);
}

// Lines and basis functions only come for data beats of a frame with SH.
void run(int frame_degree, Pace task_pace, Pace other_pace, Pace sink_pace, int count, uint64_t expected_pace) {
  Bench<Vpu_color_sum> bench;
  auto& dut = bench.dut;
  RecordSource<ColorTask, decltype(dut.task_i)> tasks(bench, kConfig, dut.task_valid_i, dut.task_ready_o, dut.task_i,
                                                      task_pace);
  WordSource lines(bench, dut.line_valid_i, dut.line_ready_o, dut.line_i, other_pace);
  RecordSource<ShBasis, decltype(dut.basis_i)> bases(bench, kConfig, dut.basis_valid_i, dut.basis_ready_o, dut.basis_i,
                                                     other_pace);
  RecordSink<Colored, decltype(dut.colored_o)> out(bench, kConfig, dut.colored_valid_o, dut.colored_ready_i,
                                                   dut.colored_o, sink_pace);
  const Frame frame{.tables = {.sh_degree = static_cast<uint64_t>(frame_degree)}};
  write_frame(kConfig, dut, frame);
  bench.reset();
  std::vector<Colored> expected;
  for (int i = 0; i < count; ++i) {
    ColorTask task = random_record<ColorTask>(kConfig, bench.rng);
    task.kind = expected_pace == 0 && bench.rng() % 8 == 0 ? (bench.rng() % 2 == 0 ? kLayerEnd : kWindowEnd) : kData;
    const auto line = bench.rng() % 2 == 0 ? random_line(kConfig, bench.rng) : random_line(kConfig, bench.rng, 16, 25);
    const ShBasis basis = random_basis(bench.rng);
    tasks.push(task);
    if (task.kind == kData && color_degree(kConfig, frame) > 0) {
      lines.push(Words(line.begin(), line.end()));
      bases.push(basis);
    }
    expected.push_back(pu_color_sum(kConfig, frame, task, line.data(), basis));
  }
  bench.run_until([&] { return out.size() == expected.size(); });
  for (size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(first_difference(kConfig, expected[i], out.at(i)), "")
        << "degree " << frame_degree << " splat " << i << " cycle " << out.cycles[i] << " seed " << bench.seed;
  }
  if (expected_pace != 0) { EXPECT_EQ(out.cycles.back() - out.cycles.front(), expected_pace * (expected.size() - 1)); }
  bench.step();
  bench.step();
  EXPECT_EQ(dut.busy_o, 0);
}

TEST(PuColorSum, EqualsItsModelAtEveryPaceAndDegree) {
  for (int degree = 0; degree <= 3; ++degree) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) run(degree, source_pace, source_pace, sink_pace, 500, 0);
    }
  }
}

TEST(PuColorSum, ReachesItsPace) {
  const uint64_t paces[] = {2, 5, 5, 8};
  for (int degree = 0; degree <= 3; ++degree) {
    run(degree, Pace::kAlways, Pace::kAlways, Pace::kAlways, 100, paces[std::min(degree, kConfig.sh_degree)]);
  }
}

TEST(PuColorSum, SaysWhenTheOldestGaussianLacksItsLine) {
  if (kConfig.sh_degree == 0) GTEST_SKIP() << "no memory without SH";
  Bench<Vpu_color_sum> bench;
  write_frame(kConfig, bench.dut, Frame{.tables = {.sh_degree = 1}});
  write_record(kConfig, bench.dut.task_i, ColorTask{});
  bench.dut.task_valid_i = bench.dut.line_valid_i = bench.dut.basis_valid_i = bench.dut.colored_ready_i = 0;
  bench.reset();
  bench.step();
  EXPECT_EQ(bench.dut.waiting_memory_o, 0);
  bench.dut.task_valid_i = 1;
  bench.step();
  EXPECT_EQ(bench.dut.waiting_memory_o, 1);
  bench.dut.line_valid_i = 1;
  bench.step();
  EXPECT_EQ(bench.dut.waiting_memory_o, 0);
  write_record(kConfig, bench.dut.task_i, ColorTask{.kind = kLayerEnd});
  bench.dut.line_valid_i = 0;
  bench.step();
  EXPECT_EQ(bench.dut.waiting_memory_o, 0);
}

}  // namespace
}  // namespace pipegs
