// SPDX-License-Identifier: Apache-2.0
// su_minmax_test: rtl/su/sort/su_minmax.sv against cpp_model/su/sort/su_minmax.hpp.
#include "cpp_model/su/sort/su_minmax.hpp"

#include "Vsu_minmax.h"
#include "verif/su/su_keys.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(SuMinmax, FindsTheRangeOfEveryArrangement) {
  const Config config = test_config();
  Bench<Vsu_minmax> bench;
  bench.dut.clear_i = bench.dut.valid_i = 0;
  bench.reset();
  for (const Arrangement arrangement : kArrangements) {
    for (const size_t count : {1, 2, 3, 100}) {
      for (const Pace pace : kPaces) {
        const std::vector<uint64_t> keys = su_keys(config, arrangement, count, bench.rng);
        for (size_t i = 0; i < count;) {
          bench.dut.valid_i = goes(pace, bench.rng);
          bench.dut.key_i = bench.dut.valid_i ? keys[i] : bench.rng() & ((uint64_t{1} << config.key_w()) - 1);
          i += bench.dut.valid_i;
          bench.step();
          if (i > 0) {
            const KeyRange expected = su_minmax({keys.data(), i});
            ASSERT_EQ(bench.dut.min_o, expected.min) << to_text(arrangement) << ", key " << i;
            ASSERT_EQ(bench.dut.max_o, expected.max) << to_text(arrangement) << ", key " << i;
          }
        }
        bench.dut.valid_i = 0;
        bench.dut.clear_i = 1;
        bench.step();
        bench.dut.clear_i = 0;
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
