// su.hpp: a Sorting Unit in the timing model.
//
// RTL     rtl/su/: su_collect, su_split, su_bitonic, su_select, su_emit, su_port.
// Idea    The splitter's passes depend on the keys alone, so su_groups() plays them when a layer begins: after how many cycles
//         which group goes to the sorter. From there on keys move one by one: sorter, queue, output.
#pragma once

#include <vector>

#include "sim/timing/cycle.hpp"
#include "sim/timing/perf.hpp"
#include "sim/timing/ru.hpp"

namespace pipegs::timing {

struct Sorted {
  Splat splat;
  uint64_t key = 0;
  uint32_t number = 0;  // in its layer, in the order of arrival
};

// A group of keys that leaves the splitter.
struct SortGroup {
  int delay = 0;  // from the cycle that starts the splitter, or that takes the last key of the group before, to its first read
  int keys = 0;
};

// The splitter's work on a set of keys (su_split.sv): groups of at most sixteen, nearest first. `keys` is used up.
void su_groups(std::vector<uint64_t>& keys, uint64_t min, uint64_t max, std::vector<SortGroup>& groups);

class Su {
 public:
  Su(const Machine& machine, int lane);

  void step(Machine& m, Cycle now);
  void taken(Machine& m, Cycle now);  // su_merge took the output

  Output<Sorted> out;
  Perf perf;

 private:
  static constexpr int kLayers = 8, kWaiting = 32, kAnswers = 32, kKeysPerLine = 8;

  // A complete layer.
  struct Layer {
    Beat end = 0;
    std::vector<Sorted> splats;  // in the order of arrival
  };
  struct Entry {
    Sorted item;      // of an end: key is the number of slots that become free
    bool outside = false;
  };
  enum Sequence { kIdle, kSort, kSpill, kEnd };
  enum Collect { kCollect, kClose, kAppend, kHand };
  enum Choice { kNone, kRecord, kKeys, kRead };
  enum Select { kSelectIdle, kMeasure, kCount, kChoose, kLoad, kGroup, kSorting };

  void begin_split(Cycle now, std::vector<Sorted>& part);
  bool split_idle(Cycle now) const { return group_ >= groups_.size() && now >= split_idle_from_; }
  bool bitonic_idle() const { return !sorting_ && fill_ == 0 && sent_ == live_; }
  void port(Machine& m, Cycle now);
  void emit(Machine& m, Cycle now);
  void sort(Cycle now);
  void collect(Machine& m, Cycle now);
  bool spill_goes(Cycle now);
  bool select_reads() const { return (select_ == kCount || select_ == kLoad) && line_ * kKeysPerLine < sorted_.splats.size(); }
  void select(Cycle now, bool sent_all);
  uint64_t overflow_line(const Machine& m, int area, uint64_t line) const;

  const int lane_, port_, records_;

  // su_collect
  Collect collect_ = kCollect;
  Layer layer_;
  int used_ = 0;         // slots of layers that live
  int release_ = 0;      // slots that become free with this cycle's end
  bool record_valid_ = false, keys_valid_ = false, arrives_ = false;
  uint32_t record_line_ = 0, keys_line_ = 0, append_ = 0;
  Queue<Layer, kLayers, 2> layers_;

  // the layer that is being sorted
  Sequence sequence_ = kIdle;
  Layer sorted_;
  std::vector<uint64_t> keys_;
  std::vector<Sorted> order_;     // of the keys in the store, sorted
  size_t next_ = 0;               // of order_, to leave the sorter next
  std::vector<SortGroup> groups_;
  size_t group_ = 0;              // in the splitter
  int group_left_ = 0;
  Cycle load_from_ = kNever, split_idle_from_ = 0;

  // su_bitonic
  bool sorting_ = false, loaded_ = false;
  Cycle sort_last_ = 0;
  int fill_ = 0, live_ = 0, sent_ = 0;

  // su_emit
  Queue<Entry, kWaiting, 2> waiting_;
  bool out_outside_ = false, looked_ = false;

  // su_select
  Select select_ = kSelectIdle;
  uint64_t low_ = 0, max_ = 0;
  int shift_ = 0, first_ = 0, stop_ = 0, sum_ = 0;
  uint32_t line_ = 0, number_ = 0, sent_keys_ = 0;
  bool seen_ = false;
  uint32_t seen_number_ = 0;
  std::array<int, 16> counts_{};
  std::vector<Sorted> part_;      // loaded

  // su_port
  Choice choice_ = kNone;
  int flight_ = 0;
  Queue<uint8_t, kAnswers, 2> answers_;
  bool record_taken_ = false, keys_taken_ = false, read_taken_ = false;  // in this cycle
  bool line_used_ = false;
  Cycle out_taken_at_ = kLongAgo;

  // Registers as the cycle began, for what is stepped later in it.
  bool moved_ = false, sorter_idle_ = false, emit_empty_ = false, select_reads_ = false;
};

}  // namespace pipegs::timing
