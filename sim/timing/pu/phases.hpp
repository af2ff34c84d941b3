// SPDX-License-Identifier: Apache-2.0
// phases.hpp: the stages of a PU that keep a record for some cycles, one behind the other, in the timing model.
//
// RTL     rtl/pu/pu_shape.sv, with the stages of cpp_model/pu/stages.def: most of them on rtl/pu/pu_phases.sv, one is
//         shorter. At a pace of four cycles those of rtl/pu/four/, pu_four_coeff by itself.
// Idea    What a stage does follows from when it got its records and when its former result was taken:
//           take  = max(ready, the record is there)
//           claim = max(take + begin, former result taken)
//           ready = take + begin + free
//           out   = claim + result
//         A record that waits to claim holds up those behind it. Where the claim lies behind the phases, younger ones
//         are in the stage by then: the next is taken before the claim is known only if that cannot matter.
//         So all times are computed as soon as they are known, often ahead of the clock. Only the first take and the
//         last result are seen by others.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <vector>

#include "cpp_model/pu/stages.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

class Phases {
 public:
  // Some stages of a table, in the order of the chain.
  explicit Phases(const std::vector<PuStage>& table) {
    for (size_t i = table.size(); i-- > 0;) {
      const PuStage& row = table[i];
      if (row.places - 1 > kMostHeld) throw std::logic_error("timing model: a stage of a PU keeps too many records");
      Stage& stage = stages_[static_cast<size_t>(count_++)];
      stage.begin = row.begin, stage.free = row.free, stage.length = row.result;
    }
  }

  // The last result: who takes it says so.
  Output<Beat> out;
  bool taken(Cycle now) {  // tells whether there is another result
    stages_[0].result = false;
    stages_[0].freed = now;
    resolve(1);
    return out.valid;
  }

  // The first stage: may it take a record, and when.
  bool can_take() const { return first().can_take(); }
  Cycle ready() const { return first().ready; }
  bool take(Cycle now, Beat beat) {  // tells whether there is a new result
    const bool before = out.valid;
    stages_[static_cast<size_t>(count_) - 1].hold(now, beat);
    resolve(1u << (count_ - 1));
    return out.valid && !before;
  }

 private:
  static constexpr int kMostHeld = 4;
  struct Held {  // a record that has not claimed the output
    Beat beat = 0;
    Cycle take = 0, claim = 0;
  };
  struct Stall {  // cycles in which the stage stands still
    Cycle from = 0, to = 0;
    Cycle of(Cycle take) const { return std::max<Cycle>(0, to - std::max(from, take + 1)); }  // of a record in it
  };
  struct Stage {
    int begin = 0, free = 0, length = 0;  // cycles; length: to the result
    std::array<Held, kMostHeld> held;
    int count = 0;
    bool result = false;  // an output that is not taken
    Beat result_beat = 0;
    Cycle ready = kLongAgo, freed = kLongAgo, result_from = 0;
    std::array<Stall, 2> stalls;  // the latest

    bool can_take() const { return count == 0 || ready < held[0].claim; }

    void hold(Cycle take, Beat beat) {
      const Cycle stall = stalls[0].of(take) + stalls[1].of(take);
      held[static_cast<size_t>(count++)] = {beat, take, take + begin + stall};
      ready = take + begin + free + stall;
    }

    // The oldest claims the output; the others stand still for as long as it waits.
    void claim() {
      const Held oldest = held[0];
      const Stall stall{oldest.claim, std::max(oldest.claim, freed)};
      if (ready >= stall.from) ready += stall.of(held[static_cast<size_t>(count) - 1].take);
      for (int i = 1; i < count; ++i) {
        Held& one = held[static_cast<size_t>(i)];
        one.claim += stall.of(one.take);
        held[static_cast<size_t>(i) - 1] = one;
      }
      --count;
      if (stall.to > stall.from) stalls = {stall, stalls[0]};
      result = true;
      result_from = stall.to + length;
      result_beat = oldest.beat;
    }
  };

  void resolve(uint32_t stages) {
    while (stages != 0) {
      const int s = std::countr_zero(stages);
      stages &= stages - 1;
      Stage& stage = stages_[static_cast<size_t>(s)];
      if (stage.count > 0 && !stage.result) {
        stage.claim();
        if (s == 0) {
          out.set(stage.result_from, stage.result_beat);
        } else {
          stages |= 1u << (s - 1);
        }
      }
      if (s + 1 == count_ || !stage.can_take()) continue;
      Stage& giver = stages_[static_cast<size_t>(s) + 1];
      if (!giver.result) continue;
      giver.result = false;
      giver.freed = std::max(stage.ready, giver.result_from);
      stage.hold(giver.freed, giver.result_beat);
      stages |= 3u << s;
    }
  }

  const Stage& first() const { return stages_[static_cast<size_t>(count_) - 1]; }

  int count_ = 0;
  std::array<Stage, kPuStages> stages_;  // the last one, whose result others see, is 0
};

}  // namespace pipegs::timing
