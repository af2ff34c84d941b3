// SPDX-License-Identifier: Apache-2.0
// color.hpp: the colour of a PU in the timing model, and the join behind it.
//
// RTL     rtl/pu/pu_color*.sv, pu_join.sv.
// Order   With lists it stands between pu_expand and pu_expand, else before the SU.
// Idea    The direction's path (rotate, normalise, basis) has fixed times and stops only for the sum behind it, so a
//         record's times through it follow from those of the record before.
#pragma once

#include <algorithm>
#include <optional>

#include "cpp_model/config.hpp"
#include "sim/timing/cycle.hpp"
#include "sim/timing/ru/ru.hpp"

namespace pipegs::timing {

struct Machine;

class Color {
 public:
  Color(const Machine& machine, int lane);

  // For pu_allocate: in this cycle.
  bool room(Cycle now) const { return tasks_.room(now) && free_from_ <= now; }
  void push(Machine& m, Cycle now, const Splat& splat);

  void step(Machine& m, Cycle now);

  // For the SU: the join holds an end back until the lines of its layer are written.
  bool shown(Cycle now) const { return out.shown(now) && (!is_end(out.value.beat) || !joins_ || ends_ > 0); }
  void taken(Machine& m, Cycle now);
  void rows_end(Machine& m, Cycle now);
  Output<Splat> out;

  bool busy() const { return !tasks_.empty() || out.valid; }
  bool waiting(Cycle now) const;  // for a line of memory

 private:
  struct Task {
    Splat splat;
    bool shaded = false;
    Cycle pushed = 0;
    bool again = false;  // its line is that of the task before
  };
  struct Line {
    uint64_t number = 0;
    int halves = 0;
    bool operator==(const Line&) const = default;
  };
  Cycle tasks_from() const {
    return flat_ && !tasks_.empty() ? std::max(tasks_.front().pushed + 1, tasks_.last_pop() + 1) : tasks_.head_from();
  }
  Cycle basis_from(Cycle pushed);  // of the next shaded record

  const int port_;
  const int self_, giver_, taker_;  // units
  const bool joins_, memory_;       // pu_join is there; the colour hardware is there and asks for lines
  int degree_ = 0, last_step_ = 0;

  SramQueue<Task, Config::color_depth()> tasks_;
  const bool flat_;  // without SH hardware: a queue of registers, which is a cycle faster
  SramQueue<uint8_t, Config::color_depth()> lines_;
  std::optional<Line> asked_;   // of the task that was queued last
  Cycle free_from_ = kLongAgo;  // the request register
  int ends_ = 0;

  // The record before, on the direction's path.
  Cycle rotate_take_ = kLongAgo, rotate_claim_ = kLongAgo, normal_take_ = kLongAgo, normal_claim_ = kLongAgo;
  Cycle basis_take_ = kLongAgo, basis_first_ = kLongAgo, basis_land_ = kLongAgo, sum_pop_ = kLongAgo;
  bool basis_known_ = false;  // of the head of the tasks
  Cycle basis_from_ = 0;
  Cycle tail_free_ = kLongAgo;
};

}  // namespace pipegs::timing
