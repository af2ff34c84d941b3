// SPDX-License-Identifier: Apache-2.0
// su_bucket_test: rtl/su/su_bucket.sv against su_bucket.
#include "Vsu_bucket.h"
#include "cpp_model/su/su.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

// Every octave; depths before it, at the borders of its buckets, and behind the last one.
TEST(SuBucket, DepthsOfAllOctaves) {
  const Config config = test_config();
  const int below = config.depth_w - config.step_w();
  const uint64_t last = (uint64_t{1} << config.depth_w) - 1;
  Vsu_bucket dut;
  std::mt19937_64 rng(test_seed());
  for (int octave = 0; octave < 1 << config.exp_w(); ++octave) {
    dut.octave_i = static_cast<CData>(octave);
    const uint64_t first = static_cast<uint64_t>(octave) << (config.depth_w - config.exp_w()), one = 1;
    std::vector<uint64_t> depths = {0, last, first, first > 0 ? first - 1 : 0};
    for (int i = 0; i < 200; ++i) {
      const uint64_t border = first + ((rng() & ((one << config.bucket_w()) - 1)) << below);
      for (const uint64_t depth : {rng() & last, border, border - 1, border + (one << below) - 1})
        depths.push_back(std::min(depth, last));
    }
    for (const uint64_t depth : depths) {
      dut.depth_i = static_cast<IData>(depth);
      dut.eval();
      ASSERT_EQ(dut.bucket_o, su_bucket(config, depth, config.has_watermarks() ? octave : 0))
          << "depth " << depth << ", octave " << octave;
    }
  }
}

}  // namespace
}  // namespace pipegs
