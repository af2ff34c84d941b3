// SPDX-License-Identifier: Apache-2.0
// traffic.hpp: what a phase of a frame moves to and from memory, played through the DRAM model: its cycles.
//
// Idea    The flows of a phase run side by side, each at the share of its bytes, line by line of 64 bytes. A flow is a
//         table read or written from end to end, or runs of consecutive bytes that begin at places spread over its
//         table. The DRAM is that of `pipegs sim` (dram_memory.hpp): rows, banks, refresh, turns from read to write.
//         Nothing waits for an answer: it is the time of the memory alone, the least that any machine needs with this
//         traffic.
// Rule    Deterministic. Beyond kPlayedLines a phase is played for so many lines and its time scaled by the bytes: the
//         flows are steady, the rate no longer changes.
// Units   Bytes; cycles of the machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pipegs {

struct Flow {
  std::string kind;  // what it moves, in the report
  bool write = false;
  double bytes = 0;
  double run = 0;    // consecutive bytes, the first at any place; 0: the table from end to end
  double table = 0;  // bytes over which runs are spread; at least `bytes` when 0
};

struct Traffic {
  double cycles = 0, bytes = 0;
  double row_hits = 0;  // share of the bursts
};

inline constexpr uint64_t kPlayedLines = 200'000;

// Runs begin at lines, and one that is no multiple of a line moves the rest of its last one: the bytes of a flow over
// the pins, and so `bytes` of what is played. `dram` as of `pipegs sim --memory`; "ideal" takes no time. Throws
// std::invalid_argument for an unknown one and for a size that is negative or not finite.
double pin_bytes(const Flow& flow);
Traffic play_traffic(const std::vector<Flow>& flows, const std::string& dram, double clock_ghz);

}  // namespace pipegs
