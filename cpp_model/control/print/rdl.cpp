// SPDX-License-Identifier: Apache-2.0
// rdl.cpp: the registers in SystemRDL 2.0.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

const char* properties(Access access) {
  switch (access) {
    case Access::Constant: return "sw = r; hw = na;";
    case Access::Read: return "sw = r; hw = w;";
    case Access::ReadWrite: return "sw = rw; hw = r;";
    case Access::Clear: return "sw = rw; onwrite = woclr; hw = r; hwset;";
    case Access::Pulse: return "sw = w; singlepulse; hw = r;";
  }
  return "";
}

std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '"' ? std::string("\\\"") : std::string(1, c);
  return "\"" + result + "\"";
}

std::string reg(const std::string& name, int offset, const std::string& what,
                const std::vector<RegisterField>& fields) {
  std::string text = fmt::format("  reg {{\n    desc = {};\n", quoted(what));
  for (const RegisterField& field : fields) {
    const std::string reset = only_in_package(name) ? "" : fmt::format(" = {}'h{:x}", field.width, field.value);
    text += fmt::format("    field {{\n      desc = {};\n      {}\n    }} {}[{}:{}]{};\n",
                        quoted(field.unit.empty() ? field.what : field.unit + ": " + field.what),
                        properties(field.access), field.name, field.low + field.width - 1, field.low, reset);
  }
  return text + fmt::format("  }} {} @ 0x{:03x};\n", name, offset);
}

}  // namespace

std::string print_rdl(const RegisterMap& map) {
  std::string text =
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// The registers of PipeGS in its default configuration, SystemRDL 2.0. Printed by cpp_model/control/print\n"
      "// (`make package`): change registers.def and records.def, never this file.\n\n"
      "addrmap pipegs {\n  name = \"PipeGS\";\n  default regwidth = 32;\n  default accesswidth = 32;\n"
      "  littleendian;\n\n";
  for (const Register& entry : map.registers) text += reg(entry.name, entry.offset, entry.what, entry.fields);
  for (const SlotBlock& block : map.blocks) {
    text += fmt::format("\n  // {}\n", block.what);
    for (const Slot& slot : block.slots) {
      for (int word = 0; word < 2; ++word)
        text += reg(word_name(block, slot, word), slot.offset + 4 * word, slot.what, slot_fields(slot, word));
    }
  }
  return text + "};\n";
}

}  // namespace pipegs
