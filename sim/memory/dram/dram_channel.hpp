// SPDX-License-Identifier: Apache-2.0
// dram_channel.hpp: one channel of DRAM with its controller: queues, banks, and one command per clock cycle.
//
// Idea    First ready, first come, first served. Each waiting burst needs one command next: a column access if its row
//         is open (a hit), an activation if the bank is closed, else a precharge. In a cycle the oldest burst whose
//         command meets all timing is served. Bursts for which a row was opened come first, then a due refresh, then
//         the reads or, while writes drain, the writes.
//         Every timing rule is "not before": for each bank and kind of command one number holds the earliest cycle, and
//         each command raises these numbers, so that a check is one comparison. All bursts of a bank that need the
//         same command are ready together, so only the oldest counts. The choice is then a minimum over a few arrays
//         with one lane for each bank, which compilers turn into vector code without branches; the next cycle in which
//         anything can happen is a minimum over the same arrays, and nothing is looked at before it.
// Units   Clock cycles of the DRAM.
// Docs    docs/cycles/memory_timing.md
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/memory/dram/dram_lanes.hpp"
#include "sim/memory/dram/dram_place.hpp"
#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

using DramCycle = int64_t;

class DramChannel {
 public:
  struct Counters {
    uint64_t bursts_read = 0, bursts_written = 0;              // over the pins
    uint64_t reads_forwarded = 0, writes_merged = 0;           // served by a write that still waits
    uint64_t row_hits = 0, row_misses = 0, row_conflicts = 0;  // row open, bank closed, other row open
    uint64_t activates = 0, precharges = 0, refreshes = 0, wck_syncs = 0;

    Counters& operator+=(const Counters& of);
  };

  explicit DramChannel(const DramTiming& timing);

  bool accepts(bool write) const {
    return write ? writes_ < write_queue_ : reads_ < read_queue_ && returns_ < returns_limit_;
  }
  // The burst is seen by tick(now + 1). `tag` names a read.
  void accept(DramCycle now, bool write, const DramPlace& place, uint32_t tag);

  // The next cycle in which tick() or finished() has something to do: neither may be called later than that.
  DramCycle next() const { return next_ < next_return_ ? next_ : next_return_; }
  void tick(DramCycle now) {  // at most one command
    if (now >= next_) act(now);
  }
  bool finished(DramCycle now, uint32_t& tag) {  // pops a read whose last beat has arrived
    if (now < next_return_) return false;
    tag = return_[first_return_ & return_mask_].tag;
    ++first_return_;
    next_return_ = --returns_ > 0 ? return_[first_return_ & return_mask_].when : kNever;
    --reads_open_;
    return true;
  }
  bool idle() const { return reads_open_ == 0 && writes_open_ == 0; }

  const Counters& counters() const { return counters_; }

 private:
  static constexpr DramCycle kNever = INT64_MAX / 2;
  using Time = int32_t;  // cycles since base_
  using Age = int32_t;   // number in the order of acceptance, then one bit for a hit, then six for the bank

  struct Burst {
    int32_t order;  // of acceptance
    int32_t next;   // in its list
    DramCycle arrived;
    uint32_t row, column, tag;
    bool counted;  // as hit, miss or conflict
  };
  struct List {  // oldest first
    int32_t head = -1, tail = -1;
  };
  struct Lists {
    List hit, miss;  // of the open row; of other rows, or all while the bank is closed
  };
  struct Bank {
    uint32_t row = 0;              // the open one
    std::array<Lists, 2> waiting;  // reads, writes
  };
  struct Opened {  // a burst for which a row was opened
    DramCycle arrived;
    int bank;
    bool write;
    uint32_t tag;
  };
  struct Return {
    DramCycle when;
    uint32_t tag;
  };

  // lists
  void append(List& list, int32_t burst);
  int32_t take_head(List& list);
  void new_head(int bank, bool write, bool hit);
  uint32_t release(int32_t burst, int bank, bool write);
  void merge_into_miss(Lists& lists);
  void split_by_row(Lists& lists, uint32_t row);
  bool write_waits(const DramPlace& place) const;
  static uint32_t filter_slot(uint32_t bank, uint32_t row, uint32_t column) {
    return (row * 97 + bank * 13 + column) & 1023;
  }
  void count(Burst& burst, uint64_t& counter) {
    if (!burst.counted) ++counter;
    burst.counted = true;
  }
  void renumber_time();
  void renumber_order();

  // commands
  void act(DramCycle now);
  void issue(Time now);
  int ready_opened(Time now) const;
  Time when_next(Time now) const;
  void column_opened(Time now, int index);
  void column_hit(Time now, int bank, bool write);
  bool sync(Time now, int bank, bool opened, bool write);
  void access(Time now, int bank, bool write, uint32_t tag);
  void activate(Time now, int bank, bool write);
  void open_row(Time now);
  void precharge(Time now, int bank);
  void close_bank(int bank);
  bool refresh(Time now);
  bool refresh_bank(Time now);
  bool next_mode() const;

  int rank_of(int bank) const { return bank >> rank_shift_; }
  static uint64_t bit(int bank) { return uint64_t{1} << bank; }

  DramTiming timing_;
  bool bank_refresh_;
  int lanes_, ranks_, rank_shift_, group_shift_, read_queue_, write_queue_;
  int drain_above_, drain_below_;
  std::array<uint64_t, 16> rank_banks_{};

  // bursts that wait
  std::vector<Burst> pool_;
  std::vector<Bank> bank_;
  std::array<DramWaiting, 2> waiting_;        // the oldest of each bank, by direction
  std::array<uint8_t, 1024> write_filter_{};  // waiting writes, by a hash of their place
  int32_t free_ = 0, order_ = 0;
  int reads_ = 0, writes_ = 0;
  uint64_t reads_open_ = 0, writes_open_ = 0;  // accepted, not yet returned or on the pins
  bool draining_ = false;

  // state of the banks; a bank that is neither closed nor open is between the two commands of an activation
  uint64_t open_ = 0;
  std::array<Opened, kDramLanes> opened_;  // oldest first; those that arrived together in the order of opening
  int opened_count_ = 0;
  uint64_t opened_banks_ = 0;

  DramNotBefore not_before_{};
  std::array<Time, 16> refresh_at_{};                     // by rank
  std::array<std::array<Time, 4>, 16> last_activates_{};  // by rank
  Time command_bus_at_ = 0;

  // distances, for each bank group that gets a command: to the commands of all banks
  struct Distances {
    std::array<std::array<DramLanes, 2>, 2> column;  // [first access writes][second access writes]
    DramLanes activate, fourth_activate, precharge;  // fourth: from the fourth last activation
  };
  std::vector<Distances> after_;
  std::array<Time, 2> wck_after_, precharge_after_;  // from an access, by direction

  // activation in two commands; WCK
  int half_open_ = -1;
  Opened half_opened_{};
  Time half_open_until_ = 0, wck_until_ = 0;
  bool synced_ = false;  // a CAS command was given, this access follows
  bool synced_opened_ = false, synced_write_ = false;
  int synced_bank_ = 0;

  Time refresh_every_, refresh_due_;
  uint64_t refreshes_owed_ = 0;
  int refresh_rank_ = 0, refresh_bank_ = 0;

  DramCycle base_ = 0, next_ = 0, next_return_ = kNever;
  std::vector<Return> return_;  // a ring in order of arrival
  uint32_t return_mask_ = 0, first_return_ = 0;
  int returns_ = 0, returns_limit_;

  Counters counters_;
};

}  // namespace pipegs
