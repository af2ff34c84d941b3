// SPDX-License-Identifier: Apache-2.0
// axi_pins.hpp: the port m_axi of a Verilated module as what AXI4 shows in a cycle (axi_signals.hpp).
//
// RTL     axi_manager_t and axi_subordinate_t of rtl/pipegs_pkg.sv: their last field lies in the low bits.
#pragma once

#include "cpp_model/config.hpp"
#include "sim/memory/axi/axi_signals.hpp"
#include "sim/rtl/pins/ports.hpp"

namespace pipegs {

// Bits of data, and of an ID: the core's tag and epoch.
struct AxiWidths {
  explicit AxiWidths(const Config& config) : data(config.bus_w), id(config.tag_w() + 1) {}
  int data, id;
};

// What the manager shows, after the module has settled. Data of W is read where it is valid.
template <class Port>
AxiManagerSide axi_manager_side(const Port& port, const AxiWidths& widths) {
  PortReader bits(port);
  const auto read_address = [&] {  // a channel and its valid
    AxiAddress address;
    address.valid = bits.next(1) != 0;
    bits.skip(3 + 4);  // prot, cache
    address.burst = static_cast<int>(bits.next(2));
    address.size = static_cast<int>(bits.next(3));
    address.length = static_cast<int>(bits.next(8));
    address.address = bits.next(64);
    address.id = static_cast<uint32_t>(bits.next(widths.id));
    return address;
  };
  AxiManagerSide side;
  side.r_ready = bits.next(1) != 0;
  side.ar = read_address();
  side.b_ready = bits.next(1) != 0;
  side.w.valid = bits.next(1) != 0;
  side.w.last = bits.next(1) != 0;
  side.w.strobes = bits.next(widths.data / 8);
  if (side.w.valid) {
    for (int i = 0; i < widths.data / 32; ++i)
      side.w.data[static_cast<size_t>(i)] = static_cast<uint32_t>(bits.next(32));
  } else {
    bits.skip(widths.data);
  }
  side.aw = read_address();
  return side;
}

// What the subordinate shows, before the module settles. `noise` stands beside a valid that is low.
template <class Port>
void write_subordinate_side(Port& port, const AxiWidths& widths, const AxiSubordinateSide& side,
                            const AxiSubordinateSide* noise = nullptr) {
  PortWriter bits(port);
  const auto& r = side.r.valid || noise == nullptr ? side.r : noise->r;
  const auto& b = side.b.valid || noise == nullptr ? side.b : noise->b;
  bits.next(1, side.r.valid);
  bits.next(1, r.last);
  bits.next(2, static_cast<uint64_t>(r.response));
  if (side.r.valid || noise != nullptr) {
    for (int i = 0; i < widths.data / 32; ++i) bits.next(32, r.data[static_cast<size_t>(i)]);
  } else {
    bits.skip(widths.data);
  }
  bits.next(widths.id, r.id);
  bits.next(1, side.ar_ready);
  bits.next(1, side.b.valid);
  bits.next(2, static_cast<uint64_t>(b.response));
  bits.next(widths.id, b.id);
  bits.next(1, side.w_ready);
  bits.next(1, side.aw_ready);
}

}  // namespace pipegs
