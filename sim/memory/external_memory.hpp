// SPDX-License-Identifier: Apache-2.0
// external_memory.hpp: the memory outside the chip, as lines of 64 bytes behind one port or behind an AXI4 bus.
//
// Idea    Contents behind a MemoryTiming (memory_timing.hpp), which says when the port is ready and when a read
//         answers. Requests take effect in the order in which they are accepted; only the answers come later. With a
//         bus an AxiMemory (axi_memory.hpp) stands in the place of the port. Lines and bursts are counted by the tag of
//         the core. Half a line takes the pins as long as a whole one: the rest is masked.
// Rule    A request behind the last line throws MemoryFault, and so does a write of a line of which a read is not
//         answered: on a bus nothing says which of them goes first.
// Units   Cycles of the machine's clock. Paper: Sec. 5.1 (off-chip memory).
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>
#include <stdexcept>
#include <unordered_map>

#include "cpp_model/memory_line.hpp"
#include "sim/memory/axi/axi_memory.hpp"
#include "sim/memory/memory_pages.hpp"
#include "sim/memory/memory_timing.hpp"

namespace pipegs {

// What no machine may ask of its memory.
struct MemoryFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class ExternalMemory {
 public:
  // bus_w: bits of the bus; 0: the port.
  explicit ExternalMemory(const ExternalMemoryOptions& options = {}, int bus_w = 0);

  struct Answer {
    int tag;
    MemoryLine data;
  };
  struct Traffic {
    uint64_t lines_read = 0, lines_written = 0;
    uint64_t bursts = 0;                           // reads, each of one to eight lines in a row
    uint64_t halves_read = 0, halves_written = 0;  // of 32 bytes
  };

  bool ready() const { return timing_->ready(); }  // may a request be accepted in this cycle
  // Accepted in this cycle: a write of one line, or a read of `lines` of them, which are answered one by one. `halves`:
  // which 32 bytes a write changes, or a read of one line needs, the low ones in bit 0; the other ones of its answer
  // are noise.
  void request(bool write, uint64_t address, int tag, const uint32_t* data, int lines = 1, int halves = 3);
  const Answer* answer() const { return shown_ ? &*shown_ : nullptr; }  // the answer shown in this cycle, if any
  void step();                                                          // the next cycle begins

  AxiMemory* bus() { return bus_.get(); }  // what stands in the place of the port, or null
  // What the core's port shows, which `request` and `step` tell themselves and the harness of a bus tells: a request
  // that was accepted, and an answer to one of that tag. `forget`: the core was reset, no answer comes to it any more.
  void accept(bool write, uint64_t address, int tag, int lines, int halves);
  void answered(int tag);
  void forget();

  void load(const std::vector<MemoryLine>& lines, uint64_t first = 0);  // by the host
  void set_lines(uint64_t lines);  // of the memory, from line 0 on; without a call it has no end

  void allow_overwrites() { overwrites_ = true; }  // of lines that are being read: they are, behind the read

  // Contents, for host access; what nobody has written is noise.
  const MemoryLine& line(uint64_t address) const { return bus_ ? bus_->line(address) : pages_.line(address); }
  MemoryLine& line(uint64_t address) { return bus_ ? bus_->line(address) : pages_.line(address); }
  const std::array<Traffic, 256>& traffic() const { return traffic_; }
  const Dram* dram() const { return bus_ ? bus_->dram() : timing_->dram(); }  // for its statistics, if it is one

 private:
  std::unique_ptr<MemoryTiming> timing_;
  std::unique_ptr<AxiMemory> bus_;
  MemoryPages pages_;
  std::array<std::deque<MemoryLine>, 256> read_;       // of each tag: lines that the port will answer
  std::array<std::deque<uint64_t>, 256> asked_;        // of each tag: lines read and not answered yet
  std::unordered_map<uint64_t, uint32_t> unanswered_;  // of each line that is read: how often
  uint64_t size_ = ~uint64_t{0};
  bool overwrites_ = false;
  std::array<Traffic, 256> traffic_{};
  std::optional<Answer> shown_;
};

}  // namespace pipegs
