// SPDX-License-Identifier: Apache-2.0
// dram_lanes.cpp: see dram_lanes.hpp.
#include "sim/memory/dram/dram_lanes.hpp"

#include <algorithm>

#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define PIPEGS_LANES [[gnu::target_clones("avx2", "default")]]
#else
#define PIPEGS_LANES
#endif

namespace pipegs {

PIPEGS_LANES int32_t oldest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, bool no_activates,
                                  int32_t now, int lanes) {
  const int32_t none_begins = no_activates ? kDramNone : 0;
  int32_t oldest = kDramNone;
  for (int block = 0; block < lanes; block += kDramBlock) {
    const int32_t *column = times.column[write].data() + block, *activate = times.activate.data() + block,
                  *precharge = times.precharge.data() + block, *no_activate = times.no_activate.data() + block,
                  *no_precharge = times.no_precharge.data() + block, *hits = waiting.hit_age.data() + block,
                  *misses = waiting.miss_age.data() + block;
    for (int i = 0; i < kDramBlock; ++i) {
      const int32_t miss_at = std::min(activate[i] | no_activate[i] | none_begins, precharge[i] | no_precharge[i]);
      const int32_t hit = hits[i] | (column[i] > now ? kDramNone : 0);
      const int32_t miss = misses[i] | (miss_at > now ? kDramNone : 0);
      oldest = std::min(oldest, std::min(hit, miss));
    }
  }
  return oldest;
}

PIPEGS_LANES int32_t earliest_ready(const DramWaiting& waiting, const DramNotBefore& times, bool write, int lanes) {
  int32_t earliest = kDramNone;
  for (int block = 0; block < lanes; block += kDramBlock) {
    const int32_t *column = times.column[write].data() + block, *activate = times.activate.data() + block,
                  *precharge = times.precharge.data() + block, *no_activate = times.no_activate.data() + block,
                  *no_precharge = times.no_precharge.data() + block, *hits = waiting.hit_age.data() + block,
                  *misses = waiting.miss_age.data() + block;
    for (int i = 0; i < kDramBlock; ++i) {
      const int32_t miss_at = std::min(activate[i] | no_activate[i], precharge[i] | no_precharge[i]);
      const int32_t hit = column[i] | (hits[i] == kDramNone ? kDramNone : 0);
      const int32_t miss = miss_at | (misses[i] == kDramNone ? kDramNone : 0);
      earliest = std::min(earliest, std::min(hit, miss));
    }
  }
  return earliest;
}

PIPEGS_LANES void raise_lanes(DramLanes& times, const DramLanes& after, int32_t now, int lanes) {
  for (int block = 0; block < lanes; block += kDramBlock) {
    int32_t* __restrict at = times.data() + block;
    const int32_t* __restrict distance = after.data() + block;
    for (int i = 0; i < kDramBlock; ++i) at[i] = std::max(at[i], now + distance[i]);
  }
}

PIPEGS_LANES void raise_lanes(std::array<DramLanes, 2>& times, const std::array<DramLanes, 2>& after, int32_t now,
                              int lanes) {
  for (int block = 0; block < lanes; block += kDramBlock) {
    int32_t* __restrict at0 = times[0].data() + block, * __restrict at1 = times[1].data() + block;
    const int32_t* __restrict distance0 = after[0].data() + block, * __restrict distance1 = after[1].data() + block;
    for (int i = 0; i < kDramBlock; ++i) at0[i] = std::max(at0[i], now + distance0[i]);
    for (int i = 0; i < kDramBlock; ++i) at1[i] = std::max(at1[i], now + distance1[i]);
  }
}

}  // namespace pipegs
