// SPDX-License-Identifier: Apache-2.0
// su_range_test: rtl/su/su_range.sv against su_bucket_range, and that range against su_bucket.
#include "Vsu_range.h"
#include "cpp_model/su/su.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(SuRange, KeysOfEveryBucket) {
  const Config config = test_config();
  const int index_w = config.key_w() - config.depth_w;
  const uint64_t depths = uint64_t{1} << config.depth_w;
  Vsu_range dut;
  for (const int octave : {0, 1, 17, 40, 48}) {
    const int begin = config.has_watermarks() ? octave : 0;
    for (uint64_t bucket = 0; bucket < uint64_t{1} << config.bucket_w(); ++bucket) {
      dut.octave_i = static_cast<CData>(octave);
      dut.bucket_i = static_cast<decltype(+dut.bucket_i)>(bucket);
      dut.eval();
      const auto [low, high] = su_bucket_range(config, bucket, begin);
      ASSERT_EQ(dut.min_o, low << index_w) << "bucket " << bucket << ", octave " << octave;
      ASSERT_EQ(dut.max_o, ((high + 1) << index_w) - 1) << "bucket " << bucket << ", octave " << octave;
      for (const uint64_t depth : {low, high}) ASSERT_EQ(su_bucket(config, depth, begin), bucket);
      if (low > 0) ASSERT_LT(su_bucket(config, low - 1, begin), bucket);
      if (high + 1 < depths) ASSERT_GT(su_bucket(config, high + 1, begin), bucket);
    }
  }
}

}  // namespace
}  // namespace pipegs
