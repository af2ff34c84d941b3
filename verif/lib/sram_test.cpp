// SPDX-License-Identifier: Apache-2.0
// sram_test: rtl/lib/pipegs_sram.sv against an array that knows which words it promises; with one port, too.
#include <optional>
#include <set>

#include "verif/support/bench.hpp"
#include "Vpipegs_sram.h"

namespace pipegs {
namespace {

constexpr uint32_t kDepth = 64;  // the module's default
#ifdef PIPEGS_ONE_PORT
constexpr bool kOnePort = true;
#else
constexpr bool kOnePort = false;
#endif

// The module with what it promises to show, and what it showed where it promises nothing.
struct Memory {
  explicit Memory(uint64_t seed = test_seed()) : bench(seed) { bench.dut.write_i = bench.dut.read_i = 0; }

  void step() {
    Vpipegs_sram& dut = bench.dut;
    dut.clk_i = 0, dut.eval(), dut.clk_i = 1, dut.eval();
    const bool collides = dut.read_i && dut.write_i && dut.raddr_i == dut.waddr_i;
    if (dut.read_i) shown = collides ? std::nullopt : words[dut.raddr_i];
    if (collides) {
      collisions.push_back(dut.rdata_o);
      shows_old += dut.rdata_o == words[dut.raddr_i];
      shows_new += dut.rdata_o == dut.wdata_i;
      shown = dut.rdata_o;  // it holds that, too
    }
    if (dut.write_i) words[dut.waddr_i] = dut.wdata_i;
  }
  void access() {
    Vpipegs_sram& dut = bench.dut;
    dut.write_i = bench.rng() % 2;
    dut.read_i = bench.rng() % 2 && !(kOnePort && dut.write_i);
    dut.waddr_i = bench.rng() % kDepth;
    dut.raddr_i = bench.rng() % 4 == 0 ? dut.waddr_i : static_cast<CData>(bench.rng() % kDepth);
    dut.wdata_i = static_cast<uint32_t>(bench.rng());
    step();
  }

  Bench<Vpipegs_sram> bench;
  std::vector<std::optional<uint32_t>> words = std::vector<std::optional<uint32_t>>(kDepth);  // that were written
  std::optional<uint32_t> shown;
  std::vector<uint32_t> collisions;
  int shows_old = 0, shows_new = 0;
};

TEST(Sram, ReadsWhatWasWrittenAndHoldsIt) {
  Memory memory;
  for (int i = 0; i < 5000; ++i) {
    memory.access();
    if (memory.shown) { ASSERT_EQ(memory.bench.dut.rdata_o, *memory.shown) << "access " << i; }
  }
}

TEST(Sram, SaysSoWhenOnePortReadsAndWrites) {
  for (const CData word : {5, 6}) {  // the one that is written, another one
    Memory memory;
    for (int i = 0; i < 100; ++i) memory.access();
    memory.bench.dut.read_i = memory.bench.dut.write_i = 1;
    memory.bench.dut.waddr_i = 5, memory.bench.dut.raddr_i = word;
    if (kOnePort) EXPECT_THROW(memory.step(), std::runtime_error);
    else EXPECT_NO_THROW(memory.step());
  }
}

TEST(Sram, ShowsNeitherTheOldNorTheNewWordOnACollisionButOthersEachTime) {
  if (kOnePort) return;
  Memory memory;
  for (int i = 0; i < 5000; ++i) memory.access();
  ASSERT_GT(memory.collisions.size(), 200u);
  EXPECT_EQ(memory.shows_old, 0);
  EXPECT_EQ(memory.shows_new, 0);
  const std::set<uint32_t> distinct(memory.collisions.begin(), memory.collisions.end());
  EXPECT_EQ(distinct.size(), memory.collisions.size());
  uint32_t ones = 0, all = ~0u;
  for (const uint32_t word : distinct) ones |= word, all &= word;
  EXPECT_EQ(ones, ~0u);
  EXPECT_EQ(all, 0u);
}

TEST(Sram, ShowsTheSameAgainWithTheSameSeedAndOtherDataWithAnother) {
  if (kOnePort) return;
  const auto shown = [](uint64_t seed) {
    Memory memory(seed);
    std::vector<uint32_t> result;
    memory.bench.dut.read_i = 1;
    for (uint32_t i = 0; i < 2 * kDepth; ++i) {  // words that were never written, then each while it is written
      memory.bench.dut.write_i = i >= kDepth;
      memory.bench.dut.raddr_i = memory.bench.dut.waddr_i = i % kDepth;
      memory.step();
      result.push_back(memory.bench.dut.rdata_o);
    }
    return result;
  };
  const std::vector<uint32_t> first = shown(1);
  EXPECT_EQ(shown(1), first);
  EXPECT_EQ(std::set<uint32_t>(first.begin(), first.end()).size(), 2 * kDepth);
  const std::vector<uint32_t> other = shown(2);
  for (uint32_t i = 0; i < 2 * kDepth; ++i) EXPECT_NE(other[i], first[i]) << "read " << i;
}

}  // namespace
}  // namespace pipegs
