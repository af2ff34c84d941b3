// SPDX-License-Identifier: Apache-2.0
// ru_order.hpp: from the SUs to the RUs in the timing model: the merge and the dispatch.
//
// RTL     rtl/su/sort/su_merge.sv, rtl/ru/ru_dispatch.sv.
#pragma once

#include "sim/timing/cycle.hpp"
#include "sim/timing/ru/ru.hpp"

namespace pipegs::timing {

struct Machine;

class Merge {
 public:
  void step(Machine& m, Cycle now);
  Output<Splat> out;
};

class Dispatch {
 public:
  void step(Machine& m, Cycle now);

 private:
  uint32_t waiting_ = 0;  // RUs that have not taken the splat yet
  Splat splat_;
};

}  // namespace pipegs::timing
