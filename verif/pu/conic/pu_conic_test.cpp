// SPDX-License-Identifier: Apache-2.0
// pu_conic_test: rtl/pu/conic/pu_conic.sv against its bit-accurate model, and the model against double.
#include "cpp_model/pu/conic/pu_conic.hpp"

#include "verif/pu/random_splat.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_conic.h"

namespace pipegs {
namespace {

struct Stage {
  Config config = test_config();
  Bench<Vpu_conic> bench;
  RecordSource<Covariance, decltype(bench.dut.covariance_i)> in{bench, config, bench.dut.covariance_valid_i,
                                                                bench.dut.covariance_ready_o, bench.dut.covariance_i};
  RecordSink<Conic, decltype(bench.dut.conic_o)> out{bench, config, bench.dut.conic_valid_o, bench.dut.conic_ready_i,
                                                     bench.dut.conic_o};
  void compare(const std::vector<Covariance>& records) {
    std::vector<Conic> expected;
    for (const Covariance& record : records) expected.push_back(pu_conic(config, Frame{}, record));
    expect_stream(config, bench, in, out, records, expected);
  }
};

TEST(PuConic, EqualsItsModelAtEveryPairOfPaces) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      SCOPED_TRACE(std::string(to_text(source)) + " to " + to_text(sink));
      Stage s;
      s.in.pace = source, s.out.pace = sink;
      std::vector<Covariance> records;
      for (int i = 0; i < 1500; ++i) records.push_back(random_covariance(s.config, s.bench.rng));
      s.compare(records);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(PuConic, SaturatesASlopeBeyondOne) {
  Stage s;
  std::vector<Covariance> records;
  for (int i = 0; i < 300; ++i) {
    Covariance r = random_splat(s.config, s.bench.rng, 30).record;
    r.b_e += static_cast<int64_t>(s.bench.rng() % 41) - 20;
    if (i % 7 == 0) r.b_m = i % 2 == 0 ? 0 : -1;
    records.push_back(r);
  }
  s.compare(records);
}

TEST(PuConic, TakesARecordInEightCyclesAndAnEndInSix) {
  Stage s;
  std::vector<Covariance> records;
  for (int i = 0; i < 100; ++i) records.push_back(random_splat(s.config, s.bench.rng, 30).record);
  for (int i = 0; i < 100; ++i) records.push_back({.kind = kLayerEnd});
  s.compare(records);
  EXPECT_EQ(s.out.cycles.at(90) - s.out.cycles.at(10), 80u * 8);
  EXPECT_EQ(s.out.cycles.at(190) - s.out.cycles.at(110), 80u * 6);
}

TEST(PuConic, AgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  const double unit = std::ldexp(1, -config.mantissa_w);
  double narrow_worst = 0, wide_worst = 0, slope_worst = 0, box_worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const RandomSplat s = random_splat(config, rng, i % 2 == 0 ? 10 : 5000);
    const Conic k = pu_conic(config, Frame{}, s.record);
    const double larger = k.swap ? s.a : s.c;
    const double narrow = kHalfLog2E * larger / s.det, wide = kHalfLog2E / larger;
    if (std::abs(s.a - s.c) > 8 * unit * larger) { ASSERT_EQ(k.swap != 0, s.a > s.c); }
    narrow_worst = std::max(
        narrow_worst, std::abs(std::ldexp(static_cast<double>(k.narrow_m), static_cast<int>(k.narrow_e)) / narrow - 1));
    wide_worst = std::max(wide_worst,
                          std::abs(std::ldexp(static_cast<double>(k.wide_m), static_cast<int>(k.wide_e)) / wide - 1));
    slope_worst = std::max(slope_worst,
                           std::abs(std::ldexp(static_cast<double>(k.slope_m), 2 - config.slope_w()) - s.b / larger));
    const double reach = std::log2(config.alpha_cut) - s.opacity;
    if (config.oriented()) continue;  // its extents come with the covariance
    for (const auto& [extent, variance] : {std::pair{k.extent_x, s.a}, std::pair{k.extent_y, s.c}}) {
      const double exact = std::sqrt(variance * std::max(reach, 0.0) / kHalfLog2E),
                   found = std::ldexp(static_cast<double>(extent), -4);
      ASSERT_GE(found, exact);
      if (reach > 0.5) box_worst = std::max(box_worst, (found - 0.25) / exact - 1);
    }
  }
  std::printf(
      "pu_conic: relative error of narrow %.3g, of wide %.3g, error of slope %.3g; box too large by 1/4 px and %.2f "
      "%%\n",
      narrow_worst, wide_worst, slope_worst, 100 * box_worst);
  EXPECT_LE(narrow_worst, 8 * unit);
  EXPECT_LE(wide_worst, 4 * unit);
  EXPECT_LE(slope_worst, 4 * unit + std::ldexp(1, 2 - config.slope_w()));
  if (config == Config{}) { EXPECT_LE(box_worst, 0.02); }  // coarser slack and opacities widen it
}

}  // namespace
}  // namespace pipegs
