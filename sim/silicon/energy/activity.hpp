// SPDX-License-Identifier: Apache-2.0
// activity.hpp: what switches in waves of the RTL: bits that toggle, edges of the clocks, accesses of the SRAMs.
//
// Idea    Waves hold every value of every signal, so each signal's Hamming distances are its toggles. A signal that
//         has a name in several modules (a port) counts once, where it appears first on the way down from the core
//         (rtl/pipegs_top.sv); what stands around that, border and harness, is left out.
//         An SRAM is known by its ports: read_i and write_i at a rising edge of its clk_i are accesses; its words are
//         left out.
// Sample  Waves with gaps (RtlOptions::sample_period) are samples: of each, its first time is what the others are held
//         against.
// Enables With enables (enables.hpp) the edges that pass each clock gate behind an enable are counted too.
// Group   Signals are summed by the name that `group` gives to the scope they stand in, "" leaves them out.
// Units   Bits, toggles of one bit, edges, accesses. The waves are those of sim/rtl/rtl_bridge.cpp: ten units of time
//         a cycle.
// Errors  InputError when the file is none, is cut off, or has no core.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "sim/silicon/energy/enables.hpp"

namespace pipegs {

struct Switching {
  uint64_t bits = 0;     // of all signals
  uint64_t toggles = 0;  // of single bits
};

struct SramAccesses {
  int width = 0;  // of rdata_o
  uint64_t reads = 0, writes = 0;
};

struct Activity {
  uint64_t cycles = 0;
  std::map<std::string, Switching> groups;
  std::map<std::string, uint64_t> clocks;     // rising edges of the signals named clk_o, by their scope
  std::map<std::string, SramAccesses> srams;  // by instance
  EnabledByUnit enabled;                      // by group and module
  std::map<std::string, uint64_t> unseen;     // by group: flip-flops whose enable the waves do not show

  void clear();  // counts, not what is counted
  void add(const Activity& more);
};

// All samples, one after the other; and their sum.
// Scopes are written with dots, as in u_core.u_front.gen_unit[0].u_pu.u_fetch.
void read_samples(const std::filesystem::path& fst, const std::function<std::string(const std::string& scope)>& group,
                  const Enables& enables, const std::function<void(const Activity&)>& on_sample);
Activity read_activity(const std::filesystem::path& fst,
                       const std::function<std::string(const std::string& scope)>& group, const Enables& enables);

}  // namespace pipegs
