// SPDX-License-Identifier: Apache-2.0
// list_room_test: rtl/list/pipegs_list_room.sv against list_log of cpp_model/areas/areas.hpp.
#include "Vpipegs_list_room.h"
#include "cpp_model/areas/areas.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(ListRoom, IsTheLargestPowerOfTwoThatFitsEveryWindow) {
  const Config config = test_config();
  Bench<Vpipegs_list_room> bench;
  auto& dut = bench.dut;
  dut.restart_i = 0;
  bench.reset();
  for (int round = 0; round < 3000; ++round) {
    const uint64_t windows = 1 + bench.rng() % (round % 3 == 0 ? 4 : uint64_t{1} << config.list_window_w());
    const uint64_t few = list_first(windows, static_cast<int>(bench.rng() % 22));
    const uint64_t lines = round % 2 == 0 ? bench.rng() >> (64 - config.address_w()) >> bench.rng() % 34
                                          : few + bench.rng() % 3 - 1;  // one less than it takes, enough, one more
    dut.windows_i = static_cast<SData>(windows);
    dut.lines_i = lines;
    dut.restart_i = 1;
    bench.step();
    dut.restart_i = 0;
    uint64_t cycles = 0;
    while (!dut.done_o && cycles < 100) bench.step(), ++cycles;
    ASSERT_LE(cycles, static_cast<uint64_t>(config.list_entry_w()) + 1);
    ASSERT_EQ(dut.none_o, !lists_fit(lines, windows)) << windows << " windows, " << lines << " lines";
    ASSERT_EQ(dut.log_o, list_log(config, lines, windows)) << windows << " windows, " << lines << " lines";
  }
}

}  // namespace
}  // namespace pipegs
