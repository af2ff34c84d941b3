// SPDX-License-Identifier: Apache-2.0
// state_check.hpp: holds what each unit says that it does against what stands at its borders, cycle by cycle.
//
// Idea    A unit's state comes from its inside, but much of it shows outside, too. What the borders leave open:
//           DOPU    busy in the cycle before a chunk shows at a PU; not starved while one does, or, nearest first,
//                   while lines are to come; waits for memory only while they are; starved without a frame
//           PU      starved when nothing is inside, or blocked by the end of a layer that waits for older ones, or for
//                   memory with a line of alphas that leaves; blocked while the SU takes nothing; waits for memory
//                   when all that it has is on its way; busy, or blocked, as long as what the cull lets through needs
//                   at least
//           SU      busy when it needs its clock for more than to take a splat; else blocked while its splat is not
//                   taken, else starved
//           RU      busy when a word of pixels begins, a line of them leaves, a layer ends, and in no more cycles than
//                   these and the splats that it has taken; else it waits for memory while it asks, else it is starved
//         Where alphas lie in stores, or an SU spills, more is open. The counters must have counted these states.
// Result  A line for each state that cannot be.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "cpp_model/config.hpp"
#include "sim/rtl/rtl_model.hpp"

namespace pipegs {

class StateCheck final : public RtlTaps {
 public:
  struct Wrong {
    std::string unit;    // "PU 1"
    int64_t cycle = -1;  // as RtlTaps counts; -1: of all
    std::string expected, found;
  };
  using Hear = std::function<void(const Wrong&)>;
  // `raster`: pixels of some frame are in raster order, lines of which two RUs may share.
  StateCheck(const Config& config, bool raster, Hear hear);

  bool wants_cycles() const override { return true; }
  void on_cycle(uint64_t number, const uint8_t* states) override;
  void on_border(const uint8_t* border) override;
  void on_chunk(int pu, int kind, const uint32_t* chunk) override;
  void on_pixels(int lane, int region, int quarter, const uint32_t* word) override;
  void on_layer_done(int ru, bool) override { now().layers |= static_cast<uint8_t>(1 << ru); }
  void on_request(int tag, bool write, uint64_t line, int lines) override;
  // After the run.
  void finish(const RtlResult& counters);

 private:
  static constexpr size_t kKinds = 4, kUnits = kMostUnits, kStates = 4;  // units of a kind at most
  static constexpr uint64_t kKept = 8;                                   // cycles that are looked back at
  static constexpr int64_t kNone = -1;                                   // before the first one
  struct Cycle {
    int64_t number = kNone;
    std::array<uint8_t, 1 + (kKinds - 1) * kUnits> states;
    std::array<uint8_t, kRtlBorders> border;
    uint8_t ends, pixels, layers;  // of each PU: an end comes; RU: a word is written back, a layer ends
    bool leaves(int ru, const Cycle& next) const {  // a line of pixels: next it is asked to be written
      return next.at(kRuAsks, ru) && next.at(kRuWrites, ru) && (!at(kRuAsks, ru) || at(kRuAsked, ru));
    }
    bool at(RtlBorder place, int unit) const { return border[place] >> unit & 1; }
  };
  struct Asked {           // of memory
    int64_t lines = 0;     // to come
    int64_t requests = 0;  // on their way to it
  };
  struct Pu {
    bool first = true;  // nothing has come from memory or from the cull since it was empty
    int64_t since = 0;  // cycles since the last line of geometry
    int passing = 0;    // cycles for which the last Gaussian from the cull is inside at least
    Asked geometry = {};
  };

  Cycle& now() { return kept_[cycles_ % kKept]; }
  const Cycle& ago(uint64_t cycles) const { return kept_[(cycles_ - cycles) % kKept]; }
  void judge();
  void judge_dopu();
  void judge_pu(int k);
  void judge_su(int k);
  void judge_ru(int k);
  void expect(const Cycle& cycle, size_t kind, int k, unsigned allowed);
  size_t place(size_t kind, int k) const;  // in a cycle's states

  const Config config_;
  const bool joined_;
  const Hear hear_;
  std::array<Cycle, kKept> kept_ = {};
  uint64_t cycles_ = 0;  // that have begun
  Asked nodes_;
  bool loading_ = true;        // the DOPU has not asked for anything in this frame
  int64_t without_nodes_ = 0;  // cycles since a line of its was to come
  std::array<Pu, kUnits> pu_;
  std::array<bool, kUnits> spills_ = {};     // SUs that have ever
  std::array<int64_t, kUnits> queued_ = {};  // of each RU: splats taken that no busy cycle has been for
  std::array<std::array<uint64_t, kStates>, 1 + (kKinds - 1)* kUnits> counts_ = {};  // of each unit
};

}  // namespace pipegs
