// SPDX-License-Identifier: Apache-2.0
// su_spill.cpp: a set of a Sorting Unit that goes to memory and comes back: see su.hpp.
#include <algorithm>
#include <bit>

#include "sim/timing/su/su_now.hpp"

namespace pipegs::timing {
namespace {

constexpr int kRecordArea = 1, kKeyArea = 2, kParts = 16, kPartW = 4;

}  // namespace

// --- su_port ---------------------------------------------------------------------------------------------------------

uint64_t Su::overflow_line(const Machine& m, int area, uint64_t line) const {
  return m.frame.tables.overflow + (static_cast<uint64_t>(lane_ << 3 | area) << 24) + line;
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

// --- su_spill, su_select ---------------------------------------------------------------------------------------------

// What stands at the output goes to memory: before the output takes the next one in the same cycle.
void Su::divert(Cycle now, const Now& is) {
  diverted_ = is.diverts && out_.shown(now) && !is.record && (!record_valid_ || record_taken_) && !keys_valid_;
  if (!diverted_) return;
  diverted_record_ = out_.value;
  out_.valid = false;
  out_taken_at_ = now;
  moved_ = true;
}

void Su::spill(const Now& is) {
  const bool record_was = record_valid_, keys_were = keys_valid_;
  const bool free = (!record_was || record_taken_) && !keys_were;
  const bool close = spill_ == kClose && collect_ == kSort && !record_was && !keys_were;
  const bool written = close && (closing_ || records_out_.size() % kKeysPerLine == 0);
  const bool take = free && (is.record || diverted_);
  if (record_taken_) record_valid_ = false;
  if (keys_taken_) keys_valid_ = false;
  if (take) {
    Sorted record;
    if (is.record) {
      record.splat = *is.in;
    } else {
      record = diverted_record_;
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
    case kSpillIdle:
      if (is.spill_start) spill_ = kWait;
      break;
    case kWait:
      if (is.drained) spill_ = kRelease;
      break;
    case kRelease:
      if (is.job_done) spill_ = kDrain;
      break;
    case kDrain:
      if (is.drained) spill_ = kClose;
      break;
    case kClose:
      if (!written) break;
      spill_ = kSelecting;
      if (records_out_.empty()) break;
      low_ = max_ = records_out_.front().key;
      for (const Sorted& record : records_out_) low_ = std::min(low_, record.key), max_ = std::max(max_, record.key);
      sent_keys_ = 0;
      select_ = kMeasure;
      break;
    case kSelecting:
      if (is.spill_done) spill_ = kSpillIdle;
      break;
  }
  if (spill_ != before) moved_ = true;
  if (is.spill_start) {
    records_out_.clear();
    closing_ = false;
  }
}

int Su::select_part() const {
  if (!seen_) return -1;
  const uint64_t key = records_out_[seen_number_].key, position = (key - low_) >> shift_;
  return key >= low_ && position < kParts ? static_cast<int>(position) : -1;
}

void Su::select(Cycle now, const Now& is) {
  const auto count = static_cast<uint32_t>(records_out_.size());
  const bool idle = is.split_idle && is.bitonic_idle, turn = is.emit_empty && idle,
             pass = select_ == kCount || select_ == kLoad;
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
  if (look && (number_ % kKeysPerLine == kKeysPerLine - 1 || number_ + 1 == count))
    answers_.pop(now), line_used_ = true;
  if (seen_ || look || read) moved_ = true;
  seen_ = look;
  if (look) seen_number_ = number_++;
  if (read) ++line_;
}

}  // namespace pipegs::timing
