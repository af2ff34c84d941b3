// SPDX-License-Identifier: Apache-2.0
// su_buckets.cpp: the buckets of depth of a Sorting Unit: see su.hpp.
#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

// --- su_buckets ------------------------------------------------------------------------------------------------------

void Su::buckets(Cycle now, const Now& is) {
  const int bits = bits_low_ + bits_high_;
  const uint32_t job_high = is.mark_bucket >> bits_low_, job_low = is.mark_bucket & ((1u << bits_low_) - 1);
  if (operation_ != kNone || is.next != kNone || inserted_) moved_ = true;

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
          words_[word] = (held ? words_[word] : 0) | Bits{1} << (insert_bucket_ & ((1u << bits_low_) - 1));
        }
      }
      held_[insert_set_] |= Bits{1} << (insert_bucket_ >> bits_low_);
      break;
    case kWord: {
      Bits& word = words_[(static_cast<size_t>(is.job_set) << bits_high_) + word_];
      const Bits below = is.job_all || word_ != job_high ? ~Bits{0} : (Bits{1} << job_low) - 1;
      work_ = word & below;
      word &= ~below;
      if (word == 0) held_[is.job_set] &= ~(Bits{1} << word_);
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
    case kWord: word_ = lowest(is.candidates); break;
    case kEntry: {
      const uint32_t bit = lowest(work_);
      entry_bucket_ = (word_ << bits_low_) + bit;
      work_ &= work_ - 1;
      break;
    }
  }
  inserted_ = operation_ == kInsert;
  if (is.ends) operation_ = is.next;
  if (is.job_done && !is.spill_job) {
    marks_.pop(now);
    if (is.mark_all) closed_[is.mark_set] = false;
  }
}

}  // namespace pipegs::timing
