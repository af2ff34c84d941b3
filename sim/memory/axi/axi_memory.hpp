// SPDX-License-Identifier: Apache-2.0
// axi_memory.hpp: an AXI4 subordinate with a memory behind it.
//
// Idea    Two behaviours over the same contents. `harsh` does what AXI4 allows: a write is applied hundreds of cycles
//         after its last beat and answered later still, answers of different IDs overtake each other, beats of one ID
//         stand between those of another, each ready falls at random. A read looks at the memory when its address is
//         taken or when its beat leaves, by chance. Otherwise an AxiTiming (axi_timing.hpp) says when what happens: a
//         read looks at the memory, and a write is applied, when it takes the line.
// Rule    In each cycle: step(), then observe() with what the manager shows. The manager is checked (axi_rules.hpp).
//         The memory has a place and a size: what lies outside is answered DECERR and changes nothing; so are the lines
//         of `failing` with SLVERR.
// Units   Cycles of the machine's clock. Numbers of lines are byte addresses / 64.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <random>
#include <set>

#include "sim/memory/axi/axi_rules.hpp"
#include "sim/memory/axi/axi_timing.hpp"
#include "sim/memory/memory_pages.hpp"

namespace pipegs {

struct AxiMemoryOptions {
  int data_w = 512;                             // bits of the bus: 128, 256 or 512
  uint64_t base = 0, size = uint64_t{1} << 40;  // bytes: first and how many, multiples of 64
  int most_reads = 256, most_writes = 64;       // bursts of the manager that may be unanswered
  bool harsh = false;
  ExternalMemoryOptions timing = {};  // not harsh
  int read_delay = 100;               // harsh: largest random cycles until a burst may answer
  int write_delay = 400;              // harsh: largest random cycles until a write is applied, half of it the least
  int ready_percent = 70;             // harsh: chance of each ready and of each answer in a cycle
  uint64_t seed = 1;                  // harsh
};

// What a memory does not do any more, as a broken one, or a bus that lost a transfer.
struct AxiSilence {
  bool ar = false, r = false;             // takes no read; answers none
  bool aw = false, w = false, b = false;  // takes no address of a write, no data; answers no write
};

class AxiMemory {
 public:
  explicit AxiMemory(const AxiMemoryOptions& options);

  const AxiSubordinateSide& step();             // the next cycle begins: what is shown in it
  void observe(const AxiManagerSide& manager);  // what the manager shows in it

  const MemoryLine& line(uint64_t address) const { return pages_.line(address); }  // contents, for host access
  MemoryLine& line(uint64_t address) { return pages_.line(address); }
  void set_lines(uint64_t lines) { options_.size = lines * 64; }
  std::set<uint64_t> failing;           // lines that answer SLVERR
  int fail_reads = 0, fail_writes = 0;  // so many of those that are taken next answer SLVERR
  AxiSilence silence;                   // from the next step on; what it owed before comes when it ends
  bool writing() const { return !writes_.empty() || !address_.empty() || !data_.empty(); }
  bool quiet() const { return bursts_ == 0 && !writing(); }
  uint64_t lines_read() const { return lines_read_; }
  uint64_t lines_written() const { return lines_written_; }
  const Dram* dram() const { return timing_.dram(); }

 private:
  struct Line {  // of a burst that is read
    uint64_t address;
    MemoryLine data;
    bool last;     // of its burst
    bool sampled;  // data is that of the memory; else it is looked at when the line leaves
    AxiResponse response;
    int halves;
  };
  struct Reads {  // of one ID
    std::deque<Line> lines;
    std::deque<int64_t> due;  // of each of their bursts: not before this cycle
    int beat = 0;             // of the first line
  };
  struct Write {
    uint32_t id;
    uint64_t address;
    MemoryLine data, mask;
    int64_t due;  // applied
    bool applied;
    AxiResponse response;
  };
  AxiResponse response(uint64_t line, int& fail) const;
  bool chance() { return static_cast<int>(rng_() % 100) < options_.ready_percent; }
  void take_read(const AxiAddress& address);
  void sample(Line& line);
  void take_write();
  void apply(Write& write);
  void take(const AxiLine& line);
  void step_harsh();
  void step_timed();
  void show_beat(uint32_t id);
  void show_answer(uint32_t id, AxiResponse response);

  AxiMemoryOptions options_;
  AxiRules rules_;
  MemoryPages pages_;
  AxiTiming timing_;  // not harsh
  std::mt19937_64 rng_;
  AxiSubordinateSide shown_;
  int64_t now_ = 0;
  int bursts_ = 0;                   // read bursts inside
  std::map<uint32_t, Reads> reads_;  // by ID
  std::deque<AxiAddress> address_;   // of writes whose data did not come
  std::deque<AxiWriteBeat> data_;    // beats without address
  std::deque<Write> writes_;         // complete, in their order; answered ones leave
  uint64_t lines_read_ = 0, lines_written_ = 0;
};

}  // namespace pipegs
