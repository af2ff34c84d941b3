// SPDX-License-Identifier: Apache-2.0
// nearest.hpp: from cells down to chunks in the timing model, the nearest first (order 2).
//
// RTL     rtl/dopu/nearest/dopu_nearest.sv, dopu_rank.sv, dopu_bucket.sv, dopu_open.sv, dopu_send.sv;
//         rtl/dopu/dopu_load.sv.
// Idea    Which nodes pass, and in which bucket of depth, is in the trace; here is only when. The registers are played
//         cycle by cycle while something moves: first what every part says in this cycle, then what it becomes.
#pragma once

#include <memory>

#include "cpp_model/config.hpp"
#include "cpp_model/dopu/dopu_load.hpp"
#include "sim/timing/dopu/dopu_item.hpp"
#include "sim/timing/line_reader.hpp"
#include "sim/timing/dopu/nearest_queue.hpp"

namespace pipegs::timing {

class Nearest {
 public:
  Nearest(const TimingTrace& trace, const Config& config);

  // For dopu_origin: null when nothing is shown.
  const DopuItem* shown(Cycle, const DopuSets& sets) { return valid_ && !dropped(sets) ? &out_ : nullptr; }
  void step(DopuCycle& cycle, DopuSets& sets);  // a cycle, after dopu_origin's

  bool wants(int level) const { return open_[static_cast<size_t>(level)].reader.wants(); }
  uint64_t line(int level) const { return open_[static_cast<size_t>(level)].reader.line(); }
  int lines(int level) const { return open_[static_cast<size_t>(level)].reader.lines(); }

 private:
  static constexpr int kLevels = 3;
  static constexpr int kResults = Config::nearest_results(), kMost = Config::nearest_open();
  static constexpr int kLoadWord = 4;  // buckets that dopu_load reads in a cycle

  struct Parent {
    uint32_t first_pass = 0;  // of its children
  };
  using Reader = LineReader<Parent, kMost>;
  struct Result {
    bool last = false, pass = false;
    NearestNode node;
    TimingSides sides = 0;
  };
  struct InTest {
    Cycle due = 0;
    uint8_t level = 0, set = 0;
    Result result;
  };
  struct Open {  // dopu_open
    Open(uint64_t base, int none) : nearest(none), reader(2, base, kMost, Config::nearest_lines()) {}
    bool room() const { return !job_valid && buckets.count() != kMost; }
    int nearest;
    FallQueue<uint16_t, kMost> buckets;  // of the nodes open, the oldest first
    bool job_valid = false;
    Reader::Job job;
    Reader reader;
    uint32_t cursor = 0;  // the next child that passes
  };
  struct Said;

  bool dropped(const DopuSets& sets) const { return out_.end != kWindowEndBeat && sets[out_.set].done && !shown_; }
  int list(int level, int set) const { return 2 * level + set; }
  Result child(int level, uint32_t node, bool last, const DopuSets& sets);
  Said look(const DopuCycle& cycle, const DopuSets& sets);
  bool send(const DopuCycle& cycle, const DopuSets& sets, const Said& is);  // tells whether the output changed
  void enter(DopuCycle& cycle, const DopuSets& sets, const Said& is);
  void open(DopuCycle& cycle, const DopuSets& sets, const Said& is);

  const TimingTrace& trace_;
  const uint32_t mark_chunks_, since_most_;
  const int near_step_, mark_shift_;

  // dopu_load: of the set on trial
  DopuLoad load_;
  const Cycle load_cycles_;  // until all buckets are read
  bool many_groups_ = false;
  Cycle judge_at_ = kNever;  // while its buckets are read

  // levels: 0 scans cells, 1 opens cells, 2 opens groups
  std::array<int, kLevels> set_{};
  std::array<std::array<bool, 2>, kLevels> complete_{};
  bool cells_in_ = false;
  std::array<int, kLevels> reserved_{};
  const Cycle test_cycles_;  // of dopu_rank; with proxies a group's range is chosen a cycle later
  FallQueue<InTest, 16> in_test_;
  std::array<FallQueue<Result, kResults>, kLevels> held_;
  std::unique_ptr<NearestQueue> queue_;
  std::array<int, 2> waiting_{};  // chunks of either set in the queue
  const int none_;                // the largest bucket also stands for none
  std::array<Open, 2> open_;

  // dopu_send
  int send_set_ = 0;
  bool popping_ = false, valid_ = false;
  bool shown_ = false;  // in the cycle before: it stays until taken
  DopuItem out_;
  uint32_t since_ = 0;
  int mark_ = 0, marks_ = 0;
};

}  // namespace pipegs::timing
