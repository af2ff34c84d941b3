// SPDX-License-Identifier: Apache-2.0
// pu_back.cpp: a PU behind the regions: pu_cache (allocate, rows, spill) or pu_late: see pu.hpp.
#include <algorithm>
#include <bit>

#include "cpp_model/ru/ru_walk.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {

uint64_t Pu::done_regions(const Machine& m, uint64_t part) const {
  uint64_t done = 0;
  for (const Ru& ru : m.ru) {
    if (ru.window() == window_) done |= ru.done().mask[part];
  }
  return done;
}

// pu_allocate hears of it in the next cycle, and has the slot in the one after that.
void Pu::line_free(Machine& m, Cycle now) {
  --used_;
  line_free_at_ = {now, line_free_at_[0]};
  m.wheel.wake(unit(kBack, lane_), now + 2);
}

void Pu::layer_free(Machine& m, Cycle now) {
  if (late_) return;
  layer_free_at_ = now;
  m.wheel.wake_now(unit(kBack, lane_));
  m.wheel.wake(unit(kBack, lane_), now + 1);
}

void Pu::back(Machine& m, Cycle now) {
  if (lists_) return late_ ? void() : lines(m, now);
  if (late_) return late(m, now);
  allocate(m, now);
}

// The record at the output of pu_intersect, without regions that are done. Counts windows.
bool Pu::take_tiles(Machine& m, Cycle now) {
  if (!tiles_.shown(now)) return false;
  splat_ = {tiles_.value, 0, 0, static_cast<uint8_t>(lane_), false};
  if (!is_end(splat_.beat)) {
    const uint64_t part = m.trace.part(splat_.beat);
    splat_.part = static_cast<uint8_t>(part);
    splat_.mask = m.trace.mask[splat_.beat] & ~done_regions(m, part);
  }
  tiles_.valid = false;
  m.wheel.wake_now(unit(kIntersect, lane_));
  if (splat_.beat == kWindowEndBeat) ++window_;
  return true;
}

// --- pu_allocate -----------------------------------------------------------------------------------------------------

void Pu::allocate(Machine& m, Cycle now) {
  const int self = unit(kBack, lane_);
  if (now >= allocate_at_) {
    switch (allocate_) {
      case kTake:
        if (!ended_.room(now) || !take_tiles(m, now)) break;
        if (is_end(splat_.beat)) {
          allocate_ = kOffer;
          allocate_at_ = now + 1;
          row_valid_ = color_valid_ = true;
          ended_.push(now, own_);
          area_ ^= own_.spilled;
          own_ = {};
          overflow_ = 0;
        } else {
          lines_ = std::popcount(splat_.mask);
          if (lines_ != 0) allocate_ = kDecide;
          allocate_at_ = now + 2;
        }
        m.wheel.wake(self, allocate_at_);
        break;
      case kDecide: {
        const bool fits = own_.lines + lines_ <= alpha_lines_;
        const int used = used_ + (line_free_at_[0] > now - 2) + (line_free_at_[1] > now - 2);
        const bool room =
            fits ? used + lines_ <= alpha_lines_ && held_ + lines_ <= alpha_addresses_ : own_.spilled || areas_ < 2;
        if (!room) break;  // a free line or layer wakes us
        if (fits) {
          own_.lines += lines_;
          used_ += lines_;
          held_ += lines_;
          m.peak_lines = std::max(m.peak_lines, static_cast<uint64_t>(used_));
        } else {
          splat_.ext = true;
          splat_.address = static_cast<uint32_t>(area_) << ru_number_w(m.config) | overflow_;
          areas_ += own_.spilled ? 0 : 1;
          own_.spilled = true;
          overflow_ += static_cast<uint32_t>(lines_);
          m.overflow_lines += static_cast<uint64_t>(lines_);
        }
        row_valid_ = color_valid_ = true;
        allocate_ = kOffer;
        allocate_at_ = now + 1;
        m.wheel.wake(self, allocate_at_);
        break;
      }
      case kOffer:
        if (row_valid_ && jobs_.room(now)) {
          jobs_.push(now, {splat_.beat, splat_.mask, splat_.address, splat_.ext});
          m.wheel.wake(unit(kRows, lane_), jobs_.head_from());
          row_valid_ = false;
        }
        if (color_valid_ && color.room(now)) {
          color.push(m, now, splat_);
          color_valid_ = false;
        }
        if (row_valid_ || color_valid_) break;
        allocate_ = kTake;
        allocate_at_ = now + 1;
        m.wheel.wake(self, allocate_at_);
        break;
    }
  }
  if (layer_free_at_ == now) {
    held_ -= ended_.front().lines;
    areas_ -= ended_.front().spilled ? 1 : 0;
    ended_.pop(now);
    m.wheel.wake(self, now + 1);
  }
}

// --- pu_late ---------------------------------------------------------------------------------------------------------

void Pu::late(Machine& m, Cycle now) {
  if (late_out_.shown(now)) {
    const bool end = is_end(splat_.beat), drop = !end && splat_.mask == 0;
    if (!drop) {
      const Beat asked = end ? kBubble : has_parts_ ? m.trace.survivor[splat_.beat] : splat_.beat;
      const bool again = !end && asked == asked_;
      if (!queued_.room(now) || (!again && !color.room(now))) return;  // the SU or the colour wakes us
      if (!again) color.push(m, now, splat_);
      queued_.push(now, {splat_, again});
      asked_ = asked;
      m.wheel.wake(unit(kSu, lane_), queued_.head_from());
    }
    late_out_.valid = false;
  }
  if (late_out_.valid || !take_tiles(m, now)) return;
  late_out_.set(now + 1, 0);
  m.wheel.wake(unit(kBack, lane_), now + 1);
}

void Pu::take_splat(Machine& m, Cycle now) {
  if (!late_) return color.taken(m, now);
  if (!queued_.front().again) color.taken(m, now);
  queued_.pop(now);
  m.wheel.wake(unit(kSu, lane_), queued_.head_from());
  m.wheel.wake(unit(kBack, lane_), now + 1);
}

// --- pu_lines; late records go to the lists as they are --------------------------------------------------------------

void Pu::lines(Machine& m, Cycle now) {
  const int self = unit(kBack, lane_);
  if (now < allocate_at_) return;
  switch (allocate_) {
    case kTake:
      if (!tiles_.shown(now)) break;
      splat_ = {tiles_.value,
                static_cast<uint32_t>(lane_) << (m.config.alpha_address_w() - m.config.unit_w()) | overflow_, 0,
                static_cast<uint8_t>(lane_), true};
      if (!is_end(splat_.beat)) splat_.mask = m.trace.mask[splat_.beat];
      tiles_.valid = false;
      m.wheel.wake_now(unit(kIntersect, lane_));
      allocate_ = kDecide;
      allocate_at_ = now + 1;
      m.wheel.wake(self, allocate_at_);
      break;
    case kDecide:
      overflow_ += static_cast<uint32_t>(std::popcount(splat_.mask));
      row_valid_ = splat_valid_ = true;
      splat_from_ = now + 1;
      allocate_ = kOffer;
      allocate_at_ = now + 1;
      m.wheel.wake(self, allocate_at_);
      m.wheel.wake(unit(kLists), splat_from_);
      break;
    case kOffer:
      if (row_valid_ && jobs_.room(now)) {
        jobs_.push(now, {splat_.beat, splat_.mask, splat_.address, true});
        m.wheel.wake(unit(kRows, lane_), jobs_.head_from());
        row_valid_ = false;
      }
      if (row_valid_ || splat_valid_) break;  // the rows or the lists wake us
      allocate_ = kTake;
      allocate_at_ = now + 1;
      m.wheel.wake(self, allocate_at_);
      break;
  }
}

Splat Pu::take_made(Machine& m, Cycle) {
  if (!late_) {
    splat_valid_ = false;
    m.wheel.wake_now(unit(kBack, lane_));
    return splat_;
  }
  Splat splat;
  splat.beat = tiles_.value;
  if (!is_end(splat.beat)) splat.mask = m.trace.mask[splat.beat];
  tiles_.valid = false;
  m.wheel.wake_now(unit(kIntersect, lane_));
  return splat;
}

// --- pu_rows and pu_spill --------------------------------------------------------------------------------------------

void Pu::rows(Machine& m, Cycle now) {
  const int self = unit(kRows, lane_), port = m.memory.alpha_port(lane_);
  const bool spill_free = pieces_left_ == 0;
  if (m.memory.granted(port, now)) {
    if (--pieces_left_ > 0) m.memory.ask(port, ++spill_line_, true);
    m.wheel.wake(self, now + 1);
  }
  if (rows_.shown(now)) {
    const RowLine& line = rows_.head();
    if (line.end ? spill_free : !line.ext || spill_free) {
      if (line.end && lists_) {
        rows_ended_ = true;
        m.wheel.wake(unit(kLists), now + 1);
      } else if (line.end) {
        color.rows_end(m, now);
      } else if (line.ext) {
        pieces_left_ = pieces_;
        spill_line_ = ru_overflow_line(m.config, m.overflow, static_cast<uint64_t>(lane_), line.address);
        m.memory.ask(port, spill_line_, true);
      }
      rows_.take(now);
    }
  }
  if (rows_.step(now, jobs_.valid(now) ? &jobs_.front() : nullptr)) {
    jobs_.pop(now);
    m.wheel.wake(unit(kBack, lane_), now + 1);
  }
  m.wheel.wake(self, rows_.next(now));
  if (rows_.head_from() > now) m.wheel.wake(self, rows_.head_from());
  if (rows_.can_load() && !jobs_.empty()) m.wheel.wake(self, std::max(now + 1, jobs_.head_from()));
}

}  // namespace pipegs::timing
