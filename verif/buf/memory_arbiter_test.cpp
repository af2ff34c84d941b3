// SPDX-License-Identifier: Apache-2.0
// memory_arbiter_test: rtl/buf/pipegs_memory_arbiter.sv with random requests on all ports and
// sim/memory/external_memory behind it.
//
// Each port has 16 lines of its own in memory, so the address alone tells whose request it is; answers of different
// ports overtake each other.
#include <map>

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_memory_arbiter.h"

namespace pipegs {
namespace {

struct Request {
  bool write;
  uint64_t address;
  int lines;
  MemoryLine data;
  int halves;  // of the line; all of a read of more lines
};

// A line to be answered, and the halves of it that count.
struct Due {
  MemoryLine line;
  int halves;
};

class Requesters : public Endpoint {
 public:
  Requesters(Bench<Vpipegs_memory_arbiter>& bench, Pace pace, Pace memory_pace, ExternalMemoryOptions options)
      : pace(pace), memory_pace(memory_pace), memory(options), bench_(bench) {
    memory.allow_overwrites();  // ports write what they read, the order is the arbiter's
    bench.dut.valid_i = bench.dut.stop_i = 0;
    bench.dut.mem_ready_i = 0;
    bench.dut.mem_rsp_valid_i = 0;
    for (int p = 0; p < ports; ++p) {
      uint64_t base = 0;
      while (base == 0 || owner_.count(base)) base = bench.rng() % (uint64_t{1} << (config.address_w() - 4));
      owner_[base] = p;
      bases_.push_back(base << 4);
      for (uint64_t line = bases_.back(); line < bases_.back() + 16; ++line) {
        memory.line(line) = lines_[line] = random_line();
      }
    }
    bench.add(*this);
  }
  MemoryLine random_line() {
    MemoryLine line;
    for (uint32_t& word : line) word = static_cast<uint32_t>(bench_.rng());
    return line;
  }
  // A read of some lines of a group of eight, or of as many as given from its first on; a write of one.
  void push(int port, bool write, int lines = 0) {
    const uint64_t place = bench_.rng() % 16;
    if (lines == 0) lines = 1 + static_cast<int>(bench_.rng() % (8 - place % 8));
    if (write) lines = 1;
    const int halves = lines == 1 ? 1 + static_cast<int>(bench_.rng() % 3) : 3;
    const uint64_t line = bases_[port] + (lines == 8 ? place & ~uint64_t{7} : place);
    waiting[port].push_back({write, line, lines, random_line(), halves});
  }
  void drive() override {
    auto& dut = bench_.dut;
    Words lines(port_words<decltype(dut.lines_i)>() + 2), halves(port_words<decltype(dut.halves_i)>() + 2);
    Words address(port_words<decltype(dut.address_i)>() + 2), data(port_words<decltype(dut.data_i)>() + 2);
    for (uint32_t& word : address) word = static_cast<uint32_t>(bench_.rng());  // noise beside a low valid
    for (uint32_t& word : data) word = static_cast<uint32_t>(bench_.rng());
    for (uint32_t& word : lines) word = static_cast<uint32_t>(bench_.rng());
    for (uint32_t& word : halves) word = static_cast<uint32_t>(bench_.rng());
    uint32_t valid = 0, write = static_cast<uint32_t>(bench_.rng()) & ((1u << writers) - 1);
    for (int p = 0; p < ports; ++p) {
      if (!up_[p] && !waiting[p].empty() && goes(pace, bench_.rng)) up_[p] = true;
      if (!up_[p]) continue;
      const Request& request = waiting[p].front();
      valid |= 1u << p;
      put_bits(address.data(), p * config.address_w(), config.address_w(), request.address);
      put_bits(lines.data(), p * config.burst_w(), config.burst_w(), static_cast<uint64_t>(request.lines - 1));
      put_bits(halves.data(), p * config.halves_w(), config.halves_w(), static_cast<uint64_t>(request.halves));
      if (p >= writers) continue;
      write = (write & ~(1u << p)) | (request.write ? 1u : 0u) << p;
      if (request.write) std::copy(request.data.begin(), request.data.end(), data.begin() + 16 * p);
    }
    write_port(dut.valid_i, &valid);
    write_port(dut.write_i, &write);
    write_port(dut.address_i, address.data());
    write_port(dut.halves_i, halves.data());
    write_port(dut.lines_i, lines.data());
    write_port(dut.data_i, data.data());

    memory.step();
    dut.mem_ready_i = memory.ready() && goes(memory_pace, bench_.rng);
    const ExternalMemory::Answer* answer = memory.answer();
    dut.mem_rsp_valid_i = answer != nullptr;
    dut.mem_rsp_tag_i = static_cast<CData>(answer != nullptr ? static_cast<uint64_t>(answer->tag) : bench_.rng());
    const MemoryLine noise = random_line();
    write_port(dut.mem_rsp_data_i, answer != nullptr ? answer->data.data() : noise.data());
  }
  void observe() override {
    take();
    leave();
    answer();
  }
  bool finished() const {
    if (testing::Test::HasFatalFailure()) return true;
    for (int p = 0; p < ports; ++p)
      if (!waiting[p].empty() || !taken_[p].empty() || !due_[p].empty()) return false;
    return true;
  }

  const Config config = test_config();
  const int ports = config.memory_ports(), writers = config.write_ports();
  Pace pace, memory_pace;
  ExternalMemory memory;
  std::vector<std::deque<Request>> waiting{static_cast<size_t>(ports)};
  std::vector<int> order;        // the ports of the requests that left
  std::vector<int> lengths;      // their lines
  std::vector<uint64_t> cycles;  // and when
  uint64_t answers = 0;

 private:
  std::string at(int port) const {
    return "port " + std::to_string(port) + ", cycle " + std::to_string(bench_.cycle) + ", seed " +
           std::to_string(bench_.seed);
  }
  void take() {
    auto& dut = bench_.dut;
    ASSERT_EQ(dut.ready_o & (dut.ready_o - 1), 0u) << "two requests taken at once, cycle " << bench_.cycle;
    for (int p = 0; p < ports; ++p) {
      if (!up_[p] || !((dut.ready_o >> p) & 1)) continue;
      taken_[p].push_back(waiting[p].front());
      waiting[p].pop_front();
      up_[p] = false;
    }
  }
  void leave() {
    auto& dut = bench_.dut;
    MemoryRequest request{};
    MemoryLine data{};
    if (dut.mem_valid_o) {
      request = read_record<MemoryRequest>(config, dut.mem_request_o);
      if (request.write) read_port(dut.mem_data_o, data.data());
    }
    if (shown_) {
      ASSERT_TRUE(dut.mem_valid_o) << "a request vanished, cycle " << bench_.cycle;
      ASSERT_EQ(first_difference(config, last_, request), "") << "a shown request changed, cycle " << bench_.cycle;
      ASSERT_EQ(last_data_, data) << "the data of a shown request changed, cycle " << bench_.cycle;
    }
    shown_ = dut.mem_valid_o && !dut.mem_ready_i;
    last_ = request;
    last_data_ = data;
    if (!dut.mem_valid_o || !dut.mem_ready_i) return;
    const auto owner = owner_.find(request.address >> 4);
    ASSERT_NE(owner, owner_.end()) << "an address that nobody asked for, cycle " << bench_.cycle;
    const int p = owner->second;
    ASSERT_EQ(request.tag, static_cast<uint64_t>(p)) << "cycle " << bench_.cycle << ", seed " << bench_.seed;
    ASSERT_FALSE(taken_[p].empty()) << "port " << p << ": a request left twice, cycle " << bench_.cycle;
    const Request expected = taken_[p].front();
    taken_[p].pop_front();
    ASSERT_EQ(request.address, expected.address) << at(p);
    ASSERT_EQ(request.write, expected.write ? 1u : 0u) << at(p);
    ASSERT_EQ(request.halves, static_cast<uint64_t>(expected.halves)) << at(p);
    ASSERT_EQ(request.lines, static_cast<uint64_t>(expected.lines - 1)) << at(p);
    if (expected.write) {
      ASSERT_EQ(data, expected.data) << at(p);
      for (size_t i = 0; i < 16; ++i) {
        if ((expected.halves >> i / 8 & 1) != 0) lines_[expected.address][i] = expected.data[i];
      }
    } else {
      for (int i = 0; i < expected.lines; ++i)
        due_[p].push_back({lines_.at(expected.address + static_cast<uint64_t>(i)), expected.halves});
    }
    memory.request(request.write != 0, request.address, static_cast<int>(request.tag), data.data(), expected.lines,
                   static_cast<int>(request.halves));
    order.push_back(p);
    lengths.push_back(expected.lines);
    cycles.push_back(bench_.cycle);
  }
  void answer() {
    auto& dut = bench_.dut;
    ASSERT_EQ(dut.rsp_valid_o & (dut.rsp_valid_o - 1), 0u) << "two ports answered at once, cycle " << bench_.cycle;
    for (int p = 0; p < ports; ++p) {
      if (!((dut.rsp_valid_o >> p) & 1)) continue;
      MemoryLine data;
      read_port(dut.rsp_data_o, data.data());
      ASSERT_FALSE(due_[p].empty()) << "port " << p << ": an answer to nothing, cycle " << bench_.cycle;
      for (size_t i = 0; i < 16; ++i) {
        if ((due_[p].front().halves >> i / 8 & 1) != 0) { ASSERT_EQ(data[i], due_[p].front().line[i]) << at(p); }
      }
      due_[p].pop_front();
      ++answers;
    }
  }

  Bench<Vpipegs_memory_arbiter>& bench_;
  std::map<uint64_t, int> owner_;  // of the sixteen lines at an address / 16
  std::map<uint64_t, MemoryLine> lines_;
  std::vector<uint64_t> bases_;
  std::vector<bool> up_ = std::vector<bool>(static_cast<size_t>(ports));
  std::vector<std::deque<Request>> taken_{static_cast<size_t>(ports)};
  std::vector<std::deque<Due>> due_{static_cast<size_t>(ports)};
  MemoryRequest last_{};
  MemoryLine last_data_{};
  bool shown_ = false;
};

TEST(MemoryArbiter, EveryRequestLeavesOnceAndEveryAnswerComesBackAtEveryPace) {
  for (const Pace pace : kPaces) {
    for (const Pace memory_pace : kPaces) {
      Bench<Vpipegs_memory_arbiter> bench;
      Requesters all(bench, pace, memory_pace, {.latency = 10, .bytes_per_cycle = 48, .jitter = 60, .queue = 8});
      bench.reset();
      uint64_t reads = 0, requests = 0;
      for (int p = 0; p < all.ports; ++p) {
        const int count = p % 4 == 3 ? 20 : 150;  // some ports fall silent while others go on
        for (int i = 0; i < count; ++i) {
          const bool write = p < all.writers && bench.rng() % 2 == 0;
          all.push(p, write);
          reads += write ? 0 : static_cast<uint64_t>(all.waiting[p].back().lines), ++requests;
        }
      }
      bench.run_until([&] { return all.finished(); });
      for (int i = 0; i < 20; ++i) bench.step();  // and nothing more
      EXPECT_EQ(all.order.size(), requests);
      EXPECT_EQ(all.answers, reads);
      if (HasFailure()) { FAIL() << "requests " << to_text(pace) << ", memory " << to_text(memory_pace); }
    }
  }
}

// What was taken before leaves, answers still come, and nothing else is taken.
TEST(MemoryArbiter, TakesNothingWhenItIsStopped) {
  for (const Pace memory_pace : kPaces) {
    Bench<Vpipegs_memory_arbiter> bench;
    Requesters all(bench, Pace::kAlways, memory_pace, {.latency = 10, .bytes_per_cycle = 48, .queue = 8});
    bench.reset();
    for (int p = 0; p < all.ports; ++p)
      for (int i = 0; i < 50; ++i) all.push(p, false, 1);
    for (int i = 0; i < 200; ++i) bench.step();
    bench.dut.stop_i = 1;
    size_t waiting = 0, still = 0;
    for (const auto& queue : all.waiting) waiting += queue.size();
    for (int i = 0; i < 200; ++i) bench.step();
    for (const auto& queue : all.waiting) still += queue.size();
    EXPECT_GT(waiting, 0u);
    EXPECT_EQ(still, waiting);
    const size_t left = all.order.size();
    EXPECT_EQ(left, static_cast<size_t>(50 * all.ports) - waiting);
    EXPECT_EQ(all.answers, left);
    EXPECT_EQ(bench.dut.mem_valid_o, 0);
  }
}

TEST(MemoryArbiter, MovesOneRequestPerCycleAndServesWritersAndTheDopuFirst) {
  Bench<Vpipegs_memory_arbiter> bench;
  Requesters all(bench, Pace::kAlways, Pace::kAlways, {.latency = 10, .bytes_per_cycle = 64, .queue = 64});
  bench.reset();
  constexpr int kEach = 20;
  for (int p = 0; p < all.ports; ++p)
    for (int i = 0; i < kEach; ++i) all.push(p, p < all.writers && i % 2 == 0, 1);
  bench.run_until([&] { return all.finished(); });
  ASSERT_EQ(all.order.size(), static_cast<size_t>(kEach * all.ports));
  EXPECT_EQ(all.cycles.back() - all.cycles.front(), all.order.size() - 1);
  // Three classes: these, the colours, the geometry; of each class each port in its turn.
  const int units = all.config.units;
  const auto class_of = [&](int port) {
    return port < all.writers || port == all.ports - 1 ? 0 : port < all.writers + units ? 2 : 1;
  };
  const int sizes[] = {all.writers + 1, units, units};
  int i = 0;
  for (int number = 0; number < 3; ++number) {
    const int begin = i;
    for (; i < begin + kEach * sizes[number]; ++i) {
      if (units == 1 && number > 0) {  // a port is not served twice while another one asks
        if (i + 1 < static_cast<int>(all.order.size())) {
          ASSERT_NE(all.order[i], all.order[i + 1]) << "request " << i;
        }
        continue;
      }
      ASSERT_EQ(class_of(all.order[i]), number) << "request " << i;
      const int turn = sizes[number];
      if (i >= begin + turn + (number == 0 ? 0 : turn)) ASSERT_EQ(all.order[i], all.order[i - turn]) << "request " << i;
    }
  }
}

// A burst of geometry of n lines takes n turns: of geometry, not of what others ask for meanwhile.
TEST(MemoryArbiter, BurstsOfGeometryTakeAsManyTurnsAsTheyHaveLines) {
  for (const bool others : {false, true}) {
    Bench<Vpipegs_memory_arbiter> bench;
    Requesters all(bench, Pace::kAlways, Pace::kAlways, {.latency = 10, .bytes_per_cycle = 64, .queue = 1000});
    bench.reset();
    const int units = all.config.units, color = all.writers + units;
    for (int i = 0; i < 200; ++i) all.push(all.writers + static_cast<int>(bench.rng() % 4) % units, false);
    uint64_t asked = 0;
    bench.run_until([&] {
      if (others && bench.rng() % 6 == 0) all.push(color, false, 1), ++asked;
      if (others && bench.rng() % 9 == 0) all.push(0, true), ++asked;
      return all.finished();
    });
    EXPECT_EQ(all.order.size(), 200 + asked);
    uint64_t last = 0, turns = 0, lines = 0, late = 0;
    for (size_t i = 0; i < all.order.size(); ++i) {
      if (all.order[i] < all.writers || all.order[i] >= color) continue;
      if (turns != 0) {
        ASSERT_GE(all.cycles[i] - last, turns) << "request " << i;
        if (!others) { ASSERT_EQ(all.cycles[i] - last, turns) << "request " << i; }
        late += all.cycles[i] - last - turns;
      }
      last = all.cycles[i], turns = static_cast<uint64_t>(all.lengths[i]), lines += turns;
    }
    EXPECT_LE(late, others ? 4 * asked : 0);
    EXPECT_GT(lines, 500u);
  }
}

}  // namespace
}  // namespace pipegs
