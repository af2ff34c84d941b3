// SPDX-License-Identifier: Apache-2.0
// ipxact.cpp: the registers as a memory map of an IP-XACT component, IEEE 1685-2014.
#include <fmt/format.h>

#include "cpp_model/control/print/print.hpp"

namespace pipegs {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

const char* access_of(Access access) {
  switch (access) {
    case Access::Constant:
    case Access::Read: return "read-only";
    case Access::ReadWrite:
    case Access::Clear: return "read-write";
    case Access::Pulse: return "write-only";
  }
  return "";
}

std::string element(int depth, const char* name, const std::string& text) {
  if (text.empty()) return "";
  return fmt::format("{:{}}<ipxact:{}>{}</ipxact:{}>\n", "", 2 * depth, name, escaped(text), name);
}

std::string field_text(const std::string& name, const RegisterField& field) {
  std::string text = "          <ipxact:field>\n" + element(6, "name", field.name) +
                     element(6, "description", field.unit.empty() ? field.what : field.unit + ": " + field.what) +
                     element(6, "bitOffset", std::to_string(field.low));
  if (!only_in_package(name))
    text += fmt::format(
        "            <ipxact:resets><ipxact:reset><ipxact:value>{}</ipxact:value></ipxact:reset></ipxact:resets>\n",
        field.value);
  text += element(6, "bitWidth", std::to_string(field.width));
  if (field.access == Access::Read || field.access == Access::Clear) text += element(6, "volatile", "true");
  text += element(6, "access", access_of(field.access));
  if (field.access == Access::Clear) text += element(6, "modifiedWriteValue", "oneToClear");
  return text + "          </ipxact:field>\n";
}

std::string reg(const std::string& name, int offset, const std::string& what,
                const std::vector<RegisterField>& fields) {
  std::string text = "        <ipxact:register>\n" + element(5, "name", name) + element(5, "description", what) +
                     element(5, "addressOffset", fmt::format("'h{:03x}", offset)) + element(5, "size", "32");
  for (const RegisterField& field : fields) text += field_text(name, field);
  return text + "        </ipxact:register>\n";
}

}  // namespace

std::string print_ipxact(const RegisterMap& map) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!-- SPDX-License-Identifier: Apache-2.0\n"
      "     The registers of PipeGS in its default configuration. Printed by cpp_model/control/print (`make "
      "package`):\n"
      "     change registers.def and records.def, never this file. -->\n"
      "<ipxact:component xmlns:ipxact=\"http://www.accellera.org/XMLSchema/IPXACT/1685-2014\">\n"
      "  <ipxact:vendor>pipegs</ipxact:vendor>\n"
      "  <ipxact:library>accelerator</ipxact:library>\n"
      "  <ipxact:name>pipegs_registers</ipxact:name>\n"
      "  <ipxact:version>1.0</ipxact:version>\n"
      "  <ipxact:memoryMaps>\n"
      "    <ipxact:memoryMap>\n"
      "      <ipxact:name>s_axi</ipxact:name>\n"
      "      <ipxact:addressBlock>\n"
      "        <ipxact:name>registers</ipxact:name>\n"
      "        <ipxact:baseAddress>'h0</ipxact:baseAddress>\n"
      "        <ipxact:range>{}</ipxact:range>\n"
      "        <ipxact:width>32</ipxact:width>\n"
      "        <ipxact:usage>register</ipxact:usage>\n",
      1 << map.address_bits);
  for (const Register& entry : map.registers) text += reg(entry.name, entry.offset, entry.what, entry.fields);
  for (const SlotBlock& block : map.blocks) {
    for (const Slot& slot : block.slots) {
      for (int word = 0; word < 2; ++word)
        text += reg(word_name(block, slot, word), slot.offset + 4 * word, slot.what, slot_fields(slot, word));
    }
  }
  return text +
         "      </ipxact:addressBlock>\n      <ipxact:addressUnitBits>8</ipxact:addressUnitBits>\n"
         "    </ipxact:memoryMap>\n  </ipxact:memoryMaps>\n</ipxact:component>\n";
}

}  // namespace pipegs
