// SPDX-License-Identifier: Apache-2.0
// csv.cpp: the map of the registers as one table: a row for each register, each field of one, and each slot.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

const char* text_of(Access access) {
  switch (access) {
    case Access::Constant: return "constant";
    case Access::Read: return "read";
    case Access::ReadWrite: return "read and write";
    case Access::Clear: return "1 clears";
    case Access::Pulse: return "1 acts";
  }
  return "";
}

std::string bits_of(int low, int width) {
  return width == 1 ? std::to_string(low) : fmt::format("{}:{}", low + width - 1, low);
}

// "28 (focal_w)" bits of its slot in the default machine: what the value takes, and which entry decides it.
std::string width_of(const Slot& slot) {
  const std::string bits = slot.width == 0 ? "absent" : bits_of(slot.shift, slot.width);
  return slot.width_name.empty() ? bits : fmt::format("{} ({})", bits, slot.width_name);
}

std::string row(int offset, const std::string& name, const std::string& bits, const std::string& access,
                const std::string& reset, const std::string& unit, const std::string& what) {
  return fmt::format("{:03x},{},{},{},{},{},\"{}\"\n", offset, name, bits, access, reset, unit, what);
}

}  // namespace

std::string print_csv(const RegisterMap& map) {
  std::string text = "offset,name,bits,access,reset,unit,what\n";
  for (const Register& reg : map.registers) {
    text += row(reg.offset, reg.name, "31:0", "", "", "", reg.what);
    for (const RegisterField& field : reg.fields) {
      const std::string value = only_in_package(reg.name) ? ""
                                : field.value > 0xffff    ? fmt::format("0x{:08x}", field.value)
                                                          : std::to_string(field.value);
      text += row(reg.offset, reg.name + "." + field.name, bits_of(field.low, field.width), text_of(field.access),
                  value, field.unit, field.what);
    }
  }
  for (const SlotBlock& block : map.blocks) {
    for (const Slot& slot : block.slots) {
      const std::string access = slot.writable ? "read and write" : "read";
      text += row(slot.offset, block.name + "." + slot.name, width_of(slot), access, "0",
                  slot.is_signed ? slot.unit + " (signed)" : slot.unit, slot.what);
    }
  }
  return text;
}

}  // namespace pipegs
