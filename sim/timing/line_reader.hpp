// SPDX-License-Identifier: Apache-2.0
// line_reader.hpp: ranges of items in external memory as a stream of items, in the timing model.
//
// RTL     rtl/lib/pipegs_line_reader.sv. The taker of items comes before the reader in a cycle, and the job comes last.
#pragma once

#include <algorithm>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

template <class Tag, int MostJobs>
class LineReader {
 public:
  struct Job {
    bool read = false;
    uint32_t first = 0, count = 0;
    Tag tag{};
  };

  LineReader(int items_per_line, uint64_t base, int jobs, int lines)
      : per_line_(static_cast<uint32_t>(items_per_line)), base_(base), credits_(lines), most_jobs_(jobs), jobs_(jobs) {}

  // --- items, for their taker ----------------------------------------------------------------------------------------
  bool item_shown(Cycle now) const { return jobs_.valid(now) && (!jobs_.front().read || line_valid_); }
  const Job& job() const { return jobs_.front(); }
  uint32_t item() const { return item_; }  // of the job
  void pop_item(Cycle now) {
    const Job& job = jobs_.front();
    const bool last = !job.read || item_ + 1 == job.count;
    line_popped_ = job.read && (last || (job.first + item_ + 1) % per_line_ == 0);
    item_ = last ? 0 : item_ + 1;
    if (last) jobs_.pop(now);
  }
  bool needs_step(Cycle now) const { return line_popped_ || jobs_.last_pop() == now; }  // after items were taken

  // --- jobs: is there room in this cycle? ----------------------------------------------------------------------------
  bool job_room(Cycle now) const { return taken_at_ == now || (jobs_.room(now) && free_from_ <= now); }

  // --- a cycle, after the items' taker: request granted, line answered, job taken (or null) --------------------------
  // Tells whether anything changed.
  bool step(Cycle now, bool granted, bool answered, const Job* job) {
    const bool load = stored_ > 0 && (!line_valid_ || line_popped_), popped = line_popped_;
    stored_ += (answered ? 1 : 0) - (load ? 1 : 0);
    line_valid_ = load || (line_valid_ && !line_popped_);
    line_popped_ = false;
    credits_ += (load ? 1 : 0) - (granted ? lines() : 0);
    if (granted) {
      const int asked = lines();
      line_ += static_cast<uint64_t>(asked);
      lines_left_ -= asked;
      if (lines_left_ == 0) free_from_ = now + 1;
    }
    if (job != nullptr) {
      taken_at_ = now;
      jobs_.push(now, *job);
      if (job->read) {
        line_ = base_ + job->first / per_line_;
        lines_left_ = static_cast<int>((job->first % per_line_ + job->count + per_line_ - 1) / per_line_);
        free_from_ = kNever;
      }
    }
    return load || popped || granted || answered || job != nullptr;
  }
  bool room_next(Cycle now) const {
    return jobs_.count() < most_jobs_ && free_from_ <= now + 1;
  }  // after step: in the next cycle
  bool room_before_job(Cycle now) const {
    return jobs_.room(now) && free_from_ <= now;
  }  // as job_room, asked for in step's cycle

  // From the next cycle on.
  bool wants() const { return lines_left_ > 0 && credits_ >= kGroup; }
  uint64_t line() const { return line_; }
  int lines() const { return std::min(lines_left_, kGroup - static_cast<int>(line_ % kGroup)); }
  Cycle next(Cycle now) const { return stored_ > 0 && !line_valid_ ? now + 1 : kNever; }
  Cycle item_from(Cycle now) const {  // kNever when it waits for the memory
    return jobs_.empty() || (jobs_.front().read && !line_valid_) ? kNever : std::max(jobs_.head_from(), now + 1);
  }
  bool idle() const { return jobs_.empty(); }

 private:
  static constexpr int kGroup = 8;  // lines: a request goes to the end of the job or of its group

  uint32_t per_line_;  // items
  uint64_t base_, line_ = 0;
  int lines_left_ = 0, credits_, stored_ = 0;
  Cycle free_from_ = kLongAgo, taken_at_ = kLongAgo;
  bool line_valid_ = false, line_popped_ = false;
  int most_jobs_;
  FallQueue<Job, MostJobs> jobs_;
  uint32_t item_ = 0;
};

}  // namespace pipegs::timing
