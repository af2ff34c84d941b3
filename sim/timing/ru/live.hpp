// SPDX-License-Identifier: Apache-2.0
// live.hpp: the part of a Rasterization Unit that blends living quads, in the timing model.
//
// RTL     rtl/ru/live/: ru_regions, ru_power, ru_quads.
// Idea    A region goes through four stages of ru_regions and two of ru_power, which all move together up to where a
//         half waits for a group's queue. The trace says which quads of a region are visible, and after how many
//         Gaussians a quad has stopped. While something is inside, every cycle is played.
#pragma once

#include <array>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs::timing {

struct Machine;

class Live {
 public:
  // A quad that has stopped, and the cycle from which on the RU knows.
  struct Stop {
    Cycle from;
    uint16_t quad;  // 16 * region + quad
  };

  // Cycles until a quad is written and its group may be empty, and until others know of its stop.
  static constexpr Cycle kInside = 6;

  Live();

  void start_window(const TimingWindow* window);  // nullptr behind the last one
  bool stopped(int region) const { return stopped_[static_cast<size_t>(region)] == 0xffff; }
  void stop(uint16_t quad) { stopped_[quad / 16u] |= static_cast<uint16_t>(1u << quad % 16u); }

  bool idle(Cycle now) const;  // nothing is inside at the beginning of this cycle
  // A cycle. What stops with it is appended to `stops`. `job`: one of ru_drain takes the groups' turn.
  void step(Machine& m, Cycle now, int lane, bool job, std::vector<Stop>& stops);
  // Behind step() of the same cycle: whether a region can be picked, and that it is, with its visible quads.
  bool moved() const { return moved_; }
  void pick(int region, uint16_t quads);

 private:
  struct Stage {
    bool valid = false;
    uint8_t region = 0;
    uint16_t quads = 0;
  };
  struct Half {
    uint8_t region = 0;
    uint8_t half = 0, live = 0;  // of the group's two quads
  };
  struct Group {
    FallQueue<Half, Config::ru_halves()> queue;
    bool second = false;
    Cycle last_issue = kLongAgo;
  };
  static constexpr int kGroups = Config::ru_groups();

  // Of a half, the group's two quads: bit 0 in its first row.
  static uint8_t live_of(uint16_t quads, int half, int group);
  bool fires(Cycle now) const;
  bool regions_empty() const;
  void issue(Cycle now, int lane, int group, std::vector<Stop>& stops);

  const TimingWindow* window_ = nullptr;
  std::array<uint16_t, kRegions> stopped_{};         // quads, by region
  std::array<uint32_t, 16 * kRegions> gaussians_{};  // that each quad has taken
  std::array<Cycle, 16 * kRegions> last_issue_;      // of each quad

  std::array<Stage, 4> regions_;  // of ru_regions, the first one first
  Stage rows_, pixels_;           // of ru_power; pixels_.quads: live ones
  unsigned halves_ = 0;           // of pixels_, that have not left
  bool moved_ = false;            // ru_regions' stages did, in the cycle that was played last
  std::array<Group, kGroups> groups_;
  struct Shown {
    uint8_t lane;
    uint16_t row;  // 4 * region + row
  };
  std::array<std::vector<Shown>, 2> shown_;  // what was issued one and two cycles ago
};

}  // namespace pipegs::timing
