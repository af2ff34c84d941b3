// SPDX-License-Identifier: Apache-2.0
// rows.hpp: the Row Units in the timing model: jobs in, one line of alphas per region out.
//
// RTL     rtl/pu/rows/pu_region.sv, rtl/pu/rows/pu_rows.sv: in the PU, or in the RU when late.
// Idea    pu_region makes a region in four cycles; pu_rows holds it for 8 / PixelsPerRow cycles and shows its line
//         three cycles later. The pipeline stands still as a whole while a line waits at its output, so it runs on a
//         time of its own, which lags behind the clock by `lag_`.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

// What goes into the Row Units. An end has no regions.
struct RowJob {
  Beat beat = 0;
  uint64_t mask = 0;
  uint32_t address = 0;  // in external memory, of the line of its first region
  bool ext = false;
};

struct RowLine {
  Beat beat = 0;  // of an end; the data's is not kept
  bool end = false, ext = false;
  uint8_t region = 0;
  uint32_t address = 0;
};

class Rows {
 public:
  explicit Rows(int pixels_per_row) : steps_(8 / pixels_per_row) {}

  bool shown(Cycle now) const { return count_ > 0 && due_[head_] + lag_ <= now; }
  Cycle head_from() const { return count_ > 0 ? due_[head_] + lag_ : kNever; }
  const RowLine& head() const { return lines_[head_]; }
  void take(Cycle now) {
    lag_ = now - due_[head_];
    head_ = (head_ + 1) & kMask;
    --count_;
  }

  // A cycle, after the taker's. Takes the job, if there is one and room for it, and tells so.
  bool step(Cycle now, const RowJob* job) {
    if (!shown(now) && waiting_ && waiting_from_ <= now && now - lag_ >= row_free_) {
      const Cycle last = now - lag_ + (waiting_line_.end ? 1 : steps_);
      const unsigned at = (head_ + static_cast<unsigned>(count_++)) & kMask;
      lines_[at] = waiting_line_;
      due_[at] = last + 3;
      row_free_ = last;
      waiting_ = false;
    }
    if (working_ && now >= finish_at_ && !waiting_) {
      waiting_ = true;
      waiting_from_ = now + 1;
      waiting_line_ = line_;
      if (rest_ != 0) {
        ++line_.address;
        select(now + 4);
      } else {
        working_ = false;
      }
    }
    if (working_ || job == nullptr) return false;
    line_ = {job->beat, is_end(job->beat), job->ext, 0, job->address};
    working_ = true;
    rest_ = job->mask;
    if (line_.end) {
      rest_ = 0;
      finish_at_ = now + 1;
    } else {
      select(now + 4);
    }
    return true;
  }

  // When something will move by itself, kNever if a job or the taker has to come first.
  Cycle next(Cycle now) const {
    Cycle when = kNever;
    const auto at = [&](Cycle cycle) { when = std::min(when, std::max(cycle, now + 1)); };
    if (waiting_ && !shown(now)) at(std::max(waiting_from_, row_free_ + lag_));
    if (working_ && !waiting_) at(finish_at_);
    return when;
  }
  bool idle() const { return !working_ && !waiting_ && count_ == 0; }
  bool can_load() const { return !working_; }

 private:
  static constexpr unsigned kMask = 7;  // the pipeline holds at most four lines

  void select(Cycle finish) {
    line_.region = static_cast<uint8_t>(std::countr_zero(rest_));
    rest_ &= rest_ - 1;
    finish_at_ = finish;
  }

  int steps_;
  // pu_region
  bool working_ = false;
  RowLine line_;
  uint64_t rest_ = 0;
  Cycle finish_at_ = 0;
  bool waiting_ = false;  // its output register
  Cycle waiting_from_ = 0;
  RowLine waiting_line_;
  // pu_rows, in its own time
  std::array<RowLine, kMask + 1> lines_{};
  std::array<Cycle, kMask + 1> due_{};
  unsigned head_ = 0;
  int count_ = 0;
  Cycle lag_ = 0, row_free_ = kLongAgo;
};

}  // namespace pipegs::timing
