// SPDX-License-Identifier: Apache-2.0
// ru_walk: which regions of a window belong to which RU, and where the alpha line of a region lies.
//
// Paper   Sec. 5.3 (four RUs render different tiles in parallel).
// Idea    Two RUs own the colours of a chess board; four own every fourth region of a row, each row starting two
//         further: a splat that covers 2x2 regions, or four in a row, keeps all of them busy. A splat's lines lie one
//         behind the other, lowest region of its mask first.
// Stream  sorted_t in, one job per owned region of its mask out: region and line. A region that is done has none, but
//         where its line lies in an alpha store: then it is freed (skip).
// RTL     rtl/ru/ru_dispatch.sv (owners), rtl/ru/ru_walk.sv (lines), rtl/ru/ru_fetch.sv (memory addresses)
#pragma once

#include <cstdint>

#include "cpp_model/areas/areas.hpp"
#include "cpp_model/regions.hpp"

namespace pipegs {

// The RU that blends a region of every window.
inline int ru_owner(const Config& c, int region) {
  return (region_x(c, region) + c.units / 2 * region_y(c, region)) % c.units;
}

// All regions of an RU in a part, as a mask: the same in each part.
inline uint64_t ru_own_mask(const Config& c, int unit) {
  uint64_t mask = 0;
  for (int r = 0; r < c.mask_w(); ++r) mask |= uint64_t{ru_owner(c, r) == unit} << r;
  return mask;
}

// The number of an RU's region among its own regions, in the order in which the pixel buffer holds them.
inline int ru_slot(const Config& c, int region) { return region / c.units; }

// The region that RU `unit` holds in `slot`: the inverse of ru_slot.
inline int ru_region(const Config& c, int unit, int slot) {
  int region = slot * c.units;
  while (ru_owner(c, region) != unit) ++region;
  return region;
}

// Bits of the number of an alpha line in its overflow area. Above it stands which of the unit's two areas; with lists
// the unit.
inline int ru_number_w(const Config& c) { return c.alpha_address_w() - (c.has_lists() ? c.unit_w() : 1); }

// First memory line of an alpha line of `unit` with this address.
inline uint64_t ru_overflow_line(const Config& c, const Span& overflow, uint64_t unit, uint64_t address) {
  const uint64_t above = address >> ru_number_w(c), number = address - (above << ru_number_w(c));
  const Area area = !c.has_lists() && above != 0 ? Area::kOdd : Area::kEven;
  return overflow.first + area_first(c, overflow.lines, c.has_lists() ? above : unit, area) +
         number * static_cast<uint64_t>(c.alpha_memory_lines());
}

}  // namespace pipegs
