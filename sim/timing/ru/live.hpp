// SPDX-License-Identifier: Apache-2.0
// live.hpp: the part of a Rasterization Unit that blends living quads, in the timing model, and how the regions of a
// finished window leave its lanes.
//
// RTL     rtl/ru/live/: ru_regions, ru_power, ru_quads; ru_drain.
// Idea    A region goes through four stages of ru_regions and two of ru_power, which all move together up to where a
//         half waits for a group's queue. The trace says which quads of a region are visible, and after how many
//         Gaussians a quad has stopped. While something is inside, every cycle is played, so a place in a queue says
//         how long ago something came or was issued, and no times are kept.
// Drain   Four jobs hand a region over, one for each row of quads. A job takes a cycle from all groups of lanes, and
//         its word of pixels has come after three more. Regions that the next splat wants go first.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include "cpp_model/config.hpp"
#include "cpp_model/regions.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs::timing {

struct Machine;

class Live {
 public:
  static constexpr int kInside = 6;  // cycles until a quad is written and its group may be empty

  void start_window(const Config& config, const TimingWindow* window);  // nullptr behind the last one

  // Regions of which all quads have stopped, as others know it. What stopped kInside cycles ago becomes known.
  void publish(const Config& config, Cycle now);
  const RegionSet& stopped() const { return all_stopped_; }

  bool idle(Cycle now) const {  // nothing is inside at the beginning of this cycle
    return now >= last_issue_ + kInside && queued_ == 0 && halves_ == 0 &&
           (regions_[0] | regions_[1] | regions_[2] | regions_[3] | rows_) == 0;
  }
  void step(Machine& m, Cycle now, int lane, bool job);  // a cycle; `job`: one of ru_drain takes the groups' turn
  // Behind step() of the same cycle: whether a region can be picked, and that it is, with its visible quads.
  bool moved() const { return moved_; }
  void pick(int region, uint16_t quads) { regions_[0] = kValid | static_cast<uint32_t>(region) << 16 | quads; }

 private:
  static constexpr unsigned kGroups = Config::ru_groups(), kHalves = Config::ru_halves();

  using Stage = uint32_t;  // a region, above its quads; 0: none
  static constexpr Stage kValid = Stage{1} << 31;
  static uint32_t region_of(Stage stage) { return stage >> 16 & 0x1ff; }

  struct Half {
    uint16_t region;
    uint8_t half, live;  // live: of the group's two quads, bit 0 in its first row
  };
  struct Group {
    std::array<Half, kHalves> queue;
    unsigned head = 0, count = 0;
    unsigned fresh = 0;              // of `count`, what came in the latest cycle: it is not at the output yet
    bool second = false;             // of the head, the first quad is issued
    uint64_t recent = ~uint64_t{0};  // quads issued in the latest cycles, 16 bits each, none: all ones
  };
  struct Stop {
    Cycle from;
    uint16_t quad;  // 16 * region + quad
  };
  struct Shown {
    uint8_t lane;
    uint16_t row;  // 4 * region + row
  };

  int issue(Group& group, unsigned number);  // a quad, or -1

  std::vector<uint32_t> left_;                // of each quad: Gaussians until it has stopped
  std::array<uint16_t, kRegions> stopped_{};  // quads, by region
  RegionSet all_stopped_;
  FallQueue<Stop, (kInside + 1) * kGroups> stops_;

  std::array<Stage, 4> regions_{};  // of ru_regions, the first one first
  Stage rows_ = 0, pixels_ = 0;     // of ru_power; pixels_: live quads
  unsigned halves_ = 0;             // of pixels_, that have not left
  bool moved_ = false;              // ru_regions' stages did, in the cycle that was played last
  std::array<Group, kGroups> groups_;
  unsigned queued_ = 0;                      // halves in all queues
  Cycle last_issue_ = kLongAgo;              // or job
  std::array<std::vector<Shown>, 2> shown_;  // what was issued one and two cycles ago
};

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
