// SPDX-License-Identifier: Apache-2.0
// su.cpp: a Sorting Unit cycle by cycle: see su.hpp.
#include <algorithm>
#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Su::Su(const Machine& m, int lane)
    : lane_(lane),
      port_(m.memory.sort_port(lane)),
      records_(m.config.records),
      config_(m.config),
      octave_(su_octave(m.config, m.frame)),
      bits_low_((m.config.bucket_w() + 1) / 2),
      bits_high_(m.config.bucket_w() - bits_low_),
      marks_cut_(m.config.has_watermarks()),
      lists_(m.config.has_lists()),
      pool_(static_cast<size_t>(records_)),
      next_slot_(static_cast<size_t>(records_)),
      marks_(m.config.su_marks()),
      table_(size_t{2} << m.config.bucket_w()),
      words_(size_t{2} << bits_high_) {
  external_.ways.resize(static_cast<size_t>(m.config.su_ways()));
  external_.nodes.resize(static_cast<size_t>(m.config.su_ways()));
  for (int i = records_; i-- > 0;) free_slots_.push_back(static_cast<uint32_t>(i));
}

void Su::step(Machine& m, Cycle now) {
  moved_ = skid_.last_pop() == now;
  leave(m, now);
  ready_ = in_.room(now), ready_at_ = now;
  if (sorting_ && now > sort_last_) {
    sorting_ = false;
    live_ = fill_;
    live_end_ = end_;
    sent_ = fill_ = 0;
    loaded_ = false;
  }
  if (lists_) m.wheel.wake_now(unit(kLists));
  port(m, now);
  const Now is = spill_ == kSpillIdle && collect_ != kSpill ? look<false>(m, now) : look<true>(m, now);
  divert(now, is);
  emit(now, is);
  sort(now, is);
  buckets(now, is);
  if (spill_ != kSpillIdle || is.spill_start) {
    external(now, is);
    spill(m, is);
  }
  show_outside(m, now);
  collect(m, now, is);
  arrive(m, now);
  if (line_used_) --flight_, line_used_ = false, moved_ = true;

  Cycle next = moved_ ? now + 1 : kNever;
  const auto at = [&](Cycle cycle) { next = std::min(next, std::max(cycle, now + 1)); };
  if (sorting_) at(sort_last_ + 1);
  if (group_ < groups_.size() && load_from_ >= now) at(load_from_ + 1);
  if (!waiting_.empty() && !out_.valid) at(waiting_.head_from());
  if (chains_.head_from() > now) at(chains_.head_from());
  if (marks_.head_from() > now) at(marks_.head_from());
  if (answers_.head_from() > now) at(answers_.head_from());
  if (!link_writes_.empty() && (operation_ != kNone || work_ != 0)) at(now + 1);
  if (back_ > 0 && !slot_valid(now)) at(now + 1);
  m.wheel.wake(unit(kSu, lane_), next);
}

void Su::taken(Machine& m, Cycle now) {
  skid_.pop(now);
  m.wheel.wake_now(unit(kSu, lane_));
}

// From the output into the skid, before the output takes the next one in the same cycle.
void Su::leave(Machine& m, Cycle now) {
  if (!out_.shown(now) || diverts() || returns() || !skid_.room(now)) return;
  if (out_outside_) answers_.pop(now), owners_.pop_front(), line_used_ = true;
  skid_.push(now, out_.value);
  out_.valid = false;
  out_taken_at_ = now;
  moved_ = true;
  m.wheel.wake(unit(kOrder, 1), skid_.head_from());
}

// --- what every part says --------------------------------------------------------------------------------------------

bool Su::slot_valid(Cycle now) const {
  if (fresh_ != records_) return true;
  if (back_ == 0 || back_pop_ >= now) return false;
  // The head of the queue of slots that came back: at most the latest two are not seen yet.
  return back_ > 3 || back_at_[static_cast<size_t>(back_next_ - back_) & 3] + 2 <= now;
}

bool Su::split_links(Cycle now) {
  while (!link_writes_.empty() && link_writes_.back().last < now) link_writes_.pop_back();
  return !link_writes_.empty() && link_writes_.back().first <= now;
}

template <bool Spills>
Su::Now Su::look(const Machine& m, Cycle now) {
  Now is{};
  // Ends that wait.
  const bool mark = marks_.valid(now);
  const Mark none;
  const Mark& head = mark ? marks_.front() : none;
  is.mark_waits = mark && !head.spills;
  is.mark_set = head.set, is.mark_all = head.all, is.mark_bucket = head.bucket, is.mark_end = head.end;

  // Splitter, sorter, output.
  is.split_idle = split_idle(now);
  is.bitonic_idle = bitonic_idle();
  is.returns = Spills && returns();
  is.outer = is.returns ? !external_.pool.empty() : Spills && external_.item();
  is.item = is.outer || (!sorting_ && sent_ < live_);
  is.item_end = !is.outer && live_end_;
  is.emit_empty = waiting_.empty() && !out_.valid && out_taken_at_ != now;
  is.spilled = Spills && open();
  is.sends = is.spilled && external_.last;
  is.diverts = Spills && (diverts() || is.returns);
  is.chain = chains_.valid(now);
  is.chain_end = is.chain && is_end(chains_.front().end);
  is.batch_ready = !sorting_ && !loaded_ && (fill_ >= live_ || fill_ < sent_);
  is.batch_valid = group_ < groups_.size() && now > load_from_;
  is.drained = !is.mark_waits && (marks_.empty() || mark) && chains_.empty() && is.split_idle && is.bitonic_idle &&
               is.emit_empty;
  is.hungry = chains_.empty() && is.split_idle;

  // Output of a set that spilled: its mark goes behind the splats that it releases.
  is.sent_all = Spills && external_.level == kSent && !is.item;
  is.mark_first = is.sends && mark && is.sent_all;
  is.emit_item = is.mark_first || is.item;
  is.outside = is.spilled && !is.mark_first && !is.item_end;
  const bool keeps = is.outside && !is.sends;
  is.emit_ready = keeps ? looked_ && !external_.lines_full : waiting_.room(now) && !ask_ && (!is.outside || looked_);
  is.kept = keeps && is.emit_item && is.emit_ready;
  is.item_goes = is.item && is.emit_ready;
  is.sent = is.mark_first && is.emit_ready;
  is.again = is.sent && !head.all && external_.rest != 0;
  is.stay = is.again && external_.rest > static_cast<uint32_t>(config_.su_refill());
  is.returned = is.returns && external_.pool.empty() && is.drained;
  is.spill_end = (is.sent && !is.again) || is.returned;

  // What comes in, or returns.
  if (is.returns) {
    if (out_.shown(now)) diverted_record_ = out_.value, is.in = &diverted_record_.splat;
  } else if (in_.valid(now)) {
    is.in = &in_.front().splat;
  }
  is.data = is.in != nullptr && !is_end(is.in->beat);
  is.open = (collect_ == kCollect && !closed_[set_]) || is.returns;
  const bool insert = is.data && is.open && slot_valid(now);

  // Buckets.
  is.spill_job = Spills && spill_ == kRelease;
  is.job = is.spill_job || is.mark_waits;
  is.job_set = is.spill_job ? set_ : head.set;
  is.job_all = is.spill_job || head.all;
  const Beat job_end = is.spill_job ? 0 : head.end;
  const uint32_t job_high = head.bucket >> bits_low_, job_low = head.bucket & ((1u << bits_low_) - 1);
  if (is.job) {
    is.candidates = held_[is.job_set];
    if (!is.job_all) is.candidates &= ((Bits{1} << job_high) - 1) | (Bits{!edge_ && job_low != 0} << job_high);
  }
  is.word_wanted = is.candidates != 0 && work_ == 0 && operation_ != kWord;
  is.quiet = is.candidates == 0 && work_ == 0 && operation_ == kNone;
  is.link_ready = !split_links(now);
  is.released_room = chains_.room(now);
  if (operation_ == kInsert) {
    const uint32_t word = (insert_set_ << bits_high_) + (insert_bucket_ >> bits_low_);
    is.filled = (held_[insert_set_] >> (insert_bucket_ >> bits_low_) & 1) != 0 &&
                (words_[word] >> (insert_bucket_ & ((1u << bits_low_) - 1)) & 1) != 0;
  }
  const bool entry = operation_ == kEntry;
  const uint32_t count =
      entry ? table_[(static_cast<size_t>(is.job_set) << (bits_low_ + bits_high_)) + entry_bucket_].count : 0;
  const bool fits = joined_.count + count <= kGroup;
  is.join_group = entry && group_valid_ && fits;
  is.push_group = group_valid_ && (entry ? !fits : is.quiet || is.hungry);
  is.ends = !((operation_ == kInsert && is.filled) || is.join_group) || is.link_ready;
  is.chain_valid = is.push_group || (is.job && is.quiet && is_end(job_end));
  is.job_done = is.job && is.quiet && !group_valid_ && (is.released_room || !is_end(job_end));
  is.next = kNone;
  const auto word_of = [this](uint8_t set, uint32_t bucket) {
    return (static_cast<uint32_t>(set) << bits_high_) + (bucket >> bits_low_);
  };
  const uint32_t job_words = static_cast<uint32_t>(is.job_set) << bits_high_;
  if (is.ends) {
    if (is.word_wanted) {
      const bool same =
          operation_ == kInsert && word_of(insert_set_, insert_bucket_) == job_words + lowest(is.candidates);
      is.next = same ? kNone : kWord;
    } else if (insert && operation_ != kInsert &&
               !(operation_ == kWord && word_of(set_, bucket_of(m.trace.key[is.in->beat])) == job_words + word_) &&
               !(inserted_ && work_ != 0 && is.released_room)) {
      is.next = kInsert;
    } else if (work_ != 0 && is.released_room && !is.chain_valid && operation_ != kInsert) {
      is.next = kEntry;
    }
  }
  is.insert = is.next == kInsert;

  // Collect.
  is.record = Spills ? shown_record(now) : kNoRecord;
  is.spill_start = is.data && is.open && !is.returns && used_ == records_ && is.drained;
  is.write = is.insert;
  is.mark_push = is.in != nullptr && !is.data && (is.open || collect_ == kSpill) && marks_.room(now);
  is.taken = is.write || is.mark_push || (is.record == kFromIn && record_taken_);
  return is;
}

// --- su_collect ------------------------------------------------------------------------------------------------------

void Su::collect(Machine& m, Cycle now, const Now& is) {
  if (is.write) {
    const uint64_t key = m.trace.key[is.in->beat];
    const uint32_t slot = free_slots_.back();
    free_slots_.pop_back();
    pool_[slot] = {*is.in, key, 0};
    stored_at_ = now;
    insert_slot_ = slot;
    insert_bucket_ = bucket_of(key);
    if (fresh_ != records_) {
      ++fresh_;
    } else {
      --back_;
      back_pop_ = now;
    }
    ++used_;
    m.peak_records = std::max(m.peak_records, static_cast<uint64_t>(used_));
  }
  const Collect before = collect_;
  const bool all = is.in != nullptr && (!marks_cut_ || is.in->beat != kLayerEndBeat);
  switch (collect_) {
    case kCollect:
      if (is.spill_start) collect_ = kSpill;
      break;
    case kSpill:
      if (is.mark_push) collect_ = kSort;
      break;
    case kSort:
      if (is.stay || is.spill_end) collect_ = is.stay ? kSpill : kCollect;
      break;
  }
  if (is.mark_push) {
    const uint8_t set = set_;
    const uint32_t bucket = all ? 0 : static_cast<uint32_t>(su_bucket(config_, in_.front().mark, octave_));
    marks_.push(now, {is.in->beat, set, all, before == kSpill, bucket});
    if (all && before == kCollect) closed_[set] = true, set_ ^= 1;
  }
  if (collect_ != before) moved_ = true;
  if (is.taken) moved_ = true;
  if (is.taken && !is.returns) in_.pop(now);
}

// The stage in front of the unit.
void Su::arrive(Machine& m, Cycle now) {
  Pu& pu = m.pu[static_cast<size_t>(lane_)];
  if (!ready_ || !(lists_ ? m.lists.shown(lane_) : pu.splat_shown(now))) return;
  Arrived arrived{lists_ ? m.lists.record() : pu.splat()};
  if (marks_cut_ && arrived.splat.beat == kLayerEndBeat) {
    arrived.mark = pu.marks.front();
    pu.marks.pop(now);
    m.wheel.wake(unit(kReader, lane_), now + 1);
  }
  m.show(now, Border::kSplat, lane_, m.beat_shown(arrived.splat.beat));
  in_.push(now, arrived);
  lists_ ? m.lists.taken(m, lane_) : pu.take_splat(m, now);
  moved_ = true;
}

}  // namespace pipegs::timing
