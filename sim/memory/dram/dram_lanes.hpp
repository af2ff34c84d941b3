// SPDX-License-Identifier: Apache-2.0
// dram_lanes.hpp: arrays with one lane for each bank of a channel, and the loops over them.
//
// Idea    Which burst is next and when, and how a command delays those of the other banks, are minima and maxima over
//         all banks. They are written on the compiler's vectors of 16 lanes; on x86 they are compiled twice, for AVX2
//         and for any processor, and chosen when the program is loaded.
// Pace    16 banks take about ten vector operations.
#pragma once

#include <array>
#include <cstdint>

namespace pipegs {

inline constexpr int kDramLanes = 64, kDramBlock = 16;  // most banks of a channel; lanes looked at together
inline constexpr int32_t kDramNone = INT32_MAX;         // no time, no burst

struct alignas(64) DramLanes : std::array<int32_t, kDramLanes> {};

// What each bank needs next in one direction (reads or writes).
struct DramWaiting {
  DramLanes hit_age, miss_age;  // of the oldest burst: of the open row, of another one; kDramNone if there is none
};

// The earliest cycle of each command. `no_...`: kDramNone if the state of the bank rules the command out, else 0.
struct DramNotBefore {
  std::array<DramLanes, 2> column;  // by direction
  DramLanes activate, precharge, no_activate, no_precharge;
};

// The lowest age among the bursts whose command is allowed at `now`, or kDramNone.
int32_t oldest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, bool no_activates, int32_t now,
                     int lanes);

// The earliest cycle in which a command of a waiting burst is allowed, or kDramNone.
int32_t earliest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, int lanes);

// times[i] is at least now + after[i].
void raise_lanes(DramLanes& times, const DramLanes& after, int32_t now, int lanes);

// The same for two arrays.
void raise_lanes(std::array<DramLanes, 2>& times, const std::array<DramLanes, 2>& after, int32_t now, int lanes);

}  // namespace pipegs
