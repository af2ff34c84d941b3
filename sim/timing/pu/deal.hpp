// SPDX-License-Identifier: Apache-2.0
// deal.hpp: survivors of all culls to the PUs, in the timing model.
//
// RTL     rtl/pu/pu_deal.sv
#pragma once

#include <optional>

#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

class Deal {
 public:
  void step(Machine& m, Cycle now);

 private:
  uint32_t waiting_ = 0;  // PUs that have still to take the record
  Beat beat_ = 0;
  Arbiter source_;
  int target_last_ = 0;
  std::optional<uint32_t> slot_;  // of the Gaussian dealt last in this layer (two eyes)
};

}  // namespace pipegs::timing
