// SPDX-License-Identifier: Apache-2.0
// external_memory.hpp: the memory outside the chip, as lines of 64 bytes behind one port.
//
// Idea    Contents behind a MemoryTiming (memory_timing.hpp), which says when the port is ready and when a read
//         answers.
//         Requests take effect in the order in which they are accepted; only the answers come later. Lines and bursts
//         are counted by tag.
// Units   Cycles of the machine's clock. Paper: Sec. 5.1 (off-chip memory).
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "cpp_model/memory_line.hpp"
#include "sim/memory/memory_pages.hpp"
#include "sim/memory/memory_timing.hpp"

namespace pipegs {

class ExternalMemory {
 public:
  explicit ExternalMemory(const ExternalMemoryOptions& options = {});

  struct Answer {
    int tag;
    MemoryLine data;
  };
  struct Traffic {
    uint64_t lines_read = 0, lines_written = 0;
    uint64_t bursts = 0;  // reads, each of one to eight lines in a row
  };

  bool ready() const { return timing_->ready(); }  // may a request be accepted in this cycle
  // Accepted in this cycle: a write of one line, or a read of `lines` of them, which are answered one by one.
  void request(bool write, uint64_t address, int tag, const uint32_t* data, int lines = 1);
  const Answer* answer() const { return shown_ ? &*shown_ : nullptr; }  // the answer shown in this cycle, if any
  void step();                                                          // the next cycle begins

  // Contents, for host access; untouched lines hold zero.
  const MemoryLine& line(uint64_t address) const { return pages_.line(address); }
  MemoryLine& line(uint64_t address) { return pages_.line(address); }
  const std::array<Traffic, 256>& traffic() const { return traffic_; }
  const Dram* dram() const { return timing_->dram(); }  // for its statistics, if the memory is one
  uint64_t busy_line_cycles() const { return lines_; }  // lines that crossed the pins

 private:
  std::unique_ptr<MemoryTiming> timing_;
  MemoryPages pages_;
  std::array<std::deque<MemoryLine>, 256> read_;  // of each tag: lines read and not answered yet
  std::array<Traffic, 256> traffic_{};
  uint64_t lines_ = 0;
  std::optional<Answer> shown_;
};

}  // namespace pipegs
