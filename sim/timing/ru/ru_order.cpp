// SPDX-License-Identifier: Apache-2.0
// ru_order.cpp: see ru_order.hpp.
#include "sim/timing/ru/ru_order.hpp"

#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void Dispatch::step(Machine& m, Cycle now) {
  for (uint32_t rest = waiting_; rest != 0; rest &= rest - 1) {
    const int j = std::countr_zero(rest);
    Ru& ru = m.ru[static_cast<size_t>(j)];
    if (!ru.queue.room(now)) continue;
    ru.queue.push(now, splat_);
    m.wheel.wake(unit(m.config.caches_alphas() ? kWalk : kSource, j), ru.queue.head_from());
    waiting_ &= ~(uint32_t{1} << j);
  }
  if (waiting_ != 0) return;  // an RU's queue wakes us
  if (m.merge.out.shown(now)) {
    splat_ = m.merge.out.value;
    m.merge.out.valid = false;
    m.show(now, Border::kSorted, 0, m.beat_shown(splat_.beat));
    m.wheel.wake_now(unit(kOrder, 1));
    if (splat_.beat == kWindowEndBeat) m.window_ends.push_back(now);
    for (int j = 0; j < m.units; ++j) {
      if (is_end(splat_.beat) || (splat_.mask & m.ru[static_cast<size_t>(j)].own()) != 0) waiting_ |= uint32_t{1} << j;
    }
    m.wheel.wake(unit(kOrder), now + 1);
  }
}

void Merge::step(Machine& m, Cycle now) {
  if (out.valid) return;
  int nearest = -1;
  uint64_t key = 0;
  for (int i = 0; i < m.units; ++i) {
    const Su& su = m.su[static_cast<size_t>(i)];
    if (!su.shown(now)) return;
    if (is_end(su.head().splat.beat)) continue;
    if (nearest < 0 || su.head().key < key) nearest = i, key = su.head().key;
  }
  const bool ends = nearest < 0;
  // A watermark, or the end of a part, has done its work.
  const bool mark = ends && m.config.has_watermarks() && m.su[0].head().splat.beat != kWindowEndBeat;
  for (int i = 0; i < m.units; ++i) {
    if (!ends && i != nearest) continue;
    Su& su = m.su[static_cast<size_t>(i)];
    if (!mark && (i == nearest || i == 0)) {
      out.set(now + 1, su.head().splat);
      out.value.unit = static_cast<uint8_t>(i);
    }
    su.taken(m, now);
  }
  m.wheel.wake(out.valid ? unit(kOrder) : unit(kOrder, 1), now + 1);  // behind a mark the next splats may be there
}

}  // namespace pipegs::timing
