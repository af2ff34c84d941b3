// SPDX-License-Identifier: Apache-2.0
// axi_port.hpp: an AxiMemory at the port m_axi of a module.
#pragma once

#include "sim/memory/axi/axi_memory.hpp"
#include "sim/rtl/pins/axi_pins.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {

// In each cycle the memory says what it shows before the module settles, and sees what the module shows after.
template <class Dut>
class AxiPort : public Endpoint {
 public:
  AxiPort(Bench<Dut>& bench, AxiMemory& memory) : bench_(bench), memory_(memory) {
    write_side({});
    bench.add(*this);
  }
  void drive() override { write_side(memory_.step()); }
  void observe() override { memory_.observe(axi_manager_side(bench_.dut.m_axi_o, widths_)); }
  const AxiSubordinateSide& shown() const { return shown_; }  // by the memory in this cycle

 private:
  void write_side(const AxiSubordinateSide& side) {
    shown_ = side;
    // What stands beside a low valid is noise.
    AxiSubordinateSide noise;
    for (uint32_t& word : noise.r.data) word = static_cast<uint32_t>(bench_.rng());
    noise.r.id = noise.b.id = static_cast<uint32_t>(bench_.rng() >> (64 - widths_.id));
    noise.r.last = bench_.rng() & 1;
    noise.r.response = noise.b.response = static_cast<AxiResponse>(bench_.rng() & 3);
    write_subordinate_side(bench_.dut.m_axi_i, widths_, side, &noise);
  }

  const AxiWidths widths_{test_config()};
  Bench<Dut>& bench_;
  AxiMemory& memory_;
  AxiSubordinateSide shown_;
};

}  // namespace pipegs
