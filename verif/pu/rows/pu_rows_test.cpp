// SPDX-License-Identifier: Apache-2.0
// pu_rows_test: rtl/pu/rows/pu_rows.sv, with pu_region, the Row Units and pu_alpha in it, against its bit-accurate
// model, line by line; the models against 128-bit integers and against Eq. 1 in double.
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "verif/pu/rows/random_row_job.hpp"
#include "verif/support/config.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpu_rows.h"

namespace pipegs {
namespace {

struct RowsBench {
  Config config = test_config();
  PuRows model{config};
  GatedBench<Vpu_rows> bench;
  RecordSource<RowJob, decltype(bench.dut.row_job_i)> in{bench, config, bench.dut.row_job_valid_i,
                                                         bench.dut.row_job_ready_o, bench.dut.row_job_i};
  RecordSink<Alphas, decltype(bench.dut.alphas_o)> out{bench, config, bench.dut.alphas_valid_o,
                                                       bench.dut.alphas_ready_i, bench.dut.alphas_o};
  std::vector<Alphas> expected;
  std::vector<Words> lines, found_lines;  // beside each record
  Beside watch{bench, [this] {
                 if (!bench.dut.alphas_valid_o || !bench.dut.alphas_ready_i) return;
                 found_lines.emplace_back(port_words<decltype(bench.dut.line_o)>());
                 read_port(bench.dut.line_o, found_lines.back().data());
               }};

  void push(const RowJob& job) {
    in.push(job);
    if (job.kind != kData) {
      expected.push_back({.kind = job.kind});
      lines.emplace_back();
      return;
    }
    for (int r = 0; r < config.regions(); ++r) {
      if (((job.mask >> r) & 1) == 0) continue;
      expected.push_back(pu_rows(config, job, r));
      uint16_t codes[64];
      pu_region_line(model, job, r, codes);
      lines.emplace_back(static_cast<size_t>(config.line_w()) / 32);
      pack_line(config, codes, lines.back().data());
    }
  }
  void run_and_compare() {
    bench.reset();
    bench.run_gated_until([&] { return out.size() >= expected.size(); }, 800000);
    for (size_t i = 0; i < std::min(out.size(), expected.size()); ++i) {
      ASSERT_EQ(out.at(i).kind, expected[i].kind) << "beat " << i;
      if (expected[i].kind != kData) continue;
      ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "") << "beat " << i << " in cycle " << out.cycles[i];
      found_lines[i].resize(lines[i].size());
      ASSERT_EQ(found_lines[i], lines[i]) << "line " << i << " in cycle " << out.cycles[i];
    }
  }
};

TEST(PuRows, EqualsItsModelAtEveryPairOfPaces) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      RowsBench s;
      s.in.pace = source, s.out.pace = sink;
      for (int i = 0; i < 120; ++i) s.push(random_row_job(s.config, s.bench.rng));
      s.run_and_compare();
      if (HasFailure()) { FAIL() << "source " << to_text(source) << ", sink " << to_text(sink); }
    }
  }
}

// One power in all pixels of a region: every code around the cut, around 0 and around both ends of what exp2 reads.
TEST(PuRows, EqualsItsModelAroundTheEdgesOfThePower) {
  RowsBench s;
  const int64_t unit = int64_t{1} << (s.config.coeff_f - s.config.power_f),  // of the power
      high = (int64_t{1} << (s.config.a_w() - 1)) / unit, one = int64_t{1} << s.config.power_f;
  for (const int64_t edge :
       {-high, high - 4, int64_t{0}, -int64_t{s.config.power_cut()}, -8 * one, -16 * one, 8 * one, 16 * one, -one}) {
    for (int64_t step = -3; step <= 3; ++step) {
      const int64_t power = std::max(-high, edge + step);
      s.push({.a = power * unit, .mask = uint64_t{1} << (s.bench.rng() % static_cast<uint64_t>(s.config.regions()))});
    }
  }
  for (int i = 0; i < 2000; ++i) {  // from one unit to the whole range
    const int64_t size = static_cast<int64_t>(s.bench.rng() % static_cast<uint64_t>(high)) >> (s.bench.rng() % 40);
    s.push({.a = (i % 8 == 0 ? size : -size) * unit, .mask = 1});
  }
  s.run_and_compare();
}

TEST(PuRows, GivesARegionPerWalkWithoutBubbles) {
  RowsBench s;
  for (int i = 0; i < 100; ++i) {
    RowJob job = gaussian_row_job(s.config, s.bench.rng);
    if (i % 2 == 0) job.mask = 1;
    s.push(job);
  }
  s.run_and_compare();
  EXPECT_EQ(s.out.cycles.back() - s.out.cycles.front(),
            (s.out.size() - 1) * (8 / static_cast<uint64_t>(s.config.pixels_per_row)));
}

TEST(PuRowsModel, ARegionIsExactUntilItsOneRounding) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 20000; ++i) {
    const RowJob job = any_row_job(config, rng);
    const int r = static_cast<int>(rng() % static_cast<uint64_t>(config.regions()));
    const Int128 x = 8 * (r % config.part_regions_x()), y = 8 * (r / config.part_regions_x());
    const int shift = config.coeff_f - config.power_f;
    const Region region = pu_region(config, job, r);
    EXPECT_EQ(region.power, static_cast<int64_t>(shift_round(
                                job.a + job.b * x + job.c * y + job.d * x * x + job.e * y * y + job.f * x * y, shift)));
    EXPECT_EQ(region.slope_x, static_cast<int64_t>(shift_round(job.b + 2 * job.d * x + job.f * y, shift)));
    EXPECT_EQ(region.slope_y, static_cast<int64_t>(shift_round(job.c + 2 * job.e * y + job.f * x, shift)));
    Words words(record_words<Region>(config));
    EXPECT_NO_THROW(pack(config, region, words.data()));  // no field overflows
  }
}

TEST(PuRowsModel, AnAlphaIsTheRoundedExponentialAndNothingBelowTheCut) {
  const Config config = test_config();
  const PuAlpha model(config);
  const double chord = std::pow(std::log(2.0) / (1 << config.exp_index_w), 2) / 8;
  const double input = std::log(2.0) * std::ldexp(1, -config.exp_f());  // bits of the power that exp2 does not read
  const double bound = 0.5 + std::ldexp(chord + input, config.alpha_w) + 0.0079;
  double worst = 0;
  for (int64_t power = -config.power_cut() - 5000; power <= 5000; power += config.power_f > 16 ? 37 : 1) {
    const double value = std::ldexp(static_cast<double>(std::min<int64_t>(power, 0)), -config.power_f);
    const double exact = std::clamp(std::ldexp(std::exp2(value), config.alpha_w), 1.0, 1.0 * config.alpha_max());
    if (power < -config.power_cut()) {
      ASSERT_LT(std::exp2(value), 1.0 / config.alpha_cut) << "power " << power;
      ASSERT_EQ(model(power), 0u) << "power " << power;
    } else {
      worst = std::max(worst, std::abs(model(power) - exact));
    }
  }
  EXPECT_GE(std::exp2(std::ldexp(-config.power_cut(), -config.power_f)), 1.0 / config.alpha_cut);
  std::printf("pu_alpha: error at most %.4f codes, bound %.4f\n", worst, bound);
  EXPECT_LE(worst, bound);
}

TEST(PuRowsModel, AlphasAreThoseOfEq1) {
  const Config config = test_config();
  const PuRows model(config);
  std::mt19937_64 rng(test_seed());
  // 81 ulp of the power (pu_row_unit.hpp), the chord of exp2 and the power bits it does not read, its table, rounding.
  const double power_bound = std::ldexp(81, -config.power_f);
  const double chord = std::pow(std::log(2.0) / (1 << config.exp_index_w), 2) / 8;
  const double relative = std::log(2.0) * (power_bound + std::ldexp(1, -config.exp_f())) + chord;
  const double bound = 0.5 + std::ldexp(relative, config.alpha_w) + 0.0079;
  double worst = 0, worst_power = 0;
  uint64_t visible = 0, flipped = 0;
  for (int i = 0; i < 30000; ++i) {
    const RowJob job = gaussian_row_job(config, rng);
    const int r = static_cast<int>(rng() % static_cast<uint64_t>(config.regions()));
    uint16_t codes[64];
    pu_region_line(model, job, r, codes);
    const Region region = pu_region(config, job, r);
    for (int pixel = 0; pixel < 64; ++pixel) {
      const int x = 8 * (r % config.part_regions_x()) + pixel % 8, y = 8 * (r / config.part_regions_x()) + pixel / 8;
      const int64_t exact = job.a + job.b * x + job.c * y + job.d * x * x + job.e * y * y + job.f * x * y;
      const double power = std::ldexp(static_cast<double>(exact), -config.coeff_f);
      Row row = pu_row_init(region, pixel / 8);
      for (int dx = 0; dx < pixel % 8; ++dx) row = pu_row_unit(row, region.curve_x);
      worst_power =
          std::max(worst_power, std::abs(std::ldexp(static_cast<double>(row.power), -config.power_f) - power));
      const bool counts = power >= -std::log2(config.alpha_cut);
      visible += counts;
      if (counts != (codes[pixel] != 0)) {  // only where the power is within its error of the cut
        ++flipped;
        ASSERT_LE(std::abs(power + std::log2(config.alpha_cut)), power_bound + std::ldexp(1, -config.power_f));
        continue;
      }
      if (!counts) continue;
      const double alpha =
          std::clamp(std::ldexp(std::exp2(std::min(power, 0.0)), config.alpha_w), 1.0, 1.0 * config.alpha_max());
      worst = std::max(worst, std::abs(codes[pixel] - alpha));
    }
  }
  std::printf(
      "pu_rows: %llu visible pixels, alpha error at most %.4f codes (bound %.4f), power error %.2f ulp of PowerF "
      "(bound 81), %llu decisions at the cut flipped\n",
      static_cast<unsigned long long>(visible), worst, bound, std::ldexp(worst_power, config.power_f),
      static_cast<unsigned long long>(flipped));
  EXPECT_LE(worst, bound);
  EXPECT_LE(worst_power, power_bound);
}

}  // namespace
}  // namespace pipegs
