// SPDX-License-Identifier: Apache-2.0
// gated_bench.hpp: a Bench whose module gets a clock edge only in cycles in which it says `active_o`, as in the top.
//
// A unit that forgets a reason to be active stands still here and its test ends with "nothing more came".
#pragma once

#include "verif/support/bench.hpp"

namespace pipegs {

template <class Dut>
class GatedBench : public Bench<Dut> {
 public:
  using Bench<Dut>::Bench;

  void gated_step() {
    Dut& dut = this->dut;
    dut.clk_i = 0;
    for (Endpoint* endpoint : this->endpoints_) endpoint->drive();
    dut.eval();
    for (Endpoint* endpoint : this->endpoints_) endpoint->observe();
    ++this->cycle;
    if (!dut.active_o) {
      ++gated;
      return;
    }
    dut.clk_i = 1;
    dut.eval();
  }
  bool run_gated_until(const std::function<bool()>& done, uint64_t limit = 100000) {
    for (const uint64_t end = this->cycle + limit; this->cycle < end;) {
      if (done()) return true;
      gated_step();
    }
    ADD_FAILURE() << "nothing more came within " << limit << " cycles (cycle " << this->cycle << ", seed " << this->seed
                  << ")";
    return false;
  }

  uint64_t gated = 0;  // cycles without a clock
};

}  // namespace pipegs
