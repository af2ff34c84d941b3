// SPDX-License-Identifier: Apache-2.0
// control_pins.hpp: the s_axi_* pins of the machine, from the side of software: one access to a register at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {

template <class Dut>
class ControlPins {
 public:
  void begin(bool write, uint32_t offset, uint32_t value) {
    write_ = write, offset_ = offset, value_ = value;
    address_up_ = true, data_up_ = write, open_ = true;
  }
  bool open() const { return open_; }  // the access is not answered yet
  uint32_t value() const { return value_; }

  void drive(Dut& dut) const {
    dut.s_axi_awvalid = write_ && address_up_;
    dut.s_axi_wvalid = data_up_;
    dut.s_axi_arvalid = !write_ && address_up_;
    dut.s_axi_awaddr = dut.s_axi_araddr = static_cast<SData>(offset_);
    dut.s_axi_awprot = dut.s_axi_arprot = 0;
    dut.s_axi_wdata = value_;
    dut.s_axi_wstrb = 0xf;
    dut.s_axi_bready = dut.s_axi_rready = 1;
  }
  void observe(const Dut& dut) {
    if (!open_) return;
    if (write_ ? dut.s_axi_awready : dut.s_axi_arready) address_up_ = false;
    if (dut.s_axi_wready) data_up_ = false;
    if (write_ ? !dut.s_axi_bvalid : !dut.s_axi_rvalid) return;
    open_ = false;
    if (!write_) value_ = dut.s_axi_rdata;
    if ((write_ ? dut.s_axi_bresp : dut.s_axi_rresp) != 0) throw RtlFault("RTL: a register refuses an access");
  }

 private:
  bool write_ = false, address_up_ = false, data_up_ = false, open_ = false;
  uint32_t offset_ = 0, value_ = 0;
};

}  // namespace pipegs
