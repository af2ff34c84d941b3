// SPDX-License-Identifier: Apache-2.0
// deal.cpp: see deal.hpp.
#include "sim/timing/pu/deal.hpp"

#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void Deal::step(Machine& m, Cycle now) {
  uint32_t room = 0, data = 0, ends = 0;
  for (int k = 0; k < m.units; ++k) {
    Pu& pu = m.pu[static_cast<size_t>(k)];
    room |= uint32_t{pu.visible.room(now)} << k;
    if (pu.front() && pu.culled.shown(now)) (is_end(pu.culled.value) ? ends : data) |= uint32_t{1} << k;
  }
  const uint32_t targets = room & ~waiting_;

  bool moved = false;
  for (uint32_t rest = waiting_ & room; rest != 0; rest &= rest - 1) {
    const int k = std::countr_zero(rest);
    Pu& pu = m.pu[static_cast<size_t>(k)];
    pu.visible.push(now, beats_[k]);
    m.wheel.wake(unit(kProject, k), pu.visible.head_from());
    waiting_ &= ~(uint32_t{1} << k);
    moved = true;
  }
  const bool free = waiting_ == 0;
  const auto take = [&](int k) {
    Output<Beat>& culled = m.pu[static_cast<size_t>(k)].culled;
    beat_ = culled.value;
    for (Beat& one : beats_) if (is_end(beat_)) one = beat_;
    culled.valid = false;
    m.wheel.wake_now(unit(m.config.tight_cull ? kReach : kCull, k));
    moved = true;
  };
  if (free && data == 0 && std::popcount(ends) == m.config.pu_fronts()) {
    for (int k = m.config.pu_fronts(); k-- > 0;) take(k);
    waiting_ = (uint32_t{1} << m.units) - 1;
  }
  const bool dealt = (free || (x_deal() > 1 && !is_end(beat_))) && data != 0 && (targets & ~waiting_) != 0;
  if (dealt) {
    uint32_t sources = data, open = targets & ~waiting_;
    for (int n = 0; n < x_deal() && sources != 0 && open != 0; ++n) {
      const int from = n == 0 ? source_.port(sources) : std::countr_zero(sources);
      take(from);
      sources &= ~(uint32_t{1} << from);
      target_last_ = round_robin(open, target_last_);
      beats_[target_last_] = beat_;
      waiting_ |= uint32_t{1} << target_last_;
      open &= ~(uint32_t{1} << target_last_);
    }
  }
  source_.clock(data, dealt);
  if (moved) m.wheel.wake(unit(kDeal), now + 1);
}

}  // namespace pipegs::timing
