// SPDX-License-Identifier: Apache-2.0
// page.cpp: the registers as tables of a page.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

const char* text_of(Access access) {
  switch (access) {
    case Access::Constant: return "constant";
    case Access::Read: return "read";
    case Access::ReadWrite: return "read, write";
    case Access::Clear: return "1 clears";
    case Access::Pulse: return "1 acts";
  }
  return "";
}

std::string bits_of(int low, int width) {
  return width == 1 ? std::to_string(low) : fmt::format("{}:{}", low + width - 1, low);
}

// "28 bits (`focal_w`)": what the value takes of its slot in the default machine.
std::string width_of(const Slot& slot) {
  std::string text = slot.width == 0 ? "absent" : fmt::format("{}", bits_of(slot.shift, slot.width));
  return slot.width_name.empty() ? text : text + fmt::format(" (`{}`)", slot.width_name);
}

}  // namespace

std::string print_page(const RegisterMap& map) {
  std::string text =
      "# Registers: the table\n\n"
      "Printed from `cpp_model/control/registers.def` and `records.def` by `make package`: change those, never this "
      "page. What the registers do and how they are programmed: [control](control.md). Offsets are bytes, hexadecimal; "
      "widths and constants are those of the default configuration, places those of every one.\n\n"
      "## Registers\n\n| offset | register | bits | field | access | value after reset | what |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Register& reg : map.registers) {
    text += fmt::format("| `{:03x}` | `{}` |  |  |  |  | {} |\n", reg.offset, reg.name, reg.what);
    for (const RegisterField& field : reg.fields) {
      const std::string value =
          field.value > 0xffff ? fmt::format("0x{:08x}", field.value) : std::to_string(field.value);
      text += fmt::format("|  |  | {} | `{}` | {} | {} | {}{}{} |\n", bits_of(field.low, field.width), field.name,
                          text_of(field.access), value, field.unit, field.unit.empty() ? "" : ": ", field.what);
    }
  }
  for (const SlotBlock& block : map.blocks) {
    std::string title = block.name;
    title[0] = static_cast<char>(std::toupper(title[0]));
    text += fmt::format("\n## {}\n\nAt {:03x}: {}. Slots of eight bytes, {}.\n\n", title, block.offset, block.what,
                        block.slots.front().writable ? "0 after reset, written while no frame is queued" : "read only");
    text += "| offset | value | bits of the slot | signed | what |\n|---|---|---|---|---|\n";
    for (const Slot& slot : block.slots) {
      text += fmt::format("| `{:03x}` | `{}` | {} | {} | {}{}{} |\n", slot.offset, slot.name, width_of(slot),
                          slot.is_signed ? "yes" : "", slot.unit, slot.unit.empty() || slot.what.empty() ? "" : ": ",
                          slot.what);
    }
  }
  return text;
}

}  // namespace pipegs
