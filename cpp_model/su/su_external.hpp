// SPDX-License-Identifier: Apache-2.0
// su_external.hpp: what the merge sort of a set that does not fit a Sorting Unit moves to external memory and back.
//
// Idea    A record goes there and back once, whatever its key. The keys go there in a list, are read back and sorted as
//         many at a time as fit the pool, and are written as runs; every level of the merge reads all keys once, and
//         all but the last one write them. So the lines depend on the number of records alone.
// RTL     rtl/su/sort/su_external.sv
#pragma once

#include <algorithm>
#include <cstdint>

#include "cpp_model/config.hpp"

namespace pipegs {

struct SuTraffic {
  uint64_t written = 0, read = 0;  // lines of external memory
  int levels = 0;                  // times that a key is merged
};

// Lines of a level's keys when every run but the last has `run` of them.
inline uint64_t su_run_lines(const Config& config, uint64_t keys, uint64_t run) {
  const auto in_line = static_cast<uint64_t>(config.su_run_keys());
  return keys / run * ((run + in_line - 1) / in_line) + (keys % run + in_line - 1) / in_line;
}

// Of a set of so many records, at least one.
inline SuTraffic su_external_traffic(const Config& config, uint64_t records) {
  const uint64_t list = (records + 7) / 8;
  SuTraffic traffic{records + list, records + list, 0};
  for (auto run = static_cast<uint64_t>(config.records / 8 * 8);; run *= static_cast<uint64_t>(config.su_ways())) {
    const uint64_t lines = su_run_lines(config, records, run);
    traffic.written += lines;
    traffic.read += lines;
    ++traffic.levels;
    if (records <= run * static_cast<uint64_t>(config.su_ways())) return traffic;
  }
}

}  // namespace pipegs
