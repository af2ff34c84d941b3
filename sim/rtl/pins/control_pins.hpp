// SPDX-License-Identifier: Apache-2.0
// control_pins.hpp: the registers of the machine, from the side of software: one access to a register at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/rtl/pins/axi_lite_pins.hpp"
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
    write_manager_side(dut.s_axi_i, {.aw_valid = write_ && address_up_,
                                     .w_valid = data_up_,
                                     .b_ready = true,
                                     .ar_valid = !write_ && address_up_,
                                     .r_ready = true,
                                     .aw_address = offset_,
                                     .ar_address = offset_,
                                     .w_data = value_,
                                     .w_strobe = 0xf});
  }
  void observe(const Dut& dut) {
    if (!open_) return;
    const AxiLiteSubordinateSide shown = axi_lite_subordinate_side(dut.s_axi_o);
    if (write_ ? shown.aw_ready : shown.ar_ready) address_up_ = false;
    if (shown.w_ready) data_up_ = false;
    if (write_ ? !shown.b_valid : !shown.r_valid) return;
    open_ = false;
    if (!write_) value_ = shown.r_data;
    if ((write_ ? shown.b_response : shown.r_response) != 0) throw RtlFault("RTL: a register refuses an access");
  }

 private:
  bool write_ = false, address_up_ = false, data_up_ = false, open_ = false;
  uint32_t offset_ = 0, value_ = 0;
};

}  // namespace pipegs
