// SPDX-License-Identifier: Apache-2.0
// package.cpp: the registers in the SystemVerilog package: offsets, a struct for each register, tables of the slots.
//
// Yosys reads a table only as one flat vector (docs/decisions.md): entry i is a fixed number of bits,
// entry 0 lowest.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

struct Entry {
  std::string bits, name;
};

// A table of `entry_width` bits an entry, the last entry first as a concatenation has it.
std::string table(const std::string& name, int entry_width, const std::vector<Entry>& entries) {
  std::string text =
      fmt::format("  localparam int unsigned {0}s = {1};\n  localparam logic [{0}s*{2}-1:0] {0}Table = {{\n", name,
                  entries.size(), entry_width);
  for (size_t i = entries.size(); i-- > 0;) {
    text += fmt::format("    {}'h{}{}  // {}\n", entry_width, entries[i].bits, i > 0 ? "," : "", entries[i].name);
  }
  return text + "  };\n";
}

std::string bits_of(int width) { return width == 1 ? "logic" : fmt::format("logic [{}:0]", width - 1); }

// The fields from the highest bit down, with what lies between them.
std::string register_struct(const Register& reg) {
  std::string text = fmt::format("  typedef struct packed {{  // {}\n", reg.what), lower;
  std::vector<std::string> lines;
  int bit = 0, gaps = 0;
  for (const RegisterField& field : reg.fields) {
    if (field.low > bit) lines.push_back(fmt::format("    {} gap_{};\n", bits_of(field.low - bit), gaps++));
    lines.push_back(fmt::format("    {} {};\n", bits_of(field.width), field.name));
    bit = field.low + field.width;
  }
  if (bit < 32) lines.push_back(fmt::format("    {} gap_{};\n", bits_of(32 - bit), gaps));
  for (size_t i = lines.size(); i-- > 0;) text += lines[i];
  for (const char c : reg.name) lower += static_cast<char>(std::tolower(c));
  return text + fmt::format("  }} control_{}_t;\n", lower);
}

// A record of the slots of a block, the first one lowest.
std::string block_struct(const SlotBlock& block) {
  std::string text = fmt::format("  typedef struct packed {{  // {}\n", block.what);
  int bits = 0;
  for (size_t i = block.slots.size(); i-- > 0;) {
    const Slot& slot = block.slots[i];
    text += fmt::format("    {} {};\n", bits_of(slot.width), slot.name);
    bits += slot.width;
  }
  std::string camel = block.name;
  camel[0] = static_cast<char>(std::toupper(camel[0]));
  return text + fmt::format("  }} {}_t;\n  localparam int unsigned {}Bits = {};\n", block.name, camel, bits);
}

}  // namespace

std::string print_package(const RegisterMap& map) {
  std::string text = fmt::format(
      "\n  // Registers of the control side, see package/pipegs_registers.csv: byte offsets.\n"
      "  localparam int unsigned ControlAddressW = {};\n",
      map.address_bits);
  std::vector<Entry> constants, slots, counters;
  for (const Register& reg : map.registers) {
    if (!reg.constant()) {
      text += fmt::format("  localparam logic [ControlAddressW-1:0] Control{}At = {}'h{:03x};\n", reg.camel_name,
                          map.address_bits, reg.offset);
    }
    uint32_t value = 0;
    for (const RegisterField& field : reg.fields) value |= field.value << field.low;
    if (!reg.constant() && value != 0) {
      text += fmt::format("  localparam logic [31:0] Control{}Reset = 32'h{:08x};\n", reg.camel_name, value);
    }
    if (!reg.constant()) continue;
    constants.push_back({fmt::format("{:04x}_{:08x}", reg.offset, value), reg.name});
  }
  text += "\n";
  for (const Register& reg : map.registers) {
    if (!reg.constant()) text += register_struct(reg);
  }
  text += "\n  // Registers that the configuration fixes: {offset of 16 bits, value of 32}.\n" +
          table("ControlConstant", 48, constants) + "\n" + block_struct(map.block("picture"));
  int at = 0;
  for (const Slot& slot : map.shadow()) {
    slots.push_back({fmt::format("{:04x}_{:04x}_{:02x}_{:02x}_{:02x}", slot.offset, at, slot.width, slot.shift,
                                 slot.is_signed ? 1 : 0),
                     slot.name});
    at += slot.width;
  }
  text += fmt::format(
      "\n  // What a start queues: frame_t, areas_t and picture_t in this order, the first one lowest. A slot is "
      "{{byte\n"
      "  // offset of its low word (16 bits), lowest bit of its value in what is queued (16), width of the value (8),\n"
      "  // bit of the slot at which it begins (8), 1 if it is signed (8)}}.\n"
      "  localparam int unsigned ControlShadowBits = {};\n",
      at);
  text += table("ControlSlot", 56, slots);
  const SlotBlock& block = map.block("counters");
  for (const Slot& slot : block.slots) {
    if (slot.width > 0) counters.push_back({fmt::format("{:04x}", slot.offset), slot.name});
  }
  text += fmt::format(
      "\n  // Performance counters: the byte offset of each that this machine has (16 bits), in their order; those of "
      "the\n"
      "  // largest machine lie from begin to end.\n"
      "  localparam logic [ControlAddressW-1:0] ControlCountersBegin = {0}'h{1:03x};\n"
      "  localparam logic [ControlAddressW-1:0] ControlCountersEnd = {0}'h{2:03x};\n",
      map.address_bits, block.offset, block.slots.back().offset + 8);
  return text + table("ControlCounter", 16, counters);
}

}  // namespace pipegs
