// SPDX-License-Identifier: Apache-2.0
// pu_region_test: rtl/pu/rows/pu_region.sv against its bit-accurate model, and the model against 128-bit
// integers.
#include "cpp_model/pu/rows/pu_region.hpp"
#include "verif/pu/rows/random_row_job.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_region.h"

namespace pipegs {
namespace {

struct RegionBench {
  Config config = test_config();
  Bench<Vpu_region> bench;
  RecordSource<RowJob, decltype(bench.dut.row_job_i)> in{bench, config, bench.dut.row_job_valid_i,
                                                         bench.dut.row_job_ready_o, bench.dut.row_job_i};
  RecordSink<Region, decltype(bench.dut.region_o)> out{bench, config, bench.dut.region_valid_o,
                                                       bench.dut.region_ready_i, bench.dut.region_o};
  std::vector<Region> expected;

  void push(const RowJob& job) {
    in.push(job);
    if (job.kind != kData) {
      expected.push_back({.kind = job.kind});
      return;
    }
    for (int r = 0; r < config.regions(); ++r) {
      if ((job.mask >> r) & 1) expected.push_back(pu_region(config, job, r));
    }
  }
  void run_and_compare() {
    bench.reset();
    bench.run_until([&] { return out.size() >= expected.size(); }, 400000);
    for (size_t i = 0; i < std::min(out.size(), expected.size()); ++i) {
      const Region found = out.at(i);
      if (expected[i].kind != kData) {
        ASSERT_EQ(found.kind, expected[i].kind) << "region " << i;
      } else {
        ASSERT_EQ(first_difference(config, expected[i], found), "") << "region " << i << " in cycle " << out.cycles[i];
      }
    }
  }
};

TEST(PuRegion, EqualsItsModelAtEveryPairOfPaces) {
  for (Pace source : kPaces) {
    for (Pace sink : kPaces) {
      RegionBench s;
      s.in.pace = source, s.out.pace = sink;
      for (int i = 0; i < 200; ++i) s.push(random_row_job(s.config, s.bench.rng));
      s.run_and_compare();
      if (HasFailure()) { FAIL() << "source " << to_text(source) << ", sink " << to_text(sink); }
    }
  }
}

TEST(PuRegion, GivesOneRegionPerFourCyclesAcrossJobs) {
  RegionBench s;
  for (int i = 0; i < 100; ++i) {
    RowJob job = gaussian_row_job(s.config, s.bench.rng);
    if (i % 2 == 0) job.mask = 1;
    s.push(job);
  }
  s.run_and_compare();
  ASSERT_GT(s.out.size(), 100u);
  EXPECT_EQ(s.out.cycles.back() - s.out.cycles.front(), 4 * (s.out.size() - 1));
}

TEST(PuRegion, ModelIsExactUntilItsOneRounding) {
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

}  // namespace
}  // namespace pipegs
