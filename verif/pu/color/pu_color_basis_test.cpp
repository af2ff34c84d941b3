// SPDX-License-Identifier: Apache-2.0
// pu_color_basis_test: rtl/pu/color/pu_color_basis.sv against its bit-accurate model, and the model against
// double precision.
#include "cpp_model/pu/color/pu_color_basis.hpp"

#include "Vpu_color_basis.h"
#include "verif/pu/color/pu_color_support.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

const Config kConfig = test_config();

glm::dvec3 random_unit(std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  const int axis = static_cast<int>(rng() % 32);
  if (axis < 6) {
    glm::dvec3 d(0);
    d[axis / 2] = axis % 2 == 0 ? 1 : -1;
    return d;
  }
  return glm::normalize(glm::dvec3(normal(rng), normal(rng), normal(rng)));
}

// Rounded, and up to `slack` units too long or too short, as pu_color_normalise may leave it.
UnitDirection to_fixed(const glm::dvec3& d, std::mt19937_64& rng, int slack) {
  const double scale = std::ldexp(1.0, kConfig.unit_direction_f()) +
                       (slack == 0 ? 0 : static_cast<int>(rng() % (2 * slack + 1)) - slack);
  return {.x = std::llround(d.x * scale), .y = std::llround(d.y * scale), .z = std::llround(d.z * scale)};
}

TEST(PuColorBasis, ModelIsCloseToDouble) {
  std::mt19937_64 rng(test_seed());
  double worst = 0;
  for (int i = 0; i < 300000; ++i) {
    const UnitDirection unit = to_fixed(random_unit(rng), rng, 0);
    double exact[15];
    sh_double(glm::normalize(glm::dvec3(unit.x, unit.y, unit.z)), exact);
    const auto found = functions(pu_color_basis(unit));
    for (int k = 0; k < 15; ++k) worst = std::max(worst, std::abs(std::ldexp(found[k], -kConfig.basis_f()) - exact[k]));
  }
  std::printf("pu_color_basis: worst error 2^%.2f\n", std::log2(worst));
  EXPECT_LT(worst, std::exp2(-13));
}

TEST(PuColorBasis, ZeroDirectionGivesFiniteValues) {
  for (const int64_t b : functions(pu_color_basis({}))) EXPECT_LT(std::abs(b), int64_t{1} << kConfig.basis_f());
}

void run(Pace source_pace, Pace sink_pace, int count, bool check_pace) {
  Bench<Vpu_color_basis> bench;
  RecordSource<UnitDirection, decltype(bench.dut.unit_i)> in(bench, kConfig, bench.dut.unit_valid_i,
                                                             bench.dut.unit_ready_o, bench.dut.unit_i, source_pace);
  RecordSink<ShBasis, decltype(bench.dut.basis_o)> out(bench, kConfig, bench.dut.basis_valid_o, bench.dut.basis_ready_i,
                                                       bench.dut.basis_o, sink_pace);
  bench.reset();
  std::vector<UnitDirection> sent;
  for (int i = 0; i < count; ++i) {
    in.push(sent.emplace_back(i % 50 == 0 ? UnitDirection{} : to_fixed(random_unit(bench.rng), bench.rng, 3)));
  }
  bench.run_until([&] { return out.size() == sent.size(); });
  for (size_t i = 0; i < out.size(); ++i) {
    ASSERT_EQ(first_difference(kConfig, pu_color_basis(sent[i]), out.at(i)), "")
        << to_text(kConfig, sent[i]) << " cycle " << out.cycles[i] << " seed " << bench.seed;
  }
  if (check_pace) { EXPECT_EQ(out.cycles.back() - out.cycles.front(), 7u * (sent.size() - 1)); }
}

TEST(PuColorBasis, EqualsItsModelAtEveryPace) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) run(source_pace, sink_pace, 1000, false);
  }
}

TEST(PuColorBasis, TakesOneDirectionInSevenCycles) { run(Pace::kAlways, Pace::kAlways, 100, true); }

}  // namespace
}  // namespace pipegs
