// SPDX-License-Identifier: Apache-2.0
// bench.hpp: drives one Verilated module: clock, reset, streams at random paces, memory, waves.
//
// A Bench owns the module and a list of endpoints. In each cycle every endpoint sets its inputs while the clock is low,
// the module settles, every endpoint looks at the handshakes, and the clock rises. Registers start from random values.
//   PIPEGS_SEED=n       another seed (printed with every failure)
//   PIPEGS_WAVES=f.fst  waves of the run (NAME_waves_test)
// Example: Bench<Vpipegs_fifo> bench;  RecordSource<Chunk> in(bench, config, bench.dut.in_valid_i, ...);
// bench.reset(); ...
#pragma once

#include <gtest/gtest.h>
#include <verilated.h>

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "cpp_model/records.hpp"
#include "sim/memory/external_memory.hpp"
#include "sim/rtl/pins/ports.hpp"
#include "verif/support/waves.hpp"

namespace pipegs {

using Words = std::vector<uint32_t>;

inline uint64_t test_seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

template <class R, class Port>
void write_record(const Config& config, Port& port, const R& record) {
  Words words(std::max<size_t>(record_words<R>(config), port_words<Port>()));
  pack(config, record, words.data());
  write_port(port, words.data());
}
template <class R, class Port>
R read_record(const Config& config, const Port& port) {
  Words words(port_words<Port>() + 2);
  read_port(port, words.data());
  return unpack<R>(config, words.data());
}

// How eager a source or a sink is. A lazy sink is ready only for what was shown in the cycle before and not taken: who
// waits for its ready before showing anything waits for ever. A lazy source is one by coin.
enum class Pace { kAlways, kQuarter, kCoin, kLazy };
inline constexpr Pace kPaces[] = {Pace::kAlways, Pace::kQuarter, Pace::kCoin, Pace::kLazy};
inline const char* to_text(Pace pace) {
  constexpr const char* kNames[] = {"always", "one in four", "coin", "lazy"};
  return kNames[static_cast<int>(pace)];
}
template <class Rng>
bool goes(Pace pace, Rng& rng) {
  return pace == Pace::kAlways || (pace == Pace::kQuarter ? rng() % 4 == 0 : rng() % 2 == 0);
}

class Endpoint {
 public:
  virtual ~Endpoint() = default;
  virtual void drive() = 0;    // the clock is low: set the module's inputs
  virtual void observe() = 0;  // the module has settled: look at the handshake that the coming edge completes
};

class BenchBase {
 public:
  explicit BenchBase(uint64_t seed) : seed(seed), rng(seed) {
    context.randReset(2);  // registers and memories start from noise
    context.randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    context.assertOn(true);
  }
  void add(Endpoint& endpoint) { endpoints_.push_back(&endpoint); }

  VerilatedContext context;
  uint64_t seed;
  std::mt19937_64 rng;
  uint64_t cycle = 0;

 protected:
  std::vector<Endpoint*> endpoints_;
};

// What a test looks at, or sets, beside its streams.
class Beside : public Endpoint {
 public:
  Beside(
      BenchBase& bench, std::function<void()> observe, std::function<void()> drive = [] {})
      : observe_(std::move(observe)), drive_(std::move(drive)) {
    bench.add(*this);
  }
  void drive() override { drive_(); }
  void observe() override { observe_(); }

 private:
  std::function<void()> observe_, drive_;
};

template <class Dut>
class Bench : public BenchBase {
 public:
  explicit Bench(uint64_t seed = test_seed()) : BenchBase(seed), dut(&context), waves_(context, dut) {}
  ~Bench() {
    if (testing::Test::HasFailure()) print_replay(seed);
  }

  void reset(int cycles = 3) {
    set_reset(0);
    for (int i = 0; i < cycles; ++i) step();
    set_reset(1);
  }

  // One clock cycle. During reset the endpoints are quiet.
  void step() {
    dut.clk_i = 0;
    const bool running = running_;
    if (running)
      for (Endpoint* endpoint : endpoints_) endpoint->drive();
    dut.eval();
    waves_.dump(cycle * 10);
    if (running)
      for (Endpoint* endpoint : endpoints_) endpoint->observe();
    dut.clk_i = 1;
    dut.eval();
    waves_.dump(cycle * 10 + 5);
    ++cycle;
  }

  // Steps until done() or, with a test failure, until `limit` more cycles have passed.
  bool run_until(const std::function<bool()>& done, uint64_t limit = 100000) {
    for (const uint64_t end = cycle + limit; cycle < end;) {
      if (done()) return true;
      step();
    }
    ADD_FAILURE() << "nothing more came within " << limit << " cycles (cycle " << cycle << ", seed " << seed << ")";
    return false;
  }

  Dut dut;

 private:
  void set_reset(CData value) {
    if constexpr (requires { dut.rst_ni; }) dut.rst_ni = value;
    running_ = value != 0;
  }

  UnitWaves<Dut> waves_;
  bool running_ = true;
};

// Feeds beats into a stream input. Valid, once up, stays with the same beat until it is taken.
template <class Port>
class WordSource : public Endpoint {
 public:
  WordSource(BenchBase& bench, CData& valid, const CData& ready, Port& port, Pace pace = Pace::kAlways)
      : bench_(bench), valid_(valid), ready_(ready), port_(port), pace(pace) {
    valid_ = 0;
    bench.add(*this);
  }
  void push(Words words) {
    words.resize(std::max(words.size(), port_words<Port>()));
    beats.push_back(std::move(words));
  }
  void drive() override {
    if (!up_ && !beats.empty() && goes(pace, bench_.rng)) up_ = true;
    valid_ = up_;
    if (up_) {
      write_port(port_, beats.front().data());
    } else {  // data beside a low valid is noise: nobody may look at it
      Words noise(port_words<Port>() + 1);
      write_port(port_, noise.data());
    }
  }
  void observe() override {
    if (!up_ || !ready_) return;
    beats.pop_front();
    up_ = false;
    ++taken;
  }
  bool empty() const { return beats.empty(); }

  std::deque<Words> beats;
  uint64_t taken = 0;

 private:
  BenchBase& bench_;
  CData& valid_;
  const CData& ready_;
  Port& port_;
  bool up_ = false;

 public:
  Pace pace;
};

template <class R, class Port>
class RecordSource : public WordSource<Port> {
 public:
  RecordSource(BenchBase& bench, const Config& config, CData& valid, const CData& ready, Port& port,
               Pace pace = Pace::kAlways)
      : WordSource<Port>(bench, valid, ready, port, pace), config_(config) {}
  void push(const R& record) {
    Words words(record_words<R>(config_) + 1);
    pack(config_, record, words.data());
    WordSource<Port>::push(std::move(words));
  }

 private:
  Config config_;
};

// Collects the beats of a stream output, with the cycle in which each was taken.
template <class Port>
class WordSink : public Endpoint {
 public:
  WordSink(BenchBase& bench, const CData& valid, CData& ready, const Port& port, Pace pace = Pace::kAlways)
      : pace(pace), bench_(bench), valid_(valid), ready_(ready), port_(port) {
    ready_ = 0;
    bench.add(*this);
  }
  void drive() override { ready_ = (pace != Pace::kLazy || shown_) && goes(pace, bench_.rng); }
  void observe() override {
    Words words(port_words<Port>() + 1);
    if (valid_) read_port(port_, words.data());
    if (shown_) {  // the stream rule: valid stays up, the beat stays the same
      EXPECT_TRUE(valid_) << "valid fell before the beat was taken, cycle " << bench_.cycle;
      if (valid_) { EXPECT_EQ(words, last_) << "the beat changed before it was taken, cycle " << bench_.cycle; }
    }
    shown_ = valid_ && !ready_;
    last_ = words;
    if (!valid_ || !ready_) return;
    beats.push_back(std::move(words));
    cycles.push_back(bench_.cycle);
  }

  std::vector<Words> beats;
  std::vector<uint64_t> cycles;
  Pace pace;

 private:
  BenchBase& bench_;
  const CData& valid_;
  CData& ready_;
  const Port& port_;
  Words last_;
  bool shown_ = false;
};

template <class R, class Port>
class RecordSink : public WordSink<Port> {
 public:
  RecordSink(BenchBase& bench, const Config& config, const CData& valid, CData& ready, const Port& port,
             Pace pace = Pace::kAlways)
      : WordSink<Port>(bench, valid, ready, port, pace), config_(config) {}
  size_t size() const { return this->beats.size(); }
  R at(size_t i) const { return unpack<R>(config_, this->beats.at(i).data()); }

 private:
  Config config_;
};

// An external memory behind a unit's port. `write` and `data` are null for a port that only reads, `lines` (of a read,
// less one) for one that asks for single lines.
template <class AddressPort, class LinePort>
class MemoryEndpoint : public Endpoint {
 public:
  MemoryEndpoint(BenchBase& bench, ExternalMemory& memory, const CData& valid, CData& ready, const CData* write,
                 const AddressPort& address, const LinePort* data, CData& answer_valid, LinePort& answer,
                 Pace pace = Pace::kAlways, const CData* lines = nullptr)
      : pace(pace),
        bench_(bench),
        memory_(memory),
        valid_(valid),
        ready_(ready),
        write_(write),
        address_(address),
        data_(data),
        answer_valid_(answer_valid),
        answer_(answer),
        lines_(lines) {
    ready_ = 0;
    answer_valid_ = 0;
    bench.add(*this);
  }
  void drive() override {
    memory_.step();
    ready_ = memory_.ready() && (pace != Pace::kLazy || shown_) && goes(pace, bench_.rng);
    const ExternalMemory::Answer* answer = memory_.answer();
    answer_valid_ = answer != nullptr;
    if (answer != nullptr) write_port(answer_, answer->data.data());
  }
  void observe() override {
    shown_ = valid_ && !ready_;
    if (!valid_ || !ready_) return;
    Words words(17);
    const bool is_write = write_ != nullptr && *write_;
    if (is_write) read_port(*data_, words.data());
    const int lines = lines_ != nullptr ? 1 + *lines_ : 1;
    EXPECT_LE(static_cast<int>(address_ % 8) + lines, 8) << "a request leaves its group, cycle " << bench_.cycle;
    memory_.request(is_write, static_cast<uint64_t>(address_), 0, words.data(), lines, halves != nullptr ? *halves : 3);
    ++requests;
    requested += static_cast<uint64_t>(lines);
  }
  uint64_t requests = 0, requested = 0;  // and their lines
  Pace pace;
  const CData* halves = nullptr;  // of a line, what a write changes; null for a port that writes whole ones

 private:
  BenchBase& bench_;
  ExternalMemory& memory_;
  const CData& valid_;
  CData& ready_;
  const CData* write_;
  const AddressPort& address_;
  const LinePort* data_;
  CData& answer_valid_;
  LinePort& answer_;
  const CData* lines_;
  bool shown_ = false;  // and not taken
};

}  // namespace pipegs
