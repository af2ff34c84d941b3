// SPDX-License-Identifier: Apache-2.0
// ru_store.cpp: the alpha stores, and the ends of layers: see ru.hpp.
#include <bit>

#include "sim/timing/machine.hpp"

namespace pipegs::timing {

void AlphaStores::want(Machine& m, int store, int ru) {
  wanted_[static_cast<size_t>(store)] |= uint32_t{1} << ru;
  m.wheel.wake_now(unit(kStore, store));
}

void AlphaStores::step(Machine& m, Cycle now, int store) {
  uint32_t& wanted = wanted_[static_cast<size_t>(store)];
  if (wanted == 0) return;
  const int ru = round_robin(wanted, last_[static_cast<size_t>(store)]);
  last_[static_cast<size_t>(store)] = ru;
  m.ru[static_cast<size_t>(ru)].fire(m, now);
  for (wanted &= ~(uint32_t{1} << ru); wanted != 0; wanted &= wanted - 1)
    m.wheel.wake(unit(kSource, std::countr_zero(wanted)), now + 1);
}

void LayerFree::done(Machine& m, Cycle now, int ru) {
  m.show(now, Border::kLayer, ru, 0);
  coming[static_cast<size_t>(ru)] = true;
  m.wheel.wake(unit(kPublish), now + 1);
}

void LayerFree::publish(Machine& m, Cycle now) {
  bool all = true;
  for (size_t i = 0; i < static_cast<size_t>(m.units); ++i) {
    count[i] += coming[i] ? 1 : 0;
    coming[i] = false;
    all = all && count[i] > 0;
  }
  if (!all) return;
  for (size_t i = 0; i < static_cast<size_t>(m.units); ++i) {
    --count[i];
    m.pu[i].layer_free(m, now);
  }
  m.wheel.wake(unit(kPublish), now + 1);
}

}  // namespace pipegs::timing
