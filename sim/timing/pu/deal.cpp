// SPDX-License-Identifier: Apache-2.0
// deal.cpp: see deal.hpp.
#include "sim/timing/pu/deal.hpp"

#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void Deal::step(Machine& m, Cycle now) {
  uint32_t room = 0, free_pus = 0, data = 0, ends = 0;
  for (int k = 0; k < m.units; ++k) {
    Pu& pu = m.pu[static_cast<size_t>(k)];
    room |= uint32_t{pu.visible.room(now)} << k;
    free_pus |= uint32_t{pu.visible.room(now, m.config.eyes)} << k;  // for what all eyes see of a Gaussian
    if (pu.front() && pu.culled.shown(now)) (is_end(pu.culled.value) ? ends : data) |= uint32_t{1} << k;
  }
  uint32_t targets = free_pus & ~waiting_;
  uint32_t second = 0;  // what the other eye sees of the Gaussian dealt last
  for (uint32_t rest = slot_ ? data : 0; rest != 0; rest &= rest - 1) {
    const int k = std::countr_zero(rest);
    if (m.trace.slot[m.pu[static_cast<size_t>(k)].culled.value] == *slot_) second |= uint32_t{1} << k;
  }
  if (second != 0) targets = (uint32_t{1} << target_last_) & ~waiting_;

  bool moved = false;
  for (uint32_t rest = waiting_ & room; rest != 0; rest &= rest - 1) {
    const int k = std::countr_zero(rest);
    Pu& pu = m.pu[static_cast<size_t>(k)];
    pu.visible.push(now, beat_);
    m.wheel.wake(unit(kProject, k), pu.visible.head_from());
    waiting_ &= ~(uint32_t{1} << k);
    moved = true;
  }
  const bool free = waiting_ == 0;
  const auto take = [&](int k) {
    Output<Beat>& culled = m.pu[static_cast<size_t>(k)].culled;
    beat_ = culled.value;
    culled.valid = false;
    m.wheel.wake_now(unit(m.config.tight_cull ? kReach : kCull, k));
    moved = true;
  };
  if (free && data == 0 && std::popcount(ends) == m.config.pu_fronts()) {
    for (int k = m.config.pu_fronts(); k-- > 0;) take(k);
    slot_.reset();
    waiting_ = (uint32_t{1} << m.units) - 1;
  }
  const bool dealt = free && data != 0 && targets != 0;
  const uint32_t asking = second != 0 ? second : data;
  if (dealt) {
    take(source_.port(asking));
    if (m.config.eyes > 1) slot_ = m.trace.slot[beat_];
    target_last_ = round_robin(targets, target_last_);
    waiting_ = uint32_t{1} << target_last_;
  }
  source_.clock(asking, dealt);
  if (moved) m.wheel.wake(unit(kDeal), now + 1);
}

}  // namespace pipegs::timing
