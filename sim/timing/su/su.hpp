// SPDX-License-Identifier: Apache-2.0
// su.hpp: a Sorting Unit in the timing model.
//
// RTL     rtl/su/: su_collect, pipegs_slot_pool, su_buckets, su_split, su_bitonic, su_emit; su_spill, su_external,
//         su_port.
// Idea    The splitter's passes depend on the keys alone, so su_groups() plays them when a chain begins: after how many
//         cycles which group goes to the sorter, and when the links are written. All else are registers, played cycle
//         by cycle while something moves: first what every part says in this cycle, then what it becomes.
#pragma once

#include <array>
#include <bit>
#include <deque>
#include <vector>

#include "cpp_model/areas/areas.hpp"
#include "cpp_model/config.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/su/su.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/ru/ru.hpp"

namespace pipegs::timing {

struct Sorted {
  Splat splat;
  uint64_t key = 0;
  uint32_t number = 0;  // of a record in memory
};

// A group of keys that leaves the splitter.
struct SortGroup {
  int delay =
      0;  // from the cycle that starts the splitter, or that takes the last key of the group before, to its first read
  int keys = 0;
  size_t links = 0;  // link writes up to here belong to the passes before this group
};

// Buckets in a word, words in a set: 2^7 of each at most (exp_w and eight bucket_bits).
using Bits = Uint128;
inline uint32_t lowest(Bits bits) {  // of them that is set; not 0
  const auto low = static_cast<uint64_t>(bits);
  return static_cast<uint32_t>(low != 0 ? std::countr_zero(low)
                                        : 64 + std::countr_zero(static_cast<uint64_t>(bits >> 64)));
}

// Cycles in which the splitter may write links, counted like SortGroup::delay.
struct LinkWrites {
  int first = 0, last = 0;
};

// The splitter's work on a set of keys in [min, max] (su_split.sv): groups of at most sixteen, nearest first. `keys`
// is used up.
void su_groups(std::vector<uint64_t>& keys, uint64_t min, uint64_t max, std::vector<SortGroup>& groups,
               std::vector<LinkWrites>& links);

class Su {
 public:
  Su(const Machine& machine, int lane);

  void step(Machine& m, Cycle now);

  // For su_merge.
  bool shown(Cycle now) const { return skid_.valid(now); }
  const Sorted& head() const { return skid_.front(); }
  void taken(Machine& m, Cycle now);

  bool ready(Cycle now) const { return ready_at_ == now ? ready_ : in_.room(now); }  // for a record from the lists

 private:
  static constexpr int kAnswers = Config::su_answers(), kKeysPerLine = 8, kGroup = 16, kRecordLine = -1;
  static constexpr uint32_t kNil = ~uint32_t{0};

  struct Arrived {
    Splat splat;
    uint32_t mark = 0;  // watermark of a layer's end (order 2): its PU keeps it no longer
  };
  struct Mark {
    Beat end = 0;
    uint8_t set = 0;
    bool all = false, spills = false;
    uint32_t bucket = 0;
  };
  struct Chain {
    Beat end = 0;  // or a chain of slots
    uint32_t head = kNil, tail = kNil, count = 0, bucket = 0;
  };
  struct Entry {
    Sorted item;
    uint32_t slot = kNil;  // that becomes free when the record is read; an end and a record in memory have none
    bool outside = false;
  };
  struct Writes {
    Cycle first, last;
  };
  enum Collect { kCollect, kSpill, kSort };
  enum Operation { kNone, kInsert, kWord, kEntry };
  enum Spill { kSpillIdle, kRelease, kDrain, kClose, kSend, kRefill };
  enum Source { kNoRecord, kFromIn, kFromBack };
  enum Choice { kNothing, kRecord, kKeys, kRun, kFetch, kRead };
  enum Form { kLoad, kGroupGoes, kSortRun, kReturn };
  enum Level { kForm, kSize, kSetup, kStart, kMerge, kSent };
  enum Tree { kTreeIdle, kLook, kTake, kCompare };

  // The merge sort in external memory of a set that spilled.
  struct Node {  // of the tree: a key of a way
    bool none = false;
    Sorted item;
    int way = 0, place = 0;  // place: in its line
  };
  struct Way {
    std::vector<Sorted> keys;         // of its run
    uint32_t line = 0;                // to be asked for next
    uint32_t unasked = 0;             // keys from there on
    uint32_t left = 0;                // keys that were not taken
    bool more = false, area = false;  // area: it lies where runs are formed
    int held = 0, ready = 0;          // lines
  };
  struct External {
    Form form = kLoad;        // su_runs
    std::deque<Sorted> pool;  // of the run, or of what returns
    // Lines of the list asked for; its keys seen, in runs, left for later; the bucket before which all were sent; what
    // is left returns.
    uint32_t asked = 0, seen = 0, formed = 0, rest = 0, from = 0;
    bool refill = false;
    Level level = kForm;  // su_levels
    uint32_t lines = 0, next_line = 0, merged_lines = 0, merged_line = 0, ways_used = 0, merges = 0, sum = 0;
    int way = 0, levels = 1;
    bool area = true, last = false;
    bool asking = false;  // su_ways
    int asked_way = 0, place = 0;
    std::vector<Way> ways;
    Tree tree = kTreeIdle;  // su_tree
    Node rising;
    bool seeding = true, taken = false, fetched = false;
    int seed = 0, node = 0;
    uint32_t nodes_filled = 0;
    std::vector<Node> nodes;
    uint32_t lines_left = 0, lines_number = 0;  // su_lines
    int lines_place = 0;
    bool lines_full = false;
    std::vector<std::vector<Sorted>> runs, merged;  // of this level, of the next one
    size_t next_run = 0, next_merged = 0;

    bool written() const { return lines_left == 0 && !lines_full; }
    bool item() const { return (tree == kLook || tree == kTake) && !seeding && !taken; }
  };

  // What the parts say in a cycle, from the registers as it began.
  struct Now;

  bool diverts() const { return spill_ == kRelease || spill_ == kDrain; }
  bool split_idle(Cycle now) const { return group_ >= groups_.size() && now >= split_idle_from_; }
  bool bitonic_idle() const { return !sorting_ && fill_ == 0 && sent_ == live_; }
  bool slot_valid(Cycle now) const;
  bool split_links(Cycle now);
  uint32_t bucket_of(uint64_t key) const {
    return static_cast<uint32_t>(su_bucket(config_, key >> (config_.key_w() - config_.depth_w), octave_));
  }
  bool open() const { return spill_ == kClose || closed(); }  // the pool is empty
  bool closed() const { return spill_ == kSend || spill_ == kRefill; }
  bool returns() const { return external_.form == kReturn; }                    // the output goes into the pool
  bool lists() const { return external_.level == kForm || spill_ == kRefill; }  // memory is asked for the list
  bool closes() const { return spill_ == kClose && collect_ == kSort; }
  Source shown_record(Cycle now) const;
  bool keys_listed(bool shown) const;
  bool fetches(Cycle now) const;
  const Sorted& item() const {
    return returns() ? external_.pool.front() : external_.item() ? external_.rising.item : batches_.front().item;
  }
  uint64_t overflow_line(const Machine& m, Area area, uint64_t line) const;

  void begin_split(Cycle now, uint64_t min, uint64_t max);
  void begin_group(Cycle origin);
  template <bool Spills>  // without: no set is on its way to memory or back
  Now look(const Machine& m, Cycle now);
  void port(Machine& m, Cycle now);
  void divert(Cycle now, const Now& is);
  void emit(Cycle now, const Now& is);
  void sort(Cycle now, const Now& is);
  void buckets(Cycle now, const Now& is);
  void spill(const Machine& m, const Now& is);
  void external(Cycle now, const Now& is);
  void form_runs(Cycle now, const Now& is, bool line, bool written);
  void merge_levels(const Now& is, bool done);
  void ask_ways(Cycle now, bool line, bool setup);
  bool rise(const Now& is);
  void keep_keys(const Now& is, bool merges);
  void show_outside(Machine& m, Cycle now);
  void collect(Machine& m, Cycle now, const Now& is);
  void arrive(Machine& m, Cycle now);
  void leave(Machine& m, Cycle now);

  const int lane_, port_, records_;
  const Config config_;
  const int octave_, bits_low_, bits_high_;
  const bool marks_cut_;  // a layer's end is a watermark (order 2)
  const bool lists_;

  FallQueue<Arrived, 2> in_;  // rtl/lib/pipegs_skid.sv
  bool ready_ = true;         // as the cycle began in which it was stepped last
  Cycle ready_at_ = kLongAgo;

  // pipegs_slot_pool, and what lies in them
  std::vector<Sorted> pool_;
  std::vector<uint32_t> next_slot_, free_slots_;
  int fresh_ = 0, used_ = 0, back_ = 0;  // back_: slots that came back
  std::array<Cycle, 4> back_at_{};       // when the latest did
  int back_next_ = 0;
  uint32_t freed_ = kNil;  // slot that becomes free in the next cycle
  Cycle back_pop_ = kLongAgo;

  // su_collect
  Collect collect_ = kCollect;
  uint8_t set_ = 0;
  std::array<bool, 2> closed_{};
  Queue<Mark, 2 * (Config::window_marks() + 1), 3> marks_;  // the one in front stands in registers

  // su_buckets
  Operation operation_ = kNone;
  bool inserted_ = false;       // it was an insertion in the cycle before
  std::vector<Chain> table_;    // of both sets
  std::vector<Bits> words_;     // filled buckets
  std::array<Bits, 2> held_{};  // words that are not zero
  uint8_t insert_set_ = 0;
  uint32_t insert_slot_ = 0, insert_bucket_ = 0;
  uint32_t word_ = 0, entry_bucket_ = 0;
  Bits work_ = 0;
  bool edge_ = false, group_valid_ = false;
  Chain joined_;
  SramQueue<Chain, Config::su_chains()> chains_;

  // su_split
  std::vector<uint64_t> keys_;
  std::vector<Entry> order_;  // of the chain in the splitter and sorter, sorted
  size_t next_ = 0;           // of order_, to leave the sorter next
  std::vector<SortGroup> groups_;
  std::vector<LinkWrites> links_;
  std::vector<Writes> link_writes_;  // to come
  size_t group_ = 0;                 // in the splitter
  int group_left_ = 0;
  Cycle load_from_ = kNever, split_idle_from_ = 0;

  // su_bitonic: keys of two batches, in the order in which they will leave
  SramQueue<Entry, 64> batches_;
  bool sorting_ = false, loaded_ = false, end_ = false, live_end_ = false;
  Cycle sort_last_ = 0;
  int fill_ = 0, live_ = 0, sent_ = 0;

  // su_emit
  SramQueue<Entry, Config::su_waiting()> waiting_;
  Output<Sorted> out_;
  FallQueue<Sorted, 2> skid_;                  // behind it
  bool out_outside_ = false, looked_ = false;  // looked_: the record's number was read
  bool ask_ = false;                           // for a record in memory
  uint32_t ask_line_ = 0;
  Cycle out_taken_at_ = kLongAgo, stored_at_ = kLongAgo;  // when a record went on its way into the pool

  // su_spill
  Spill spill_ = kSpillIdle;
  std::vector<Sorted> records_out_;  // records of the set in memory
  bool back_held_ = false;           // the record shown is one out of the pool, and was in the cycle before
  bool keys_sent_ = false;           // the line of keys that the shown record completes, or the last one, is written
  Sorted diverted_record_;           // of the output, that goes to memory or into the pool

  // su_external
  External external_;
  Sorted kept_;  // that goes back to memory in this cycle

  // su_port
  Choice choice_ = kNothing;
  int flight_ = 0;   // lines asked for and not yet used
  int awaited_ = 0;  // of these, the unanswered ones
  SramQueue<uint8_t, kAnswers> answers_;
  std::deque<int> owners_;  // of the lines in flight: a way, or kRecordLine
  bool record_taken_ = false, keys_taken_ = false, run_taken_ = false, fetch_taken_ = false, read_taken_ = false,
       line_used_ = false;  // in this cycle

  bool moved_ = false;
};

// What the parts say in a cycle, from the registers as it began.
struct Su::Now {
  bool item, outer, item_end, split_idle, bitonic_idle, emit_empty, drained, spilled, sends, outside, kept, diverts;
  bool spill_job, mark_waits, mark_first, mark_all, emit_item, emit_ready, item_goes;
  bool chain, chain_end, batch_ready, batch_valid;
  bool hungry, link_ready, released_room, sent_all;
  uint8_t mark_set;
  uint32_t mark_bucket;
  Beat mark_end;
  // buckets
  bool job, job_all, job_done, quiet, word_wanted, ends, push_group, join_group, filled, insert, chain_valid;
  uint8_t job_set;
  Bits candidates;
  Operation next;
  // a set that spilled: its mark leaves; then what is left
  bool sent, again, stay, returns, returned, spill_end;
  // collect
  const Splat* in;
  Source record;
  bool data, open, taken, write, spill_start, mark_push;
};

}  // namespace pipegs::timing
