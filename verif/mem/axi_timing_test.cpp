// SPDX-License-Identifier: Apache-2.0
// axi_timing_test: sim/memory/axi/bus_timing beside rtl/mem/pipegs_axi_manager.sv and an AXI4 memory behind it, in each
// cycle.
//
// Both see the same random requests; the memory of both is the same AxiTiming. In every cycle the one must accept what
// the other accepts and answer the tag that the other answers. So the timing model has the machine's cycles behind a
// bus, of every width.
#include <deque>
#include <map>

#include "Vpipegs_axi_manager.h"
#include "sim/memory/axi/bus_timing.hpp"
#include "verif/support/axi_port.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

struct Mix {  // of the requests, in percent
  int writes, fenced;
  Pace pace = Pace::kAlways;
};

class Pair : public Endpoint {
 public:
  explicit Pair(const ExternalMemoryOptions& timing)
      : memory({.data_w = test_config().bus_w, .timing = timing}), port(bench, memory), model(timing, config) {
    bench.dut.mem_valid_i = bench.dut.epoch_i = 0;
    bench.dut.base_i = 0;
    bench.add(*this);
    bench.reset();
  }
  bool chance(int percent) { return static_cast<int>(bench.rng() % 100) < percent; }
  void drive() override {
    auto& dut = bench.dut;
    expected_ = model.step();
    if (!up_ && left > 0 && goes(mix.pace, bench.rng)) {
      --left;
      up_ = true;
      const auto ports = static_cast<uint64_t>(config.memory_ports()),
                 writers = static_cast<uint64_t>(config.write_ports());
      request_ = {.write = chance(mix.writes), .address = bench.rng() % 4096};
      const bool fenced = request_.write || chance(mix.fenced);
      request_.tag = fenced ? bench.rng() % writers : writers + bench.rng() % (ports - writers);
      if (run_ > 0) {  // lines in a row, as most requests are
        request_.address = last_ + 1;
        --run_;
      } else {
        run_ = bench.rng() % 16;
      }
      request_.lines = request_.write ? 0 : bench.rng() % (8 - request_.address % 8);
      request_.halves = config.coded() && !request_.write && request_.lines == 0 ? 1 + bench.rng() % 3 : 3;
      last_ = request_.address + request_.lines;
    }
    dut.mem_valid_i = up_;
    write_record(config, dut.mem_request_i, request_);
  }
  void observe() override {
    auto& dut = bench.dut;
    const std::string at = "cycle " + std::to_string(bench.cycle) + ", seed " + std::to_string(bench.seed);
    const int answer = dut.rsp_valid_o ? dut.rsp_tag_o : MemoryTiming::kNoAnswer;
    ASSERT_EQ(answer, expected_) << "tag that is answered, " << at;
    if (answer != MemoryTiming::kNoAnswer && --bursts_[answer].front() == 0) {
      bursts_[answer].pop_front();
      --open;
    }
    if (!up_) return;
    const bool accepted = model.offer(request_.write, request_.address, static_cast<int>(request_.tag),
                                      1 + static_cast<int>(request_.lines), static_cast<int>(request_.halves));
    ASSERT_EQ(dut.mem_ready_o, accepted) << (request_.write ? "write" : "read") << " of tag " << request_.tag << ", "
                                         << at;
    refused += !accepted;
    if (!accepted) return;
    up_ = false;
    if (!request_.write) {
      ++open;
      bursts_[static_cast<int>(request_.tag)].push_back(1 + static_cast<int>(request_.lines));
    }
    most_open = std::max(most_open, open);
    most_writes = std::max(most_writes, static_cast<int>(dut.writes_o));
  }
  void run(int requests, const Mix& of) {
    mix = of;
    left = requests;
    bench.run_until([&] { return testing::Test::HasFatalFailure() || (left == 0 && !up_ && !bench.dut.pending_o); },
                    3000000);
  }

  const Config config = test_config();
  Bench<Vpipegs_axi_manager> bench;
  AxiMemory memory;
  AxiPort<Vpipegs_axi_manager> port;
  BusTiming model;
  Mix mix = {};
  int left = 0, open = 0, most_open = 0, most_writes = 0;  // requests to come; reads unanswered
  uint64_t refused = 0;

 private:
  MemoryRequest request_ = {};
  bool up_ = false;
  uint64_t last_ = 0, run_ = 0;
  std::map<int, std::deque<int>> bursts_;  // of each tag: lines that are missing of its reads
  int expected_ = MemoryTiming::kNoAnswer;
};

const ExternalMemoryOptions kMemories[] = {
    {.latency = 1, .bytes_per_cycle = 64, .write_latency = 1},
    {.latency = 30, .jitter = 25, .write_latency = 7},
    {.latency = 100, .bytes_per_cycle = 20, .write_latency = 150},
    {.dram = "lpddr5-6400x4"},
    {.dram = "lpddr5-6400x4", .write_latency = 300},
};
const Mix kMixes[] = {
    {0, 0}, {100, 0}, {50, 0}, {50, 50}, {10, 90}, {30, 30, Pace::kCoin}, {50, 100}, {3, 60}, {3, 60, Pace::kQuarter}};

TEST(AxiTiming, EveryCycleIsThatOfTheRtl) {
  uint64_t refused = 0;
  for (const ExternalMemoryOptions& memory : kMemories) {
    Pair pair(memory);
    for (int round = 0; round < 3 && !testing::Test::HasFatalFailure(); ++round) {
      for (const Mix& mix : kMixes) {
        pair.run(round == 0 ? 1500 : 200, mix);
        if (testing::Test::HasFatalFailure()) {
          FAIL() << memory.dram << ", latency " << memory.latency << ", writes " << mix.writes << " %, fenced "
                 << mix.fenced << " %, " << to_text(mix.pace);
        }
        ASSERT_EQ(pair.open, 0);
      }
    }
    refused += pair.refused;
  }
  EXPECT_GT(refused, 1000u);
}

// So slow that as many are unanswered as the manager allows.
TEST(AxiTiming, EveryCycleIsThatOfTheRtlAtTheLimits) {
  for (const int writes : {0, 100, 30}) {
    Pair pair({.latency = 3000, .bytes_per_cycle = 64, .write_latency = 3000});
    pair.run(1500, {.writes = writes, .fenced = 20});
    EXPECT_LE(pair.most_open, Config::bus_reads());
    if (writes == 0) { EXPECT_EQ(pair.most_open, Config::bus_reads()); }
    if (writes == 100) { EXPECT_GE(pair.most_writes, Config::bus_writes() - 1); }
  }
}

}  // namespace
}  // namespace pipegs
