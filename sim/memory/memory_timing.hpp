// SPDX-License-Identifier: Apache-2.0
// memory_timing.hpp: when the memory outside the chip answers, without its contents: one port for RTL and timing model.
//
// Idea    ExternalMemory (contents, for the RTL) and the timing model drive the same object, so that both see the same
//         memory. PinsTiming is the ideal one: each line costs 64 / bytes_per_cycle cycles of the pins, half a line
//         that is read half as many; a read answers after `latency` cycles plus a random jitter of up to `jitter`
//         cycles, never before an earlier read of the same tag. When `queue` lines wait for the pins the port is not
//         ready. DramMemory (dram_memory.hpp) is a DRAM with its channels, banks and rows.
// Rule    In each cycle: step, then at most one request, only when ready; a read is of up to eight lines in a row. At
//         most one line is answered per cycle; answers of one tag keep their order.
// Units   Cycles of the machine's clock. Paper: Sec. 5.1 (off-chip memory).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <queue>
#include <random>
#include <string>
#include <vector>

#include "sim/memory/ring.hpp"

namespace pipegs {

class Dram;

struct ExternalMemoryOptions {
  std::string dram = "ideal";     // dram_memory_names(), at a machine clock of 1 GHz, or "ideal"
  int latency = 100;              // ideal: cycles from acceptance to answer when nothing waits
  double bytes_per_cycle = 51.2;  // ideal: of the pins
  int jitter = 0;                 // ideal: largest random delay added to an answer
  int queue = 64;                 // ideal: lines that wait for the pins, from which on the port is not ready
  uint64_t seed = 1;
  int path = 20;           // DRAM: cycles between machine and channels, there and back
  int write_latency = 20;  // behind a bus: cycles until a line that is written is answered
  bool harsh = false;      // behind a bus: all that AXI4 allows and a machine may stumble over, see axi_memory.hpp
};

class MemoryTiming {
 public:
  static constexpr int kNoAnswer = -1;

  virtual ~MemoryTiming() = default;
  virtual int step() = 0;          // the next cycle begins: tag of the line answered in it
  virtual bool ready() const = 0;  // may a request be accepted in this cycle
  // Accepted in this cycle: a write of one line, or a read of `lines` of them from `line` on. Tags 0 to 255. `halves`:
  // which 32 bytes a read of one line needs, the low ones in bit 0; all of others.
  virtual void request(bool write, uint64_t line, int tag, int lines, int halves = 3) = 0;
  // Both at once, for a port whose readiness depends on what is asked: was it accepted? At most once in a cycle.
  virtual bool offer(bool write, uint64_t line, int tag, int lines, int halves = 3) {
    if (!ready()) return false;
    request(write, line, tag, lines, halves);
    return true;
  }
  virtual const Dram* dram() const { return nullptr; }  // for its statistics, if it is one
};

class PinsTiming final : public MemoryTiming {
 public:
  explicit PinsTiming(const ExternalMemoryOptions& options);

  int step() override;
  bool ready() const override { return starts_.size() < static_cast<size_t>(options_.queue); }  // those wait
  void request(bool write, uint64_t line, int tag, int lines, int halves = 3) override;

 private:
  struct Pending {
    double due;
    uint64_t order;
    int tag;
    bool operator>(const Pending& other) const { return due != other.due ? due > other.due : order > other.order; }
  };

  void add(bool write, int tag, double cycles);  // one line, so long on the pins

  ExternalMemoryOptions options_;
  double cycles_per_line_;
  std::mt19937_64 rng_;
  double now_ = 0, pins_free_ = 0;
  Ring<double> starts_;  // of those: when each gets the pins
  uint64_t order_ = 0;
  Ring<Pending> answers_;  // without jitter answers come in the order of the requests
  std::priority_queue<Pending, std::vector<Pending>, std::greater<>> shuffled_;  // with jitter
  std::array<double, 256> last_due_{};  // per tag: answers of one tag stay in order
};

// Throws std::invalid_argument for an unknown preset or options out of range.
double memory_peak(const ExternalMemoryOptions& options);  // bytes per cycle at the pins
std::unique_ptr<MemoryTiming> memory_timing(const ExternalMemoryOptions& options);

}  // namespace pipegs
