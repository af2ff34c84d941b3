// SPDX-License-Identifier: Apache-2.0
// list_write: where the records of a frame lie in external memory: one list for each window.
//
// Paper   the reproduced GSCore of Sec. 5.        RTL  rtl/list/list_write.sv, list_read.sv
// Idea    Entry n of the list of window w is one line, at overflow + 2^ListAreaW + {w, n}.
// Rule    The order inside a list depends on timing and means nothing: a list is sorted before it is blended.
#pragma once

#include <vector>

#include "cpp_model/records.hpp"

namespace pipegs {

inline uint64_t list_line(const Config& config, const Frame& frame, uint64_t number, uint64_t entry) {
  return frame.tables.overflow + (uint64_t{1} << config.list_area_w()) + (number << config.list_entry_w()) + entry;
}

struct ListWrite {
  ListWrite(const Config& config, const Frame& frame)
      : config(config),
        frame(frame),
        counts((frame.raster.windows.last_x - frame.raster.windows.first_x + 1) *
               (frame.raster.windows.last_y - frame.raster.windows.first_y + 1)) {}

  // The line of the next record of a window.
  uint64_t operator()(uint64_t number) { return list_line(config, frame, number, counts.at(number)++); }

  Config config;
  Frame frame;
  std::vector<uint64_t> counts;  // entries of each list; a new frame starts with a new ListWrite
};

}  // namespace pipegs
