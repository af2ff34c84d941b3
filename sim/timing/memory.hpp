// SPDX-License-Identifier: Apache-2.0
// memory.hpp: the arbiter to external memory in the timing model.
//
// RTL     rtl/buf/pipegs_memory_arbiter.sv: round robin among those that go first, then among the colours, then among
//         the bursts of geometry, for the cycle after; a register on the way out and one on the way back.
// Idea    A unit asks by setting its port's bit, which counts from the next cycle on and is cleared by the grant. The
//         unit is woken in the cycle of its grant and in the cycle of its answer.
#pragma once

#include <array>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/memory/memory_timing.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

class Memory {
 public:
  Memory(MemoryTiming& timing, const Config& config);

  // lines: of a read, in a row; halves: of the line, what a write changes or a read of one line needs, the low one in
  // bit 0.
  void ask(int port, uint64_t line, bool write = false, int lines = 1, int halves = 3) {
    wanted_ |= uint64_t{1} << port, request_[static_cast<size_t>(port)] = {line, write, lines, halves};
  }
  bool granted(int port, Cycle now) const { return granted_ == port && grant_at_ == now; }
  bool answered(int port) const { return answered_ == port; }
  void step(Machine& machine, Cycle now);  // first of all in every cycle
  void idle_step() { timing_.step(); }     // a cycle before the frame
  bool idle() const { return wanted_ == 0 && !out_valid_; }

  Cycle last_accepted() const { return last_accepted_; }
  uint64_t bursts(int port) const { return bursts_[static_cast<size_t>(port)]; }
  uint64_t halves_read(int port) const { return read_[static_cast<size_t>(port)]; }
  uint64_t halves_written(int port) const { return written_[static_cast<size_t>(port)]; }

  // Ports, see rtl/pipegs_top.sv.
  int alpha_port(int lane) const { return lane; }
  int sort_port(int lane) const { return units_ + lane; }
  int raster_port(int lane) const { return 2 * units_ + lane; }
  int list_port() const { return 3 * units_; }  // only with lists
  int geometry_port(int lane) const { return write_ports_ + lane; }
  int color_port(int lane) const { return write_ports_ + units_ + lane; }
  int node_port() const { return write_ports_ + 2 * units_; }

 private:
  static constexpr int kPorts = 42, kNone = -1;
  struct Request {
    uint64_t line = 0;
    bool write = false;
    int lines = 1;
    int halves = 3;
  };

  MemoryTiming& timing_;
  int units_, write_ports_;
  uint64_t first_;     // ports that go first: those that may write, and the DOPU's
  uint64_t geometry_;  // those that go last
  std::array<uint8_t, kPorts> grant_unit_{}, answer_unit_{};  // whom to wake
  uint64_t wanted_ = 0;
  std::array<Request, kPorts> request_{};
  int pause_ = 0;       // cycles for which no geometry is asked for
  int chosen_ = kNone;  // granted in this cycle if it asks
  Arbiter arbiter_;
  bool out_valid_ = false;
  int out_port_ = 0;
  Request out_;
  int granted_ = kNone, answered_ = kNone, coming_ = kNone;
  Cycle grant_at_ = kLongAgo, last_accepted_ = 0;
  std::array<uint64_t, kPorts> bursts_{}, read_{}, written_{};
};

}  // namespace pipegs::timing
