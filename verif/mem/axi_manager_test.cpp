// SPDX-License-Identifier: Apache-2.0
// axi_manager_test: rtl/mem/pipegs_axi_manager.sv between a core of random requests and an AXI4 memory.
//
// Every line that is read is compared with an array (core_port.hpp); the memory checks the rules of AXI4, and so does
// synth/prove/parts/axi_check.sv, bound to the module.
#include "verif/mem/core_port.hpp"

namespace pipegs {
namespace {

constexpr uint64_t kBase = 0x1234567000;
const AxiWidths kWidths(test_config());
const int kDataW = kWidths.data, kBeats = 512 / kDataW;

struct Machine {
  explicit Machine(AxiMemoryOptions options)
      : memory(with_width(options)), port(bench, memory), core(bench, memory, kBase) {
    memory_options = options;
    bench.reset();
  }
  static AxiMemoryOptions with_width(AxiMemoryOptions options) {
    options.data_w = kDataW;
    options.most_reads = PIPEGS_READS;
    options.most_writes = PIPEGS_WRITES;
    options.seed = test_seed();
    return options;
  }
  void finish() {
    bench.run_until([&] { return core.finished(); }, 1000000);
  }

  Bench<Vpipegs_axi_manager> bench;
  AxiMemoryOptions memory_options;
  AxiMemory memory;
  AxiPort<Vpipegs_axi_manager> port;
  CorePort core;
};

const AxiMemoryOptions kHarsh{.harsh = true};

TEST(AxiManager, EveryReadSeesTheWritesBeforeItAtEveryPace) {
  for (const Pace pace : kPaces) {
    for (const int ready : {20, 70, 100}) {
      AxiMemoryOptions options = kHarsh;
      options.ready_percent = ready;
      Machine machine(options);
      machine.core.pace = pace;
      for (int i = 0; i < 3000; ++i) machine.core.push(machine.core.random_request());
      machine.finish();
      EXPECT_EQ(machine.core.accepted, 3000u);
      for (uint64_t line = 0; line < CorePort::kShared; ++line) {
        ASSERT_EQ(machine.memory.line(kBase / 64 + line), machine.core.model[line]) << "line " << line;
      }
      if (HasFailure()) { FAIL() << "core " << to_text(pace) << ", memory ready " << ready << " %"; }
    }
  }
}

// Seldom a write, so that reads that must wait do not all wait.
TEST(AxiManager, EveryReadSeesTheWritesBeforeItWhenWritesAreFew) {
  Machine machine(kHarsh);
  for (int i = 0; i < 6000; ++i) {
    CoreRequest request = machine.core.random_request();
    if (request.write && machine.bench.rng() % 8 != 0) request.write = false, request.halves = 3;
    machine.core.push(request);
  }
  machine.finish();
}

TEST(AxiManager, ATimedMemoryGivesTheSameLines) {
  for (const char* dram : {"ideal", "lpddr5-6400x4"}) {
    Machine machine({.timing = {.dram = dram, .latency = 40, .jitter = 30, .write_latency = 60}});
    for (int i = 0; i < 4000; ++i) machine.core.push(machine.core.random_request());
    machine.finish();
    EXPECT_EQ(machine.core.accepted, 4000u) << dram;
  }
}

TEST(AxiManager, AResetOfTheCoreDropsWhatItAskedForAndNothingElse) {
  Machine machine(kHarsh);
  machine.core.pace = Pace::kCoin;
  uint64_t turns = 0, undrained = 0;
  for (int round = 0; round < 60 && !testing::Test::HasFatalFailure(); ++round) {
    for (int i = 0; i < 200; ++i) machine.core.push(machine.core.random_request());
    const uint64_t steps = 1 + machine.bench.rng() % 400;
    for (uint64_t i = 0; i < steps; ++i) machine.bench.step();
    machine.bench.run_until([&] { return machine.bench.dut.drained_o != 0; }, 20000);
    undrained += machine.bench.dut.pending_o;
    machine.core.restart();
    ++turns;
  }
  for (int i = 0; i < 200; ++i) machine.core.push(machine.core.random_request());
  machine.finish();
  EXPECT_EQ(turns, 60u);
  EXPECT_GT(undrained, 30u);  // most of them in mid-flight
}

// Until every read of the old core is answered on the bus, drained_o is low; then it rises.
TEST(AxiManager, DrainedSaysWhetherReadsOfTheOldCoreAreOut) {
  Machine machine({.timing = {.latency = 50}});
  auto& dut = machine.bench.dut;
  CoreRequest request;
  request.tag = machine.core.config.memory_ports() - 1;
  request.line = CorePort::kFixed;
  request.lines = 8;
  for (int i = 0; i < 3; ++i) machine.core.push(request);
  machine.bench.run_until([&] { return machine.core.accepted == 3; });
  EXPECT_EQ(dut.drained_o, 1);
  machine.core.restart();
  machine.core.push(request);
  machine.bench.step();
  EXPECT_EQ(dut.drained_o, 0);
  int low = 0;
  for (; dut.drained_o == 0 && low < 500; ++low) machine.bench.step();
  EXPECT_GT(low, 40);
  EXPECT_LT(low, 40 + 50 + 3 * 8 * kBeats);
  machine.finish();
  EXPECT_EQ(machine.core.answered, 8u);
}

// Lines outside the memory and lines that fail, while the core is reset now and then: each failed answer to this core
// is told one cycle later, of a read and of a write in the same cycle both, and none to the core before it.
TEST(AxiManager, EveryErrorIsToldOneCycleLaterAndAWriteWithItsLine) {
  AxiMemoryOptions options = kHarsh;
  options.base = kBase;
  options.size = (CorePort::kFixed + CorePort::kShared / 2) * 64;
  options.read_delay = options.write_delay = 30;  // many answers before the core is reset
  uint64_t dropped = 0, both = 0;
  std::array<uint64_t, 4> told{};
  for (const bool failing : {false, true}) {
    Machine machine(options);
    auto& dut = machine.bench.dut;
    std::deque<std::pair<uint64_t, CData>> writes;  // lines accepted and not answered, and their epochs
    uint32_t errors = 0;                            // of the answers in the cycle before
    uint64_t line = 0;                              // if one of them was a write's
    for (uint64_t i = CorePort::kShared / 2; i < CorePort::kShared; ++i) machine.core.store(CorePort::kFixed + i, {});
    if (failing) {
      for (const uint64_t bad : {3, 9, 31}) {
        machine.memory.failing.insert(kBase / 64 + bad);
        machine.core.refused.insert(bad);
      }
    }
    Beside watch(machine.bench, [&] {
      const AxiSubordinateSide& shown = machine.port.shown();
      const bool answered = shown.b.valid && axi_manager_side(dut.m_axi_o, kWidths).b_ready;
      ASSERT_EQ(dut.error_o, errors) << "cycle " << machine.bench.cycle;
      if (errors >> 2 != 0) { ASSERT_EQ(dut.error_line_o, line) << "cycle " << machine.bench.cycle; }
      ASSERT_EQ(dut.writes_o, writes.size()) << "cycle " << machine.bench.cycle;
      ASSERT_EQ(dut.answered_o, answered) << "cycle " << machine.bench.cycle;
      for (size_t i = 0; i < told.size(); ++i) told[i] += dut.error_o >> i & 1;
      both += (dut.error_o & 3) != 0 && dut.error_o >> 2 != 0;
      errors = 0;
      if (shown.r.valid && shown.r.response != AxiResponse::kOkay) {
        const bool now = shown.r.id >> machine.core.config.tag_w() == dut.epoch_i;
        if (now) errors |= shown.r.response == AxiResponse::kDecodeError ? 2 : 1;
        dropped += !now;
      }
      if (answered) {
        if (shown.b.response != AxiResponse::kOkay) {
          const bool now = writes.front().second == dut.epoch_i;
          if (now) errors |= shown.b.response == AxiResponse::kDecodeError ? 8 : 4;
          dropped += !now;
          line = writes.front().first;
        }
        writes.pop_front();
      }
      if (dut.mem_valid_i && dut.mem_ready_o) {
        const auto request = read_record<MemoryRequest>(machine.core.config, dut.mem_request_i);
        if (request.write) writes.push_back({request.address, dut.epoch_i});
      }
    });
    for (int round = 0; round < 40 && !testing::Test::HasFatalFailure(); ++round) {
      if (round > 0) machine.core.restart();
      for (int i = 0; i < 400; ++i) {
        CoreRequest request = machine.core.random_request();
        if (machine.bench.rng() % 4 == 0) {  // a write outside the memory, too
          request.write = true, request.tag = 0, request.lines = 1;
          request.line = CorePort::kFixed + CorePort::kShared + machine.bench.rng() % CorePort::kShared;
          machine.core.refused.insert(request.line);
        }
        machine.core.push(request);
      }
      const uint64_t end = machine.bench.cycle + 200 + machine.bench.rng() % 200;
      machine.bench.run_until(
          [&] { return machine.core.finished() || (round < 39 && machine.bench.cycle >= end && dut.drained_o); });
    }
  }
  EXPECT_GT(told[0], 0u);
  EXPECT_GT(told[1], 50u);
  EXPECT_GT(told[2], 0u);
  EXPECT_GT(told[3], 50u);
  EXPECT_GT(both, 0u);
  EXPECT_GT(dropped, 0u);
}

// What the manager says of reads or of writes that it waits for.
struct Wait {
  explicit Wait(uint64_t port) : waits(port & 1), moves(port >> 1 & 1), located(port >> 2 & 1), line(port >> 3) {}
  bool waits, moves, located;
  uint64_t line;
};

// Memory falls silent now and then, in one channel or in all: in each cycle the manager says whether anything is owed
// and whether anything moves, and the line that it names is one that is owed.
TEST(AxiManager, SaysWhatMemoryOwes) {
  Machine machine(kHarsh);
  auto& dut = machine.bench.dut;
  std::map<uint32_t, std::deque<uint64_t>> reads;  // of each ID: lines of bursts that were taken and are not answered
  std::deque<uint64_t> writes;                     // lines accepted and not answered
  uint64_t still = 0, named = 0;                   // cycles in which a read is owed and nothing moves; with its line
  Beside watch(
      machine.bench,
      [&] {
        const AxiManagerSide shown = axi_manager_side(dut.m_axi_o, kWidths);
        const AxiSubordinateSide& memory = machine.port.shown();
        const Wait read(dut.read_wait_o), write(dut.write_wait_o);
        const std::string at = "cycle " + std::to_string(machine.bench.cycle);
        const bool asks = shown.ar.valid && memory.ar_ready, answered = memory.b.valid && shown.b_ready;
        const uint64_t line = (shown.ar.address - kBase) / 64;
        size_t out = 0;
        bool owed = false;
        for (const auto& [id, lines] : reads) {
          out += lines.size();
          owed = owed || std::find(lines.begin(), lines.end(), read.line) != lines.end();
        }
        ASSERT_EQ(read.waits, shown.ar.valid || out > 0) << at;
        ASSERT_EQ(read.moves, asks || memory.r.valid) << at;
        ASSERT_TRUE(read.located || !shown.ar.valid) << at;
        if (read.located) { ASSERT_TRUE(shown.ar.valid ? read.line == line : owed) << at; }
        still += read.waits && !read.moves;
        named += read.waits && !read.moves && read.located;
        ASSERT_EQ(write.waits, !writes.empty()) << at;
        ASSERT_EQ(write.moves, (shown.aw.valid && memory.aw_ready) || (shown.w.valid && memory.w_ready) || answered)
            << at;
        if (write.located) { ASSERT_EQ(write.line, writes.front()) << at; }
        if (asks) reads[shown.ar.id].push_back(line);
        if (memory.r.valid && memory.r.last) reads[memory.r.id].pop_front();
        if (answered) writes.pop_front();
        if (dut.mem_valid_i && dut.mem_ready_o) {
          const auto request = read_record<MemoryRequest>(machine.core.config, dut.mem_request_i);
          if (request.write) writes.push_back(request.address);
        }
      },
      [&] {
        if (machine.bench.cycle % 100 != 0) return;
        const uint64_t draw = machine.bench.rng() % 12;
        machine.memory.silence = {draw == 0 || draw == 5, draw == 1 || draw == 5, draw == 2 || draw == 5,
                                  draw == 3 || draw == 5, draw == 4 || draw == 5};
      });
  for (int i = 0; i < 4000; ++i) machine.core.push(machine.core.random_request());
  machine.finish();
  EXPECT_GT(still, 500u);
  EXPECT_GT(named, still / 2);
}

// Two reads of one tag in a row, the first of which comes in any cycle about that of the answer to a write.
TEST(AxiManager, ReadsStayInOrderWhenTheLastWriteIsAnswered) {
  Machine machine({.timing = {.latency = 5, .bytes_per_cycle = 64, .write_latency = 10}});
  for (uint64_t delay = 0; delay < 40; ++delay) {
    CoreRequest request;
    request.write = true;
    request.data = machine.core.random_line();
    machine.core.push(request);
    for (uint64_t i = 0; i < delay; ++i) machine.bench.step();
    request.write = false;
    for (request.line = 0; request.line < 4; ++request.line) machine.core.push(request);
    machine.finish();
  }
  EXPECT_EQ(machine.core.answered, 160u);
}

// An identifier is as wide as the ports need: over many reads of both epochs each of its bits is 0 and 1.
TEST(AxiManager, EveryBitOfAnIdentifierIsUsed) {
  Machine machine(kHarsh);
  uint32_t ones = 0, zeros = 0;
  Beside watch(machine.bench, [&] {
    const AxiManagerSide shown = axi_manager_side(machine.bench.dut.m_axi_o, kWidths);
    if (shown.ar.valid) ones |= shown.ar.id, zeros |= ~shown.ar.id;
  });
  for (int epoch = 0; epoch < 2; ++epoch) {
    for (int i = 0; i < 500; ++i) machine.core.push(machine.core.random_request());
    machine.finish();
    machine.core.restart();
  }
  const int id_w = 1 + machine.core.config.tag_w();  // {epoch, tag}
  EXPECT_EQ(ones, (1u << id_w) - 1);
  EXPECT_EQ(zeros & ones, ones);
  EXPECT_GE(2 * machine.core.config.memory_ports(), 1 << machine.core.config.tag_w()) << "half as many would do";
}

// As many as the parameters say are unanswered at once, and not more: the memory and the checker count, too.
TEST(AxiManager, KeepsToItsLimits) {
  AxiMemoryOptions options = kHarsh;
  options.ready_percent = 100;
  options.read_delay = options.write_delay = 4000;
  for (const bool write : {false, true}) {
    Machine machine(options);
    CoreRequest request;
    request.write = write;
    request.tag = write ? 0 : machine.core.config.memory_ports() - 1;
    request.line = write ? 0 : CorePort::kFixed;
    for (int i = 0; i < 600; ++i) machine.core.push(request);
    uint64_t most = 0;
    for (int i = 0; write && i < 1500; ++i) machine.bench.step();  // no write is answered yet
    if (write) most = machine.core.accepted;
    machine.bench.run_until(
        [&] {
          if (!write) most = std::max(most, machine.core.accepted - machine.core.answered);
          return machine.core.finished();
        },
        1000000);
    EXPECT_EQ(most, write ? PIPEGS_WRITES : PIPEGS_READS);
  }
}

#ifndef PIPEGS_SMALL
// One read in an idle machine: how many cycles more than at the bare port, whose memory answers after `latency`.
TEST(AxiManager, AReadTakesTwoCyclesMoreAndOneForEachFurtherBeat) {
  Machine machine({.timing = {.latency = 30, .bytes_per_cycle = 64}});
  CoreRequest request;
  request.tag = machine.core.config.memory_ports() - 1;
  request.line = CorePort::kFixed;
  machine.core.push(request);
  machine.finish();
  ASSERT_EQ(machine.core.answers.size(), 1u);
  EXPECT_EQ(machine.core.answers[0] - machine.core.last_accepted, 30u + 2 + (kBeats - 1));
}

TEST(AxiManager, MovesALineInEachTurnOfTheBus) {
  for (const int lines : {1, 8}) {
    for (const bool write : {false, true}) {
      Machine machine({.timing = {.latency = 20, .bytes_per_cycle = 64}});
      CoreRequest request;
      request.lines = lines;
      request.write = write;
      if (write && lines > 1) continue;
      request.tag = write ? 0 : machine.core.config.memory_ports() - 1;
      const uint64_t first = write ? 0 : CorePort::kFixed;
      constexpr int kRequests = 400;
      for (int i = 0; i < kRequests; ++i) {
        request.line = first + static_cast<uint64_t>(i * lines) % CorePort::kShared;
        request.data = machine.core.random_line();
        machine.core.push(request);
      }
      const uint64_t begin = machine.bench.cycle;
      machine.finish();
      const uint64_t turns = static_cast<uint64_t>(kRequests * lines) * kBeats;
      EXPECT_LE(machine.bench.cycle - begin, turns + 60) << lines << (write ? " written" : " read");
    }
  }
}

// A read that must wait for a write does not hold up others, and later writes do not hold up the read.
TEST(AxiManager, OnlyWhatMustWaitWaits) {
  Machine machine({.timing = {.latency = 20, .bytes_per_cycle = 64, .write_latency = 300}});
  CoreRequest write, read, other;
  write.write = true;
  write.data = machine.core.random_line();
  read.tag = 1;
  other.tag = machine.core.config.memory_ports() - 1;
  other.line = CorePort::kFixed;
  const uint64_t begin = machine.bench.cycle;
  machine.core.push(write);
  machine.core.push(read);
  machine.core.push(other);
  for (int i = 0; i < 40; ++i) {
    write.line = 8 + static_cast<uint64_t>(i % 8);
    machine.core.push(write);
  }
  machine.finish();
  ASSERT_EQ(machine.core.order, (std::vector<int>{other.tag, read.tag}));
  EXPECT_LT(machine.core.answers[0] - begin, 40u);
  EXPECT_GE(machine.core.answers[1] - begin, 300u);
  EXPECT_LT(machine.core.answers[1] - begin, 300u + 45);
}
#endif

}  // namespace
}  // namespace pipegs
