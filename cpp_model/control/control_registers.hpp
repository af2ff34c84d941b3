// SPDX-License-Identifier: Apache-2.0
// control_registers.hpp: bit- and cycle-accurate model of rtl/control/pipegs_control_registers.sv.
//
// Idea    What a register does follows from the access of its fields in the table (registers.def), not from its name;
//         names stand here only where the machine sets a bit. A step is one clock edge: what the bus asks for is
//         answered from the state before it, then events are added.
// RTL     rtl/control/pipegs_control_registers.sv and its parts
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cpp_model/control/registers.hpp"

namespace pipegs {

inline constexpr int kErrorCauses = 8;  // those that give frames up; the last one of ERROR is the start's

struct ControlInputs {
  bool aw_valid = false, w_valid = false, b_ready = false, ar_valid = false, r_ready = false;
  uint32_t aw_address = 0, ar_address = 0, w_data = 0, w_strobe = 0;
  bool frame_ready = false, apart = false, busy = false, silent = false, frame_done = false;
  uint32_t errors = 0, located = 0;  // located: of each cause, its line is known
  std::array<uint64_t, kErrorCauses> error_lines = {};
  std::vector<uint64_t> counters;  // those that the machine has, in the order of their slots
};

struct ControlOutputs {
  bool aw_ready, w_ready, b_valid, b_error, ar_ready, r_valid, r_error, irq, frame_valid, abort;
  uint32_t r_data;  // where r_valid
  uint32_t timeout;
};

class ControlRegisters {
 public:
  explicit ControlRegisters(const Config& config);
  ControlRegisters(const ControlRegisters&) = delete;
  void reset();
  void step(const ControlInputs& in);
  ControlOutputs outputs() const;
  // What the slots of map.shadow() hold, without shift and sign.
  const std::vector<uint64_t>& shadow() const { return shadow_; }

  const RegisterMap map;

 private:
  struct Answer {
    bool error;
    uint32_t data;
  };
  Answer read(int offset, const ControlInputs& in);  // keeps the high word of a counter
  bool write(int offset, uint32_t data, uint32_t mask);
  uint64_t shown(size_t slot) const;  // all 64 bits of a slot of the shadow set
  uint32_t& value(const std::string& name) { return values_.at(offsets_.at(name)); }
  uint32_t bit(const std::string& name, const std::string& field) const;

  std::vector<Slot> slots_;
  std::map<std::string, int> offsets_;
  std::map<int, const Register*> registers_;
  std::map<int, uint32_t> values_;
  std::vector<uint64_t> shadow_;
  uint32_t high_ = 0, pulses_ = 0;  // pulses_: what a write to CONTROL does in this step
  bool queued_ = false, abort_ = false, located_ = false, irq_ = false;
  bool aw_full_ = false, w_full_ = false, ar_full_ = false, b_full_ = false, r_full_ = false;
  uint32_t aw_address_ = 0, ar_address_ = 0, w_data_ = 0, w_strobe_ = 0;
  Answer b_ = {}, r_ = {};
};

}  // namespace pipegs
