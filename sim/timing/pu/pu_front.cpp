// SPDX-License-Identifier: Apache-2.0
// pu_front.cpp: a PU's fetch and cull, and its stages up to the regions: see pu.hpp.
#include <algorithm>
#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {
Pu::Pu(const Machine& m, int lane)
    : color(m, lane),
      lane_(lane),
      front_(lane < m.config.pu_fronts()),
      late_(!m.config.caches_alphas()),
      lists_(m.config.has_lists()),
      has_parts_(m.config.parts() > 1),
      tight_(m.config.tight_cull != 0),
      four_(m.config.pace == 4),
      reader_(m.config.gaussians_per_line(), m.frame.tables.gaussians, m.config.geometry_jobs(),
              m.config.geometry_lines()),
      phases_(pu_built(m.config, "project", "conic")),
      coeff_phases_(pu_built(m.config, "coeff", "coeff")),
      expand_(lane),
      parts_(lane),
      ended_(m.config.alpha_layers),
      alpha_lines_(m.config.alpha_lines),
      alpha_addresses_(m.config.alpha_addresses()),
      rows_(m.config.pixels_per_row),
      pieces_(m.config.alpha_memory_lines()) {
  constexpr size_t kDecode = 4, kCull = 8;  // stages
  pipe_.assign(m.config.coded() ? kDecode + kCull : kCull, kBubble);
  pipe_walk_.resize(pipe_.size());
}

// --- pu_fetch --------------------------------------------------------------------------------------------------------

void Pu::reader(Machine& m, Cycle now) {
  const int port = m.memory.geometry_port(lane_);
  const bool room = !front_ || reader_.room_before_job(now);
  Reader::Job job;
  const bool is_mark = m.config.has_watermarks() && m.dopu.chunk().end == kLayerEndBeat;
  const bool take = room && m.dopu.chunk_shown(lane_, now) && (!is_mark || marks.room(now));
  if (take) {
    const ChunkBeat& chunk = m.dopu.take_chunk(m, lane_);
    m.show(now, Border::kChunk, lane_, is_end(chunk.end) ? end_kind(chunk.end) : 0);
    if (is_mark) marks.push(now, chunk.mark);
    if (!front_) return;
    job.read = !is_end(chunk.end);
    job.first = chunk.slot;
    job.count = chunk.count;
    job.tag = {chunk.end, chunk.first, chunk.survivors, chunk.walk};
  }
  reader_.step(now, m.memory.granted(port, now), m.memory.answered(port), take ? &job : nullptr);
  if (reader_.wants()) m.memory.ask(port, reader_.line(), false, reader_.lines());
  m.wheel.wake(unit(kCull, lane_), reader_.item_from(now));
  m.wheel.wake(unit(kReader, lane_), reader_.next(now));
  if (const bool next = reader_.room_next(now); next != chunk_room_) {
    chunk_room_ = next;
    if (m.dopu.has_chunk()) {
      m.wheel.wake(unit(kDopu), now + 1);
      m.wheel.wake(unit(kReader, lane_), now + 1);
    }
  }
}

// --- pu_cull ---------------------------------------------------------------------------------------------------------

// With Occlusion: whether the Gaussian there touches nothing of the rectangle around what is open.
bool Pu::beside(const Machine& m, Cycle now, unsigned place) const {
  const Beat beat = pipe_[place];
  if (beat == kBubble || is_end(beat)) return false;
  return beyond(m.open.closed(m, pipe_walk_[place], now), m.trace.most[beat]);
}

void Pu::cull(Machine& m, Cycle now) {
  Output<Beat>& out = tight_ ? survivor_ : culled;
  if (out.valid) return;  // pu_deal or pu_reach wakes us
  const Beat leaving = pipe_[pipe_at_];
  if (leaving != kBubble) {
    out.set(now + 1, leaving);
    m.wheel.wake(tight_ ? unit(kReach, lane_) : unit(kDeal), now + 1);
    --pipe_count_;
  }
  Beat entering = kBubble;
  uint32_t reader_walk = 0;
  const bool item = reader_.item_shown(now);
  if (item) {
    const Reader::Job& job = reader_.job();
    reader_walk = job.tag.walk;
    const int eyes = m.trace.walks[reader_walk].eyes;
    const int seen = static_cast<int>(reader_.item()) * eyes + eye_;  // a Gaussian comes once for each eye (pu_eyes)
    if (!job.read) {
      entering = job.tag.end;
    } else if ((job.tag.survivors >> seen & 1) != 0) {
      entering = job.tag.first + static_cast<Beat>(std::popcount(job.tag.survivors & ((uint64_t{1} << seen) - 1)));
    }
    eye_ = job.read && eye_ + 1 < eyes ? eye_ + 1 : 0;
    if (eye_ == 0) {
      reader_.pop_item(now);
      if (reader_.needs_step(now)) m.wheel.wake_now(unit(kReader, lane_));
    }
  }
  pipe_[pipe_at_] = entering;
  if (item) pipe_walk_[pipe_at_] = reader_walk;
  // The rectangle goes into the register behind stage 4.
  if (const unsigned place = (pipe_at_ + 3) % pipe_.size(); m.config.occlusion && beside(m, now, place)) {
    pipe_[place] = kBubble;
    --pipe_count_;
  }
  pipe_at_ = pipe_at_ + 1 == pipe_.size() ? 0 : pipe_at_ + 1;
  if (entering != kBubble) ++pipe_count_;
  if (pipe_count_ > 0 || item) m.wheel.wake(unit(kCull, lane_), now + 1);
}

// --- pu_reach --------------------------------------------------------------------------------------------------------

void Pu::reach(Machine& m, Cycle now) {
  const int self = unit(kReach, lane_);
  const auto dropped = [&] { return !is_end(reach_.front()) && m.trace.dropped[reach_.front()] != 0; };
  if (reach_offered_ ? !culled.valid : reach_.valid(now) && dropped()) {
    reach_.pop(now);
    reach_offered_ = false;
    if (survivor_.valid) m.wheel.wake(self, now + 1);
  }
  if (survivor_.shown(now) && reach_.room(now)) {
    reach_.push(now, survivor_.value);
    survivor_.valid = false;
    m.wheel.wake_now(unit(kCull, lane_));
  }
  if (reach_.empty() || reach_offered_) return;
  if (dropped()) return m.wheel.wake(self, reach_.head_from());
  culled.set(reach_.head_from(), reach_.front());
  reach_offered_ = true;
  m.wheel.wake(unit(kDeal), culled.from);
}

// --- stages of eight or four cycles ----------------------------------------------------------------------------------

void Pu::project(Machine& m, Cycle now) {
  if (visible.empty() || !phases_.can_take()) return;  // pu_deal, or pu_conic wakes us
  const int self = unit(kProject, lane_);
  const Cycle when = std::max(phases_.ready(), visible.head_from());
  if (when > now) return m.wheel.wake(self, when);
  if (visible.count() > Config::visible_depth() - m.config.eyes) m.wheel.wake(unit(kDeal), now + 1);
  const Beat beat = visible.front();
  visible.pop(now);
  if (phases_.take(now, beat)) m.wheel.wake(unit(kConic, lane_), four_ ? now + 1 : phases_.out.from);
  if (!visible.empty() && phases_.can_take()) m.wheel.wake(self, std::max(phases_.ready(), visible.head_from()));
}

// A slot takes a new record to the front and sends the front record out, in phase `out_phase`; `tail` cycles later the
// next slot begins, at once when there was nothing to calculate.
void Pu::slot(Machine& m, Cycle now, SlotStage& stage, Output<Beat>& in, int giver, int self, int taker, int out_phase,
              int tail) {
  if (stage.active) {
    if (now < stage.out_at) return m.wheel.wake(self, stage.out_at);
    if (stage.front_valid && stage.out.valid) return;  // the taker wakes us
    if (stage.front_valid) {
      stage.out.set(now + 1, stage.front);
      m.wheel.wake(taker, now + 1);
    }
    stage.active = false;
    stage.front_valid = stage.fresh;
    stage.free_at = now + 1;
    if (stage.fresh) {
      stage.front = in.value;
      in.valid = false;
      m.wheel.wake_now(giver);
      if (!is_end(stage.front)) stage.free_at = now + tail;
    }
  }
  if (!stage.front_valid && !in.valid) return;
  const Cycle when = stage.front_valid ? stage.free_at : std::max(stage.free_at, in.from);
  if (when > now) return m.wheel.wake(self, when);
  stage.active = true;
  stage.fresh = in.shown(now);
  stage.out_at = now + out_phase;
  m.wheel.wake(self, stage.out_at);
}

// At a pace of four cycles the last stage of `phases` shows what it has at `out`, its own until that is taken: tells
// whether it was.
bool Pu::show(Phases& phases, bool& shown, Output<Beat>& out, Cycle now) {
  const bool taken = shown && !out.valid;
  if (taken) {
    shown = phases.out.valid = false;
    phases.taken(now);
  }
  if (!shown && phases.out.valid) {
    shown = true;
    out.set(phases.out.from, phases.out.value);
  }
  return taken;
}

void Pu::conic(Machine& m, Cycle now) {
  const bool there = phases_.out.valid;
  if (four_) {
    if (show(phases_, conic_shown_, conic_.out, now)) m.wheel.wake_now(unit(kProject, lane_));
    if (conic_.out.valid) m.wheel.wake(unit(lists_ || has_parts_ ? kExpand : kCoeff, lane_), conic_.out.from);
    return;
  }
  slot(m, now, conic_, phases_.out, unit(kProject, lane_), unit(kConic, lane_),
       unit(lists_ || has_parts_ ? kExpand : kCoeff, lane_), 5, 3);
  if (!there || phases_.out.valid) return;
  if (phases_.taken(now)) m.wheel.wake(unit(kConic, lane_), phases_.out.from);
}

void Pu::coeff(Machine& m, Cycle now) {
  Output<Beat>& in = lists_ ? expand_.out : has_parts_ ? parts_.out : conic_.out;
  if (four_) {
    show(coeff_phases_, coeff_shown_, coeff_.out, now);
    if (in.valid && coeff_phases_.can_take()) {
      const Cycle when = std::max(coeff_phases_.ready(), in.from);
      if (when > now) m.wheel.wake(unit(kCoeff, lane_), when);
      if (when <= now) {
        in.valid = false;
        m.wheel.wake_now(unit(lists_ || has_parts_ ? kExpand : kConic, lane_));
        coeff_phases_.take(now, in.value);
        show(coeff_phases_, coeff_shown_, coeff_.out, now);
      }
    }
    if (coeff_.out.valid) m.wheel.wake(unit(kIntersect, lane_), coeff_.out.from);
    return;
  }
  slot(m, now, coeff_, in, unit(lists_ || has_parts_ ? kExpand : kConic, lane_), unit(kCoeff, lane_),
       unit(kIntersect, lane_), 3, 5);
}

// --- pu_intersect ----------------------------------------------------------------------------------------------------

void Pu::intersect(Machine& m, Cycle now) {
  const int self = unit(kIntersect, lane_);
  const bool full = tiles_.valid;
  if (intersect_.step(now, walks_.valid(now) ? &walks_.front() : nullptr, tiles_, m.trace)) walks_.pop(now);
  if (!full && tiles_.valid) m.wheel.wake(lists_ && late_ ? unit(kLists) : unit(kBack, lane_), now + 1);
  if (coeff_.out.shown(now)) {
    if (walks_.room(now)) {
      walks_.push(now, coeff_.out.value);
      coeff_.out.valid = false;
      m.wheel.wake_now(unit(kCoeff, lane_));
    } else if (walks_.last_pop() == now) {
      m.wheel.wake(self, now + 1);
    }
  }
  m.wheel.wake(self, intersect_.next(now));
  if (walks_.empty()) return;
  if (walks_.head_from() > now) m.wheel.wake(self, walks_.head_from());
  if (is_end(walks_.front())) m.wheel.wake(self, now + 1);
}

}  // namespace pipegs::timing
