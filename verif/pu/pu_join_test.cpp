// SPDX-License-Identifier: Apache-2.0
// pu_join_test: rtl/pu/pu_join.sv: splats pass in order; an end passes only when the rows' path has ended that layer.
#include "Vpu_join.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(PuJoin, PassesEverySplatInOrderAndAnEndOnlyBehindTheRowsEnd) {
  const Config config = test_config();
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Vpu_join> bench;
      bench.dut.rows_end_valid_i = 0;
      RecordSource<Splat, decltype(bench.dut.colored_i)> in(
          bench, config, bench.dut.colored_valid_i, bench.dut.colored_ready_o, bench.dut.colored_i, source_pace);
      RecordSink<Splat, decltype(bench.dut.splat_o)> out(bench, config, bench.dut.splat_valid_o,
                                                         bench.dut.splat_ready_i, bench.dut.splat_o, sink_pace);
      bench.reset();
      std::vector<Splat> sent;
      size_t ends_sent = 0;
      for (int i = 0; i < 400; ++i) {
        sent.push_back(random_record<Splat>(config, bench.rng));
        sent.back().kind = bench.rng() % 5 == 0 ? kLayerEnd : kData;
        ends_sent += sent.back().kind != kData;
        in.push(sent.back());
      }
      size_t rows_ends = 0, ends_out = 0, looked = 0, most = 0;
      const auto ahead = static_cast<size_t>(config.alpha_layers);
      const uint64_t rows_one_in = sink_pace == Pace::kQuarter ? 1 : 20;
      const bool complete = bench.run_until([&] {
        while (looked < out.size()) ends_out += out.at(looked++).kind != kData;
        EXPECT_LE(ends_out, rows_ends);
        // The rows end at their own time, at most as many layers ahead of the colours as live.
        bench.dut.rows_end_valid_i =
            rows_ends < ends_sent && rows_ends < ends_out + ahead && bench.rng() % rows_one_in == 0;
        rows_ends += bench.dut.rows_end_valid_i;
        most = std::max(most, rows_ends - ends_out);
        return out.size() == sent.size();
      });
      ASSERT_TRUE(complete);
      if (rows_one_in == 1) EXPECT_EQ(most, ahead);
      for (size_t i = 0; i < sent.size(); ++i) ASSERT_EQ(out.at(i), sent[i]) << "beat " << i;
    }
  }
}

}  // namespace
}  // namespace pipegs
