// SPDX-License-Identifier: Apache-2.0
// drain.hpp: how the regions of a finished window leave the lanes of a Rasterization Unit, in the timing model.
//
// RTL     rtl/ru/live/ru_drain.sv.
// Idea    Four jobs hand a region over, one for each row of quads. A job takes a cycle from all groups of lanes, and
//         its word of pixels has come after three more. Regions that the next splat wants go first.
#pragma once

#include <array>
#include <bit>

#include "cpp_model/config.hpp"
#include "cpp_model/regions.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

class Drain {
 public:
  struct Word {
    int region = 0, row = 0;
    size_t window = 0;
  };

  // In the cycle `now`, behind step(): regions to hand over; `quiet`: they are only cleared. So are the words that
  // begin behind `rows` rows of pixels.
  void start(Cycle now, const RegionSet& regions, bool quiet, size_t window, int rows) {
    held_ = regions, quiet_ = quiet, window_ = window, rows_ = rows, from_ = now + 1;
  }
  const RegionSet& held() const { return held_; }  // not handed over yet
  bool empty() const { return !active() && words.empty(); }
  bool active() const { return held_ != RegionSet{} || flying_ != 0; }

  // A cycle: whether a job takes the groups' turn. `wanted`: regions that the next splat waits for.
  bool step(const Config& config, Cycle now, const RegionSet& wanted);

  FallQueue<Word, Config::ru_drained()> words;  // that have come

 private:
  void choose(const Config& config, const RegionSet& wanted);

  RegionSet held_;
  bool quiet_ = false;
  size_t window_ = 0;
  int rows_ = 0;
  Cycle from_ = 0;
  int chosen_ = -1, row_ = 0;  // the next job
  unsigned flying_ = 0;        // bit i: the word of coming_[i] is on its way to be written
  std::array<Word, 3> coming_{};
};

}  // namespace pipegs::timing
