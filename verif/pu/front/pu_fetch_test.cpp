// SPDX-License-Identifier: Apache-2.0
// pu_fetch_test: rtl/pu/front/pu_fetch.sv against a queue of chunks and the packed memory.
#include "Vpu_fetch.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

using Memory = MemoryEndpoint<QData, VlWide<16>>;

// A memory with `slots` random Gaussians from line `first` on, and what the module must send for a chunk.
struct World {
  Config config = test_config();
  std::vector<GaussianRecord> gaussians;
  uint64_t first = 1000;

  template <class Rng>
  World(Rng& rng, int slots, ExternalMemory& memory) {
    const int per_line = config.gaussians_per_line();
    for (int i = 0; i < slots; ++i) {
      gaussians.push_back(random_record<GaussianRecord>(config, rng));
      pack(config, gaussians.back(),
           memory.line(first + static_cast<uint64_t>(i / per_line)).data() + i % per_line * 8);
    }
  }

  void expect(const Chunk& chunk, std::vector<Fetched>& beats) const {
    for (uint64_t i = 0; i < (chunk.kind == kData ? chunk.count : 1); ++i) {
      Fetched f;
      f.kind = chunk.kind;
      f.window_x = chunk.window_x;
      f.window_y = chunk.window_y;
      f.origin_x = chunk.origin_x;
      f.origin_y = chunk.origin_y;
      f.origin_z = chunk.origin_z;
      f.view_exp = chunk.view_exp;
      f.offset_exp = chunk.offset_exp;
      if (chunk.kind == kData) {
        f.slot = chunk.slot + i;
        const GaussianRecord& g = gaussians.at(f.slot);
        f.offset_x = g.offset_x, f.offset_y = g.offset_y, f.offset_z = g.offset_z;
        f.qw = g.qw, f.qx = g.qx, f.qy = g.qy, f.qz = g.qz;
        f.scale_0 = g.scale_0, f.scale_1 = g.scale_1, f.scale_2 = g.scale_2;
        f.opacity = g.opacity, f.base_r = g.base_r, f.base_g = g.base_g, f.base_b = g.base_b, f.index = g.index;
      }
      beats.push_back(f);
    }
  }
};

template <class Rng>
Chunk random_chunk(const Config& config, Rng& rng, int slots) {
  Chunk chunk = random_record<Chunk>(config, rng);
  chunk.kind = rng() % 5 == 0 ? 1 + rng() % 2 : kData;
  chunk.count = 1 + rng() % static_cast<uint64_t>(config.chunk);
  chunk.slot = rng() % static_cast<uint64_t>((slots - config.chunk) / 2) * 2;
  return chunk;
}

void run(Pace source_pace, Pace sink_pace, Pace memory_pace, const ExternalMemoryOptions& options, int chunks) {
  Bench<Vpu_fetch> bench;
  auto& dut = bench.dut;
  ExternalMemory memory(options);
  const int slots = 400;
  const World world(bench.rng, slots, memory);
  const Config& config = world.config;
  RecordSource<Chunk, decltype(dut.chunk_i)> in(bench, config, dut.chunk_valid_i, dut.chunk_ready_o, dut.chunk_i,
                                                source_pace);
  RecordSink<Fetched, decltype(dut.fetched_o)> out(bench, config, dut.fetched_valid_o, dut.fetched_ready_i,
                                                   dut.fetched_o, sink_pace);
  Memory port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr, dut.mem_address_o, nullptr, dut.rsp_valid_i,
              dut.rsp_data_i, memory_pace, &dut.mem_lines_o);
  write_record(config, dut.gaussians_i, Span{world.first, 1000});
  bench.reset();
  std::vector<Fetched> expected;
  for (int i = 0; i < chunks; ++i) {
    const Chunk chunk = random_chunk(config, bench.rng, slots);
    world.expect(chunk, expected);
    in.push(chunk);
  }
  ASSERT_TRUE(bench.run_until([&] { return out.size() == expected.size(); }));
  for (size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(first_difference(config, expected[i], out.at(i)), "") << "beat " << i << " at cycle " << out.cycles[i];
  }
  for (int i = 0; i < 200; ++i) bench.step();
  EXPECT_EQ(out.size(), expected.size()) << "a beat too many";
  EXPECT_EQ(dut.idle_o, 1);
}

TEST(PuFetch, SendsEveryGaussianInOrderAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      for (const Pace memory : kPaces) run(source, sink, memory, {.latency = 20, .jitter = 30}, 40);
    }
  }
}

TEST(PuFetch, KeepsItsPrefetchWithinTheBufferWhileTheSinkStands) {
  Bench<Vpu_fetch> bench;
  auto& dut = bench.dut;
  ExternalMemory memory({.latency = 5});
  const World world(bench.rng, 400, memory);
  RecordSource<Chunk, decltype(dut.chunk_i)> in(bench, world.config, dut.chunk_valid_i, dut.chunk_ready_o, dut.chunk_i);
  Memory port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr, dut.mem_address_o, nullptr, dut.rsp_valid_i,
              dut.rsp_data_i, Pace::kAlways, &dut.mem_lines_o);
  dut.fetched_ready_i = 0;
  bench.reset();
  for (int i = 0; i < 20; ++i) {
    Chunk chunk;
    chunk.count = static_cast<uint64_t>(world.config.chunk);
    in.push(chunk);
  }
  for (int i = 0; i < 500; ++i) bench.step();
  EXPECT_LE(port.requested, 65u);  // 64 lines in the buffer, one in its output register
  EXPECT_GE(port.requested, 64u);
}

TEST(PuFetch, SendsOneGaussianPerCycleBehindALongLatency) {
  Bench<Vpu_fetch> bench;
  auto& dut = bench.dut;
  ExternalMemory memory({.latency = 24, .bytes_per_cycle = 64});
  const World world(bench.rng, 400, memory);
  RecordSource<Chunk, decltype(dut.chunk_i)> in(bench, world.config, dut.chunk_valid_i, dut.chunk_ready_o, dut.chunk_i);
  RecordSink<Fetched, decltype(dut.fetched_o)> out(bench, world.config, dut.fetched_valid_o, dut.fetched_ready_i,
                                                   dut.fetched_o);
  Memory port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr, dut.mem_address_o, nullptr, dut.rsp_valid_i,
              dut.rsp_data_i, Pace::kAlways, &dut.mem_lines_o);
  write_record(world.config, dut.gaussians_i, Span{world.first, 1000});
  bench.reset();
  const size_t beats = 20 * static_cast<size_t>(world.config.chunk);
  for (int i = 0; i < 20; ++i) {
    Chunk chunk;
    chunk.slot = static_cast<uint64_t>(4 * i);
    chunk.count = static_cast<uint64_t>(world.config.chunk);
    in.push(chunk);
  }
  ASSERT_TRUE(bench.run_until([&] { return out.size() == beats; }));
  EXPECT_EQ(out.cycles.back() - out.cycles.front(), beats - 1);
}

}  // namespace
}  // namespace pipegs
