// SPDX-License-Identifier: Apache-2.0
// pu_coeff_test: rtl/pu/conic/pu_coeff.sv against its bit-accurate model, and the model against double, pixel by
// pixel.
#include "cpp_model/pu/conic/pu_coeff.hpp"

#include "verif/pu/random_splat.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_coeff.h"

namespace pipegs {
namespace {

struct Stage {
  Config config = test_config();
  Bench<Vpu_coeff> bench;
  RecordSource<Conic, decltype(bench.dut.conic_i)> in{bench, config, bench.dut.conic_valid_i, bench.dut.conic_ready_o,
                                                      bench.dut.conic_i};
  RecordSink<Coeff, decltype(bench.dut.coeff_o)> out{bench, config, bench.dut.coeff_valid_o, bench.dut.coeff_ready_i,
                                                     bench.dut.coeff_o};
  void compare(const std::vector<Conic>& records) {
    std::vector<Coeff> expected;
    for (const Conic& record : records) expected.push_back(pu_coeff(config, Frame{}, record));
    expect_stream(config, bench, in, out, records, expected);
  }
  Conic conic() { return pu_conic(config, Frame{}, random_covariance(config, bench.rng)); }
};

TEST(PuCoeff, EqualsItsModelAtEveryPairOfPaces) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      SCOPED_TRACE(std::string(to_text(source)) + " to " + to_text(sink));
      Stage s;
      s.in.pace = source, s.out.pace = sink;
      std::vector<Conic> records;
      for (int i = 0; i < 1500; ++i) records.push_back(s.conic());
      s.compare(records);
      if (HasFatalFailure()) return;
    }
  }
}

// Exponents and slopes around the edge of the range, where each coefficient in turn makes the record dead.
TEST(PuCoeff, EqualsItsModelAroundTheRange) {
  Stage s;
  auto& rng = s.bench.rng;
  std::vector<Conic> records;
  int dead = 0;
  for (int i = 0; i < 20000; ++i) {
    Conic k = random_record<Conic>(s.config, rng);
    k.kind = kData;
    k.narrow_m |= uint64_t{1} << (s.config.mantissa_w - 1);
    k.wide_m |= uint64_t{1} << (s.config.mantissa_w - 1);
    k.narrow_e = -s.config.mantissa_w + 4 - static_cast<int64_t>(rng() % (i % 2 == 0 ? 6 : 40));
    k.wide_e = -s.config.mantissa_w + 4 - static_cast<int64_t>(rng() % (i % 2 == 0 ? 6 : 40));
    k.slope_m = i % 16 == 0 ? (int64_t{1} << (s.config.slope_w() - 2)) * (i % 32 == 0 ? 1 : -1)
                            : (k.slope_m >> 1) >> (rng() % 30);
    k.mean_x >>= rng() % s.config.mean_w();
    k.mean_y >>= rng() % s.config.mean_w();
    records.push_back(k);
    dead += pu_coeff(s.config, Frame{}, k).dead != 0;
  }
  EXPECT_GT(dead, 5000);
  EXPECT_LT(dead, 18000);
  s.compare(records);
}

TEST(PuCoeff, TakesARecordInEightCyclesAndAnEndInFour) {
  Stage s;
  std::vector<Conic> records;
  for (int i = 0; i < 100; ++i)
    records.push_back(pu_conic(s.config, Frame{}, random_splat(s.config, s.bench.rng, 30).record));
  for (int i = 0; i < 100; ++i) records.push_back({.kind = kLayerEnd});
  s.compare(records);
  EXPECT_EQ(s.out.cycles.at(90) - s.out.cycles.at(10), 80u * 8);
  EXPECT_EQ(s.out.cycles.at(190) - s.out.cycles.at(110), 80u * 4);
}

// Every pixel of the window that counts, from the exact covariance (and from the quantised one).
TEST(PuCoeff, PowerAgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  for (double longest : {1.0, 10.0, 100.0, 1000.0, 5000.0}) {
    double worst = 0, worst_quantised = 0, squares = 0, pixels = 0;
    for (int i = 0; i < 6000; ++i) {
      const RandomSplat s = random_splat(config, rng, longest);
      const Covariance& r = s.record;
      const Coeff q = pu_coeff(config, Frame{}, pu_conic(config, Frame{}, r));
      auto value = [](auto m, int64_t e) { return std::ldexp(static_cast<double>(m), static_cast<int>(e)); };
      const double a = value(r.a_m, r.a_e), b = value(r.b_m, r.b_e), c = value(r.c_m, r.c_e),
                   det = value(r.det_m, r.det_e);
      for (int y = 0; y < config.window; ++y) {
        for (int x = 0; x < config.window; ++x) {
          const double exact = s.power(x, y), dx = x - s.mean_x, dy = y - s.mean_y;
          if (exact < -std::log2(config.alpha_cut)) continue;
          ASSERT_EQ(q.dead, 0u);
          const double found = std::ldexp(
              static_cast<double>(q.a + q.b * x + q.c * y + q.d * x * x + q.e * y * y + q.f * x * y), -config.coeff_f);
          const double quantised =
              -s.opacity - kHalfLog2E * (c >= a ? c / det * std::pow(dx - b / c * dy, 2) + dy * dy / c
                                                : a / det * std::pow(dy - b / a * dx, 2) + dx * dx / a);
          worst = std::max(worst, std::abs(found - exact));
          worst_quantised = std::max(worst_quantised, std::abs(found - quantised));
          squares += (found - exact) * (found - exact);
          ++pixels;
        }
      }
    }
    std::printf(
        "pu_coeff: sigma up to %4.0f px: error of the power %.3g (2^%.1f), rms %.3g; from the quantised covariance "
        "%.3g\n",
        longest, worst, std::log2(worst), std::sqrt(squares / pixels), worst_quantised);
    if (config == Config{}) { EXPECT_LE(worst, std::exp2(-9.5)); }
  }
}

}  // namespace
}  // namespace pipegs
