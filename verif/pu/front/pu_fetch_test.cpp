// SPDX-License-Identifier: Apache-2.0
// pu_fetch_test: rtl/pu/front/pu_fetch.sv against a queue of chunks and the packed memory.
#include <string_view>
#include <type_traits>

#include "Vpu_fetch.h"
#include "cpp_model/golden.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

constexpr int kSlots = 400;

constexpr bool kCoded = std::string_view(PIPEGS_SET).find("record=48") != std::string_view::npos;
using Item = std::conditional_t<kCoded, GaussianCode, GaussianRecord>;  // in memory
using Sent = std::conditional_t<kCoded, Coded, Fetched>;

// The beat of an item, or of an end.
[[maybe_unused]] Coded sent(const Chunk& chunk, const GaussianCode& code, uint64_t slot) {
  return {.kind = kData,
          .window_x = chunk.window_x,
          .window_y = chunk.window_y,
          .walk = chunk.walk,
          .origin_x = chunk.origin_x,
          .origin_y = chunk.origin_y,
          .origin_z = chunk.origin_z,
          .view_exp = chunk.view_exp,
          .offset_exp = chunk.offset_exp,
          .scale_exp = chunk.scale_exp,
          .code = code,
          .slot = slot};
}
[[maybe_unused]] Fetched sent(const Chunk& chunk, const GaussianRecord& record, uint64_t slot) {
  return golden_fetched(chunk, record, slot);
}

// A memory with kSlots random Gaussians from line `first` on, and what the module must send for a chunk.
struct World {
  Config config = test_config();
  std::vector<Item> gaussians;
  uint64_t first = 1000;

  template <class Rng>
  World(Rng& rng, ExternalMemory& memory) {
    const int per_line = config.gaussians_per_line();
    for (int i = 0; i < kSlots; ++i) {
      gaussians.push_back(random_record<Item>(config, rng));
      pack(config, gaussians.back(),
           memory.line(first + static_cast<uint64_t>(i / per_line)).data() + i % per_line * (16 / per_line));
    }
  }

  void expect(const Chunk& chunk, std::vector<Sent>& beats) const {
    if (chunk.kind != kData) {
      beats.push_back(sent(chunk, Item{}, 0));
      beats.back().kind = chunk.kind;
      return;
    }
    for (uint64_t slot = chunk.slot; slot < chunk.slot + chunk.count; ++slot)
      beats.push_back(sent(chunk, gaussians.at(slot), slot));
  }
};

template <class Rng>
Chunk random_chunk(const Config& config, Rng& rng) {
  Chunk chunk = random_record<Chunk>(config, rng);
  chunk.kind = rng() % 5 == 0 ? 1 + rng() % 3 : kData;
  chunk.count = 1 + rng() % static_cast<uint64_t>(config.chunk);
  const auto per_line = static_cast<uint64_t>(std::max(2, config.gaussians_per_line()));
  chunk.slot = rng() % (static_cast<uint64_t>(kSlots - config.chunk) / per_line) * per_line;
  return chunk;
}

// The module between its chunks, a sink and the memory, out of reset.
struct Fetch {
  explicit Fetch(const ExternalMemoryOptions& options, Pace source = Pace::kAlways, Pace sink = Pace::kAlways,
                 Pace memory_pace = Pace::kAlways)
      : memory(options),
        in(bench, config, dut.chunk_valid_i, dut.chunk_ready_o, dut.chunk_i, source),
        out(bench, config, dut.fetched_valid_o, dut.fetched_ready_i, dut.fetched_o, sink),
        port(bench, memory, dut.mem_valid_o, dut.mem_ready_i, nullptr, dut.mem_address_o, nullptr, dut.rsp_valid_i,
             dut.rsp_data_i, memory_pace, &dut.mem_lines_o) {
    write_record(config, dut.gaussians_i, Span{world.first, 1000});
    bench.reset();
  }
  void push_full_chunks(uint64_t apart) {
    for (uint64_t i = 0; i < 20; ++i) in.push({.slot = apart * i, .count = static_cast<uint64_t>(config.chunk)});
  }
  Bench<Vpu_fetch> bench;
  Vpu_fetch& dut = bench.dut;
  ExternalMemory memory;
  const World world{bench.rng, memory};
  const Config& config = world.config;
  RecordSource<Chunk, decltype(dut.chunk_i)> in;
  RecordSink<Sent, decltype(dut.fetched_o)> out;
  MemoryEndpoint<QData, VlWide<16>> port;
};

TEST(PuFetch, SendsEveryGaussianInOrderAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) {
      for (const Pace memory : kPaces) {
        Fetch fetch({.latency = 20, .jitter = 30}, source, sink, memory);
        std::vector<Sent> expected;
        for (int i = 0; i < 40; ++i) {
          const Chunk chunk = random_chunk(fetch.config, fetch.bench.rng);
          fetch.world.expect(chunk, expected);
          fetch.in.push(chunk);
        }
        ASSERT_TRUE(fetch.bench.run_until([&] { return fetch.out.size() == expected.size(); }));
        for (size_t i = 0; i < expected.size(); ++i) {
          ASSERT_EQ(first_difference(fetch.config, expected[i], fetch.out.at(i)), "")
              << "beat " << i << " at cycle " << fetch.out.cycles[i];
        }
        for (int i = 0; i < 200; ++i) fetch.bench.step();
        EXPECT_EQ(fetch.out.size(), expected.size()) << "a beat too many";
        EXPECT_EQ(fetch.dut.idle_o, 1);
      }
    }
  }
}

TEST(PuFetch, KeepsItsPrefetchWithinTheBufferWhileTheSinkStands) {
  Fetch fetch({.latency = 5});
  const Beside stands(
      fetch.bench, [] {}, [&] { fetch.dut.fetched_ready_i = 0; });
  fetch.push_full_chunks(0);
  for (int i = 0; i < 500; ++i) fetch.bench.step();
  // All lines of the buffer and one in its output register, or those of all chunks that it may ask for.
  const Config& config = fetch.config;
  const int lines =
      std::min(config.geometry_lines(), config.geometry_jobs() * config.chunk / config.gaussians_per_line());
  EXPECT_LE(fetch.port.requested, static_cast<uint64_t>(lines) + 1);
  EXPECT_GE(fetch.port.requested, static_cast<uint64_t>(lines));
}

TEST(PuFetch, SendsOneGaussianPerCycleBehindALongLatency) {
  Fetch fetch({.latency = 24, .bytes_per_cycle = 64});
  fetch.push_full_chunks(4);
  const size_t beats = 20 * static_cast<size_t>(fetch.config.chunk);
  ASSERT_TRUE(fetch.bench.run_until([&] { return fetch.out.size() == beats; }));
  EXPECT_EQ(fetch.out.cycles.back() - fetch.out.cycles.front(), beats - 1);
}

}  // namespace
}  // namespace pipegs
