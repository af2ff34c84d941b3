// SPDX-License-Identifier: Apache-2.0
// su_spill.cpp: a set of a Sorting Unit that goes to memory and comes back: see su.hpp.
#include <algorithm>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {
// --- su_port ---------------------------------------------------------------------------------------------------------

uint64_t Su::overflow_line(const Machine& m, Area area, uint64_t line) const {
  return m.overflow.first + area_first(m.config, m.overflow.lines, static_cast<uint64_t>(lane_), area) + line;
}

void Su::port(Machine& m, Cycle now) {
  record_taken_ = keys_taken_ = run_taken_ = fetch_taken_ = read_taken_ = false;
  if (spill_ == kSpillIdle && collect_ != kSpill && choice_ == kNothing && awaited_ == 0) return;
  const bool shown = shown_record(now) != kNoRecord, listed = keys_listed(shown);
  if (m.memory.answered(port_)) {
    answers_.push(now, 0);
    --awaited_;
    moved_ = true;
  }
  const External& e = external_;
  if (m.memory.granted(port_, now)) {
    record_taken_ = choice_ == kRecord;
    keys_taken_ = choice_ == kKeys;
    run_taken_ = choice_ == kRun;
    fetch_taken_ = choice_ == kFetch;
    read_taken_ = choice_ == kRead;
    if (fetch_taken_ || read_taken_) {
      ++flight_;
      ++awaited_;
      owners_.push_back(read_taken_ ? kRecordLine : lists() ? 0 : e.asked_way);
    } else {
      ++m.overflow_lines;
    }
    choice_ = kNothing;
    moved_ = true;
    return;
  }
  if (choice_ != kNothing) return;
  const auto records = static_cast<uint32_t>(records_out_.size());
  if (shown && !listed) {
    choice_ = kRecord;
    m.memory.ask(port_, overflow_line(m, Area::kRecords, records), true);
  } else if (listed) {
    choice_ = kKeys;
    m.memory.ask(port_, overflow_line(m, Area::kKeys, records / kKeysPerLine), true);
  } else if (e.lines_full) {
    choice_ = kRun;
    const Area area = e.level == kForm || !e.area ? Area::kRuns : Area::kMerged;
    m.memory.ask(port_, overflow_line(m, area, e.lines_number), true);
  } else if (flight_ != kAnswers && fetches(now)) {
    choice_ = kFetch;
    const Way& way = e.ways[static_cast<size_t>(e.asked_way)];
    const uint64_t line = lists() ? overflow_line(m, Area::kKeys, e.asked)
                                  : overflow_line(m, way.area ? Area::kRuns : Area::kMerged, way.line);
    m.memory.ask(port_, line);
  } else if (flight_ != kAnswers && ask_) {
    choice_ = kRead;
    m.memory.ask(port_, overflow_line(m, Area::kRecords, ask_line_));
  }
}

// --- su_spill --------------------------------------------------------------------------------------------------------

// The record that waits for memory: one that was shown in the cycle before goes first.
Su::Source Su::shown_record(Cycle now) const {
  if (!back_held_ && collect_ == kSpill && in_.valid(now) && !is_end(in_.front().splat.beat)) return kFromIn;
  return diverts() && out_.shown(now) ? kFromBack : kNoRecord;
}

// A line of keys waits for memory: the one that the shown record completes, or the last one.
bool Su::keys_listed(bool shown) const {
  const size_t part = records_out_.size() % kKeysPerLine;
  return !keys_sent_ && (shown ? part == kKeysPerLine - 1 : closes() && part != 0);
}

// What stands at the output goes to memory or into the pool: before the output takes the next one in the same cycle.
void Su::divert(Cycle now, const Now& is) {
  const bool returns = is.returns && is.write;
  if (!returns && (is.record != kFromBack || !record_taken_)) return;
  diverted_record_ = out_.value;
  if (returns) answers_.pop(now), owners_.pop_front(), line_used_ = true;
  out_.valid = false;
  out_taken_at_ = now;
}

void Su::spill(const Machine& m, const Now& is) {
  const bool written = closes() && (keys_sent_ || records_out_.size() % kKeysPerLine == 0);
  const bool back_held = is.record == kFromBack && !record_taken_;
  if (back_held != back_held_ || record_taken_ || keys_taken_) moved_ = true;
  back_held_ = back_held;
  if (keys_taken_) keys_sent_ = true;
  if (record_taken_) {
    Sorted record = diverted_record_;
    if (is.record == kFromIn) {
      record.splat = *is.in;
      record.key = m.trace.key[is.in->beat];
    }
    record.number = static_cast<uint32_t>(records_out_.size());
    records_out_.push_back(record);
    keys_sent_ = false;
  }
  const Spill before = spill_;
  switch (spill_) {
    case kSpillIdle:
      if (is.spill_start) spill_ = kRelease;
      break;
    case kRelease:
      if (is.job_done) spill_ = kDrain;
      break;
    case kDrain:
      if (is.drained) spill_ = kClose;
      break;
    case kClose:
      if (written) spill_ = kSend;
      break;
    case kSend:
      if (is.sent) spill_ = is.stay ? kClose : is.again ? kRefill : kSpillIdle;
      break;
    case kRefill:
      if (is.returned) spill_ = kSpillIdle;
      break;
  }
  if (spill_ != before) moved_ = true;
  if (is.spill_start) records_out_.clear();
  if (spill_ == kRefill && external_.form == kLoad) fresh_ = back_ = 0;  // slots from 0 on for what returns
  if (is.spill_start || is.stay) keys_sent_ = false;
}

}  // namespace pipegs::timing
