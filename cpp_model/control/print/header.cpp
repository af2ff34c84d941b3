// SPDX-License-Identifier: Apache-2.0
// header.cpp: the registers for a driver in C99: offsets, masks, and a struct for each part of what a start queues.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

std::string upper(std::string name) {
  for (char& c : name) c = c == '.' ? '_' : static_cast<char>(std::toupper(c));
  return name;
}

// With what it is behind it, or above it where the line has no room.
std::string line(const std::string& text, const std::string& what) {
  constexpr size_t kColumns = 120;
  if (what.empty()) return text + "\n";
  if (text.size() + what.size() + 7 <= kColumns) return fmt::format("{} /* {} */\n", text, what);
  return fmt::format("{:{}}/* {} */\n{}\n", "", text.find_first_not_of(' '), what, text);
}

std::string block_struct(const SlotBlock& block) {
  std::string text =
      fmt::format("\n/* {}, in the order of its slots. */\nstruct pipegs_{} {{\n", block.what, block.name);
  for (const Slot& slot : block.slots) {
    std::string name = slot.name;
    for (char& c : name) c = c == '.' ? '_' : c;
    text += line(fmt::format("  {} {};", slot.is_signed ? "int64_t" : "uint64_t", name), slot.what);
  }
  return text + "};\n";
}

// Each cause of an error with its sentence.
std::string causes(const RegisterMap& map) {
  std::string text = "\n/* CAUSE(NAME, bit, what) for each bit of PIPEGS_ERROR. */\n#define PIPEGS_ERROR_CAUSES(CAUSE)";
  for (const Register& reg : map.registers) {
    if (reg.name != "ERROR") continue;
    for (const RegisterField& field : reg.fields) {
      text += fmt::format(" \\\n  CAUSE({}, {}, \"{}\")", upper(field.name), field.low, field.what);
    }
  }
  return text + "\n";
}

// The machine as it was built, in the order of the registers: a struct, and for each field where it is read.
std::string configuration(const RegisterMap& map) {
  std::string fields =
      "\n/* The machine as it was built: what the registers CONFIG_... say. */\n"
      "struct pipegs_configuration {\n";
  std::string places =
      "\n/* FIELD(name, offset, lowest bit, width) for each field of struct pipegs_configuration. */\n"
      "#define PIPEGS_CONFIGURATION(FIELD)";
  for (const Register& reg : map.registers) {
    if (reg.name.rfind("CONFIG_", 0) != 0) continue;
    for (const RegisterField& field : reg.fields) {
      const std::string name = reg.name == "CONFIG_HASH" ? "config_hash" : field.name;
      fields += line(fmt::format("  uint32_t {};", name), field.what);
      places += fmt::format(" \\\n  FIELD({}, PIPEGS_{}, {}, {})", name, reg.name, field.low, field.width);
    }
  }
  return fields + "};\n" + places + "\n";
}

}  // namespace

std::string print_header(const RegisterMap& map) {
  std::string text =
      "/* SPDX-License-Identifier: Apache-2.0\n"
      " * pipegs_registers.h: the registers of PipeGS for a driver in C99. Printed by cpp_model/control/print from\n"
      " * registers.def and records.def (`make package`): change those, never this file.\n"
      " *\n"
      " * An offset is in bytes; a register has 32 bits. A slot is a value of 64 bits at its offset, low word first; "
      "a\n"
      " * signed one reads with its sign. Addresses and sizes are in bytes, multiples of a line of memory.\n"
      " * PIPEGS_LAYOUT must read PIPEGS_LAYOUT_VALUE, else this header is not that of the machine. */\n"
      "#ifndef PIPEGS_REGISTERS_H\n#define PIPEGS_REGISTERS_H\n\n#include <stdint.h>\n";
  for (const Register& reg : map.registers) {
    text += "\n" + line(fmt::format("#define PIPEGS_{} 0x{:03x}u", reg.name, reg.offset), reg.what);
    uint32_t value = 0;
    for (const RegisterField& field : reg.fields) {
      const std::string name = "PIPEGS_" + reg.name + "_" + upper(field.name);
      const uint32_t mask = static_cast<uint32_t>(((uint64_t{1} << field.width) - 1) << field.low);
      value |= field.value << field.low;
      text += line(fmt::format("#define {} 0x{:08x}u", name, mask), field.what);
      if (field.low > 0) text += fmt::format("#define {}_SHIFT {}\n", name, field.low);
    }
    // The values that no configuration changes.
    if (reg.name == "ID" || reg.name == "VERSION" || reg.name == "LAYOUT") {
      text += fmt::format("#define PIPEGS_{}_VALUE 0x{:08x}u\n", reg.name, value);
    }
  }
  for (const SlotBlock& block : map.blocks) {
    const std::string name = "PIPEGS_" + upper(block.name);
    text += "\n" + line(fmt::format("#define {} 0x{:03x}u", name, block.offset), block.what);
    text += fmt::format("#define {}_SLOTS {}\n", name, block.slots.size());
    for (const Slot& slot : block.slots) {
      text += fmt::format("#define {}_{} 0x{:03x}u\n", name, upper(slot.name), slot.offset);
    }
  }
  for (const SlotBlock& block : map.blocks) text += block_struct(block);
  return text + causes(map) + configuration(map) + "\n#endif\n";
}

}  // namespace pipegs
