// SPDX-License-Identifier: Apache-2.0
// bus_timing.hpp: the AXI4 manager and the memory behind it as the core's port sees them, without contents.
//
// RTL     rtl/mem/pipegs_axi_manager.sv: the fence, one register before each of AR, AW and W, the queue of writes that
//         are not answered, one register behind R.
// Idea    A MemoryTiming like the others, so the timing model runs with or without a bus. What shows on the bus are
//         registers only, so a cycle of the bus is played when it begins, and what the core offers counts in the next.
// Units   Cycles of the machine's clock.
#pragma once

#include "cpp_model/config.hpp"
#include "sim/memory/axi/axi_timing.hpp"
#include "sim/memory/ring.hpp"

namespace pipegs {

class BusTiming final : public MemoryTiming {
 public:
  BusTiming(const ExternalMemoryOptions& options, const Config& config);

  int step() override;
  bool ready() const override { return false; }  // it depends on what is asked: see offer
  void request(bool, uint64_t, int, int, int = 3) override {}
  bool offer(bool write, uint64_t line, int tag, int lines, int halves = 3) override;
  const Dram* dram() const override { return axi_.dram(); }

 private:
  // rtl/buf/pipegs_sram_fifo.sv: a word is seen two cycles after it came.
  struct Queue {
    int stored = 0;  // in the memory and not fetched
    bool valid = false;
    int count() const { return stored + valid; }
    void clock(bool push, bool pop) {
      const bool fetch = stored > 0 && (!valid || pop);
      stored += push - fetch;
      valid = fetch || (valid && !pop);
    }
  };
  struct Read {
    uint64_t line = 0;
    int tag = 0, lines = 1, halves = 3;
    uint64_t stamp = 0;  // writes accepted before it
  };

  void clock();  // the edge at the end of the cycle before
  // What the registers say in the present cycle.
  bool address_free() const { return !aw_valid_ || aw_ready_; }
  bool last_beat() const { return w_beat_ + 1 == beats_; }
  bool data_free() const { return !w_valid_ || (w_ready_ && last_beat()); }
  bool read_free() const { return !ar_valid_ || ar_ready_; }
  bool passes(int tag) const { return tag >= write_ports_ || (waiting_.count() == 0 && writes_.count() == 0); }
  bool due() const;  // the first read in the fence may go

  AxiTiming axi_;
  int write_ports_, beats_;

  // Registers.
  bool ar_valid_ = false, aw_valid_ = false, w_valid_ = false;
  Read ar_;
  uint64_t aw_line_ = 0;
  int w_beat_ = 0;
  Queue writes_;        // not answered
  Queue waiting_;       // reads in the fence
  Ring<Read> fenced_;   // these
  uint64_t stamp_ = 0;  // writes accepted
  bool passing_ = false, leaving_ = false;
  int reads_ = 0;             // not answered
  int line_tag_ = kNoAnswer;  // the line that shows to the core

  // The present cycle: what the bus shows and what the core offers.
  bool ar_ready_ = false, aw_ready_ = false, w_ready_ = false, b_taken_ = false, read_ends_ = false;
  int line_ = kNoAnswer;      // a line that is whole with this cycle's beat
  Ring<uint64_t> addresses_;  // of writes whose data is not whole
  int data_ = 0;              // whole lines without an address
  bool offered_ = false, accepted_ = false, offered_write_ = false;
  Read offer_;
};

// The memory at the core's port: behind a bus if the machine has one.
std::unique_ptr<MemoryTiming> machine_memory_timing(const ExternalMemoryOptions& options, const Config& config);

}  // namespace pipegs
