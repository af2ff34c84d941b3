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

Su::Su(const Machine& m, int lane) : lane_(lane), port_(m.memory.sort_port(lane)), records_(m.config.records) {}

void Su::step(Machine& m, Cycle now) {
  moved_ = out_taken_at_ == now;
  sorter_idle_ = sequence_ == kIdle && layers_.empty();
  emit_empty_ = waiting_.empty() && !out.valid && out_taken_at_ != now;
  select_reads_ = select_reads();
  if (sorting_ && now > sort_last_) {
    sorting_ = false;
    live_ = fill_;
    sent_ = fill_ = 0;
    loaded_ = false;
  }
  port(m, now);
  emit(m, now);
  sort(now);
  collect(m, now);
  if (line_used_) --flight_, line_used_ = false, moved_ = true;
  if (release_ != 0) used_ -= release_, release_ = 0, moved_ = true;

  Cycle next = moved_ ? now + 1 : kNever;
  if (sorting_) next = std::min(next, std::max(sort_last_ + 1, now + 1));
  if (group_ < groups_.size() && load_from_ >= now) next = std::min(next, load_from_ + 1);
  if (!waiting_.empty() && !out.valid) next = std::min(next, std::max(waiting_.head_from(), now + 1));
  if (sequence_ == kIdle && !layers_.empty()) next = std::min(next, std::max(layers_.head_from(), now + 1));
  if (answers_.head_from() > now) next = std::min(next, answers_.head_from());
  m.wheel.wake(unit(kSu, lane_), next);
}

void Su::taken(Machine& m, Cycle now) {
  const Sorted& item = out.value;
  if (is_end(item.splat.beat)) release_ = static_cast<int>(item.key);
  if (out_outside_) answers_.pop(now), line_used_ = true;
  out.valid = false;
  out_taken_at_ = now;
  m.wheel.wake_now(unit(kSu, lane_));
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
    choice_ = kNone;
    moved_ = true;
    return;
  }
  if (choice_ != kNone) return;
  const bool item = sequence_ == kSpill && !sorting_ && sent_ < live_ && looked_ && waiting_.room(now) &&
                    order_[next_].number >= static_cast<uint32_t>(records_);
  if (record_valid_) {
    choice_ = kRecord;
    m.memory.ask(port_, overflow_line(m, kRecordArea, record_line_), true);
  } else if (keys_valid_) {
    choice_ = kKeys;
    m.memory.ask(port_, overflow_line(m, kKeyArea, keys_line_), true);
  } else if ((select_reads_ || item) && flight_ != kAnswers) {
    choice_ = kRead;
    m.memory.ask(port_, select_reads_ ? overflow_line(m, kKeyArea, line_) : overflow_line(m, kRecordArea, order_[next_].number - static_cast<uint32_t>(records_)));
  }
}

// --- su_emit: from the queue to the output --------------------------------------------------------------------------------

void Su::emit(Machine& m, Cycle now) {
  if (!out.valid && waiting_.valid(now)) {
    const Entry& entry = waiting_.front();
    out_outside_ = entry.outside;
    out.set(now + 1, entry.item);
    if (out_outside_) out.from = kNever;
    waiting_.pop(now);
    moved_ = true;
  }
  if (out.valid && out.from == kNever && !answers_.empty()) out.from = std::max(now + 1, answers_.head_from());
  if (out.valid && out.from > now) m.wheel.wake(unit(kOrder, 1), out.from);
}

// --- the sequence of a layer, su_split, su_bitonic --------------------------------------------------------------------------

void Su::begin_split(Cycle now, std::vector<Sorted>& part) {
  keys_.clear();
  for (const Sorted& item : part) keys_.push_back(item.key);
  order_ = part;
  std::sort(order_.begin(), order_.end(), [](const Sorted& a, const Sorted& b) { return a.key < b.key; });
  next_ = 0;
  su_groups(keys_, order_.front().key, order_.back().key, groups_);
  group_ = 0;
  group_left_ = groups_[0].keys;
  load_from_ = now + groups_[0].delay;
}

void Su::sort(Cycle now) {
  const bool sent_all = split_idle(now) && bitonic_idle(), item = !sorting_ && sent_ < live_;
  const bool splits = group_ < groups_.size() && now > load_from_ && !sorting_ && !loaded_ && (fill_ >= live_ || fill_ < sent_);
  const bool start = !sorting_ && loaded_ && sent_ == live_, spills = sequence_ == kSpill;

  bool send = false;
  if (item) {
    send = spills ? spill_goes(now) : waiting_.room(now);
    if (send) {
      waiting_.push(now, {order_[next_], spills && order_[next_].number >= static_cast<uint32_t>(records_)});
      ++next_;
    }
  }
  if (splits) {
    ++fill_;
    if (--group_left_ == 0) {
      loaded_ = true;
      if (++group_ < groups_.size()) {
        group_left_ = groups_[group_].keys;
        load_from_ = now + groups_[group_].delay;
      } else {
        split_idle_from_ = now + 1;
      }
    }
  }
  if (send) ++sent_;
  if (start) {
    if (fill_ == 1) {
      live_ = 1;
      sent_ = fill_ = 0;
      loaded_ = false;
    } else {
      sorting_ = true;
      sort_last_ = now + sort_cycles(fill_);
    }
  }
  moved_ = moved_ || send || splits || start;

  const bool selected = select_ == kSelectIdle;
  if (spills) select(now, sent_all);
  switch (sequence_) {
    case kIdle:
      if (!layers_.valid(now)) break;
      std::swap(sorted_, layers_.front());
      layers_.pop(now);
      moved_ = true;
      if (sorted_.splats.empty()) {
        sequence_ = kEnd;
      } else if (sorted_.splats.size() > static_cast<size_t>(records_)) {
        sequence_ = kSpill;
        const auto [low, high] = std::minmax_element(sorted_.splats.begin(), sorted_.splats.end(), [](const Sorted& a, const Sorted& b) { return a.key < b.key; });
        low_ = low->key, max_ = high->key;
        sent_keys_ = 0;
        select_ = kMeasure;
      } else {
        sequence_ = kSort;
        begin_split(now, sorted_.splats);
      }
      break;
    case kSort:
      if (sent_all) sequence_ = kEnd, moved_ = true;
      break;
    case kSpill:
      if (selected) sequence_ = kEnd, moved_ = true;
      break;
    case kEnd:
      if (!waiting_.room(now) || item) break;
      Entry end;
      end.item.splat.beat = sorted_.end;
      end.item.key = std::min(sorted_.splats.size(), static_cast<size_t>(records_));
      waiting_.push(now, end);
      sequence_ = kIdle;
      moved_ = true;
      break;
  }
}

// --- a layer that does not fit ------------------------------------------------------------------------------------------------

// The key at the sorter's output: its record's number is looked up first, then its line is asked for.
bool Su::spill_goes(Cycle now) {
  const bool outside = order_[next_].number >= static_cast<uint32_t>(records_);
  const bool go = looked_ && waiting_.room(now) && (!outside || (read_taken_ && !select_reads_));
  if (looked_ == go) moved_ = true;
  looked_ = !go;
  return go;
}

void Su::select(Cycle now, bool sent_all) {
  const auto count = static_cast<uint32_t>(sorted_.splats.size());
  const bool turn = emit_empty_ && sent_all, pass = select_ == kCount || select_ == kLoad;
  const bool look = pass && turn && answers_.valid(now) && number_ != count, pass_done = number_ == count && !seen_;
  // The key that was looked at in the cycle before.
  int part = -1;
  if (seen_) {
    const uint64_t key = sorted_.splats[seen_number_].key, position = (key - low_) >> shift_;
    if (key >= low_ && position < kParts) part = static_cast<int>(position);
  }
  const auto parts = [this](int i) { return counts_[static_cast<size_t>(i)]; };
  const bool fits = stop_ < kParts && sum_ + parts(std::min(stop_, kParts - 1)) <= records_;
  const bool read = read_taken_ && select_reads_;
  switch (select_) {
    case kMeasure:
      shift_ = std::max(static_cast<int>(std::bit_width(max_ - low_)) - kPartW, 0);
      counts_.fill(0);
      line_ = number_ = 0;
      select_ = kCount;
      moved_ = true;
      break;
    case kCount:
      if (part >= 0) ++counts_[static_cast<size_t>(part)];
      if (pass_done) first_ = stop_ = sum_ = 0, select_ = kChoose, moved_ = true;
      break;
    case kChoose:
      moved_ = true;
      part_.clear();
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
      if (part >= first_ && part < stop_ && part >= 0) part_.push_back(sorted_.splats[seen_number_]), ++sum_;
      if (pass_done) select_ = kGroup, moved_ = true;
      break;
    case kGroup:
      begin_split(now, part_);
      select_ = kSorting;
      moved_ = true;
      break;
    case kSorting:
      if (!sent_all) break;
      select_ = sent_keys_ == count ? kSelectIdle : kChoose;
      first_ = stop_;
      sum_ = 0;
      moved_ = true;
      break;
    case kSelectIdle: break;
  }
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

void Su::collect(Machine& m, Cycle now) {
  const auto number = static_cast<uint32_t>(layer_.splats.size()), records = static_cast<uint32_t>(records_);
  const bool fits = number < records, room = used_ != records_, lines_free = !record_valid_ && !keys_valid_;
  const bool appended = append_ == records;
  const bool arrived = arrives_;
  if (record_taken_) record_valid_ = false;
  if (keys_taken_) keys_valid_ = false;
  arrives_ = false;
  switch (collect_) {
    case kCollect: {
      Color& color = m.pu[static_cast<size_t>(lane_)].color;
      if (!lines_free || !color.shown(now)) break;
      const Splat& splat = color.out.value;
      const bool data = !is_end(splat.beat);
      if (data && fits && !room) break;
      if (data) {
        layer_.splats.push_back({splat, m.trace.key[splat.beat], number});
        if (fits) {
          ++used_;
        } else {
          record_valid_ = true;
          record_line_ = number - records;
          keys_line_ = number / kKeysPerLine;
          if (number % kKeysPerLine == kKeysPerLine - 1) keys_valid_ = true;
        }
      } else {
        layer_.end = splat.beat;
        collect_ = number > records ? kClose : kHand;
      }
      color.taken(m, now);
      moved_ = true;
      break;
    }
    case kClose:
      if (!lines_free) break;
      if (number % kKeysPerLine != 0) keys_valid_ = true;
      collect_ = kAppend;
      moved_ = true;
      break;
    case kAppend:
      if (arrived) {
        keys_line_ = (append_ - 1) / kKeysPerLine;
        if ((append_ - 1) % kKeysPerLine == kKeysPerLine - 1) keys_valid_ = true;
      }
      arrives_ = sorter_idle_ && lines_free && !arrived && !appended;
      if (arrives_) ++append_;
      if (appended && !arrived && lines_free) collect_ = kHand;
      moved_ = true;
      break;
    case kHand:
      if (!lines_free || !layers_.room(now)) break;
      layers_.push(now, std::move(layer_));
      layer_ = {};
      append_ = 0;
      collect_ = kCollect;
      moved_ = true;
      break;
  }
  moved_ = moved_ || record_taken_ || keys_taken_;
}

}  // namespace pipegs::timing
