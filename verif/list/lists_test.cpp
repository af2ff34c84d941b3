// SPDX-License-Identifier: Apache-2.0
// lists_test: rtl/list/pipegs_lists.sv whole, before a memory: what the PUs give comes to the SUs, window by window,
// not before all is written.
#include "Vpipegs_lists.h"
#include "verif/list/list_bench.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

using LinePort = std::remove_reference_t<decltype(Vpipegs_lists::rsp_data_i)>;

struct ListsRun {
  using Dut = Vpipegs_lists;
  explicit ListsRun(const ExternalMemoryOptions& options)
      : memory(options),
        pus(bench, config, bench.dut.made_valid_i, bench.dut.made_ready_o, bench.dut.made_i, bench.dut.number_i),
        port(bench, memory, bench.dut.mem_valid_o, bench.dut.mem_ready_i, &bench.dut.mem_write_o,
             bench.dut.mem_address_o, &bench.dut.mem_data_o, bench.dut.rsp_valid_i, bench.dut.rsp_data_i, Pace::kAlways,
             &bench.dut.mem_lines_o),
        sus(bench, config, bench.dut.splat_valid_o, bench.dut.splat_ready_i, bench.dut.splat_room_i,
            bench.dut.splat_o) {
    bench.dut.restart_i = 0;
    write_frame(config, bench.dut, Frame{});
    bench.reset();
  }
  void frame(uint64_t columns, uint64_t rows, size_t count) {
    auto& dut = bench.dut;
    write_frame(config, dut, list_frame(config, bench.rng, columns, rows));
    sus.clear();
    dut.restart_i = 1;
    bench.gated_step();
    dut.restart_i = 0;
    ListRecords records;
    records.add(config, bench.rng, columns * rows, count);
    pus.offer(records);
    uint64_t written = 0;
    const uint64_t reads = memory.traffic()[0].lines_read;
    ASSERT_TRUE(bench.run_gated_until(
        [&] {
          written += dut.written_o;
          if (written == 0) {
            EXPECT_EQ(memory.traffic()[0].lines_read, reads)
                << "a list is read before all are written, cycle " << bench.cycle;
          }
          return sus.ended(columns * rows);
        },
        200 * (count + columns * rows) + 10000));
    for (int i = 0; i < 20; ++i) bench.gated_step();
    EXPECT_EQ(written, 1u);
    EXPECT_EQ(dut.busy_o, 0);
    size_t found = 0;
    for (uint64_t w = 0; w < columns * rows; ++w) {
      for (const Splat& splat : sus.entries[w]) {
        ASSERT_LT(splat.index, count);
        ASSERT_EQ(records.numbers[splat.index], w) << "record " << splat.index << ", seed " << bench.seed;
        ASSERT_EQ(first_difference(config, records.splats[splat.index], splat), "")
            << "record " << splat.index << ", seed " << bench.seed;
        ++found;
      }
    }
    ASSERT_EQ(found, count);
  }
  Config config = test_config();
  GatedBench<Dut> bench;
  ExternalMemory memory;
  ListPus<Dut, CData, std::remove_reference_t<decltype(Dut::made_i)>, std::remove_reference_t<decltype(Dut::number_i)>>
      pus;
  MemoryEndpoint<QData, LinePort> port;
  ListSus<CData, std::remove_reference_t<decltype(Dut::splat_o)>> sus;
};

TEST(Lists, BringEveryRecordToItsWindowAtEveryPace) {
  for (const Pace pus : kPaces) {
    for (const Pace memory_pace : kPaces) {
      for (const Pace sus : kPaces) {
        ListsRun run({.latency = 50, .jitter = 40});
        run.pus.pace = pus;
        run.port.pace = memory_pace;
        run.sus.pace = sus;
        run.frame(4, 6, 1000);
        run.frame(1, 1, 100);
        run.frame(5, 1, 0);
        run.frame(16, 9, 400);
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
