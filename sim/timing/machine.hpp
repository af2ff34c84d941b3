// SPDX-License-Identifier: Apache-2.0
// machine.hpp: the units of the timing model, wired, and the loop that steps them.
//
// RTL     rtl/pipegs_top.sv.
// Idea    Each unit is a few registers and a step function that plays one cycle of it. A unit is stepped only in cycles
//         for which somebody woke it: itself for what it knows will come, its neighbours for what they give or take.
//         Units are stepped in the order of enum Unit, takers before givers (cycle.hpp).
#pragma once

#include <memory>
#include <vector>

#include "sim/timing/pu/deal.hpp"
#include "sim/timing/dopu/dopu.hpp"
#include "sim/timing/event.hpp"
#include "sim/timing/list/lists.hpp"
#include "sim/timing/memory.hpp"
#include "sim/timing/open.hpp"
#include "sim/timing/pu/pu.hpp"
#include "sim/timing/ru/ru.hpp"
#include "sim/timing/ru/ru_order.hpp"
#include "sim/timing/su/su.hpp"
#include "sim/timing/trace/trace.hpp"

namespace pipegs::timing {

// In the order of their steps. Bit of a unit on the wheel: kMostUnits * Unit + lane.
enum Unit : int {
  kPublish,   // what the RUs report, from the cycle on in which the others see it
  kLanes,     // ru_lanes
  kSource,    // ru_fetch, or ru_rows when late
  kRuMemory,  // ru_memory, ru_resolve
  kStore,     // pipegs_alpha_store
  kWalk,      // ru_walk
  kOrder,     // lane 0: ru_dispatch, 1: su_merge
  kSu,
  kLists,  // only with lists
  kColor,  // pu_color, pu_join
  kRows,   // pu_rows, pu_spill
  kBack,   // pu_allocate, pu_late or pu_lines
  kIntersect,
  kCoeff,
  kExpand,     // with lists, or with parts pu_parts
  kListColor,  // with lists, instead of kColor
  kConic,
  kProject,  // pu_project, and the stages behind it up to what kConic plays or shows
  kDeal,
  kReach,  // with TightCull
  kCull,
  kReader,  // pu_fetch
  kDopu,
  kUnitEnd
};
inline constexpr int unit(int kind, int lane = 0) { return kMostUnits * kind + lane; }

struct Machine {
  Machine(const TimingTrace& trace, const Config& config, MemoryTiming& memory_timing);

  Cycle run();   // cycles of the frame; throws std::runtime_error when the model hangs
  bool cycle();  // one cycle; false when the frame was done before it
  Cycle cycles() const { return cycles_; }
  void step(int unit, Cycle now);

  const TimingTrace& trace;
  const Config config;
  const Frame& frame;
  const Span overflow;
  const int units;
  Wheel wheel;
  Memory memory;
  std::vector<Ru> ru;
  AlphaStores stores;
  Dispatch dispatch;
  Merge merge;
  std::vector<Su> su;
  Lists lists;
  std::vector<Pu> pu;
  Deal deal;
  Dopu dopu;

  // Set by the RUs, seen by others: windows and layers that they finished, and what is open.
  LayerFree layer_free;
  OpenRegister open;
  std::vector<Cycle> window_ends;  // when the end of each window left the merge
  uint64_t overflow_lines = 0;
  uint64_t peak_lines = 0, peak_records = 0;  // in one alpha store, in one SU's store
  bool every_cycle = false;                   // wake everything in every cycle: slow, and must change nothing

  // What crosses the units' borders, when somebody wants to know.
  void show(Cycle now, Border border, int lane, uint64_t what) {
    if (events != nullptr) events->push_back({now, border, static_cast<uint8_t>(lane), what});
  }
  uint64_t beat_shown(Beat beat) const { return is_end(beat) ? end_kind(beat) : shown_splat(trace.key[beat]); }
  std::vector<TimingEvent>* events = nullptr;

 private:
  const size_t windows_ = trace.windows.size();
  std::array<uint64_t, Wheel::kWords> all_{};  // units that this machine has
  Cycle cycles_ = -1;                          // of the frame, when it is done
};

}  // namespace pipegs::timing
