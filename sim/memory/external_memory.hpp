// SPDX-License-Identifier: Apache-2.0
// external_memory.hpp: the memory outside the chip, as lines of 64 bytes behind one port.
//
// Idea    Contents behind a MemoryTiming (memory_timing.hpp), which says when the port is ready and when a read
//         answers.
//         Requests take effect in the order in which they are accepted; only the answers come later. Bytes and requests
//         are counted by tag.
// Rule    A request behind the last line throws MemoryFault, and so does a write of a line of which a read is not
//         answered: on a bus nothing says which of them goes first.
// Units   Cycles of the machine's clock. Paper: Sec. 5.1 (off-chip memory).
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "cpp_model/memory_line.hpp"
#include "sim/memory/memory_pages.hpp"
#include "sim/memory/memory_timing.hpp"

namespace pipegs {

// What no machine may ask of its memory.
struct MemoryFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ExternalMemory {
 public:
  explicit ExternalMemory(const ExternalMemoryOptions& options = {});

  struct Answer {
    int tag;
    MemoryLine data;
  };
  struct Traffic {
    uint64_t lines_read = 0, lines_written = 0;
  };

  bool ready() const { return timing_->ready(); }                             // may a request be accepted in this cycle
  void request(bool write, uint64_t address, int tag, const uint32_t* data);  // accepted in this cycle
  const Answer* answer() const { return shown_ ? &*shown_ : nullptr; }        // the answer shown in this cycle, if any
  void step();                                                                // the next cycle begins

  void set_lines(uint64_t lines) { size_ = lines; }  // of the memory, from line 0 on; without a call it has no end

  void allow_overwrites() { overwrites_ = true; }  // of lines that are being read: they are, behind the read

  // Contents, for host access; untouched lines hold zero.
  const MemoryLine& line(uint64_t address) const { return pages_.line(address); }
  MemoryLine& line(uint64_t address) { return pages_.line(address); }
  const std::array<Traffic, 256>& traffic() const { return traffic_; }
  const Dram* dram() const { return timing_->dram(); }  // for its statistics, if the memory is one
  uint64_t busy_line_cycles() const { return lines_; }  // lines that crossed the pins

 private:
  struct Read {
    uint64_t line;
    MemoryLine data;
  };

  std::unique_ptr<MemoryTiming> timing_;
  MemoryPages pages_;
  std::array<std::deque<Read>, 256> read_;             // of each tag: lines read and not answered yet
  std::unordered_map<uint64_t, uint32_t> unanswered_;  // of each line that is read: how often
  uint64_t size_ = ~uint64_t{0};
  bool overwrites_ = false;
  std::array<Traffic, 256> traffic_{};
  uint64_t lines_ = 0;
  std::optional<Answer> shown_;
};

}  // namespace pipegs
