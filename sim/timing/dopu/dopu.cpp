// SPDX-License-Identifier: Apache-2.0
// dopu.cpp: see dopu.hpp.
#include "sim/timing/dopu/dopu.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "cpp_model/dopu/dopu_axis.hpp"
#include "cpp_model/dopu/dopu_layer.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

constexpr int kQuietCycles = 127;
constexpr Cycle kOriginCycles = 9, kShiftCycles = 4, kPlanesCycles = 53;

}  // namespace

Dopu::Dopu(const Machine& m)
    : units_(m.units),
      slabs_(m.config.slabs()),
      slab_cells_(m.config.slab_cells()),
      axis_(dopu_axis(m.frame)),
      walks_(m.trace.walks.size()),
      judges_(m.frame.walk_most != 0),
      most_asked_(m.config.node_lines() / 2),
      asked_(most_asked_),
      table_line_(m.frame.tables.cells) {
  table_left_ = table_coming_ = (m.config.table_cells() + 1) / 2;
  const int camera = dopu_layer_camera(m.config, m.frame, axis_);
  for (int step = 0; step < 2 * slabs_; ++step) {
    slab_of_step_[static_cast<size_t>(step)] = dopu_layer_step(m.config, camera, step);
  }
  if (m.config.has_watermarks()) {
    nearest_ = std::make_unique<Nearest>(m.trace, m.config);
  } else {
    descend_ = std::make_unique<Descend>(m.trace);
  }
}

const ChunkBeat& Dopu::take_chunk(Machine& m, int lane) {
  emit_taken_ |= uint32_t{1} << lane;
  m.wheel.wake_now(unit(kDopu));
  return emit_chunk_;
}

uint32_t Dopu::ready_pus(const Machine& m, Cycle now) const {
  uint32_t ready = 0;
  const bool is_mark = m.config.has_watermarks() && emit_chunk_.end == kLayerEndBeat;
  for (int k = 0; k < units_; ++k) {
    const Pu& pu = m.pu[static_cast<size_t>(k)];
    const bool shown = (emit_valid_ >> k & 1) != 0, full = is_mark && shown && !pu.marks.room(now);
    ready |= uint32_t{(pu.front() ? pu.chunk_room(now) : shown) && !full} << k;
  }
  return ready;
}

void Dopu::step(Machine& m, Cycle now) {
  if (!busy_) return;
  // Cycles since the last step: nothing moved in them, so the clock may have stopped.
  if (stepped_ >= 0) {
    int quiet = acted_ ? 0 : std::min(quiet_ + 1, kQuietCycles);  // of the next cycle
    const Cycle between = now - stepped_ - 1;
    if (level_) {
      quiet = between > 0 ? 0 : quiet;
    } else {
      frozen_ += std::max<Cycle>(0, between - (kQuietCycles - quiet));
      quiet = static_cast<int>(std::min<Cycle>(kQuietCycles, quiet + between));
    }
    quiet_ = quiet;
  }
  stepped_ = now;
  woken_ = origin_taken_ = window_sent_ = window_walked_ = false;

  DopuCycle cycle;
  cycle.now = now;
  cycle.phase = static_cast<int>((now - frozen_) % 3);
  cycle.cell = item_valid_ && item_shown_ ? &item_ : nullptr;
  emit(m, cycle);
  origin(m, cycle);
  port(m, cycle);
  nearest_ ? nearest_->step(cycle, sets_) : descend_->step(cycle, sets_);
  cells(m, cycle);
  windows(m, cycle);
  ask(m);

  acted_ = cycle.moved || woken_ || level_ || now == 0;
  if (!acted_ && quiet_ == kQuietCycles) ++frozen_;  // this cycle's edge does not come
  if (last_sent_ && emit_valid_ == 0) busy_ = false;

  // What comes by itself.
  if (cycle.changed) cycle.at(now + 1);
  if (multiplying_ && multiplied_at_ > now) cycle.at(multiplied_at_);
  if (shifting_ && shifted_at_ > now) cycle.at(shifted_at_);
  if (planes_ != kPlanesReady && planes_at_ > now) cycle.at(planes_at_);
  if (now < 2 + m.config.focal_w()) cycle.at(2 + m.config.focal_w());
  m.wheel.wake(unit(kDopu), cycle.next);
}

// --- dopu_emit -------------------------------------------------------------------------------------------------------

void Dopu::emit(Machine& m, DopuCycle& cycle) {
  const Cycle now = cycle.now;
  const bool held = emit_valid_ != 0, standing = shifting_ && shifted_at_ <= now;
  level_ = false;
  if (emit_taken_ != 0) {
    emit_valid_ &= ~emit_taken_;
    emit_taken_ = 0;
    cycle.changed = true;
    woken_ = true;
  }
  if (!held && !standing) return;
  const uint32_t ready = ready_pus(m, now);
  if (ready != 0) woken_ = true;  // blocked && chunk_ready
  level_ = ready != 0;
  if (held || !standing || (shifted_.data() && ready == 0)) return;
  // The chunk, or the end, moves to the output.
  cycle.moved = cycle.changed = origin_taken_ = true;
  emit_chunk_ = {};
  if (shifted_.data()) {
    const TimingNode& node = m.trace.chunks[shifted_.node];
    emit_chunk_ = {0, node.first,          node.count, shifted_.chunk->first, shifted_.chunk->survivors,
                   0, shifted_.chunk->walk};
    emit_last_ = round_robin(ready, emit_last_);
    emit_valid_ = uint32_t{1} << emit_last_;
    had_chunk_ = true;
  } else {
    emit_chunk_.end = shifted_.end;
    emit_chunk_.mark = shifted_.mark;
    const bool drop = shifted_.end == kLayerEndBeat && !had_chunk_;
    emit_valid_ = drop ? 0 : (uint32_t{1} << units_) - 1;
    had_chunk_ = false;
    if (shifted_.last) last_sent_ = true;
  }
  emit_from_ = now + 1;
  level_ = false;
  for (int k = 0; k < units_; ++k) m.wheel.wake(unit(kReader, k), now + 1);
}

// --- dopu_origin -----------------------------------------------------------------------------------------------------

void Dopu::origin(const Machine& m, DopuCycle& cycle) {
  const Cycle now = cycle.now;
  const bool was_multiplying = multiplying_;
  if (multiplying_ && now >= multiplied_at_ && (!shifting_ || origin_taken_)) {
    shifting_ = true;
    shifted_ = multiplied_;
    shifted_at_ = now + (shifted_.data() ? kShiftCycles : 1);
    multiplying_ = false;
    cycle.changed = true;
  } else if (origin_taken_) {
    shifting_ = false;
    cycle.changed = true;
  }
  const DopuItem* item = node(now);
  if (item == nullptr) return;
  if (item->end == kWindowEndBeat && sets_[item->set].given_up) {
    window_sent_ = cycle.node_taken = cycle.moved = cycle.changed = true;
    return;
  }
  if (was_multiplying) return;
  multiplying_ = true;
  multiplied_ = *item;
  multiplied_at_ = now + (multiplied_.data() ? kOriginCycles : 1);
  window_sent_ = multiplied_.end == kWindowEndBeat;
  if (window_sent_ && !m.trace.walks[sets_[multiplied_.set].walk].ends) multiplied_.end = kPartEndBeat;
  cycle.node_taken = cycle.moved = cycle.changed = true;
}

// --- the memory port -------------------------------------------------------------------------------------------------

void Dopu::port(Machine& m, DopuCycle& cycle) {
  const int port = m.memory.node_port();
  const bool granted = m.memory.granted(port, cycle.now), answered = m.memory.answered(port);
  if (granted || answered) woken_ = true;
  if (granted) {
    cycle.granted = port_last_ = port_shown_;
    port_locked_ = false;
    if (cycle.granted == 2) {
      const int lines = table_lines();
      table_line_ += static_cast<uint64_t>(lines);
      table_left_ -= lines;
    } else {
      asked_.push(cycle.now, {cycle.granted, lines(cycle.granted)});
    }
  }
  if (!answered) return;
  if (table_coming_ > 0) {
    cycle.answered = 2;
    --table_coming_;
  } else {
    cycle.answered = asked_.front().level;
    if (--asked_.front().lines == 0) asked_.pop(cycle.now);
  }
  cycle.changed = true;
}

void Dopu::ask(Machine& m) {
  const auto wants = [&](int level) { return nearest_ ? nearest_->wants(level) : descend_->wants(level); };
  const uint32_t requests = uint32_t{wants(0)} | uint32_t{wants(1)} << 1 | uint32_t{table_left_ > 0} << 2;
  if (requests == 0) {
    port_locked_ = false;
    return;
  }
  if (!port_locked_ || (requests >> port_shown_ & 1) == 0) port_shown_ = round_robin(requests, port_last_);
  port_locked_ = true;
  if (asked_.count() == most_asked_) return;
  if (port_shown_ == 2) {
    m.memory.ask(m.memory.node_port(), table_line_, false, table_lines());
  } else {
    m.memory.ask(m.memory.node_port(), line(port_shown_), false, lines(port_shown_));
  }
}

// --- dopu_cells ------------------------------------------------------------------------------------------------------

void Dopu::cells(const Machine& m, DopuCycle& cycle) {
  const Cycle now = cycle.now;
  const DopuSet& set = sets_[walk_set_];
  const bool advance = !item_valid_ || !item_shown_ || cycle.cell_taken;
  if (advance && item_valid_) item_valid_ = false, cycle.changed = true;
  const bool loading = table_coming_ > 0 || cycle.answered == 2;  // an answer of this cycle counts from the next one on
  if (!walking_ || loading || (m.config.has_slabs() && now < 2 + m.config.focal_w()) || !set.fresh) return;
  const bool done = set.done;
  const bool inside = walk_step_ < 2 * slabs_ && slab_of_step_[static_cast<size_t>(walk_step_)] >= 0;
  if (advance || !inside) cycle.moved = cycle.changed = true;
  const bool read = advance && (inside || done);
  const bool is_end = end_next_ || done, window_end = walk_layer_ == slabs_ - 1 || done;
  const bool finished = read && is_end && window_end, last = set.walk + 1 == walks_;
  if (read) {
    item_valid_ = true;
    item_ = {};
    item_.set = walk_set_;
    if (is_end) {
      item_.end = window_end ? kWindowEndBeat : kLayerEndBeat;
      item_.last = window_end && last;
      item_shown_ = true;
    } else {
      item_.node = static_cast<uint32_t>(
          dopu_layer_cell(m.config, axis_, slab_of_step_[static_cast<size_t>(walk_step_)], walk_number_));
      item_shown_ = m.trace.cells[item_.node].count != 0;
    }
  }
  if (finished) {
    window_walked_ = true;
    if (last) walking_ = false;
    walk_step_ = walk_layer_ = walk_number_ = 0;
    end_next_ = false;
  } else if (!inside) {
    ++walk_step_;
  } else if (read && end_next_) {
    ++walk_step_;
    ++walk_layer_;
    end_next_ = false;
  } else if (read) {
    end_next_ = walk_number_ == slab_cells_ - 1;
    walk_number_ = end_next_ ? 0 : walk_number_ + 1;
  }
}

// --- dopu_windows ----------------------------------------------------------------------------------------------------

bool Dopu::all_done(const Machine& m, size_t number) const {
  const TimingWalk& walk = m.trace.walks[number];
  RegionSet done;
  for (const Ru& ru : m.ru) {
    if (ru.window() == walk.window) done |= ru.done();
  }
  for (uint64_t part = 0; part < static_cast<uint64_t>(m.config.parts()); ++part) {
    if (walk_has(m.config, walk.walk, part) && std::popcount(done.mask[part]) != m.config.mask_w()) return false;
  }
  return true;
}

// What is closed of the set's walk, none if that is no news for its planes.
Closed Dopu::closed(const Machine& m, size_t set, Cycle now) const {
  if (!sets_[set].valid || sets_[set].judges || sets_[set].given_up) return {};
  const Closed closed = m.open.closed(m, sets_[set].walk, now);
  return closed == sets_[set].closed ? Closed{} : closed;
}

// Planes are made anew; tells whether they are asked for.
bool Dopu::refit(const Machine& m, Cycle now) {
  for (const size_t set : {size_t{oldest_}, size_t{oldest_} ^ 1}) {
    refit_closed_ = closed(m, set, now);
    refit_set_ = set;
    refit_ = !(refit_closed_ == Closed{});
    if (refit_) return true;
  }
  return false;
}

void Dopu::windows(const Machine& m, DopuCycle& cycle) {
  const Cycle now = cycle.now;
  // done of the next cycle; the sets as they were when this one began.
  for (size_t s = 0; s < 2; ++s) {
    const bool done = sets_[s].valid && !sets_[s].judges && !m.config.has_lists() && all_done(m, sets_[s].walk);
    if (done != done_[s]) woken_ = cycle.changed = true;
    done_[s] = done;
  }
  if (planes_ == kPlanesBusy && now >= planes_at_) planes_ = kPlanesReady;
  const bool occlusion = m.config.occlusion != 0;
  if (refit_) woken_ = cycle.changed = true;
  if (planes_ == kPlanesReady && refit_) {
    DopuSet& set = sets_[refit_set_];
    set.closed_before = set.closed;
    set.closed = refit_closed_;
    set.closed_from = now + 1;
    refit_ = false;
    planes_ = kPlanesIdle;
    planes_at_ = now + 1;
  } else if (planes_ == kPlanesReady && !sets_[fill_].valid) {
    DopuSet& set = sets_[fill_];
    const TimingWalk& walk = m.trace.walks[next_walk_];
    set.valid = set.fresh = true;
    set.given_up = false;
    set.walk = next_walk_;
    set.chunk = walk.first_chunk;
    set.closed = set.closed_before = {};
    set.judges = judges_ && walk.walk == kWholeWalk;
    if (!set.judges) ++next_walk_;
    fill_ ^= 1;
    planes_ = kPlanesIdle;
    planes_at_ = now + 1;
    cycle.changed = true;
  } else if (planes_ == kPlanesIdle && now >= planes_at_ &&
             ((next_walk_ < walks_ && !sets_[fill_ ^ 1].judges && !(occlusion && sets_[fill_].valid)) ||
              (occlusion && refit(m, now)))) {
    planes_ = kPlanesBusy;
    planes_at_ = now + kPlanesCycles;
    if (refit_) woken_ = cycle.changed = true;
  }
  if (window_walked_) {
    sets_[walk_set_].fresh = false;
    walk_set_ ^= 1;
    cycle.changed = true;
  }
  if (cycle.judged) {
    DopuSet& set = sets_[fill_ ^ 1];
    set.judges = false;
    set.given_up = cycle.split;
    if (set.given_up != m.trace.walks[next_walk_++].given_up)
      throw std::logic_error("timing model: another judgement than the trace's");
  }
  if (window_sent_) {
    sets_[oldest_].valid = false;
    oldest_ ^= 1;
    cycle.changed = true;
  }
  for (size_t s = 0; s < 2; ++s) sets_[s].done = (done_[s] || sets_[s].given_up) && sets_[s].valid;
}

}  // namespace pipegs::timing
