// SPDX-License-Identifier: Apache-2.0
// pu_rows_test: rtl/pu/rows/pu_rows.sv against its bit-accurate model, line by line, and the model against
// Eq. 1 in double.
#include "cpp_model/pu/rows/pu_rows.hpp"
#include "verif/pu/rows/random_row_job.hpp"
#include "verif/support/config.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpu_rows.h"

namespace pipegs {
namespace {

// The line that leaves beside each record.
struct LineWatch : Endpoint {
  LineWatch(BenchBase& bench, Vpu_rows& dut) : dut(dut) { bench.add(*this); }
  void drive() override {}
  void observe() override {
    if (!dut.alphas_valid_o || !dut.alphas_ready_i) return;
    lines.emplace_back(port_words<decltype(dut.line_o)>());
    read_port(dut.line_o, lines.back().data());
  }
  Vpu_rows& dut;
  std::vector<Words> lines;
};

struct RowsBench {
  Config config = test_config();
  PuRows model{config};
  GatedBench<Vpu_rows> bench;
  RecordSource<RowJob, decltype(bench.dut.row_job_i)> in{bench, config, bench.dut.row_job_valid_i,
                                                         bench.dut.row_job_ready_o, bench.dut.row_job_i};
  RecordSink<Alphas, decltype(bench.dut.alphas_o)> out{bench, config, bench.dut.alphas_valid_o,
                                                       bench.dut.alphas_ready_i, bench.dut.alphas_o};
  LineWatch watch{bench, bench.dut};
  std::vector<Alphas> expected;
  std::vector<Words> lines;

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
      watch.lines[i].resize(lines[i].size());
      ASSERT_EQ(watch.lines[i], lines[i]) << "line " << i << " in cycle " << out.cycles[i];
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

TEST(PuRows, AlphasAreThoseOfEq1) {
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
