// SPDX-License-Identifier: Apache-2.0
// axi_timing.hpp: when an AXI4 subordinate with a memory behind it answers, without contents: for AxiMemory and for the
// timing model.
//
// Idea    A MemoryTiming (memory_timing.hpp) takes one line per cycle, reads and writes in the order in which they
//         came, and says when a read answers; its beats leave one after the other, lines never mixed. A write is in
//         memory when the timing takes it and answered `write_latency` cycles later.
// Rule    In each cycle: step(); then what it shows holds; read() and write() for what is accepted in it; end().
// Units   Cycles of the machine's clock; lines of 64 bytes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "sim/memory/memory_timing.hpp"
#include "sim/memory/ring.hpp"

namespace pipegs {

struct AxiLine {  // on its way to the timing
  bool write = false;
  uint64_t line = 0;
  uint32_t id = 0;
  bool last = true;  // of its burst
  int halves = 3;    // of the line that is read
};

class AxiTiming {
 public:
  // data_w: bits of the bus, 128, 256 or 512.
  AxiTiming(const ExternalMemoryOptions& options, int data_w, int write_latency);

  void step();  // the next cycle begins

  // What shows in this cycle.
  bool ready() const { return ready_; }                      // AR, AW and W
  bool beat() const { return beat_ > 0; }                    // R is valid
  bool line_ends() const { return beat_ == beats(shown_); }  // with the last beat of a line
  const AxiLine& beat_line() const { return shown_; }
  bool answer() const { return answer_; }  // B is valid

  // What is accepted in this cycle; a write when both its address and its last beat have come.
  void read(uint64_t line, int lines, uint32_t id, int halves = 3);
  void write(uint64_t line, uint32_t id) { asks_.push_back({true, line, id, true}); }
  // The cycle is over; R and B are taken if they are ready. What the timing has taken in it, if anything.
  std::optional<AxiLine> end(bool r_ready, bool b_ready);

  const Dram* dram() const { return timing_->dram(); }

 private:
  int beats(const AxiLine& line) const { return line.halves == 3 ? beats_ : (beats_ + 1) / 2; }

  std::unique_ptr<MemoryTiming> timing_;
  int beats_, write_latency_;
  int64_t now_ = 0;
  bool ready_ = false, answer_ = false;
  int beat_ = 0;                          // shown, counted from 1; 0: none
  AxiLine shown_;                         // its line
  Ring<AxiLine> asks_;                    // that the timing did not take
  std::array<Ring<AxiLine>, 256> asked_;  // of each tag of the timing, oldest first
  Ring<AxiLine> back_;                    // that it has answered
  int sent_ = 0;                          // beats of the first of them that were taken
  Ring<int64_t> answers_;                 // of each write that is in memory: when it may be answered
};

}  // namespace pipegs
