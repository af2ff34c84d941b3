// SPDX-License-Identifier: Apache-2.0
// su_external.hpp: what the merge sort of a set that does not fit a Sorting Unit moves to external memory and back.
//
// Idea    A record goes there and back once, whatever its key. The keys go there in a list, are read back and sorted as
//         many at a time as fit the pool, and are written as runs. A merge before the last one reads and writes no more
//         of them than bring the number of runs to the ways of the last one. So the lines depend on the number of
//         records alone.
// RTL     rtl/su/sort/su_external.sv
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct SuTraffic {
  uint64_t written = 0, read = 0;  // lines of external memory
  int levels = 0;                  // times that a key is merged, at most
};

// Lines of so many keys that are one run.
inline uint64_t su_run_lines(const Config& config, uint64_t keys) {
  const auto in_line = static_cast<uint64_t>(config.su_run_keys());
  return (keys + in_line - 1) / in_line;
}

// Of a set of so many records, at least one.
inline SuTraffic su_external_traffic(const Config& config, uint64_t records) {
  const auto ways = static_cast<size_t>(config.su_ways()), pool = static_cast<size_t>(config.records / 8 * 8);
  const uint64_t list = (records + 7) / 8;
  SuTraffic traffic{records + list, records + list, 0};
  std::vector<uint64_t> runs;  // keys of each
  for (uint64_t left = records; left > 0; left -= runs.back()) {
    runs.push_back(std::min<uint64_t>(left, pool));
    traffic.written += su_run_lines(config, runs.back());
  }
  for (traffic.levels = 1;; ++traffic.levels) {
    std::vector<uint64_t> merged;
    const auto read = [&](size_t first, size_t count) {
      for (size_t i = first; i < first + count; ++i) traffic.read += su_run_lines(config, runs[i]);
    };
    for (size_t next = 0, count = 0; next < runs.size(); next += count) {
      const size_t left = runs.size() - next, all = left + merged.size();
      if (all <= ways) {  // the last merge takes the runs of both levels
        read(next, left);
        for (const uint64_t keys : merged) traffic.read += su_run_lines(config, keys);
        traffic.levels += merged.empty() ? 0 : 1;
        return traffic;
      }
      count = std::min({left, ways, all - (ways - 1)});
      read(next, count);
      const auto first = runs.begin() + static_cast<std::ptrdiff_t>(next);
      merged.push_back(std::accumulate(first, first + static_cast<std::ptrdiff_t>(count), uint64_t{0}));
      traffic.written += su_run_lines(config, merged.back());
    }
    runs = std::move(merged);
  }
}

}  // namespace pipegs
