// SPDX-License-Identifier: Apache-2.0
// pu_lines_test: rtl/pu/rows/pu_lines.sv against its bit-accurate model: lines are counted, both outputs get every
// record, the end waits.
#include "cpp_model/pu/rows/pu_lines.hpp"

#include "Vpu_lines.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

Tiles random_tiles(const Config& config, std::mt19937_64& rng) {
  Tiles t = random_record<Tiles>(config, rng);
  t.kind = kData;
  for (uint64_t thin = rng() % 4; thin > 0; --thin) t.mask &= rng();
  if (t.mask == 0) t.mask = 1;
  return t;
}

void run(Pace source_pace, Pace rows_pace, Pace splat_pace, bool check_pace) {
  const Config config = test_config();
  Bench<Vpu_lines> bench;
  auto& dut = bench.dut;
  dut.unit_i = 2;
  dut.restart_i = dut.rows_end_i = 0;
  RecordSource<Tiles, std::remove_reference_t<decltype(dut.tiles_i)>> in(bench, config, dut.tiles_valid_i,
                                                                         dut.tiles_ready_o, dut.tiles_i, source_pace);
  RecordSink<RowJob, std::remove_reference_t<decltype(dut.row_job_o)>> jobs(
      bench, config, dut.row_job_valid_o, dut.row_job_ready_i, dut.row_job_o, rows_pace);
  RecordSink<Splat, std::remove_reference_t<decltype(dut.splat_o)>> splats(bench, config, dut.splat_valid_o,
                                                                           dut.splat_ready_i, dut.splat_o, splat_pace);
  std::vector<uint64_t> numbers;  // of the windows, beside the splats
  std::deque<Listed> listings;    // beside the tiles that are shown
  const Beside beside(
      bench,
      [&] {
        if (dut.splat_valid_o && dut.splat_ready_i) numbers.push_back(dut.window_o);
        if (dut.tiles_valid_i && dut.tiles_ready_o) listings.pop_front();
      },
      [&] {
        if (!listings.empty()) write_record(config, dut.listed_i, listings.front());
      });
  bench.reset();
  size_t seen = 0;
  for (int frame = 0; frame < 3; ++frame) {
    dut.restart_i = 1;
    bench.step();
    dut.restart_i = 0;
    PuLines model(config, 2);
    std::vector<PuLines::Out> expected;
    const uint64_t start = bench.cycle;
    const int records = 400;
    for (int i = 0; i < records; ++i) {
      const Tiles t = random_tiles(config, bench.rng);
      const auto listed = random_record<Listed>(config, bench.rng);
      in.push(t);
      listings.push_back(listed);
      expected.push_back(model(t, listed));
    }
    Tiles end;
    end.kind = kWindowEnd;
    in.push(end);
    listings.push_back({});
    expected.push_back(model(end, {}));
    ASSERT_TRUE(bench.run_until(
        [&] { return jobs.size() == seen + expected.size() && splats.size() + 1 == seen + expected.size(); }));
    if (check_pace) { EXPECT_LE(bench.cycle - start, 3u * records + 10); }
    for (int i = 0; i < 30; ++i) bench.step();
    ASSERT_EQ(splats.size() + 1, seen + expected.size()) << "the end passed before the rows had ended";
    dut.rows_end_i = 1;
    bench.step();
    dut.rows_end_i = 0;
    ASSERT_TRUE(bench.run_until([&] { return splats.size() == seen + expected.size(); }));
    for (size_t i = 0; i < expected.size(); ++i) {
      ASSERT_EQ(first_difference(config, expected[i].row_job, jobs.at(seen + i)), "")
          << "row job " << i << ", frame " << frame << ", seed " << bench.seed;
      ASSERT_EQ(first_difference(config, expected[i].splat, splats.at(seen + i)), "")
          << "splat " << i << ", frame " << frame << ", seed " << bench.seed;
      if (expected[i].splat.kind == kData) { ASSERT_EQ(expected[i].number, numbers.at(seen + i)); }
    }
    seen += expected.size();
    bench.step();
    EXPECT_EQ(dut.busy_o, 0);
  }
}

TEST(PuLines, EqualsItsModelAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace rows : kPaces) {
      for (const Pace splats : kPaces) run(source, rows, splats, false);
    }
  }
}

TEST(PuLines, TakesARecordInThreeCycles) { run(Pace::kAlways, Pace::kAlways, Pace::kAlways, true); }

}  // namespace
}  // namespace pipegs
