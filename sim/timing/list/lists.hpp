// SPDX-License-Identifier: Apache-2.0
// lists.hpp: the lists of the windows in the timing model: written while the frame is preprocessed, then read window
// by window.
//
// RTL     rtl/list/pipegs_list_write.sv, pipegs_list_read.sv, pipegs_lists.sv.
// Idea    A record costs a line of memory on its way in and on its way out. What stands in a list is kept here.
#pragma once

#include <vector>

#include "cpp_model/config.hpp"
#include "sim/timing/line_reader.hpp"
#include "sim/timing/ru/ru.hpp"

namespace pipegs::timing {

struct Machine;

class Lists {
 public:
  explicit Lists(const Machine& machine);

  void step(Machine& m, Cycle now);

  // For the SUs: one record on the wires of all.
  const Splat& record() const { return out_; }
  bool shown(int lane) const { return (waiting_ >> lane & 1) != 0; }
  void taken(Machine& m, int lane);

 private:
  enum Read { kIdle, kCount, kLines, kEnd };
  struct Tag {
    size_t window = 0;
  };

  void write(Machine& m, Cycle now, bool granted);
  void read(Machine& m, Cycle now, bool granted, bool answered);

  const int units_, port_;
  const size_t windows_;
  const int log_;  // a list has 2^this lines
  bool moved_ = false;

  // pipegs_list_write
  std::vector<std::vector<Splat>> lists_;
  uint32_t ended_ = 0;
  Arbiter source_;
  bool held_valid_ = false, out_valid_ = false, written_ = false;
  Splat held_;

  // pipegs_list_read
  Read state_ = kIdle;
  size_t number_ = 0;
  LineReader<Tag, Config::list_jobs()> reader_;
  static constexpr Cycle kPatience = 7;  // of its sleep
  Cycle woken_ = kLongAgo;
  uint32_t waiting_ = 0, taken_ = 0;   // SUs that have still to take the record
  static constexpr Cycle kNobody = 3;  // cycles without a ready SU until the next one in turn gets the record
  Cycle none_from_ = kNever;
  Arbiter target_;
  Splat out_;
};

}  // namespace pipegs::timing
