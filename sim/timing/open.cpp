// SPDX-License-Identifier: Apache-2.0
// open.cpp: see open.hpp.
#include "sim/timing/open.hpp"

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void OpenRegister::publish(Machine& m, Cycle now) {
  Seen seen{.known = true, .window = m.ru[0].window(), .closed = {}};
  for (const Ru& ru : m.ru) {
    seen.known = seen.known && ru.window() == seen.window;
    seen.closed |= ru.done();
  }
  if (!seen.known) seen.closed = {};
  if (seen == seen_) return;
  seen_ = seen;
  before_ = now >= from_ ? latest_ : before_;
  const Windows& windows = m.frame.raster.windows;
  const uint64_t columns = windows.last_x - windows.first_x + 1;
  latest_ = seen.known ? open_of(m.config, seen.closed, windows.first_x + seen.window % columns,
                                 windows.first_y + seen.window / columns)
                       : Open{};
  from_ = now + 1;
  m.wheel.wake(unit(kDopu), now + 1);
}

Closed OpenRegister::closed(const Machine& m, size_t walk, Cycle now) const {
  const TimingWalk& of = m.trace.walks[walk];
  const Windows& windows = m.frame.raster.windows;
  const uint64_t columns = windows.last_x - windows.first_x + 1;
  return closed_at(m.config, now >= from_ ? latest_ : before_, windows.first_x + of.window % columns,
                   windows.first_y + of.window / columns, of.walk);
}

}  // namespace pipegs::timing
