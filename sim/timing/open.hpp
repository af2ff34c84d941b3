// SPDX-License-Identifier: Apache-2.0
// open.hpp: the rectangle around the regions that the RUs have not closed, in the timing model.
//
// RTL     rtl/pipegs_open.sv, rtl/lib/pipegs_closed.sv.
// Idea    What the RUs show in a cycle is known a cycle later; what was known before stays for that cycle.
#pragma once

#include <cstddef>

#include "cpp_model/open.hpp"
#include "sim/timing/cycle.hpp"

namespace pipegs::timing {

struct Machine;

class OpenRegister {
 public:
  void publish(Machine& m, Cycle now);  // behind the RUs'
  Closed closed(const Machine& m, size_t walk, Cycle now) const;

 private:
  struct Seen {
    bool known = false;
    size_t window = 0;
    RegionSet closed;
    bool operator==(const Seen&) const = default;
  };
  Seen seen_;
  Open latest_, before_;
  Cycle from_ = 0;
};

}  // namespace pipegs::timing
