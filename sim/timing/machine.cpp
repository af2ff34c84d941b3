// SPDX-License-Identifier: Apache-2.0
// machine.cpp: see machine.hpp.
#include "sim/timing/machine.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <string>

#include "cpp_model/areas/frame_areas.hpp"

namespace pipegs::timing {

static_assert(unit(kUnitEnd) <= 64 * Wheel::kWords);

Machine::Machine(const TimingTrace& trace, const Config& config, MemoryTiming& memory_timing)
    : trace(trace),
      config(config),
      frame(trace.frame),
      overflow{frame.tables.overflow, overflow_area(config, trace.slots, frame_windows(frame))},
      units(config.units),
      memory(memory_timing, config),
      lists(*this),
      dopu(*this) {
  for (int k = 0; k < units; ++k) {
    ru.emplace_back(*this, k);
    su.emplace_back(*this, k);
    pu.emplace_back(*this, k);
  }
  constexpr Cycle kHarnessCycles = 5;  // of the harness before the restart
  for (Cycle i = 0; i < kHarnessCycles; ++i) memory.idle_step();
  for (int kind = 0; kind < kUnitEnd; ++kind) {
    for (int lane = 0; lane < kMostUnits; ++lane) {
      const bool there = kind == kOrder                                                         ? lane < 2
                         : kind == kPublish || kind == kDeal || kind == kDopu || kind == kLists ? lane == 0
                                                                                                : lane < units;
      const bool listed = kind == kLists || kind == kListColor || (kind == kExpand && config.parts() == 1);
      if (!there || (!config.caches_alphas() && (kind == kWalk || kind == kStore || kind == kRows)) ||
          (config.has_lists() ? kind == kColor : listed) || (kind == kReach && !config.tight_cull))
        continue;
      all_[static_cast<size_t>(unit(kind, lane) / 64)] |= uint64_t{1} << (unit(kind, lane) % 64);
    }
  }
}

void Machine::step(int number, Cycle now) {
  const int kind = number / kMostUnits, lane = number % kMostUnits;
  const auto k = static_cast<size_t>(lane);
  switch (kind) {
    case kPublish:
      for (Ru& one : ru) one.publish(*this, now);
      layer_free.publish(*this, now);
      if (config.occlusion) open.publish(*this, now);
      break;
    case kLanes: ru[k].lanes(*this, now); break;
    case kSource: ru[k].source(*this, now); break;
    case kRuMemory: ru[k].memory(*this, now); break;
    case kStore: stores.step(*this, now, lane); break;
    case kWalk: ru[k].walk(*this, now); break;
    case kOrder: lane == 0 ? dispatch.step(*this, now) : merge.step(*this, now); break;
    case kSu: su[k].step(*this, now); break;
    case kLists: lists.step(*this, now); break;
    case kColor:
    case kListColor: pu[k].color.step(*this, now); break;
    case kRows: pu[k].rows(*this, now); break;
    case kBack: pu[k].back(*this, now); break;
    case kIntersect: pu[k].intersect(*this, now); break;
    case kCoeff: pu[k].coeff(*this, now); break;
    case kExpand: pu[k].expand(*this, now); break;
    case kConic: pu[k].conic(*this, now); break;
    case kDeal: deal.step(*this, now); break;
    case kReach: pu[k].reach(*this, now); break;
    case kCull: pu[k].cull(*this, now); break;
    case kReader: pu[k].reader(*this, now); break;
    case kDopu: dopu.step(*this, now); break;
    case kProject: pu[k].project(*this, now); break;
    default: break;
  }
}

Cycle Machine::run() {
  while (cycle()) {}
  return cycles_;
}

bool Machine::cycle() {
  constexpr Cycle kQuiet = 200000;  // without a request to memory: the model hangs
  if (cycles_ >= 0) return false;
  const Cycle now = wheel.now();
  if (now == 0 || every_cycle) {
    for (int i = 0; i < Wheel::kWords; ++i) wheel.word(i) |= all_[static_cast<size_t>(i)];
  }
  memory.step(*this, now);
  for (int i = 0; i < Wheel::kWords; ++i) {
    uint64_t& word = wheel.word(i);
    while (word != 0) {
      const int bit = std::countr_zero(word);
      word &= word - 1;
      step(64 * i + bit, now);
    }
  }
  if (ru[0].window() == windows_ && memory.idle() &&
      std::all_of(ru.begin(), ru.end(), [&](const Ru& one) { return one.window() == windows_ && one.written(); })) {
    Cycle end = memory.last_accepted();
    for (const Ru& one : ru) end = std::max(end, one.last_busy());
    cycles_ = end + 1;
  }
  if (now - memory.last_accepted() > kQuiet)
    throw std::runtime_error("timing model: no memory request for " + std::to_string(kQuiet) + " cycles, cycle " +
                             std::to_string(now) + ": it hangs");
  wheel.next_cycle();
  return true;
}

}  // namespace pipegs::timing
