// SPDX-License-Identifier: Apache-2.0
// registers.cpp: see registers.hpp.
#include "cpp_model/control/registers.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "cpp_model/areas/areas.hpp"
#include "cpp_model/lib/record_table.hpp"

namespace pipegs {
namespace {

constexpr int kAddressBits = 12;

uint32_t fnv(std::string_view text, uint32_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}
constexpr uint32_t kFnvBegin = 2166136261u;

uint32_t config_hash(const Config& config) {
  uint32_t hash = kFnvBegin;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member != nullptr) {
      hash = fnv(std::string(entry.name) + "=" + std::to_string(entry.value) + ";", hash);
    }
  }
  return hash;
}

// Filled in when all names and offsets are known.
uint32_t layout_hash() { return 0; }
uint32_t layout_hash(const RegisterMap& map) {
  uint32_t hash = kFnvBegin;
  for (const Register& reg : map.registers) {
    hash = fnv(reg.name + "@" + std::to_string(reg.offset) + ";", hash);
    for (const RegisterField& field : reg.fields) {
      hash = fnv(field.name + "@" + std::to_string(field.low) + "+" + std::to_string(field.width) + ";", hash);
    }
  }
  for (const SlotBlock& block : map.blocks) {
    for (const Slot& slot : block.slots) {
      hash = fnv(block.name + "." + slot.name + "@" + std::to_string(slot.offset) + ";", hash);
    }
  }
  return hash;
}

const RecordEntry& record(std::string_view camel_name) {
  for (const RecordEntry& entry : record_table()) {
    if (camel_name == entry.camel_name) return entry;
  }
  throw std::logic_error("records.def has no " + std::string(camel_name));
}

// All fields of a record, those of the records in it in their place. One without a sentence has that of the field
// before it in the same record, or of the record that it lies in.
void add_fields(const Config& config, const RecordEntry& entry, const std::string& outer, const std::string& outer_what,
                std::vector<Slot>& slots) {
  std::string what = outer_what;
  for (const RecordField& field : entry.fields) {
    const std::string name = outer + field.name;
    if (*field.what != '\0') what = field.what;
    if (field.form == RecordField::kRecord) {
      add_fields(config, record(field.type), name + ".", *field.what != '\0' ? field.what : outer_what, slots);
      continue;
    }
    const bool address = std::string_view(field.type).ends_with("address_w");
    slots.push_back({.name = name,
                     .offset = 0,
                     .width = config_value(config, field.type),
                     .shift = address ? clog2(config.memory_w() / 8) : 0,
                     .is_signed = field.form == RecordField::kSigned,
                     .width_name = field.type,
                     .unit = address ? "byte" : "",
                     .what = what});
  }
}

std::string leaf(const std::string& name) { return name.substr(name.rfind('.') + 1); }

void add_sizes(const std::vector<Slot>& frame, std::vector<Slot>& slots) {
  for (Slot slot : frame) {
    if (slot.width_name != "address_w") continue;
    slot.what = "size of what lies at " + slot.name + ", a multiple of a line";
    slot.name = leaf(slot.name);
    slots.push_back(slot);
  }
  slots.push_back(slots.back());
  slots.back().name = "picture";
  slots.back().what = "size of what lies at picture.base in raster order, a multiple of a line";
}

void add_unit_counters(const Config& config, const std::vector<Slot>& states, std::vector<Slot>& slots) {
  const auto add = [&](const std::string& name, bool there) {
    for (Slot state : states) {
      state.what = name + ": " + state.what;
      state.name = name + "_" + state.name;
      if (!there) state.width = 0;
      slots.push_back(state);
    }
  };
  add("dopu", true);
  for (const char* kind : {"pu", "su", "ru"}) {
    for (int i = 0; i < kMostUnits; ++i) add(kind + std::to_string(i), i < config.units);
  }
}

void check(const RegisterMap& map) {
  std::set<int> taken;
  const auto take = [&](int offset, const std::string& name) {
    if (offset % 4 != 0 || offset < 0 || offset >= 1 << map.address_bits || !taken.insert(offset).second) {
      throw std::logic_error("registers.def: " + name + " lies at no place of its own");
    }
  };
  for (const Register& reg : map.registers) {
    take(reg.offset, reg.name);
    uint64_t bits = 0;
    for (const RegisterField& field : reg.fields) {
      const uint64_t mask = ((uint64_t{1} << field.width) - 1) << field.low;
      const bool fits = field.width == 32 || field.value >> field.width == 0;
      if (mask >> 32 != 0 || (bits & mask) != 0 || !fits ||
          (field.access == Access::Constant) != (reg.fields.front().access == Access::Constant)) {
        throw std::logic_error("registers.def: " + reg.name + "." + field.name + " does not fit");
      }
      bits |= mask;
    }
  }
  for (const SlotBlock& block : map.blocks) {
    if (static_cast<int>(block.slots.size()) * 8 > block.bytes) {
      throw std::logic_error("registers.def: " + block.name + " has no room for all of its slots");
    }
    for (const Slot& slot : block.slots) {
      take(slot.offset, slot.name);
      take(slot.offset + 4, slot.name);
      if (slot.width + slot.shift > 64) throw std::logic_error("registers.def: " + slot.name + " is over 64 bits");
    }
  }
}

}  // namespace

const SlotBlock& RegisterMap::block(std::string_view name) const {
  return *std::find_if(blocks.begin(), blocks.end(), [&](const SlotBlock& block) { return block.name == name; });
}

std::vector<Slot> RegisterMap::shadow() const {
  std::vector<Slot> slots;
  for (const char* name : {"frame", "areas", "picture"}) {
    slots.insert(slots.end(), block(name).slots.begin(), block(name).slots.end());
  }
  return slots;
}

RegisterMap register_map(const Config& c) {
  std::vector<Slot> picture, counters, states;
  // clang-format off
  RegisterMap map = {
    .registers = {
#define PIPEGS_REGISTER(NAME, Name, offset, what) {#NAME, #Name, offset, what, {
#define REGISTER_FIELD(name, low, width, access, value, unit, what) \
      {#name, low, width, Access::access, static_cast<uint32_t>(value), unit, what},
#define PIPEGS_REGISTER_END }},
#define PIPEGS_BLOCK(name, Name, offset, bytes, what)
#define PICTURE_FIELD(name, Name, width, shift, unit, what)
#define COUNTER(name, unit, what)
#define UNIT_COUNTER(name, unit, what)
#include "cpp_model/control/registers.def"
#undef PIPEGS_REGISTER
#undef REGISTER_FIELD
#undef PIPEGS_REGISTER_END
#undef PIPEGS_BLOCK
    },
    .blocks = {
#define PIPEGS_REGISTER(NAME, Name, offset, what)
#define REGISTER_FIELD(name, low, width, access, value, unit, what)
#define PIPEGS_REGISTER_END
#define PIPEGS_BLOCK(name, Name, offset, bytes, what) {#name, offset, bytes, what, {}},
#include "cpp_model/control/registers.def"
#undef PIPEGS_BLOCK
#undef PICTURE_FIELD
#undef COUNTER
#undef UNIT_COUNTER
    },
    .address_bits = kAddressBits,
  };
#define PIPEGS_BLOCK(name, Name, offset, bytes, what)
#define PICTURE_FIELD(name, Name, width, shift, unit, what) \
  picture.push_back({#name, 0, width, shift, false, "", unit, what});
#define COUNTER(name, unit, what) counters.push_back({#name, 0, c.perf_w(), 0, false, "perf_w", unit, what, false});
#define UNIT_COUNTER(name, unit, what) states.push_back({#name, 0, c.perf_w(), 0, false, "perf_w", unit, what, false});
#include "cpp_model/control/registers.def"
  // clang-format on
  for (Slot& slot : counters) {
    if (slot.name == "reserved") slot.width = 0;
  }
  for (SlotBlock& block : map.blocks) {
    if (block.name == "frame") add_fields(c, record("Frame"), "", "", block.slots);
    if (block.name == "areas") add_sizes(map.block("frame").slots, block.slots);
    if (block.name == "picture") block.slots = picture;
    if (block.name == "counters") {
      block.slots = counters;
      add_unit_counters(c, states, block.slots);
    }
    for (size_t i = 0; i < block.slots.size(); ++i) block.slots[i].offset = block.offset + 8 * static_cast<int>(i);
  }
  for (Register& reg : map.registers) {
    if (reg.name == "LAYOUT") reg.fields[0].value = layout_hash(map);
  }
  check(map);
  return map;
}

}  // namespace pipegs
