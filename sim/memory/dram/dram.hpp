// SPDX-License-Identifier: Apache-2.0
// dram.hpp: the memory outside the chip as DRAM: lines of 64 bytes go in, reads come back when the DRAM has them.
//
// Idea    A line, or half of one, is cut into bursts of the DRAM, each goes to its channel (dram_channel.hpp). Lines
//         enter in order: one that meets a full queue waits at the front, and those behind it wait too, so that
//         `ready()` does not depend on an address. A read is done when its last burst has arrived; a write is done when
//         it is accepted, and a read that follows a waiting write to the same line is answered from it. Only timing is
//         kept here, no contents. Nothing is allocated after construction; a step in which nothing can happen is one
//         comparison.
// Units   step() is one cycle of the machine; inside, cycles of the DRAM.
// Docs    docs/cycles/memory_timing.md
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/memory/dram/dram_channel.hpp"
#include "sim/memory/dram/dram_place.hpp"
#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

// Read latencies in cycles of the machine.
class LatencyHistogram {
 public:
  void add(int64_t cycles) {
    const auto bin = static_cast<std::size_t>(cycles);
    ++bins_[bin < bins_.size() ? bin : bins_.size() - 1];
    ++count_;
    sum_ += cycles;
    if (cycles > max_) max_ = cycles;
  }
  uint64_t count() const { return count_; }
  std::vector<uint64_t> reads() const;  // by latency, 0 to the longest; the last one holds all that are longer
  int64_t max() const { return max_; }
  double mean() const { return count_ == 0 ? 0 : static_cast<double>(sum_) / static_cast<double>(count_); }
  int64_t percentile(double percent) const;  // the smallest latency that this part of the reads does not exceed

 private:
  std::array<uint64_t, 4096> bins_{};  // the last one holds all that are longer
  uint64_t count_ = 0;
  int64_t sum_ = 0, max_ = 0;
};

class Dram {
 public:
  struct Statistics {
    uint64_t reads = 0, writes = 0;                            // lines accepted
    uint64_t bursts_read = 0, bursts_written = 0;              // over the pins
    uint64_t reads_forwarded = 0, writes_merged = 0;           // bursts served by a waiting write
    uint64_t row_hits = 0, row_misses = 0, row_conflicts = 0;  // row open, bank closed, other row open
    uint64_t activates = 0, precharges = 0, refreshes = 0;
    uint64_t data_bus_busy = 0;  // cycles of the DRAM, summed over the channels
    double data_bus_share = 0;   // of all cycles of all channels
    double latency_mean = 0;     // of reads, from request() to done(), in cycles of the machine
    int64_t latency_p50 = 0, latency_p90 = 0, latency_p99 = 0, latency_max = 0;
  };

  explicit Dram(const DramTiming& timing, double machine_clock_ghz = 1.0);

  bool ready() const { return waiting_ < timing_.front_queue && free_ >= 0; }  // may a line be given now
  // Only if ready; `id` names a read. `halves`: which 32 bytes of the line are needed, of which bursts may be fewer.
  void request(bool write, uint64_t line, uint32_t id, int halves = 3);
  void step() {
    if (const DramCycle until = dram_cycle(++step_); until >= next_all_) advance(until);
  }
  bool done(uint32_t& id) {  // pops a read that has arrived by now, in order of arrival
    return arrived_ != 0 && pop(id);
  }
  bool idle() const;  // no line waits, no burst is on its way

  Statistics statistics() const;
  const LatencyHistogram& read_latency() const { return latency_; }
  int64_t cycles() const { return step_; }  // of the machine
  double seconds() const { return static_cast<double>(step_) * 1e-9 / machine_clock_ghz_; }
  double achieved_gbps() const;  // bytes over the pins by time
  const DramTiming& timing() const { return timing_; }

 private:
  struct Line {  // a read that is on its way or not yet popped
    uint32_t id;
    int32_t left;   // bursts; the next free slot while unused
    int64_t since;  // cycle of the machine
  };
  struct Waiting {
    uint64_t burst;   // the first one not yet in a channel
    DramPlace place;  // of this burst
    int32_t left;     // bursts
    uint32_t slot;
    bool write;
  };

  void advance(DramCycle until);
  bool offer(Waiting& waiting, DramCycle now);
  void arrive(uint32_t slot);
  bool pop(uint32_t& id);
  DramCycle dram_cycle(int64_t step) const { return static_cast<DramCycle>(static_cast<double>(step) * ratio_ + 1e-6); }

  DramTiming timing_;
  double machine_clock_ghz_, ratio_;  // cycles of the DRAM in one of the machine
  DramPlaces places_;
  int bursts_per_line_, line_shift_;  // 64-byte line to its first burst: left shift if positive
  int64_t step_ = 0;

  std::vector<DramChannel> channels_;
  std::array<DramCycle, 32> next_{};
  DramCycle next_all_ = 0;

  std::vector<Waiting> front_;  // a ring
  int first_waiting_ = 0, waiting_ = 0;
  std::vector<Line> lines_;
  int32_t free_ = 0;
  std::vector<uint32_t> arrivals_;  // a ring of slots
  uint32_t first_arrival_ = 0, arrived_ = 0;

  uint64_t reads_ = 0, writes_ = 0;
  LatencyHistogram latency_;
};

}  // namespace pipegs
