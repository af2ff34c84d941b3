// SPDX-License-Identifier: Apache-2.0
// registers.hpp: the table of registers (registers.def) for one configuration, with a slot for each field of frame_t.
//
// Idea    A register is 32 bits at a fixed offset. A slot is a value of up to 64 bits in two registers, the low word
//         first; its place depends on the tables alone, its width on the configuration. A slot whose value does not
//         exist in this configuration reads 0.
// RTL     rtl/control/, by what print_package() of print/print.hpp writes into rtl/pipegs_pkg.sv
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

enum class Access { Constant, Read, ReadWrite, Clear, Pulse };

struct RegisterField {
  std::string name;
  int low, width;  // bits low to low + width - 1
  Access access;
  uint32_t value;  // after reset
  std::string unit, what;
};

struct Register {
  std::string name, camel_name;  // IRQ_STATUS, IrqStatus
  int offset;                    // byte
  std::string what;
  std::vector<RegisterField> fields;
  bool constant() const { return fields.front().access == Access::Constant; }
};

struct Slot {
  std::string name;        // camera.position.x
  int offset;              // byte, of its low word
  int width;               // bits of the value; 0: it does not exist
  int shift;               // bit of the slot at which it begins: 6 for an address, which is given in bytes
  bool is_signed;          // it reads with its sign in all bits above it
  std::string width_name;  // of config.def, where it has one
  std::string unit, what;
  bool writable = true;
};

struct SlotBlock {
  std::string name;
  int offset, bytes;
  std::string what;
  std::vector<Slot> slots;
};

struct RegisterMap {
  std::vector<Register> registers;
  std::vector<SlotBlock> blocks;  // frame, areas, picture, counters
  int address_bits;               // of a byte in the map
  const SlotBlock& block(std::string_view name) const;
  std::vector<Slot> shadow() const;  // the slots that a start queues: frame, areas, picture
};

inline constexpr int kUnitStates = 4;  // counters of a unit: busy, starved, blocked, memory

// Throws std::logic_error when the table contradicts itself: overlaps, fields beyond their register, a full block.
RegisterMap register_map(const Config& config);

}  // namespace pipegs
