// SPDX-License-Identifier: Apache-2.0
// alpha_store_test: rtl/buf/pipegs_alpha_store.sv against an array.
#include <map>
#include <set>

#include "verif/support/config.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpipegs_alpha_store.h"

namespace pipegs {
namespace {

// All ports of the store: the PU, which writes while slots and addresses are left, and one reader per unit that holds
// its request until it is granted. Each line is read or skipped once, in any order.
struct Traffic : Endpoint {
  Traffic(BenchBase& bench, Vpipegs_alpha_store& dut, const Config& config)
      : bench(bench), dut(dut), config(config), asked(config.units), taken(config.units) {
    bench.add(*this);
  }
  void drive() override {
    // A slot that is free in one cycle may be taken three cycles later: the Row Units stand between.
    used -= coming & 1;
    coming >>= 1;
    const uint64_t oldest = held.empty() ? head : *held.begin();
    const bool room = used < config.alpha_lines && head - oldest < static_cast<uint64_t>(config.alpha_addresses());
    dut.write_i = room && goes(write_pace, bench.rng);
    dut.address_i = dut.write_i ? head & 0xffffff : bench.rng() & 0xffffff;
    written.resize(static_cast<size_t>(config.line_w()) / 32);
    for (uint32_t& word : written) word = static_cast<uint32_t>(bench.rng());
    write_port(dut.line_i, written.data());
    Words ports(port_words<decltype(dut.read_address_i)>() + 1);
    for (int j = 0; j < config.units; ++j) {
      if (!((valid >> j) & 1) && !unread.empty() && (filled || used == config.alpha_lines) &&
          goes(read_pace, bench.rng)) {
        filled = true;
        const size_t at = bench.rng() % 4 == 0 ? 0 : bench.rng() % unread.size();
        asked[j] = unread[at];
        unread.erase(unread.begin() + static_cast<std::ptrdiff_t>(at));
        valid |= 1u << j;
        skip = (skip & ~(1u << j)) | (bench.rng() % skip_one_in == 0 ? 1u << j : 0);
      }
      put_bits(ports.data(), j * 24, 24, asked[j] & 0xffffff);
    }
    write_port(dut.read_address_i, ports.data());
    dut.read_valid_i = valid;
    dut.read_skip_i = skip;
  }
  void observe() override {
    // The answer to the read of the cycle before the last one.
    ASSERT_EQ(dut.answer_valid_o, answers[1].to) << "cycle " << bench.cycle;
    if (answers[1].to != 0) {
      Words line(port_words<decltype(dut.answer_o)>());
      read_port(dut.answer_o, line.data());
      line.resize(answers[1].line.size());
      ASSERT_EQ(line, answers[1].line) << "cycle " << bench.cycle;
    }
    ASSERT_EQ(dut.free_o, answers[0].frees) << "cycle " << bench.cycle;
    coming |= static_cast<uint32_t>(dut.free_o) << 2;
    ASSERT_EQ(dut.read_ready_o & ~dut.read_valid_i, 0);
    ASSERT_LE(std::popcount(dut.read_ready_o), 1);
    answers[1] = answers[0];
    answers[0] = {};
    for (int j = 0; j < config.units; ++j) {
      if (!((dut.read_ready_o >> j) & 1)) continue;
      answers[0] = {dut.read_ready_o & ~skip, true, lines.at(asked[j])};
      lines.erase(asked[j]);
      held.erase(asked[j]);
      valid &= ~(1u << j);
      ++taken[j], ++reads;
    }
    if (!dut.write_i) return;
    lines[head] = written;
    held.insert(head);
    unread.push_back(head++);
    ++used;
  }

  struct Answer {
    uint32_t to = 0;  // readers
    bool frees = false;
    Words line;
  };
  BenchBase& bench;
  Vpipegs_alpha_store& dut;
  Config config;
  Pace read_pace = Pace::kAlways, write_pace = Pace::kCoin;
  std::map<uint64_t, Words> lines;  // that live, by address, which counts on here
  std::set<uint64_t> held;
  std::vector<uint64_t> unread;  // of these, those that nobody asks for, the oldest first
  std::vector<uint64_t> asked, taken;
  Words written;
  Answer answers[2];
  uint64_t head = 0, reads = 0, skip_one_in = 4;
  int used = 0;
  uint32_t valid = 0, skip = 0, coming = 0;
  bool filled = false;  // the store was full once: only then it is read
};

TEST(AlphaStore, AnswersEachReaderWithWhatWasWritten) {
  for (Pace read : kPaces) {
    for (Pace write : kPaces) {
      const Config config = test_config();
      GatedBench<Vpipegs_alpha_store> bench;
      Traffic traffic(bench, bench.dut, config);
      traffic.read_pace = read, traffic.write_pace = write;
      bench.reset();
      bench.run_gated_until([&] { return traffic.reads >= 4000 || HasFailure(); });
      if (HasFailure()) { FAIL() << "readers " << to_text(read) << ", writer " << to_text(write); }
    }
  }
}

TEST(AlphaStore, ReadsOneLinePerCycleAndServesEveryReaderEqually) {
  const Config config = test_config();
  Bench<Vpipegs_alpha_store> bench;
  Traffic traffic(bench, bench.dut, config);
  traffic.write_pace = Pace::kAlways;
  bench.reset();
  bench.run_until([&] { return traffic.reads > 0; });
  for (int i = 0; i < 40; ++i) bench.step();
  EXPECT_EQ(traffic.reads, 41u);
  for (uint64_t taken : traffic.taken) EXPECT_NEAR(static_cast<double>(taken), 41.0 / config.units, 1.0);
}

}  // namespace
}  // namespace pipegs
