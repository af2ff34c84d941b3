// dram_channel.hpp: one channel of DRAM with its controller: queues, banks, and one command per clock cycle.
//
// Idea    First ready, first come, first served. Each waiting burst needs one command next: a column access if its row
//         is open, an activation if the bank is closed, else a precharge. In a cycle the oldest burst whose command
//         meets all timing is served. Bursts whose row was opened for them come first, then a due refresh, then the
//         reads or, while writes drain, the writes.
//         All bursts of a bank that need the same command are ready together, so only the oldest of each list counts:
//         banks are bits of a mask, and `ready_[kind]` holds the banks whose own timing allows a command of that kind.
//         A small wheel of the next 64 cycles sets these bits when their time comes; the distances between commands of
//         different banks are kept for each bank group and rank. Nothing is looked at before `next()`.
// Units   Clock cycles of the DRAM.
// Docs    docs/memory_timing.md
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/dram/dram_place.hpp"
#include "sim/dram/dram_timing.hpp"

namespace pipegs {

using DramCycle = int64_t;

class DramChannel {
 public:
  struct Counters {
    uint64_t bursts_read = 0, bursts_written = 0;       // over the pins
    uint64_t reads_forwarded = 0, writes_merged = 0;    // served by a write that still waits
    uint64_t row_hits = 0, row_misses = 0, row_conflicts = 0;  // row open, bank closed, other row open
    uint64_t activates = 0, precharges = 0, refreshes = 0, wck_syncs = 0;

    Counters& operator+=(const Counters& of);
  };

  explicit DramChannel(const DramTiming& timing);

  bool accepts(bool write) const {
    return write ? writes_ < timing_.write_queue : reads_ < timing_.read_queue && returns_ < returns_limit_;
  }
  // The burst is seen by tick(now + 1). `tag` names a read.
  void accept(DramCycle now, bool write, const DramPlace& place, uint32_t tag);

  // The next cycle in which tick() or finished() has something to do.
  DramCycle next() const { return returns_ > 0 && return_[first_return_].when < next_ ? return_[first_return_].when : next_; }
  void tick(DramCycle now);                            // at most one command
  bool finished(DramCycle now, uint32_t& tag);         // pops a read whose last beat has arrived
  bool idle() const { return reads_open_ == 0 && writes_open_ == 0; }

  const Counters& counters() const { return counters_; }

 private:
  static constexpr DramCycle kNever = INT64_MAX / 2;
  static constexpr int kWheel = 64;
  enum Kind { kColumn, kActivate, kPrecharge, kKinds };

  struct Burst {
    uint64_t order;    // of acceptance
    DramCycle arrived;
    uint32_t row, column, tag;
    int16_t next;
    bool counted;      // as hit, miss or conflict
  };
  struct List {  // oldest first
    int16_t head = -1, tail = -1;
  };
  struct Lists {
    List hit, miss;  // of the open row; of other rows, or all while the bank is closed
  };
  struct Bank {
    uint32_t row = 0;              // the open one
    uint32_t opened_tag = 0;       // of the burst for which it was opened
    DramCycle opened_arrived = 0;  // of that burst
    std::array<Lists, 2> waiting;  // reads, writes
    std::array<DramCycle, kKinds> ready_at{};
  };
  struct Return {
    DramCycle when;
    uint32_t tag;
  };
  struct Distances {  // the earliest cycle of a command, by rank and by bank group
    std::array<DramCycle, 16> rank_at{}, group_at{};
  };
  struct Access {
    int bank = -1;
    bool opened = false;  // the burst for which the row was opened, not the oldest hit
    bool write = false;
  };

  // lists
  void append(List& list, int16_t burst);
  int16_t take_head(List& list);
  void release(int16_t burst, int bank, bool write);
  void merge_into_miss(Lists& lists);
  void split_by_row(Lists& lists, uint32_t row);
  void new_head(int bank, bool write, bool hit);
  bool write_waits(const DramPlace& place) const;
  static uint32_t filter_slot(uint32_t bank, uint32_t row, uint32_t column) {
    return (row * 97 + bank * 13 + column) & 1023;
  }

  // time
  void hold(Kind kind, int bank, DramCycle until);
  void schedule_wake(Kind kind, int bank, DramCycle now, DramCycle at);
  void wake(DramCycle now);
  DramCycle when_next(DramCycle now) const;

  // commands
  bool issue(DramCycle now);
  uint64_t choose_opened(DramCycle now) const;
  uint64_t choose(DramCycle now) const;
  void column(DramCycle now, Access access);
  void activate(DramCycle now, int bank, bool write);
  void open_row(DramCycle now);
  void precharge(DramCycle now, int bank);
  void close_bank(int bank);
  bool refresh(DramCycle now);
  void count(Burst& burst, uint64_t& counter);
  bool next_mode() const;

  uint64_t allowed(DramCycle now, const Distances& distances) const;
  DramCycle earliest(uint64_t banks, const Distances& distances) const;

  static uint64_t bit(int bank) { return uint64_t{1} << bank; }
  int group_of(int bank) const { return bank >> bank_bits_; }
  int rank_of(int bank) const { return bank >> rank_shift_; }

  DramTiming timing_;
  int ranks_, groups_, bank_bits_, rank_shift_;
  int drain_above_, drain_below_;
  std::array<uint64_t, 16> rank_banks_{}, group_banks_{};

  // bursts that wait
  std::vector<Burst> pool_;
  std::vector<Bank> bank_;
  std::array<std::array<uint64_t, 2>, 2> has_{};  // banks with bursts, by direction and by hit
  // Age of the oldest burst in each of these lists, in the form in which the oldest of all is chosen: its place in
  // the order of acceptance, then one bit for a hit, then six bits for the bank.
  std::array<std::array<std::array<uint64_t, 64>, 2>, 2> age_{};
  std::array<uint64_t, 64> opened_age_{};  // by arrival, then by completion of the activation; a bit for a write
  uint64_t order_ = 0, opened_count_ = 0;
  int reads_ = 0, writes_ = 0;
  uint64_t reads_open_ = 0, writes_open_ = 0;  // accepted, not yet returned or on the pins
  std::array<uint8_t, 1024> write_filter_{};  // waiting writes, by a hash of their place
  int16_t free_ = 0;
  bool draining_ = false;

  // state of the banks
  uint64_t closed_, open_ = 0;         // neither: between the two commands of an activation
  std::array<uint64_t, 2> opened_{};   // banks with a burst for which they were opened, by direction
  std::array<uint64_t, kKinds> ready_{}, armed_{};

  // distances between banks
  std::array<Distances, 2> columns_;  // by direction
  Distances activates_;
  std::array<DramCycle, 16> precharge_at_{}, refresh_at_{};     // by rank
  std::array<std::array<DramCycle, 4>, 16> last_activates_{};  // by rank
  struct Gap {
    DramCycle same_group, same_rank, other_rank;
  };
  std::array<std::array<Gap, 2>, 2> gap_;  // [first access writes][second access writes]
  std::array<DramCycle, 2> wck_after_, precharge_after_;  // from an access, by direction
  DramCycle command_bus_at_ = 0;

  // activation in two commands; WCK
  int half_open_ = -1;
  bool half_open_write_ = false;
  DramCycle half_open_until_ = 0;
  Access synced_;  // a CAS command was given, this access follows
  DramCycle wck_until_ = 0;

  DramCycle refresh_due_;
  uint64_t refreshes_owed_ = 0;
  int refresh_rank_ = 0;

  // wheel: for each of the next 64 cycles a list of (kind, bank), as kind * 64 + bank
  static constexpr uint8_t kNone = 255;
  std::array<uint8_t, kWheel> wheel_;
  std::array<uint8_t, kKinds * 64> after_{};
  uint64_t wheel_busy_ = 0;  // cycles with a list
  DramCycle wheel_now_ = 0, next_;

  std::vector<Return> return_;  // a ring in order of arrival
  uint32_t return_mask_ = 0, first_return_ = 0;
  int returns_ = 0, returns_limit_;

  Counters counters_;
};

}  // namespace pipegs
