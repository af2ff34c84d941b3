// SPDX-License-Identifier: Apache-2.0
// control_registers.cpp: see control_registers.hpp.
#include "cpp_model/control/control_registers.hpp"

#include <stdexcept>

namespace pipegs {
namespace {

uint32_t field_mask(const RegisterField& field) {
  return static_cast<uint32_t>(((uint64_t{1} << field.width) - 1) << field.low);
}
uint64_t low_bits(int width) { return width == 64 ? ~uint64_t{0} : (uint64_t{1} << width) - 1; }

}  // namespace

ControlRegisters::ControlRegisters(const Config& config) : map(register_map(config)), slots_(map.shadow()) {
  for (const Register& reg : map.registers) {
    offsets_[reg.name] = reg.offset;
    registers_[reg.offset] = &reg;
  }
  reset();
}

void ControlRegisters::reset() {
  for (const Register& reg : map.registers) {
    values_[reg.offset] = 0;
    for (const RegisterField& field : reg.fields) values_[reg.offset] |= field.value << field.low;
  }
  shadow_.assign(slots_.size(), 0);
  high_ = 0;
  queued_ = abort_ = located_ = irq_ = aw_full_ = w_full_ = ar_full_ = b_full_ = r_full_ = false;
}

uint32_t ControlRegisters::bit(const std::string& name, const std::string& field_name) const {
  for (const RegisterField& field : registers_.at(offsets_.at(name))->fields) {
    if (field.name == field_name) return field_mask(field);
  }
  throw std::logic_error("no field " + name + "." + field_name);
}

uint64_t ControlRegisters::shown(size_t slot) const {
  const Slot& s = slots_[slot];
  uint64_t value = shadow_[slot];
  if (s.is_signed && s.width > 0 && (value >> (s.width - 1)) != 0) value |= ~low_bits(s.width);
  return value << s.shift;
}

ControlRegisters::Answer ControlRegisters::read(int offset, const ControlInputs& in) {
  if (const auto found = registers_.find(offset); found != registers_.end()) {
    if (found->second->name == "STATUS") {
      return {false, (in.busy ? bit("STATUS", "busy") : 0) | (queued_ ? bit("STATUS", "queued") : 0) |
                         (value("ERROR") != 0 ? bit("STATUS", "failed") : 0) |
                         (in.silent ? bit("STATUS", "silent") : 0)};
    }
    return {false, values_.at(offset)};
  }
  for (size_t i = 0; i < slots_.size(); ++i) {
    if ((offset & ~4) == slots_[i].offset) return {false, static_cast<uint32_t>(shown(i) >> 8 * (offset & 4))};
  }
  size_t counter = 0;
  for (const Slot& slot : map.block("counters").slots) {
    const uint64_t shown = slot.width > 0 ? in.counters.at(counter++) : 0, count = in.apart ? 0 : shown;
    if ((offset & ~4) != slot.offset) continue;
    if (offset & 4) return {false, high_};
    high_ = static_cast<uint32_t>(count >> 32);
    return {false, static_cast<uint32_t>(count)};
  }
  return {true, 0};
}

bool ControlRegisters::write(int offset, uint32_t data, uint32_t mask) {
  if (const auto found = registers_.find(offset); found != registers_.end()) {
    bool writable = false;
    for (const RegisterField& field : found->second->fields) {
      const uint32_t bits = mask & field_mask(field);
      uint32_t& value = values_.at(offset);
      if (field.access == Access::ReadWrite) value = (value & ~bits) | (data & bits);
      if (field.access == Access::Clear) value &= ~(data & bits);
      if (field.access == Access::Pulse) pulses_ |= data & bits;
      writable = writable || (field.access != Access::Constant && field.access != Access::Read);
    }
    return !writable;
  }
  for (size_t i = 0; i < slots_.size(); ++i) {
    if ((offset & ~4) != slots_[i].offset) continue;
    if (queued_) return true;
    const int at = 8 * (offset & 4);
    const uint64_t bits = static_cast<uint64_t>(mask) << at;
    const uint64_t next = (shown(i) & ~bits) | ((static_cast<uint64_t>(data) << at) & bits);
    shadow_[i] = (next >> slots_[i].shift) & low_bits(slots_[i].width);
    return false;
  }
  return true;
}

void ControlRegisters::step(const ControlInputs& in) {
  const bool was_queued = queued_, taken = queued_ && in.frame_ready;
  const bool writes = aw_full_ && w_full_ && (!b_full_ || in.b_ready), reads = ar_full_ && (!r_full_ || in.r_ready);
  const bool irq = (value("IRQ_STATUS") & value("IRQ_ENABLE")) != 0;
  if (in.b_ready) b_full_ = false;
  if (in.r_ready) r_full_ = false;
  if (reads) {
    r_ = read(static_cast<int>(ar_address_ & ~3u), in);
    r_full_ = true;
  }
  pulses_ = 0;
  if (writes) {
    uint32_t mask = 0;
    for (int i = 0; i < 4; ++i) mask |= (w_strobe_ >> i & 1) != 0 ? 0xffu << 8 * i : 0;
    b_ = {write(static_cast<int>(aw_address_ & ~3u), w_data_, mask), 0};
    b_full_ = true;
  }
  const bool aborts = (pulses_ & bit("CONTROL", "abort_all")) != 0;
  const bool starts = !aborts && (pulses_ & bit("CONTROL", "start")) != 0;

  // Events: what is set stays set although it is cleared in the same cycle.
  const uint32_t caused = in.errors | (starts && was_queued ? bit("ERROR", "start_full") : 0);
  if (in.errors != 0 && (value("ERROR") & ((1u << kErrorCauses) - 1)) == 0) {
    const int cause = __builtin_ctz(in.errors);
    located_ = (in.located >> cause & 1) != 0;
    const uint64_t address = located_ ? in.error_lines.at(static_cast<size_t>(cause)) * 64 : 0;
    value("ERROR_FIRST") = static_cast<uint32_t>(cause) << 8;
    value("ERROR_ADDRESS_LOW") = static_cast<uint32_t>(address);
    value("ERROR_ADDRESS_HIGH") = static_cast<uint32_t>(address >> 32);
  }
  value("ERROR") |= caused;
  const bool held = (value("ERROR") & ((1u << kErrorCauses) - 1)) != 0;
  const uint32_t valid = bit("ERROR_FIRST", "valid"), located = bit("ERROR_FIRST", "located");
  value("ERROR_FIRST") = (value("ERROR_FIRST") & ~(valid | located)) | (held ? valid | (located_ ? located : 0) : 0);
  if (in.frame_done) value("IRQ_STATUS") |= bit("IRQ_STATUS", "frame_done");
  if (was_queued && (taken || aborts)) value("IRQ_STATUS") |= bit("IRQ_STATUS", "queue_free");
  if (caused != 0) value("IRQ_STATUS") |= bit("IRQ_STATUS", "error");
  value("FRAMES_STARTED") += taken;
  value("FRAMES_DONE") += in.frame_done;
  if (aborts || taken) queued_ = false;
  if (starts && !was_queued) queued_ = true;
  abort_ = aborts;
  irq_ = irq;

  // The registers in front: full, they wait; empty, they take.
  const auto advance = [](bool& full, bool leaves, bool comes) {
    const bool takes = !full && comes;
    full = takes || (full && !leaves);
    return takes;
  };
  if (advance(aw_full_, writes, in.aw_valid)) aw_address_ = in.aw_address;
  if (advance(w_full_, writes, in.w_valid)) w_data_ = in.w_data, w_strobe_ = in.w_strobe;
  if (advance(ar_full_, reads, in.ar_valid)) ar_address_ = in.ar_address;
}

ControlOutputs ControlRegisters::outputs() const {
  return {.aw_ready = !aw_full_,
          .w_ready = !w_full_,
          .b_valid = b_full_,
          .b_error = b_.error,
          .ar_ready = !ar_full_,
          .r_valid = r_full_,
          .r_error = r_.error,
          .irq = irq_,
          .frame_valid = queued_,
          .abort = abort_,
          .r_data = r_.data,
          .timeout = values_.at(offsets_.at("BUS_TIMEOUT"))};
}

}  // namespace pipegs
