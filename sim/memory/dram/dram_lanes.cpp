// SPDX-License-Identifier: Apache-2.0
// dram_lanes.cpp: see dram_lanes.hpp.
//
// Rule    Clang makes clones only of a function whose first declaration has the attribute. So what is cloned has
//         internal linkage, and what the header declares calls it.
#include "sim/memory/dram/dram_lanes.hpp"

#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PIPEGS_LANES __attribute__((target_clones("avx2", "default")))
#else
#define PIPEGS_LANES
#endif
#define PIPEGS_INLINED inline __attribute__((always_inline))

namespace pipegs {
namespace {

typedef int32_t Block __attribute__((vector_size(4 * kDramBlock), may_alias));

PIPEGS_INLINED const Block& block_of(const DramLanes& lanes, int from) {
  return *reinterpret_cast<const Block*>(lanes.data() + from);
}

// Blocks go by reference: passing them by value would depend on the processor's level.
PIPEGS_INLINED void lower(Block& lanes, const Block& to) { lanes = lanes < to ? lanes : to; }

PIPEGS_INLINED int32_t lowest(const Block& lanes) {
  int32_t least = kDramNone;
  for (int i = 0; i < kDramBlock; ++i) least = lanes[i] < least ? lanes[i] : least;
  return least;
}

PIPEGS_INLINED void raise_block(DramLanes& times, const DramLanes& after, int32_t now, int from) {
  Block& lanes = *reinterpret_cast<Block*>(times.data() + from);
  const Block to = block_of(after, from) + now;
  lanes = lanes > to ? lanes : to;
}

PIPEGS_LANES int32_t oldest(const DramWaiting& waiting, const DramNotBefore& times, const DramLanes& columns,
                            int32_t none_begins, int32_t now, int lanes) {
  Block found = Block{} + kDramNone;
  for (int from = 0; from < lanes; from += kDramBlock) {
    Block miss_at = block_of(times.activate, from) | block_of(times.no_activate, from) | none_begins;
    lower(miss_at, block_of(times.precharge, from) | block_of(times.no_precharge, from));
    lower(found, block_of(waiting.hit_age, from) | ((block_of(columns, from) > now) & kDramNone));
    lower(found, block_of(waiting.miss_age, from) | ((miss_at > now) & kDramNone));
  }
  return lowest(found);
}

PIPEGS_LANES int32_t earliest(const DramWaiting& waiting, const DramNotBefore& times, const DramLanes& columns,
                              int lanes) {
  Block found = Block{} + kDramNone;
  for (int from = 0; from < lanes; from += kDramBlock) {
    Block miss_at = block_of(times.activate, from) | block_of(times.no_activate, from);
    lower(miss_at, block_of(times.precharge, from) | block_of(times.no_precharge, from));
    lower(found, block_of(columns, from) | ((block_of(waiting.hit_age, from) == kDramNone) & kDramNone));
    lower(found, miss_at | ((block_of(waiting.miss_age, from) == kDramNone) & kDramNone));
  }
  return lowest(found);
}

PIPEGS_LANES void raise_one(DramLanes& times, const DramLanes& after, int32_t now, int lanes) {
  for (int from = 0; from < lanes; from += kDramBlock) raise_block(times, after, now, from);
}

PIPEGS_LANES void raise_two(std::array<DramLanes, 2>& times, const std::array<DramLanes, 2>& after, int32_t now,
                            int lanes) {
  for (int from = 0; from < lanes; from += kDramBlock) {
    raise_block(times[0], after[0], now, from);
    raise_block(times[1], after[1], now, from);
  }
}

}  // namespace

int32_t oldest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, bool no_activates, int32_t now,
                     int lanes) {
  return oldest(waiting, times, times.column[write], no_activates ? kDramNone : 0, now, lanes);
}

int32_t earliest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, int lanes) {
  return earliest(waiting, times, times.column[write], lanes);
}

void raise_lanes(DramLanes& times, const DramLanes& after, int32_t now, int lanes) {
  raise_one(times, after, now, lanes);
}

void raise_lanes(std::array<DramLanes, 2>& times, const std::array<DramLanes, 2>& after, int32_t now, int lanes) {
  raise_two(times, after, now, lanes);
}

}  // namespace pipegs
