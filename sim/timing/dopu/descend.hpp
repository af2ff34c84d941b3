// SPDX-License-Identifier: Apache-2.0
// descend.hpp: from cells down to chunks in the timing model, in the order of the walk.
//
// RTL     rtl/dopu/dopu_descend.sv, dopu_test.sv.
// Idea    Which nodes pass is in the trace; here is only when. One box test for all levels, upper levels first; a queue
//         of results for each level, and a reader of children for each of the two upper ones.
#pragma once

#include "cpp_model/config.hpp"
#include "sim/timing/dopu/dopu_item.hpp"
#include "sim/timing/line_reader.hpp"

namespace pipegs::timing {

class Descend {
 public:
  explicit Descend(const TimingTrace& trace)
      : trace_(trace), readers_{reader(trace.frame.tables.groups), reader(trace.frame.tables.chunks)} {}

  // For dopu_origin: null when nothing is shown.
  const DopuItem* shown(Cycle now, const DopuSets& sets);
  void step(DopuCycle& cycle, DopuSets& sets);  // a cycle, after dopu_origin's

  bool wants(int level) const { return readers_[static_cast<size_t>(level)].wants(); }
  uint64_t line(int level) const { return readers_[static_cast<size_t>(level)].line(); }
  int lines(int level) const { return readers_[static_cast<size_t>(level)].lines(); }

 private:
  static constexpr int kLevels = 3;
  static constexpr int kResults = Config::descend_results();
  static constexpr Cycle kTestCycles = 12;  // of dopu_test

  struct Tag {
    Beat end = 0;
    uint8_t set = 0;
    bool last = false;
  };
  using Reader = LineReader<Tag, Config::descend_jobs()>;
  static Reader reader(uint64_t base) { return {2, base, Config::descend_jobs(), Config::descend_lines()}; }
  struct InTest {
    Cycle due = 0;
    DopuItem item;
    uint8_t level = 0;
    bool pass = false;
  };

  static bool drops(const DopuItem& item, const DopuSets& sets) { return item.data() && sets[item.set].done; }
  bool passes(int level, DopuItem& item, DopuSets& sets) const;
  void test(DopuCycle& cycle, DopuSets& sets);
  void read(DopuCycle& cycle, const DopuSets& sets);

  const TimingTrace& trace_;
  std::array<FallQueue<DopuItem, kResults>, kLevels> results_;
  std::array<int, kLevels> reserved_{};
  FallQueue<InTest, 8> in_test_;
  std::array<Reader, 2> readers_;
  bool shown_ = false;  // to dopu_origin, in the cycle before: it stays until taken
};

}  // namespace pipegs::timing
