// SPDX-License-Identifier: Apache-2.0
// color.cpp: see color.hpp.
#include "sim/timing/pu/color.hpp"

#include <algorithm>

#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "sim/timing/machine.hpp"

namespace pipegs::timing {

Color::Color(const Machine& m, int lane)
    : port_(m.memory.color_port(lane)),
      self_(unit(m.config.has_lists() ? kListColor : kColor, lane)),
      giver_(unit(m.config.has_lists() ? kExpand : kBack, lane)),
      taker_(unit(m.config.has_lists() ? kExpand : kSu, lane)),
      joins_(m.config.has_stores()),
      memory_(m.config.sh_degree != 0 && m.frame.tables.sh_degree != 0),
      degree_(std::min(static_cast<int>(m.frame.tables.sh_degree), m.config.sh_degree)),
      last_step_(degree_ == 1   ? 1
                 : degree_ == 2 ? 3
                                : 7),
      tasks_(m.config.sh_degree != 0 ? Config::color_depth() : 2),
      flat_(m.config.sh_degree == 0) {}

void Color::push(Machine& m, Cycle now, const Splat& splat) {
  const bool shaded = !is_end(splat.beat) && memory_;
  tasks_.push(now, {splat, shaded, now});
  if (shaded) {
    const uint32_t slot = m.trace.slot[m.config.parts() > 1 ? m.trace.survivor[splat.beat] : splat.beat];
    const int place = color_place(m.config, static_cast<int>(m.frame.tables.sh_degree), slot);
    m.memory.ask(port_, color_line(m.config, m.frame, slot), false, 1,
                 m.config.coded() ? 1 << (place >= m.config.memory_w() / 2) : 3);
    free_from_ = kNever;
  }
  m.wheel.wake(self_, tasks_from());
}

Cycle Color::basis_from(Cycle pushed) {
  rotate_take_ = std::max({pushed + 2, rotate_take_ + 1, rotate_claim_ + 2});
  rotate_claim_ = std::max(rotate_take_ + 4, normal_take_);
  normal_take_ = std::max(rotate_claim_ + 5, normal_claim_ + 2);
  normal_claim_ = std::max(normal_take_ + 3, basis_take_);
  basis_take_ = std::max(normal_claim_ + 4, basis_first_ + 6);
  basis_first_ = std::max(basis_take_ + 1, basis_land_);
  basis_land_ = std::max(basis_first_ + 7, sum_pop_);
  return basis_land_ + 1;
}

void Color::step(Machine& m, Cycle now) {
  if (m.memory.granted(port_, now)) {
    free_from_ = now + 1;
    m.wheel.wake(giver_, now + 1);
  }
  if (m.memory.answered(port_)) lines_.push(now, 0);
  if (tasks_.empty()) return;
  const Task& task = tasks_.front();
  Cycle when = tasks_from();
  if (task.shaded) {
    if (!basis_known_) basis_from_ = basis_from(task.pushed), basis_known_ = true;
    when = std::max({when, lines_.head_from(), basis_from_});
    if (when >= kNever) return;  // the memory wakes us
    when += last_step_;
  }
  when = std::max(when, tail_free_);
  if (when > now) return m.wheel.wake(self_, when);
  if (out.valid) return;  // the SU wakes us
  tail_free_ = now + (task.shaded ? 5 : 2);
  out.set(tail_free_, task.splat);
  m.wheel.wake(taker_, tail_free_);
  if (task.shaded) {
    lines_.pop(now);
    sum_pop_ = now;
    basis_known_ = false;
  }
  tasks_.pop(now);
  m.wheel.wake(giver_, now + 1);
  m.wheel.wake(self_, now + 1);
}

void Color::taken(Machine& m, Cycle) {
  if (is_end(out.value.beat) && joins_) --ends_;
  out.valid = false;
  m.wheel.wake_now(self_);
}

void Color::rows_end(Machine& m, Cycle now) {
  ++ends_;
  m.wheel.wake(taker_, now + 1);
}

bool Color::waiting(Cycle now) const { return tasks_.valid(now) && tasks_.front().shaded && !lines_.valid(now); }

}  // namespace pipegs::timing
