// SPDX-License-Identifier: Apache-2.0
// areas.hpp: how the overflow area is divided: one table, from which rtl/pipegs_pkg.sv gets its functions.
//
// Paper   None: its buffers hold everything.
// RTL     area_lines, area_place, area_first, list_first of rtl/pipegs_pkg.sv
// Idea    The host gives an area of any size; every part of it is the size shifted, so the machine divides by nothing.
//         With lists the lower half is theirs. The rest is shared out to the units, and a share to what a unit keeps
//         there: in its lower half the SU's (all of the share when no alphas go to memory), in its upper half alphas.
//           SU       keys, 1/8 | merged runs, 1/8 | runs, 1/4 | records, 1/2
//           alphas   of the layers that overflow, in turn even, 1/2 | odd, 1/2; with lists all alphas of the frame
//         A list has 2^n lines, the largest power of two of which the half has one for each window, and ListGap lines
//         stand empty behind it: lists a power of two apart would all begin in the same bank of a DRAM.
// Units   Lines of external memory.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

enum class Area { kKeys, kMerged, kRuns, kRecords, kEven, kOdd, kLists };
inline constexpr Area kAllAreas[] = {Area::kKeys, Area::kMerged, Area::kRuns, Area::kRecords,
                                     Area::kEven, Area::kOdd,    Area::kLists};

// An area has size >> lines_shift lines and begins times * (size >> place_shift) lines behind the first one of its
// unit's share.
struct AreaPlan {
  int lines_shift = 0, times = 0, place_shift = 0;
};

// Lines of alphas go to external memory.
inline bool has_alpha_areas(const Config& c) { return c.caches_alphas() && c.spills_alphas(); }
// The share of a unit is size >> this.
inline int area_share_shift(const Config& c) { return clog2(c.units) + c.has_lists(); }

inline AreaPlan area_plan(const Config& c, Area area) {
  const int share = area_share_shift(c), sort = share + has_alpha_areas(c);
  switch (area) {
    case Area::kKeys: return {sort + 3, 0, 0};
    case Area::kMerged: return {sort + 3, 1, sort + 3};
    case Area::kRuns: return {sort + 2, 1, sort + 2};
    case Area::kRecords: return {sort + 1, 2, sort + 2};
    case Area::kEven: return {share + (c.has_lists() ? 1 : 2), 2, share + 2};
    case Area::kOdd: return {share + 2, 3, share + 2};
    default: return {1, 0, 0};
  }
}

// As the functions of the package.
inline uint64_t area_lines(const Config& c, uint64_t size, Area area) { return size >> area_plan(c, area).lines_shift; }
inline uint64_t area_place(const Config& c, uint64_t size, Area area) {
  const AreaPlan plan = area_plan(c, area);
  return static_cast<uint64_t>(plan.times) * (size >> plan.place_shift);
}
inline uint64_t area_first(const Config& c, uint64_t size, uint64_t unit, Area area) {
  if (area == Area::kLists) return 0;
  return (c.has_lists() ? size >> 1 : 0) + unit * (size >> area_share_shift(c)) + area_place(c, size, area);
}

// The first line of a window's list, from the first one of all on, where each has 2^log lines.
inline uint64_t list_first(uint64_t window, int log) {
  return (window << log) + window * static_cast<uint64_t>(Config::list_gap());
}
// There is a line for each window.
inline bool lists_fit(uint64_t lines, uint64_t windows) { return list_first(windows, 0) <= lines; }
// The lines of each list are 2^this, where `lines` are those of all lists.
inline int list_log(const Config& c, uint64_t lines, uint64_t windows) {
  int log = 0;
  while (log < c.list_entry_w() && list_first(windows, log + 1) <= lines) ++log;
  return log;
}

}  // namespace pipegs
