// SPDX-License-Identifier: Apache-2.0
// axi_pins.hpp: the m_axi_* pins of a Verilated module as what AXI4 shows in a cycle (axi_signals.hpp).
#pragma once

#include "sim/memory/axi/axi_signals.hpp"
#include "sim/rtl/pins/ports.hpp"

namespace pipegs {

// What the manager shows, after the module has settled. Data of W is read where it is valid.
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
  if (side.w.valid) read_port(dut.m_axi_wdata, side.w.data.data());
  side.r_ready = dut.m_axi_rready;
  side.b_ready = dut.m_axi_bready;
  return side;
}

// What the subordinate shows, before the module settles. `noise` stands beside a valid that is low.
template <class Dut>
void write_subordinate_side(Dut& dut, const AxiSubordinateSide& side, const AxiSubordinateSide* noise = nullptr) {
  dut.m_axi_arready = side.ar_ready;
  dut.m_axi_awready = side.aw_ready;
  dut.m_axi_wready = side.w_ready;
  dut.m_axi_rvalid = side.r.valid;
  dut.m_axi_bvalid = side.b.valid;
  if (side.r.valid || noise != nullptr) {
    const auto& r = side.r.valid ? side.r : noise->r;
    dut.m_axi_rid = static_cast<SData>(r.id);
    dut.m_axi_rresp = static_cast<CData>(r.response);
    dut.m_axi_rlast = r.last;
    write_port(dut.m_axi_rdata, r.data.data());
  }
  if (side.b.valid || noise != nullptr) {
    const auto& b = side.b.valid ? side.b : noise->b;
    dut.m_axi_bid = static_cast<SData>(b.id);
    dut.m_axi_bresp = static_cast<CData>(b.response);
  }
}

}  // namespace pipegs
