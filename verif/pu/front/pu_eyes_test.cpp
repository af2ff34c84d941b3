// SPDX-License-Identifier: Apache-2.0
// pu_eyes_test: rtl/pu/front/pu_eyes.sv: each Gaussian is shown once for each eye that is wanted, or for the one of its
// walk, everything else once.
#include "cpp_model/dopu/walk.hpp"
#include "Vpu_eyes.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(PuEyes, ShowEachGaussianToThoseThatAreWanted) {
  const Config config = test_config();
  for (int wanted = 1; wanted <= 3; ++wanted) {
    for (const Pace source_pace : kPaces) {
      for (const Pace sink_pace : kPaces) {
        Bench<Vpu_eyes> bench;
        RecordSource<Fetched, decltype(bench.dut.fetched_i)> source(
            bench, config, bench.dut.fetched_valid_i, bench.dut.fetched_ready_o, bench.dut.fetched_i, source_pace);
        RecordSink<Fetched, decltype(bench.dut.seen_o)> sink(bench, config, bench.dut.seen_valid_o,
                                                             bench.dut.seen_ready_i, bench.dut.seen_o, sink_pace);
        std::vector<int> eyes, expected_eyes;
        const Beside beside(bench, [&] {
          if (bench.dut.seen_valid_o && bench.dut.seen_ready_i) eyes.push_back(bench.dut.eye_o);
        });
        bench.dut.wanted_i = static_cast<CData>(wanted);
        bench.reset();
        std::vector<Fetched> expected;
        for (int i = 0; i < 200; ++i) {
          Fetched in = random_record<Fetched>(config, bench.rng);
          in.kind = bench.rng() % 4 == 0 ? kLayerEnd : kData;
          source.push(in);
          for (int eye = 0; eye < 2; ++eye) {
            const bool one = walk_eye(config, in.walk) != kAllEyes;
            const bool seen = one ? walk_eye(config, in.walk) == eye : (wanted >> eye & 1) != 0;
            if (in.kind == kData ? !seen : eye != 0) continue;
            expected.push_back(in);
            expected_eyes.push_back(eye);
          }
        }
        bench.run_until([&] { return source.empty() && sink.size() >= expected.size(); });
        for (int i = 0; i < 5; ++i) bench.step();
        ASSERT_EQ(sink.size(), expected.size());
        EXPECT_EQ(eyes, expected_eyes) << "seed " << bench.seed;
        for (size_t k = 0; k < expected.size(); ++k) ASSERT_EQ(first_difference(config, expected[k], sink.at(k)), "");
        if (source_pace == Pace::kAlways && sink_pace == Pace::kAlways) {
          EXPECT_EQ(sink.cycles.back() - sink.cycles.front(), expected.size() - 1) << "one in a cycle";
        }
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
