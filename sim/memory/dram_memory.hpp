// SPDX-License-Identifier: Apache-2.0
// dram_memory.hpp: a DRAM behind the machine's memory port.
//
// Idea    Lines go to the DRAM (sim/memory/dram/dram.hpp) in the order in which they are accepted, those of one request
//         in the same cycle as far as it takes them. Answers of one tag keep their order: a line that comes back early
//         waits for those before it, in a buffer beside the controller.
//         One answer per cycle. `path` cycles are added to every answer for the way between the machine and the
//         channels.
// Units   Cycles of the machine's clock, 1 GHz.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/memory/dram/dram.hpp"
#include "sim/memory/memory_timing.hpp"
#include "sim/memory/ring.hpp"

namespace pipegs {

// The preset of this name with the controller of this machine: channels take turns with every 64-byte line, so that a
// line opens one row only; bank groups are spread (RoBaCoGrCh); a bank stays open while hits wait; 64 reads and 64
// writes wait in each channel, and writes leave in long runs (docs/cycles/memory_timing.md). Throws
// std::invalid_argument for an unknown name.
DramTiming dram_memory_timing(const std::string& name);

class DramMemory final : public MemoryTiming {
 public:
  explicit DramMemory(const ExternalMemoryOptions& options);

  int step() override;
  bool ready() const override { return lines_left_ == 0 && dram_.ready() && flying_ < kFlying; }
  void request(bool write, uint64_t line, int tag, int lines, int halves = 3) override;
  const Dram* dram() const override { return &dram_; }

 private:
  static constexpr uint32_t kFlying = 1024;  // lines asked for and not answered yet
  struct Read {
    int tag = 0;
    bool back = false;  // from the DRAM
  };
  struct Due {
    int64_t cycle;
    int tag;
  };

  void enter();  // lines of the request accepted last, as many as the DRAM takes

  Dram dram_;
  int path_;
  int64_t now_ = 0;
  uint64_t next_line_ = 0;  // of a read: the next line that the DRAM has not taken, and how many there are
  int lines_left_ = 0, tag_ = 0, halves_ = 3;
  uint32_t flying_ = 0;
  std::array<Read, kFlying> reads_{};
  Ring<uint32_t> free_;
  std::array<Ring<uint32_t>, 256> order_;  // of each tag: its lines, oldest first
  Ring<Due> due_;                          // answers on their way to the machine
};

}  // namespace pipegs
