// SPDX-License-Identifier: Apache-2.0
// su_sort.cpp: the splitter, the sorter and the output of a Sorting Unit: see su.hpp.
#include <algorithm>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {
namespace {

// Cycles in the bitonic network.
int sort_cycles(int keys) { return keys <= 1 ? 0 : keys <= 2 ? 1 : keys <= 4 ? 3 : keys <= 8 ? 6 : 10; }

}  // namespace

// --- su_emit ---------------------------------------------------------------------------------------------------------

void Su::emit(Cycle now, const Now& is) {
  if (freed_ != kNil) {
    free_slots_.push_back(freed_);
    ++back_;
    back_at_[static_cast<size_t>(back_next_++) & 3] = now;
    --used_;
    freed_ = kNil;
    moved_ = true;
  }
  const bool busy = stored_at_ == now - 1;  // the pool is written
  if (busy) moved_ = true;
  // From the queue to the output; the record's slot becomes free in the next cycle.
  if (!out_.valid && waiting_.valid(now) && !busy) {
    const Entry& entry = waiting_.front();
    out_outside_ = entry.outside;
    out_.set(out_outside_ ? kNever : now + 1, entry.item);
    freed_ = entry.slot;
    waiting_.pop(now);
    moved_ = true;
  }
  // Into the queue, or back to memory.
  const bool outside = is.outside && is.emit_item;
  if (outside && looked_ == (is.emit_ready && is.emit_item)) moved_ = true;
  looked_ = outside && !is.emit_ready && (looked_ || !busy);
  if (read_taken_) ask_ = false;
  if (!is.emit_item || !is.emit_ready) return;
  moved_ = true;
  if (is.kept) {
    kept_ = item();
    return;
  }
  Entry entry;
  if (is.mark_first) {
    entry.item.splat.beat = is.mark_end;
    marks_.pop(now);
  } else if (is.outer) {
    entry.item = item();
    entry.outside = ask_ = true;
    ask_line_ = entry.item.number;
  } else {
    entry = batches_.front();
  }
  waiting_.push(now, entry);
}

// A record from memory stands at the output when its line is the first of those that were read.
void Su::show_outside(Machine& m, Cycle now) {
  if (out_.valid && out_.from == kNever && !answers_.empty() && owners_.front() == kRecordLine)
    out_.from = std::max(now + 1, answers_.head_from());
  if (out_.valid && out_.from > now) m.wheel.wake(unit(kSu, lane_), out_.from);
}

// --- su_split, su_bitonic --------------------------------------------------------------------------------------------

void Su::begin_group(Cycle origin) {
  group_left_ = groups_[group_].keys;
  load_from_ = origin + groups_[group_].delay;
  // The latest are at the back, so they come in turned round.
  const size_t from = group_ == 0 ? 0 : groups_[group_ - 1].links;
  for (size_t i = groups_[group_].links; i-- > from;)
    link_writes_.push_back({origin + links_[i].first, origin + links_[i].last});
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
  if (is.item_goes && !is.outer) ++sent_, batches_.pop(now), moved_ = true;
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
      const auto [nearest, farthest] = su_bucket_range(config_, chain.bucket, octave_);
      const int below = config_.key_w() - config_.depth_w;
      begin_split(now, nearest << below, ((farthest + 1) << below) - 1);
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

}  // namespace pipegs::timing
