// SPDX-License-Identifier: Apache-2.0
// phases.hpp: the stages of a PU that keep a record for eight cycles, one behind the other, in the timing model.
//
// RTL     rtl/pu/pu_shape.sv, with the stages of cpp_model/pu/stages.def: most of them on rtl/pu/pu_phases.sv, one is
//         shorter.
// Idea    What a stage does follows from when it got its record and when its former result was taken:
//           take  = max(ready, the record is there)
//           claim = max(take + begin, former result taken)
//           ready = claim + free
//           out   = claim + result
//         so all times are computed as soon as they are known, often ahead of the clock. Only the first take and the
//         last result are seen by others.
#pragma once

#include <algorithm>
#include <array>

#include "cpp_model/pu/stages.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/knobs.hpp"

namespace pipegs::timing {

class Phases {
 public:
  explicit Phases(const Config& config) {
    const std::vector<PuStage> table = pu_stages(config);
    for (size_t i = table.size(); i-- > 0;) {
      const PuStage& row = table[i];
      if (!row.built) continue;
      Stage& stage = stages_[static_cast<size_t>(count_++)];
      stage.begin = row.begin, stage.free = row.free, stage.length = row.result;
      if (x_pace() < 8 && row.begin + row.free == 8) {
        stage.begin = 1;
        stage.free = x_pace() - 1;
        stage.length = std::max(1, x_pace() - 2);
      }
    }
  }

  // The last result: conic takes it, then says so.
  Output<Beat> out;
  bool taken(Cycle now) {  // tells whether there is another result
    stages_[0].result = false;
    stages_[0].freed = now;
    resolve(1);
    return out.valid;
  }

  // The first stage: may it take a record, and when.
  bool can_take() const { return !first().holding; }
  Cycle ready() const { return first().ready; }
  bool take(Cycle now, Beat beat) {  // tells whether there is a new result
    const bool before = out.valid;
    hold(count_ - 1, now, beat);
    resolve(1u << (count_ - 1));
    return out.valid && !before;
  }

 private:
  struct Stage {
    int begin = 0, free = 0, length = 0;   // cycles; length: to the result
    bool holding = false, result = false;  // a record that has not claimed the output; an output that is not taken
    Beat beat = 0, result_beat = 0;
    Cycle claim = 0, ready = kLongAgo, freed = kLongAgo, result_from = 0;
  };

  void hold(int s, Cycle take, Beat beat) {
    Stage& stage = stages_[static_cast<size_t>(s)];
    stage.holding = true;
    stage.beat = beat;
    stage.claim = take + stage.begin;
  }

  void resolve(uint32_t stages) {
    while (stages != 0) {
      const int s = std::countr_zero(stages);
      stages &= stages - 1;
      Stage& stage = stages_[static_cast<size_t>(s)];
      if (stage.holding && !stage.result) {
        const Cycle when = std::max(stage.claim, stage.freed);
        stage.holding = false;
        stage.result = true;
        stage.ready = when + stage.free;
        stage.result_from = when + stage.length;
        stage.result_beat = stage.beat;
        if (s == 0) {
          out.set(stage.result_from, stage.result_beat);
        } else {
          stages |= 1u << (s - 1);
        }
      }
      if (s + 1 == count_ || stage.holding) continue;
      Stage& giver = stages_[static_cast<size_t>(s) + 1];
      if (!giver.result) continue;
      giver.result = false;
      giver.freed = std::max(stage.ready, giver.result_from);
      hold(s, giver.freed, giver.result_beat);
      stages |= 3u << s;
    }
  }

  const Stage& first() const { return stages_[static_cast<size_t>(count_) - 1]; }

  int count_ = 0;
  std::array<Stage, kPuStages> stages_;  // the last one, whose result others see, is 0
};

}  // namespace pipegs::timing
