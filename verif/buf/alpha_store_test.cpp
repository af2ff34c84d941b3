// SPDX-License-Identifier: Apache-2.0
// alpha_store_test: rtl/buf/pipegs_alpha_store.sv against an array.
#include "verif/support/config.hpp"
#include "verif/support/gated_bench.hpp"
#include "Vpipegs_alpha_store.h"

namespace pipegs {
namespace {

// All ports of the store: one writer, and one reader per unit that holds its request until it is granted.
struct Traffic : Endpoint {
  Traffic(BenchBase& bench, Vpipegs_alpha_store& dut, const Config& config)
      : bench(bench),
        dut(dut),
        config(config),
        model(static_cast<size_t>(config.alpha_lines)),
        asked(config.units),
        taken(config.units) {
    bench.add(*this);
  }
  void drive() override {
    dut.write_i = fill < model.size() || goes(write_pace, bench.rng);
    Words line(static_cast<size_t>(config.line_w()) / 32);
    for (uint32_t& word : line) word = static_cast<uint32_t>(bench.rng());
    write_port(dut.line_i, line.data());
    written = line;
    Words ports(port_words<decltype(dut.read_address_i)>() + 1);
    for (int j = 0; j < config.units; ++j) {
      if (!((valid >> j) & 1) && fill == model.size() && goes(read_pace, bench.rng))
        valid |= 1u << j, asked[j] = bench.rng() & 0xffffff;
      put_bits(ports.data(), j * 24, 24, asked[j]);
    }
    write_port(dut.read_address_i, ports.data());
    do dut.address_i = fill < model.size() ? fill : bench.rng() & 0xffffff;
    while (is_asked(dut.address_i));
    dut.read_valid_i = valid;
  }
  void observe() override {
    // The answer to the read of the cycle before.
    ASSERT_EQ(dut.answer_valid_o, answer_to) << "cycle " << bench.cycle;
    if (answer_to != 0) {
      Words line(port_words<decltype(dut.answer_o)>());
      read_port(dut.answer_o, line.data());
      line.resize(answer.size());
      ASSERT_EQ(line, answer) << "cycle " << bench.cycle;
    }
    ASSERT_EQ(dut.read_ready_o & ~dut.read_valid_i, 0);
    ASSERT_LE(std::popcount(dut.read_ready_o), 1);
    answer_to = dut.read_ready_o;
    for (int j = 0; j < config.units; ++j) {
      if (!((answer_to >> j) & 1)) continue;
      answer = model[asked[j] % model.size()];
      valid &= ~(1u << j);
      ++taken[j], ++reads;
    }
    if (dut.write_i) model[dut.address_i % model.size()] = written;
    if (fill < model.size()) ++fill;
  }

  // Somebody may read that line in this cycle, so nobody writes it.
  bool is_asked(uint64_t address) const {
    for (int j = 0; j < config.units; ++j)
      if ((valid >> j & 1) && asked[j] % model.size() == address % model.size()) return true;
    return false;
  }

  BenchBase& bench;
  Vpipegs_alpha_store& dut;
  Config config;
  Pace read_pace = Pace::kAlways, write_pace = Pace::kCoin;
  std::vector<Words> model;
  std::vector<uint64_t> asked, taken;
  Words written, answer;
  size_t fill = 0;
  uint32_t valid = 0, answer_to = 0;
  uint64_t reads = 0;
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
  bench.reset();
  bench.run_until([&] { return traffic.reads > 0; });
  for (int i = 0; i < 400; ++i) bench.step();
  EXPECT_EQ(traffic.reads, 401u);
  for (uint64_t taken : traffic.taken) EXPECT_NEAR(static_cast<double>(taken), 401.0 / config.units, 1.0);
}

}  // namespace
}  // namespace pipegs
