// su.cpp: see su.hpp.
#include "sim/timing/su.hpp"

#include <algorithm>
#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

// Cycles in the bitonic network.
int sort_cycles(int keys) { return keys <= 1 ? 0 : keys <= 2 ? 1 : keys <= 4 ? 3 : keys <= 8 ? 6 : 10; }

constexpr int kRecordArea = 1, kKeyArea = 2, kParts = 16, kPartW = 4;

}  // namespace

struct Su::Now {
  bool item, item_end, split_idle, bitonic_idle, emit_empty, drained, selecting, diverts, spill_job;
  bool mark_waits, mark_first, mark_all, spill_done, emit_item, emit_ready, item_goes;
  bool chain, chain_end, batch_ready, batch_valid;
  bool hungry, link_ready, released_room, select_write, sent_all;
  uint8_t mark_set;
  uint32_t mark_bucket;
  Beat mark_end;
  // buckets
  bool job, job_all, job_done, quiet, word_wanted, ends, push_group, join_group, filled, insert, chain_valid;
  uint8_t job_set;
  uint64_t candidates;
  Operation next;
  // collect
  const Splat* in;
  bool data, open, taken, write, spill_start, record, mark_push;
};

Su::Su(const Machine& m, int lane)
    : lane_(lane), port_(m.memory.sort_port(lane)), records_(m.config.records),
      bucket_shift_(m.config.key_w() - m.config.bucket_w()), bits_low_((m.config.bucket_w() + 1) / 2), bits_high_(m.config.bucket_w() - bits_low_),
      marks_cut_(m.config.order == 2), lists_(m.config.order == 1), pool_(static_cast<size_t>(records_)), next_slot_(static_cast<size_t>(records_)),
      marks_(m.config.order == 2 ? kSuMarks : kSuMarksLayers), table_(size_t{2} << m.config.bucket_w()), words_(size_t{2} << bits_high_) {
  for (int i = records_; i-- > 0;) free_slots_.push_back(static_cast<uint32_t>(i));
}

void Su::step(Machine& m, Cycle now) {
  moved_ = out_taken_at_ == now;
  if (sorting_ && now > sort_last_) {
    sorting_ = false;
    live_ = fill_;
    live_end_ = end_;
    sent_ = fill_ = 0;
    loaded_ = false;
  }
  if (lists_) m.wheel.wake_now(unit(kLists));
  port(m, now);
  const Now is = look(m, now);
  emit(m, now, is);
  sort(now, is);
  buckets(now, is);
  if (spill_ != kSpillIdle || is.spill_start) {
    if (is.selecting) select(now, is);
    spill(now, is);
  }
  collect(m, now, is);
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
  if (back_ > 0 && fresh_ == records_ && !slot_valid(now + 1)) at(now + 1);
  m.wheel.wake(unit(kSu, lane_), next);
}

void Su::taken(Machine& m, Cycle now) {
  if (out_outside_) answers_.pop(now), line_used_ = true;
  out_.valid = false;
  out_taken_at_ = now;
  m.wheel.wake_now(unit(kSu, lane_));
}

// --- what every part says -----------------------------------------------------------------------------------------------

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

int Su::select_part() const {
  if (!seen_) return -1;
  const uint64_t key = records_out_[seen_number_].key, position = (key - low_) >> shift_;
  return key >= low_ && position < kParts ? static_cast<int>(position) : -1;
}

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
  is.item = !sorting_ && sent_ < live_;
  is.item_end = live_end_;
  is.emit_empty = waiting_.empty() && !out_.valid && out_taken_at_ != now;
  is.selecting = spill_ == kSelecting;
  is.diverts = diverts();
  is.chain = chains_.valid(now);
  is.chain_end = is.chain && is_end(chains_.front().end);
  is.batch_ready = !sorting_ && !loaded_ && (fill_ >= live_ || fill_ < sent_);
  is.batch_valid = group_ < groups_.size() && now > load_from_;
  is.drained = !is.mark_waits && (marks_.empty() || mark) && chains_.empty() && is.split_idle && is.bitonic_idle && is.emit_empty;
  is.hungry = chains_.empty() && is.split_idle;

  // Output of a set that spilled: its marks go between its splats.
  is.sent_all = select_ == kSelectIdle && !is.item;
  is.mark_first = is.selecting && mark && (is.sent_all || (!head.all && is.item && head.bucket <= bucket_of(batches_.front().item.key)));
  is.emit_item = is.mark_first || (is.item && (!is.selecting || mark));
  const bool outside = is.selecting && !is.mark_first && !is.item_end;
  is.emit_ready = waiting_.room(now) && (!outside || (looked_ && read_taken_ && !select_reads()));
  is.item_goes = is.item && is.emit_ready && !is.mark_first && (!is.selecting || mark);
  is.spill_done = is.mark_first && head.all && is.emit_ready;

  // What comes in.
  const Color& color = m.pu[static_cast<size_t>(lane_)].color;
  const Splat* wires = lists_ ? &m.lists.record() : &color.out.value;
  is.in = (lists_ ? m.lists.shown(lane_) : color.shown(now)) ? wires : nullptr;
  is.data = is.in != nullptr && !is_end(is.in->beat);
  is.open = collect_ == kCollect && !closed_[set_];
  const bool insert = is.data && is.open && slot_valid(now);

  // Buckets.
  is.spill_job = spill_ == kRelease;
  is.job = is.spill_job || is.mark_waits;
  is.job_set = is.spill_job ? set_ : head.set;
  is.job_all = is.spill_job || head.all;
  const Beat job_end = is.spill_job ? 0 : head.end;
  const uint32_t job_high = head.bucket >> bits_low_, job_low = head.bucket & ((1u << bits_low_) - 1);
  if (is.job) {
    is.candidates = held_[is.job_set];
    if (!is.job_all) is.candidates &= ((uint64_t{1} << job_high) - 1) | (uint64_t{!edge_ && job_low != 0} << job_high);
  }
  is.word_wanted = is.candidates != 0 && work_ == 0 && operation_ != kWord;
  is.quiet = is.candidates == 0 && work_ == 0 && operation_ == kNone;
  is.select_write = select_ == kLoad && select_part() >= first_ && select_part() < stop_ && select_part() >= 0;
  is.link_ready = !split_links(now) && !is.select_write;
  is.released_room = chains_.room(now);
  if (operation_ == kInsert) {
    const uint32_t word = (insert_set_ << bits_high_) + (insert_bucket_ >> bits_low_);
    is.filled = (held_[insert_set_] >> (insert_bucket_ >> bits_low_) & 1) != 0 && (words_[word] >> (insert_bucket_ & ((1u << bits_low_) - 1)) & 1) != 0;
  }
  const bool entry = operation_ == kEntry;
  const uint32_t count = entry ? table_[(static_cast<size_t>(is.job_set) << (bits_low_ + bits_high_)) + entry_bucket_].count : 0;
  const bool fits = joined_.count + count <= kGroup;
  is.join_group = entry && group_valid_ && fits;
  is.push_group = group_valid_ && (entry ? !fits : is.quiet || is.hungry);
  is.ends = !((operation_ == kInsert && is.filled) || is.join_group) || is.link_ready;
  is.chain_valid = is.push_group || (is.job && is.quiet && is_end(job_end));
  is.job_done = is.job && is.quiet && !group_valid_ && (is.released_room || !is_end(job_end));
  is.next = kNone;
  const auto word_of = [this](uint8_t set, uint32_t bucket) { return (static_cast<uint32_t>(set) << bits_high_) + (bucket >> bits_low_); };
  const uint32_t job_words = static_cast<uint32_t>(is.job_set) << bits_high_;
  if (is.ends) {
    if (is.word_wanted) {
      const bool same = operation_ == kInsert && word_of(insert_set_, insert_bucket_) == job_words + static_cast<uint32_t>(std::countr_zero(is.candidates));
      is.next = same ? kNone : kWord;
    } else if (insert && operation_ != kInsert && !(operation_ == kWord && word_of(set_, bucket_of(m.trace.key[is.in->beat])) == job_words + word_)) {
      is.next = kInsert;
    } else if (work_ != 0 && is.released_room && !is.chain_valid) {
      is.next = kEntry;
    }
  }
  is.insert = is.next == kInsert;

  // Collect.
  is.record = is.data && collect_ == kSpill;
  is.spill_start = is.data && is.open && used_ == records_ && (is.drained || (marks_cut_ && m.other_spills(lane_)));
  is.write = is.insert;
  is.mark_push = is.in != nullptr && !is.data && (is.open || collect_ == kSpill) && marks_.room(now);
  const bool spill_free = (!record_valid_ || record_taken_) && !keys_valid_;
  is.taken = is.write || is.mark_push || (is.record && spill_free);
  if (lists_) {
    const bool same = operation_ == kWord && !is_end(wires->beat) && word_of(set_, bucket_of(m.trace.key[wires->beat])) == job_words + word_;
    const bool insert_ready = is.ends && !is.word_wanted && operation_ != kInsert && !same;
    ready_ = is_end(wires->beat) ? (is.open || collect_ == kSpill) && marks_.room(now)
                                 : (is.open && slot_valid(now) && insert_ready) || (collect_ == kSpill && spill_free);
  }
  return is;
}

// --- su_port ------------------------------------------------------------------------------------------------------------

uint64_t Su::overflow_line(const Machine& m, int area, uint64_t line) const {
  return m.frame.overflow + (static_cast<uint64_t>(lane_ << 3 | area) << 24) + line;
}

void Su::port(Machine& m, Cycle now) {
  record_taken_ = keys_taken_ = read_taken_ = false;
  if (m.memory.answered(port_)) answers_.push(now, 0), moved_ = true;
  if (m.memory.granted(port_, now)) {
    record_taken_ = choice_ == kRecord;
    keys_taken_ = choice_ == kKeys;
    read_taken_ = choice_ == kRead;
    if (read_taken_) ++flight_;
    if (choice_ != kRead) ++m.overflow_lines;
    choice_ = kNothing;
    moved_ = true;
    return;
  }
  if (choice_ != kNothing) return;
  const auto records = static_cast<uint32_t>(records_out_.size());
  if (record_valid_) {
    choice_ = kRecord;
    m.memory.ask(port_, overflow_line(m, kRecordArea, records - 1), true);
  } else if (keys_valid_) {
    choice_ = kKeys;
    m.memory.ask(port_, overflow_line(m, kKeyArea, (records - 1) / kKeysPerLine), true);
  } else if (spill_ == kSelecting && flight_ != kAnswers) {
    const bool mark = marks_.valid(now);
    const bool item = !sorting_ && sent_ < live_ && looked_ && waiting_.room(now) && mark;
    const bool first = item && !marks_.front().all && marks_.front().bucket <= bucket_of(batches_.front().item.key);
    if (select_reads()) {
      choice_ = kRead;
      m.memory.ask(port_, overflow_line(m, kKeyArea, line_));
    } else if (item && !first) {
      choice_ = kRead;
      m.memory.ask(port_, overflow_line(m, kRecordArea, batches_.front().item.number));
    }
  }
}

// --- su_emit --------------------------------------------------------------------------------------------------------------

void Su::emit(Machine& m, Cycle now, const Now& is) {
  // From the queue to the output; the record's slot becomes free.
  if (!out_.valid && waiting_.valid(now)) {
    const Entry& entry = waiting_.front();
    out_outside_ = entry.outside;
    out_.set(out_outside_ ? kNever : now + 1, entry.item);
    if (entry.slot != kNil) {
      free_slots_.push_back(entry.slot);
      ++back_;
      back_at_[static_cast<size_t>(back_next_++) & 3] = now;
      --used_;
    }
    waiting_.pop(now);
    moved_ = true;
  }
  if (out_.valid && out_.from == kNever && !answers_.empty()) out_.from = std::max(now + 1, answers_.head_from());
  if (out_.valid && out_.from > now) m.wheel.wake(is.diverts ? unit(kSu, lane_) : unit(kOrder, 1), out_.from);

  // Into the queue.
  const bool outside = is.selecting && is.emit_item && !is.mark_first && !is.item_end;
  if (outside && looked_ == (is.emit_ready && is.emit_item)) moved_ = true;
  looked_ = outside && !is.emit_ready;
  if (!is.emit_item || !is.emit_ready) return;
  moved_ = true;
  Entry entry;
  if (is.mark_first) {
    entry.item.splat.beat = is.mark_end;
    marks_.pop(now);
  } else {
    entry = batches_.front();
    entry.outside = outside;
    if (outside) entry.slot = kNil;
  }
  waiting_.push(now, entry);
}

// --- su_split, su_bitonic ---------------------------------------------------------------------------------------------------

void Su::begin_group(Cycle origin) {
  group_left_ = groups_[group_].keys;
  load_from_ = origin + groups_[group_].delay;
  // The latest are at the back, so they come in turned round.
  const size_t from = group_ == 0 ? 0 : groups_[group_ - 1].links;
  for (size_t i = groups_[group_].links; i-- > from;) link_writes_.push_back({origin + links_[i].first, origin + links_[i].last});
}

// Of order_.
void Su::begin_split(Cycle now, uint64_t min, uint64_t max) {
  std::sort(order_.begin(), order_.end(), [](const Entry& a, const Entry& b) { return a.item.key < b.item.key; });
  next_ = 0;
  groups_.clear();
  links_.clear();
  if (order_.size() <= kGroup) {
    groups_.push_back({1, static_cast<int>(order_.size()), 0});
  } else {
    keys_.clear();
    for (const Entry& entry : order_) keys_.push_back(entry.item.key);
    su_groups(keys_, min, max, groups_, links_);
  }
  group_ = 0;
  link_writes_.clear();
  begin_group(now);
}

void Su::sort(Cycle now, const Now& is) {
  const bool end_goes = is.chain_end && is.split_idle && is.batch_ready, load = is.batch_valid && is.batch_ready;
  const bool start = !sorting_ && loaded_ && sent_ == live_;
  if (is.item_goes) ++sent_, batches_.pop(now), moved_ = true;
  if (load) {
    batches_.push(now, order_[next_++]);
    ++fill_;
    end_ = false;
    if (--group_left_ == 0) {
      loaded_ = true;
      if (++group_ < groups_.size()) {
        begin_group(now);
      } else {
        split_idle_from_ = now + 1;
      }
    }
    moved_ = true;
  }
  if (is.chain && is.split_idle) {
    const Chain& chain = chains_.front();
    if (is.chain_end) {
      if (end_goes) {
        Entry entry;
        entry.item.splat.beat = chain.end;
        batches_.push(now, entry);
        fill_ = 1;
        loaded_ = end_ = true;
        chains_.pop(now);
        moved_ = true;
      }
    } else {
      order_.clear();
      uint32_t slot = chain.head;
      for (uint32_t i = 0; i < chain.count; ++i, slot = next_slot_[slot]) order_.push_back({pool_[slot], slot, false});
      const uint64_t min = static_cast<uint64_t>(chain.bucket) << bucket_shift_;
      begin_split(now, min, min | ((uint64_t{1} << bucket_shift_) - 1));
      chains_.pop(now);
      moved_ = true;
    }
  }
  if (start) {
    moved_ = true;
    if (fill_ == 1) {
      live_ = 1;
      live_end_ = end_;
      sent_ = fill_ = 0;
      loaded_ = false;
    } else {
      sorting_ = true;
      sort_last_ = now + sort_cycles(fill_);
    }
  }
}

// --- su_buckets -------------------------------------------------------------------------------------------------------------

void Su::buckets(Cycle now, const Now& is) {
  const int bits = bits_low_ + bits_high_;
  const uint32_t job_high = is.mark_bucket >> bits_low_, job_low = is.mark_bucket & ((1u << bits_low_) - 1);
  if (operation_ != kNone || is.next != kNone) moved_ = true;

  // Chains to the splitter.
  if (is.chain_valid && is.released_room) {
    if (is.push_group) {
      joined_.end = 0;
      chains_.push(now, joined_);
      group_valid_ = false;
    } else {
      Chain end;
      end.end = is.mark_end;
      chains_.push(now, end);
    }
    moved_ = true;
  }

  // What ends in this cycle.
  switch (operation_) {
    case kNone: break;
    case kInsert:
      if (is.ends) {
        Chain& chain = table_[(static_cast<size_t>(insert_set_) << bits) + insert_bucket_];
        const uint32_t word = (static_cast<uint32_t>(insert_set_) << bits_high_) + (insert_bucket_ >> bits_low_);
        if (is.filled) {
          next_slot_[insert_slot_] = chain.head;
          chain.head = insert_slot_;
          ++chain.count;
        } else {
          chain = {0, insert_slot_, insert_slot_, 1, insert_bucket_};
          const bool held = (held_[insert_set_] >> (insert_bucket_ >> bits_low_) & 1) != 0;
          words_[word] = (held ? words_[word] : 0) | uint64_t{1} << (insert_bucket_ & ((1u << bits_low_) - 1));
        }
      }
      held_[insert_set_] |= uint64_t{1} << (insert_bucket_ >> bits_low_);
      break;
    case kWord: {
      uint64_t& word = words_[(static_cast<size_t>(is.job_set) << bits_high_) + word_];
      const uint64_t below = is.job_all || word_ != job_high ? ~uint64_t{0} : (uint64_t{1} << job_low) - 1;
      work_ = word & below;
      word &= ~below;
      if (word == 0) held_[is.job_set] &= ~(uint64_t{1} << word_);
      if (word_ == job_high) edge_ = true;
      break;
    }
    case kEntry:
      if (is.ends) {
        const Chain& chain = table_[(static_cast<size_t>(is.job_set) << bits) + entry_bucket_];
        if (is.join_group) {
          next_slot_[joined_.tail] = chain.head;
          joined_.tail = chain.tail;
          joined_.count += chain.count;
        } else {
          joined_ = chain;
          joined_.bucket = entry_bucket_;
        }
        group_valid_ = true;
      }
      break;
  }
  if (is.job_done) edge_ = false, moved_ = true;

  // What begins.
  switch (is.next) {
    case kNone: break;
    case kInsert:
      insert_set_ = set_;
      insert_slot_ = free_slots_.back();  // collect() takes it
      insert_bucket_ = 0;                 // and says which bucket
      break;
    case kWord: word_ = static_cast<uint32_t>(std::countr_zero(is.candidates)); break;
    case kEntry: {
      const auto bit = static_cast<uint32_t>(std::countr_zero(work_));
      entry_bucket_ = (word_ << bits_low_) + bit;
      work_ &= work_ - 1;
      break;
    }
  }
  if (is.ends) operation_ = is.next;
  if (is.job_done && !is.spill_job) {
    marks_.pop(now);
    if (is.mark_all) closed_[is.mark_set] = false;
  }
}

// --- su_spill, su_select ------------------------------------------------------------------------------------------------------

void Su::spill(Cycle now, const Now& is) {
  const bool record_was = record_valid_, keys_were = keys_valid_;
  const bool free = (!record_was || record_taken_) && !keys_were, back = is.diverts && out_.shown(now);
  const bool close = spill_ == kClose && collect_ == kSort && !record_was && !keys_were;
  const bool written = close && (closing_ || records_out_.size() % kKeysPerLine == 0);
  const bool take = free && (is.record || back);
  if (record_taken_) record_valid_ = false;
  if (keys_taken_) keys_valid_ = false;
  if (take) {
    Sorted record;
    if (is.record) {
      record.splat = *is.in;
    } else {
      record = out_.value;
      out_.valid = false;
      out_taken_at_ = now;
    }
    record.number = static_cast<uint32_t>(records_out_.size());
    records_out_.push_back(record);
    record_valid_ = true;
    if (records_out_.size() % kKeysPerLine == 0) keys_valid_ = true;
    moved_ = true;
  }
  if (close && !written) keys_valid_ = closing_ = true;
  if (close || record_taken_ || keys_taken_) moved_ = true;
  const Spill before = spill_;
  switch (spill_) {
    case kSpillIdle: if (is.spill_start) spill_ = kWait; break;
    case kWait: if (is.drained) spill_ = kRelease; break;
    case kRelease: if (is.job_done) spill_ = kDrain; break;
    case kDrain: if (is.drained) spill_ = kClose; break;
    case kClose:
      if (!written) break;
      spill_ = kSelecting;
      if (records_out_.empty()) break;
      low_ = max_ = records_out_.front().key;
      for (const Sorted& record : records_out_) low_ = std::min(low_, record.key), max_ = std::max(max_, record.key);
      sent_keys_ = 0;
      select_ = kMeasure;
      break;
    case kSelecting: if (is.spill_done) spill_ = kSpillIdle; break;
  }
  if (spill_ != before) moved_ = true;
  if (is.spill_start) {
    records_out_.clear();
    closing_ = false;
  }
}

void Su::select(Cycle now, const Now& is) {
  const auto count = static_cast<uint32_t>(records_out_.size());
  const bool idle = is.split_idle && is.bitonic_idle, turn = is.emit_empty && idle, pass = select_ == kCount || select_ == kLoad;
  const bool look = pass && turn && answers_.valid(now) && number_ != count, pass_done = number_ == count && !seen_;
  const bool read = read_taken_ && select_reads();
  const int part = select_part();
  const auto parts = [this](int i) { return counts_[static_cast<size_t>(i)]; };
  const bool fits = stop_ < kParts && sum_ + parts(std::min(stop_, kParts - 1)) <= records_;
  const Select before = select_;
  switch (select_) {
    case kSelectIdle: break;
    case kMeasure:
      shift_ = std::max(static_cast<int>(std::bit_width(max_ - low_)) - kPartW, 0);
      counts_.fill(0);
      line_ = number_ = 0;
      select_ = kCount;
      break;
    case kCount:
      if (part >= 0) ++counts_[static_cast<size_t>(part)];
      if (pass_done) first_ = stop_ = sum_ = 0, select_ = kChoose;
      break;
    case kChoose:
      part_.clear();
      moved_ = true;
      if (fits) {
        sum_ += parts(stop_++);
        break;
      }
      line_ = number_ = 0;
      if (sum_ == 0) {
        select_ = stop_ == kParts ? kMeasure : kCount;
        low_ += static_cast<uint64_t>(stop_) << shift_;
        if (stop_ < kParts) shift_ = std::max(shift_ - kPartW, 0);
        counts_.fill(0);
      } else {
        select_ = kLoad;
        sent_keys_ += static_cast<uint32_t>(sum_);
        sum_ = 0;
      }
      break;
    case kLoad:
      if (is.select_write) part_.push_back({records_out_[seen_number_], kNil, false}), ++sum_;
      if (pass_done) select_ = kFull;
      break;
    case kFull: {
      order_ = part_;
      uint64_t min = order_.front().item.key, max = min;
      for (const Entry& entry : order_) min = std::min(min, entry.item.key), max = std::max(max, entry.item.key);
      begin_split(now, min, max);
      select_ = kSorting;
      break;
    }
    case kSorting:
      if (!idle) break;
      select_ = sent_keys_ == count ? kSelectIdle : kChoose;
      first_ = stop_;
      sum_ = 0;
      break;
  }
  if (select_ != before) moved_ = true;
  if (!pass) {
    seen_ = false;
    return;
  }
  if (look && (number_ % kKeysPerLine == kKeysPerLine - 1 || number_ + 1 == count)) answers_.pop(now), line_used_ = true;
  if (seen_ || look || read) moved_ = true;
  seen_ = look;
  if (look) seen_number_ = number_++;
  if (read) ++line_;
}

// --- su_collect -----------------------------------------------------------------------------------------------------------------

void Su::collect(Machine& m, Cycle now, const Now& is) {
  if (is.write) {
    const uint64_t key = m.trace.key[is.in->beat];
    const uint32_t slot = free_slots_.back();
    free_slots_.pop_back();
    pool_[slot] = {*is.in, key, 0};
    insert_slot_ = slot;
    insert_bucket_ = bucket_of(key);
    if (fresh_ != records_) {
      ++fresh_;
    } else {
      --back_;
      back_pop_ = now;
    }
    ++used_;
  }
  if (is.record && is.taken) records_out_.back().key = m.trace.key[is.in->beat];
  const Collect before = collect_;
  const bool all = is.in != nullptr && (!marks_cut_ || is.in->beat == kWindowEndBeat);
  switch (collect_) {
    case kCollect: if (is.spill_start) collect_ = kSpill; break;
    case kSpill: if (is.mark_push && all) collect_ = kSort; break;
    case kSort: if (is.spill_done) collect_ = kCollect; break;
  }
  if (is.mark_push) {
    const uint8_t set = set_;
    auto& marks = m.pu[static_cast<size_t>(lane_)].marks;
    const uint32_t bucket = all ? 0 : bucket_of(static_cast<uint64_t>(marks.front()) << m.config.index_w);
    if (!all) {
      marks.pop(now);
      m.wheel.wake(unit(kReader, lane_), now + 1);
    }
    marks_.push(now, {is.in->beat, set, all, before == kSpill, bucket});
    if (all && before == kCollect) closed_[set] = true, set_ ^= 1;
  }
  if (collect_ != before) moved_ = true;
  if (!is.taken) return;
  lists_ ? m.lists.taken(m, lane_) : m.pu[static_cast<size_t>(lane_)].color.taken(m, now);
  moved_ = true;
}

}  // namespace pipegs::timing
