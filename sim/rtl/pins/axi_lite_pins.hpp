// SPDX-License-Identifier: Apache-2.0
// axi_lite_pins.hpp: the port s_axi of a Verilated module: what software's side asks, what the registers answer.
//
// RTL     axi_lite_manager_t and axi_lite_subordinate_t of rtl/pipegs_pkg.sv: their last field lies in the low bits.
#pragma once

#include "sim/rtl/pins/ports.hpp"

namespace pipegs {

inline constexpr int kControlAddressBits = 12;

struct AxiLiteManagerSide {
  bool aw_valid = false, w_valid = false, b_ready = false, ar_valid = false, r_ready = false;
  uint32_t aw_address = 0, ar_address = 0, w_data = 0, w_strobe = 0;
};
struct AxiLiteSubordinateSide {
  bool aw_ready, w_ready, b_valid, ar_ready, r_valid;
  uint32_t b_response, r_response, r_data;
};

template <class Port>
void write_manager_side(Port& port, const AxiLiteManagerSide& side) {
  PortWriter bits(port);
  bits.next(1, side.r_ready);
  bits.next(1, side.ar_valid);
  bits.next(kControlAddressBits, side.ar_address);
  bits.next(1, side.b_ready);
  bits.next(1, side.w_valid);
  bits.next(4, side.w_strobe);
  bits.next(32, side.w_data);
  bits.next(1, side.aw_valid);
  bits.next(kControlAddressBits, side.aw_address);
}

template <class Port>
AxiLiteSubordinateSide axi_lite_subordinate_side(const Port& port) {
  PortReader bits(port);
  const auto next = [&](int width) { return static_cast<uint32_t>(bits.next(width)); };
  AxiLiteSubordinateSide side;
  side.r_valid = next(1) != 0;
  side.r_response = next(2);
  side.r_data = next(32);
  side.ar_ready = next(1) != 0;
  side.b_valid = next(1) != 0;
  side.b_response = next(2);
  side.w_ready = next(1) != 0;
  side.aw_ready = next(1) != 0;
  return side;
}

}  // namespace pipegs
