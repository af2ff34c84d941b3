// SPDX-License-Identifier: Apache-2.0
// su_bench.hpp: an SU with a source, a sink and a memory; the tests of all orders share it.
//
// The bench stops the module's clock whenever active_o is low, as the top does: a missing term in active_o hangs a
// test.
#pragma once

#include <algorithm>

#include "Vpipegs_su.h"
#include "cpp_model/su/su.hpp"
#include "cpp_model/su/su_external.hpp"
#include "verif/su/su_keys.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {

inline const Config kConfig = test_config();
inline constexpr uint64_t kOverflow = 0x12345;  // first line of the overflow areas
// In which the buckets of depth begin; random depths lie before, in and behind its 16 octaves.
inline const int kOctave = kConfig.has_watermarks() ? static_cast<int>(test_seed() % 40) : 0;

struct SuBench : Bench<Vpipegs_su> {
  SuBench(Pace source, Pace sink, bool gated, const ExternalMemoryOptions& options = {}, int unit = 1)
      : gated(gated),
        memory(options),
        in(*this, kConfig, dut.in_valid_i, dut.in_ready_o, dut.in_i, source),
        out(*this, kConfig, dut.out_valid_o, dut.out_ready_i, dut.out_o, sink),
        port(*this, memory, dut.mem_valid_o, dut.mem_ready_i, &dut.mem_write_o, dut.mem_address_o, &dut.mem_data_o,
             dut.rsp_valid_i, dut.rsp_data_i, source) {
    Frame frame;
    frame.tables.overflow = kOverflow;
    write_frame(kConfig, dut, frame);
    dut.unit_i = unit;
    dut.octave_i = kOctave;
    reset();
  }
  // One cycle; the module sees the edge only when it asked for it.
  void step() {
    dut.clk_i = 0;
    for (Endpoint* endpoint : endpoints_) endpoint->drive();
    if (blocked) dut.out_ready_i = 0;
    dut.eval();
    for (Endpoint* endpoint : endpoints_) endpoint->observe();
    perf[dut.perf_o] += 1;
    overflowed += dut.overflow_o;
    fetched += dut.mem_valid_o && dut.mem_ready_i && !dut.mem_write_o;
    asleep += !dut.active_o;
    if (dut.active_o || !gated) {
      dut.clk_i = 1;
      dut.eval();
    }
    ++cycle;
  }
  bool run_until_sent(size_t beats, uint64_t limit) {
    for (const uint64_t end = cycle + limit; cycle < end;) {
      if (out.size() >= beats) return true;
      step();
    }
    ADD_FAILURE() << "only " << out.size() << " of " << beats << " beats came, cycle " << cycle << ", seed " << seed;
    return false;
  }
  // Queues a layer; `expected` gets what shall come out.
  void layer(Arrangement arrangement, size_t count, uint64_t kind) {
    std::vector<Splat> splats;
    for (const uint64_t key : su_keys(kConfig, arrangement, count, rng)) {
      Splat splat = random_record<Splat>(kConfig, rng);
      splat.kind = kData;
      splat.depth = key >> kConfig.index_w;
      splat.index = key & ((uint64_t{1} << kConfig.index_w) - 1);
      splats.push_back(splat);
      in.push(splat);
    }
    su_sort(splats);
    expected.insert(expected.end(), splats.begin(), splats.end());
    Splat end;
    end.kind = kind;
    in.push(end);
    expected.push_back(end);
  }
  void check(uint64_t limit) {
    run_until_sent(expected.size(), limit);
    for (size_t i = 0; i < std::min(expected.size(), out.size()); ++i) {
      ASSERT_EQ(first_difference(kConfig, expected[i], out.at(i)), "")
          << "beat " << i << " of " << expected.size() << ", seed " << seed;
    }
    for (int i = 0; i < 300; ++i) step();
    EXPECT_EQ(out.size(), expected.size());
    const uint64_t before = asleep;
    step();
    EXPECT_EQ(asleep, before + 1) << "an empty unit needs no clock";
  }

  bool gated, blocked = false;
  ExternalMemory memory;
  RecordSource<Splat, decltype(dut.in_i)> in;
  RecordSink<Splat, decltype(dut.out_o)> out;
  MemoryEndpoint<QData, VlWide<16>> port;
  std::vector<Splat> expected;
  uint64_t perf[4] = {}, overflowed = 0, fetched = 0, asleep = 0;
};

inline ExternalMemoryOptions memory_options(std::mt19937_64& rng) {
  ExternalMemoryOptions options;
  options.latency = 1 + static_cast<int>(rng() % 120);
  options.jitter = static_cast<int>(rng() % 40);
  options.bytes_per_cycle = rng() % 2 ? 51.2 : 13;
  options.queue = 1 + static_cast<int>(rng() % 64);
  return options;
}

}  // namespace pipegs
