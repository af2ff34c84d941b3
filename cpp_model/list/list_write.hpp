// SPDX-License-Identifier: Apache-2.0
// list_write: where the records of a frame lie in external memory: one list for each window.
//
// Paper   the reproduced GSCore of Sec. 5.        RTL  rtl/list/pipegs_list_write.sv, pipegs_list_read.sv
// Idea    Entry n of the list of window w is one line, at overflow + list_first(w, list_log) + n (areas.hpp).
// Rule    The order inside a list depends on timing and means nothing: a list is sorted before it is blended.
#pragma once

#include <vector>

#include "cpp_model/areas/areas.hpp"

namespace pipegs {

inline uint64_t list_line(const Config& config, const Span& overflow, uint64_t windows, uint64_t number,
                          uint64_t entry) {
  const uint64_t lines = area_lines(config, overflow.lines, Area::kLists);
  return overflow.first + list_first(number, list_log(config, lines, windows)) + entry;
}

struct ListWrite {
  ListWrite(const Config& config, const Span& overflow, uint64_t windows)
      : config(config), overflow(overflow), counts(windows) {}

  // The line of the next record of a window.
  uint64_t operator()(uint64_t number) {
    const uint64_t entry = counts.at(number)++;
    return list_line(config, overflow, counts.size(), number, entry);
  }

  Config config;
  Span overflow;
  std::vector<uint64_t> counts;  // entries of each list; a new frame starts with a new ListWrite
};

}  // namespace pipegs
