// SPDX-License-Identifier: Apache-2.0
// axi_port.hpp: an AxiMemory at the m_axi pins of a module.
#pragma once

#include "sim/memory/axi_memory.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {

template <class Dut>
AxiManagerSide axi_manager_side(const Dut& dut) {
  AxiManagerSide side;
  side.ar = {dut.m_axi_arvalid != 0, dut.m_axi_arid,   dut.m_axi_araddr,
             dut.m_axi_arlen,        dut.m_axi_arsize, dut.m_axi_arburst};
  side.aw = {dut.m_axi_awvalid != 0, dut.m_axi_awid,   dut.m_axi_awaddr,
             dut.m_axi_awlen,        dut.m_axi_awsize, dut.m_axi_awburst};
  side.w.valid = dut.m_axi_wvalid;
  side.w.last = dut.m_axi_wlast;
  side.w.strobes = dut.m_axi_wstrb;
  read_port(dut.m_axi_wdata, side.w.data.data());
  side.r_ready = dut.m_axi_rready;
  side.b_ready = dut.m_axi_bready;
  return side;
}

// In each cycle the memory says what it shows before the module settles, and sees what the module shows after.
template <class Dut>
class AxiPort : public Endpoint {
 public:
  AxiPort(Bench<Dut>& bench, AxiMemory& memory) : bench_(bench), memory_(memory) {
    write_side({});
    bench.add(*this);
  }
  void drive() override { write_side(memory_.step()); }
  void observe() override { memory_.observe(axi_manager_side(bench_.dut)); }
  const AxiSubordinateSide& shown() const { return shown_; }  // by the memory in this cycle

 private:
  void write_side(const AxiSubordinateSide& side) {
    Dut& dut = bench_.dut;
    shown_ = side;
    dut.m_axi_arready = side.ar_ready;
    dut.m_axi_awready = side.aw_ready;
    dut.m_axi_wready = side.w_ready;
    dut.m_axi_rvalid = side.r.valid;
    dut.m_axi_bvalid = side.b.valid;
    // What stands beside a low valid is noise.
    AxiSubordinateSide noise;
    for (uint32_t& word : noise.r.data) word = static_cast<uint32_t>(bench_.rng());
    noise.r.id = noise.b.id = static_cast<uint32_t>(bench_.rng() & 0x1ff);
    noise.r.last = bench_.rng() & 1;
    noise.r.response = noise.b.response = static_cast<AxiResponse>(bench_.rng() & 3);
    const auto& r = side.r.valid ? side.r : noise.r;
    const auto& b = side.b.valid ? side.b : noise.b;
    dut.m_axi_rid = static_cast<SData>(r.id);
    dut.m_axi_rresp = static_cast<CData>(r.response);
    dut.m_axi_rlast = r.last;
    write_port(dut.m_axi_rdata, r.data.data());
    dut.m_axi_bid = static_cast<SData>(b.id);
    dut.m_axi_bresp = static_cast<CData>(b.response);
  }

  Bench<Dut>& bench_;
  AxiMemory& memory_;
  AxiSubordinateSide shown_;
};

}  // namespace pipegs
