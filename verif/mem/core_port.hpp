// SPDX-License-Identifier: Apache-2.0
// core_port.hpp: a core at the memory port of pipegs_axi_manager: random requests, and what each of them must see.
//
// Idea    The model is an array to which a write goes in the cycle in which it is accepted. A read of a tag that may
//         write must show the array as it was when the read was accepted; other tags read lines that nobody writes. No
//         line is written while a read of it is unanswered: AXI does not say which of the two comes first, and the core
//         does not do it. A reset of the core turns the epoch: what was asked for before must never be answered.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "verif/support/axi_port.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_axi_manager.h"

namespace pipegs {

struct CoreRequest {
  bool write = false;
  uint64_t line = 0;
  int tag = 0;
  int lines = 1;
  MemoryLine data{};
  int halves = 3;  // of the line, that a write changes or a read of one line needs
};

class CorePort : public Endpoint {
 public:
  static constexpr uint64_t kShared = 64;   // lines that all tags that may write write and read
  static constexpr uint64_t kFixed = 4096;  // first of as many lines that the others read

  CorePort(Bench<Vpipegs_axi_manager>& bench, AxiMemory& memory, uint64_t base)
      : memory(memory), bench_(bench), first_(base / 64) {
    auto& dut = bench.dut;
    dut.mem_valid_i = 0;
    dut.epoch_i = 0;
    dut.base_i = base;
    for (uint64_t line = 0; line < kShared; ++line) {
      store(line, random_line());
      store(kFixed + line, random_line());
    }
    bench.add(*this);
  }

  void push(const CoreRequest& request) { waiting.push_back(request); }
  CoreRequest random_request() {
    CoreRequest request;
    request.tag = static_cast<int>(bench_.rng() % static_cast<uint64_t>(config.memory_ports()));
    const bool writer = request.tag < config.write_ports();
    request.write = writer && bench_.rng() % 2 == 0;
    request.line = (writer ? 0 : kFixed) + bench_.rng() % kShared;
    request.lines = request.write ? 1 : 1 + static_cast<int>(bench_.rng() % (8 - request.line % 8));
    request.data = random_line();
    const bool reads_half = config.coded() && request.lines == 1;
    if (request.write || reads_half) request.halves = 1 + static_cast<int>(request.data[0] % 3);
    return request;
  }
  MemoryLine random_line() {
    MemoryLine line;
    for (uint32_t& word : line) word = static_cast<uint32_t>(bench_.rng());
    return line;
  }
  void store(uint64_t line, const MemoryLine& data) { memory.line(first_ + line) = model[line] = data; }

  // The core is reset now: what it showed is gone, and nothing of it is answered.
  void restart() {
    bench_.dut.epoch_i = !bench_.dut.epoch_i;
    up_.reset();
    reset_ = true;
    waiting.clear();
    for (auto& due : due_) due.clear();
    reading_.clear();
  }

  void drive() override {
    auto& dut = bench_.dut;
    const bool shows = !std::exchange(reset_, false);  // in reset it does not
    if (shows && !up_ && !waiting.empty() && goes(pace, bench_.rng) && free(waiting.front())) {
      up_ = waiting.front();
      waiting.pop_front();
    }
    CoreRequest shown;
    if (up_) {
      shown = *up_;
    } else {
      shown = random_request();
      shown.tag = static_cast<int>(bench_.rng() >> (64 - config.tag_w()));
    }
    dut.mem_valid_i = up_.has_value();
    write_record(config, dut.mem_request_i,
                 MemoryRequest{.write = shown.write,
                               .address = shown.line,
                               .tag = static_cast<uint64_t>(shown.tag),
                               .halves = static_cast<uint64_t>(shown.halves),
                               .lines = static_cast<uint64_t>(shown.lines - 1)});
    write_port(dut.mem_data_i, shown.data.data());
  }

  void observe() override {
    auto& dut = bench_.dut;
    if (!dut.pending_o) {
      ASSERT_TRUE(memory.quiet()) << "idle, and the memory is not: " << at();
      for (const auto& due : due_) ASSERT_TRUE(due.empty()) << "idle, and an answer is missing: " << at();
    }
    if (dut.rsp_valid_o) answer();
    if (!up_ || !dut.mem_ready_o) return;
    const CoreRequest& request = *up_;
    ++accepted;
    last_accepted = bench_.cycle;
    if (request.write) {
      if (!refused.contains(request.line)) write(request);
    } else {
      for (int i = 0; i < request.lines; ++i) {
        const uint64_t line = request.line + static_cast<uint64_t>(i);
        due_[static_cast<size_t>(request.tag)].push_back({line, request.halves, model[line]});
        ++reading_[line];
      }
    }
    up_.reset();
  }
  bool finished() const {
    if (testing::Test::HasFatalFailure()) return true;
    return waiting.empty() && !up_ && !bench_.dut.pending_o;
  }

  const Config config = test_config();
  AxiMemory& memory;
  std::deque<CoreRequest> waiting;
  std::map<uint64_t, MemoryLine> model;
  std::set<uint64_t> refused;  // lines that the memory does not write
  Pace pace = Pace::kAlways;
  uint64_t accepted = 0, answered = 0, last_accepted = 0;
  std::vector<int> order;         // tags of the lines that were answered
  std::vector<uint64_t> answers;  // and when

 private:
  struct Due {
    uint64_t line;
    int halves;  // of it that were asked for
    MemoryLine data;
  };
  std::string at() const { return "cycle " + std::to_string(bench_.cycle) + ", seed " + std::to_string(bench_.seed); }
  bool free(const CoreRequest& request) {
    const auto reads = reading_.find(request.line);
    return !request.write || reads == reading_.end() || reads->second == 0;
  }
  void write(const CoreRequest& request) {
    for (size_t i = 0; i < 16; ++i) {
      if ((request.halves >> i / 8 & 1) != 0) model[request.line][i] = request.data[i];
    }
  }
  void answer() {
    auto& dut = bench_.dut;
    const int tag = dut.rsp_tag_o;
    ASSERT_LT(tag, config.memory_ports()) << at();
    auto& due = due_[static_cast<size_t>(tag)];
    ASSERT_FALSE(due.empty()) << "tag " << tag << ": an answer to nothing, " << at();
    MemoryLine data;
    read_port(dut.rsp_data_o, data.data());
    for (size_t i = 0; i < 16; ++i) {
      if ((due.front().halves >> i / 8 & 1) == 0) data[i] = due.front().data[i];
    }
    ASSERT_EQ(data, due.front().data) << "tag " << tag << ", line " << due.front().line << ", " << at();
    --reading_[due.front().line];
    due.pop_front();
    ++answered;
    order.push_back(tag);
    answers.push_back(bench_.cycle);
  }

  Bench<Vpipegs_axi_manager>& bench_;
  uint64_t first_;  // line 0 in the memory
  std::optional<CoreRequest> up_;
  bool reset_ = false;
  std::array<std::deque<Due>, 256> due_;
  std::map<uint64_t, int> reading_;  // of each line: reads that are not answered
};

}  // namespace pipegs
