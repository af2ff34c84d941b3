// SPDX-License-Identifier: Apache-2.0
// axi_rules.hpp: does a manager obey AXI4? What a subordinate can see of it, cycle by cycle.
//
// Rule    What is shown and not taken stays, unchanged. Bursts are INCR in beats of the bus, aligned, within 4 KB.
//         WLAST stands at the last beat of its burst. No more bursts are unanswered than agreed. A broken rule is a
//         std::runtime_error whose one line names the cycle, the channel and the rule.
#pragma once

#include <cstdint>
#include <deque>
#include <string>

#include "sim/memory/axi/axi_signals.hpp"

namespace pipegs {

class AxiRules {
 public:
  // data_w: bits of the bus. most_reads, most_writes: bursts that may be unanswered.
  AxiRules(int data_w, int most_reads, int most_writes)
      : bytes_(data_w / 8), most_reads_(most_reads), most_writes_(most_writes) {}

  void check(const AxiManagerSide& manager, const AxiSubordinateSide& own);  // one cycle

 private:
  void fail(const std::string& channel, const std::string& rule) const;
  void check_address(const std::string& channel, const AxiAddress& now, const AxiAddress& before) const;
  void check_data(const AxiWriteBeat& now);

  int bytes_, most_reads_, most_writes_;
  uint64_t cycle_ = 0;
  AxiAddress ar_, aw_;  // shown and not taken in the cycle before, else not valid
  AxiWriteBeat w_;
  int reads_ = 0, writes_ = 0;  // unanswered
  std::deque<int> lengths_;     // of bursts on AW whose data did not end
  std::deque<int> ends_;        // of bursts on W whose address did not come: beats - 1
  int beat_ = 0;                // of the burst on W
};

}  // namespace pipegs
