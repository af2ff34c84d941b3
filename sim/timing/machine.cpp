// SPDX-License-Identifier: Apache-2.0
// machine.cpp: see machine.hpp.
#include "sim/timing/machine.hpp"

#include <algorithm>
#include <cstdio>
#include "sim/timing/knobs.hpp"
#include <bit>
#include <stdexcept>
#include <string>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"

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
  walk_peak.resize(trace.walks.size() + 2), walk_done.resize(trace.walks.size() + 2, -1), walk_last.resize(trace.walks.size() + 2, -1);
  if (config.has_watermarks()) near_step = dopu_depth_near(trace.config, trace.frame);
  constexpr Cycle kHarnessCycles = 5;  // of the harness before the restart
  for (Cycle i = 0; i < kHarnessCycles; ++i) memory.idle_step();
  for (int kind = 0; kind < kUnitEnd; ++kind) {
    for (int lane = 0; lane < 4; ++lane) {
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
  const int kind = number >> 2, lane = number & 3;
  const auto k = static_cast<size_t>(lane);
  switch (kind) {
    case kPublish:
      for (Ru& one : ru) one.publish(*this, now);
      layer_free.publish(*this, now);
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

bool Machine::other_spills(int lane, Cycle now) const {
  for (int k = 0; k < units; ++k) {
    if (k != lane && su[static_cast<size_t>(k)].spilling(now)) return true;
  }
  return false;
}

Cycle Machine::run() {
  while (cycle()) {}
  if (x_log() != 0) {
    for (const Spilled& s : spills) fprintf(stderr, "spill %lld lane %d walk %zu window %zu mark %d sent %d\n", static_cast<long long>(s.at), s.lane, s.walk, trace.walks[s.walk].window, s.mark, s.sent_walk == s.walk ? s.sent : 999);
    for (size_t i = 0; i < trace.walks.size(); ++i)
      fprintf(stderr, "walk %zu window %zu %c%d peak %d done %d last %d end %lld\n", i, trace.walks[i].window, trace.walks[i].variant, trace.walks[i].place, walk_peak[i], walk_done[i], walk_last[i], static_cast<long long>(i < walk_ends.size() ? walk_ends[i] : -1));
    uint64_t quads = 0;
    for (Su& one : su) fprintf(stderr, "su episodes %llu spilled %llu refilled %llu again %llu\n", static_cast<unsigned long long>(one.episodes_), static_cast<unsigned long long>(one.spilled_), static_cast<unsigned long long>(one.refilled_), static_cast<unsigned long long>(one.again_));
    for (Ru& one : ru) {
      quads += one.live_.issued_;
      fprintf(stderr, "ru quads/4 %llu halves %llu regions %llu blocked %llu hazards/4 %llu\n", static_cast<unsigned long long>(one.live_.issued_ / 4), static_cast<unsigned long long>(one.live_.fired_), static_cast<unsigned long long>(one.live_.picked_), static_cast<unsigned long long>(one.live_.blocked_), static_cast<unsigned long long>(one.live_.hazard_ / 4));
    }
    fprintf(stderr, "quads %llu per group %llu\n", static_cast<unsigned long long>(quads), static_cast<unsigned long long>(quads / 16));
  }
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
  if (x_stat() != 0 && now % 8 == 0) {
    static uint64_t n = 0, c[40];
    ++n;
    int rubusy = 0, vis = 0, culled_wait = 0, tiles = 0, full = 0, splits = 0, sorts = 0, inwait = 0, used = 0, outw = 0, merge_wait = 0, spill = 0, idle = 0;
    for (Ru& r : ru) rubusy += r.live_.queued_ != 0 || r.live_.halves_ != 0;
    for (Ru& r : ru) idle += r.queue.empty();
    for (Pu& p : pu) { vis += p.visible.count() > 0 || p.phases_.first().holding; culled_wait += p.culled.shown(now); tiles += p.queued_.count() >= 60; }
    for (Su& u : su) {
      full += u.used_ == u.records_; splits += !u.split_idle(now); sorts += u.sorting_; inwait += u.in_.valid(now); used += u.used_; outw += u.out_.valid; spill += u.spill_ != Su::kSpillIdle;
    }
    merge_wait = merge.out.valid;
    c[0] += rubusy; c[1] += idle; c[2] += vis; c[3] += culled_wait; c[4] += tiles; c[5] += full; c[6] += splits; c[7] += sorts; c[8] += inwait; c[9] += static_cast<uint64_t>(used); c[10] += outw; c[11] += merge_wait; c[12] += spill;
    c[13] += dopu.emit_valid_ != 0; c[14] += dopu.multiplying_ || dopu.shifting_; c[15] += dopu.nearest_ && !dopu.nearest_->queue_->idle();
    c[16] += dopu.nearest_ && !dopu.nearest_->in_test_.empty();
    for (int k = 0; k < config.pu_fronts(); ++k) c[17] += pu[static_cast<size_t>(k)].pipe_count_ > 0;
    c[18] += dopu.nearest_ && (dopu.nearest_->open_[1].reader.wants());
    c[19] += dopu.nearest_ && dopu.nearest_->queue_->crowded();
    bool oneset = true; int dones = 0;
    for (auto& s : dopu.sets_) dones += s.valid; oneset = dones == 1; c[20] += oneset;
    c[21] += dopu.nearest_ && dopu.nearest_->valid_;
    for (Su& u : su) c[22] += u.closed_[0] + u.closed_[1];
    for (Pu& p : pu) {
      c[23] += p.phases_.out.valid; c[24] += p.conic_.out.valid; c[25] += p.parts_.out.valid; c[26] += p.coeff_.out.valid; c[27] += static_cast<uint64_t>(p.walks_.count()); c[28] += p.tiles_.valid; c[29] += p.late_out_.valid; c[30] += static_cast<uint64_t>(p.queued_.count()); c[31] += p.phases_.first().holding;
    }
    for (Ru& r : ru) {
      const bool none = !r.splat_valid_ && r.queue.empty() && r.live_.queued_ == 0 && r.live_.halves_ == 0;
      for (unsigned g = 0; g < 4; ++g) c[32] += r.live_.groups_[g].count != 0;
      c[33] += none && dispatch.waiting_ == 0 && !merge.out.valid;
      c[34] += none && (dispatch.waiting_ != 0 || merge.out.valid);
      c[35] += !none && r.live_.queued_ == 0;
    }
    static const char* name[] = {"ru busy", "ru queue empty", "pu has visible", "culled waits", "pu out full", "su full", "splitting", "bitonic", "su in waits", "su used", "su out", "merge out", "spill", "dopu emit waits", "dopu origin", "dopu queue busy", "dopu testing", "cull busy(of 2)", "chunk reader wants", "queue crowded", "one set", "dopu item", "su sets closed", "phases out", "conic out", "parts out", "coeff out", "walks", "tiles", "late out", "queued", "project holds", "groups with work(16)", "ru none, stream none", "ru none, others full", "ru something, no quads"};
    if (now % (1 << 21) == 0 || x_stat() == now) { fprintf(stderr, "@%lld", static_cast<long long>(now)); for (int i = 0; i < 36; ++i) fprintf(stderr, " | %s %.2f", name[i], double(c[i]) / double(n)); fprintf(stderr, "\n"); }
  }
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
