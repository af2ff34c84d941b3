// SPDX-License-Identifier: Apache-2.0
// dram_check.hpp: plays the traces through the channels and holds the result against other DRAM simulators.
//
// Idea    The reference runs are played again by their own rules. Requests are cut into bursts and offered in order, up
//         to four in a cycle; a full queue stops the burst at the front and all behind it. A burst is offered while
//         fewer than `max_out` are on their way. The run ends when as many bursts have finished as the trace has. In
//         the runs of Ramulator 2 a write counted twice, when it was accepted and when it was written: a trace with one
//         write in three then ends after three quarters of it, with GB/s 4/3 of what crossed the pins. Both numbers
//         are kept.
//         Latencies count from the cycle in which the controller sees the burst to the last beat of a read, or to the
//         command of a write.
// Docs    docs/cycles/memory_timing.md
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/memory/dram/dram_channel.hpp"
#include "sim/memory/dram/check/dram_references.hpp"
#include "sim/memory/dram/dram_timing.hpp"
#include "sim/memory/dram/check/dram_trace.hpp"

namespace pipegs {

struct DramPlay {
  uint64_t bursts = 0;    // of the trace
  DramCycle cycles = 0;   // clock cycles of the DRAM
  double gbps = 0;        // bytes of the trace over the time of the run, as the references count
  double pin_gbps = 0;    // bytes over the pins over the time of the run
  double latency_ns = 0;  // mean of reads and writes, as the references count
  double read_latency_ns = 0;
  DramChannel::Counters counters;  // of all channels
};

DramPlay play_dram(const DramTiming& timing, std::span<const DramTransfer> trace, int max_out,
                   bool writes_finish_twice = false);

struct DramCheck {
  DramReference reference;
  DramPlay play;
  double difference() const { return play.gbps / reference.gbps - 1; }
  bool streaming() const { return reference.trace.rfind("random", 0) != 0; }
  // DRAMsim3 keeps eight commands for each bank and serves the banks in turn: two streams that meet in one bank lose
  // more there than here.
  bool known_to_differ() const {
    return reference.configuration == "DDR4_8Gb_x8_3200" && reference.trace == "two_streams_1k" &&
           reference.max_out == 64;
  }
  // The same number of bursts, and of bandwidth streams within 5 % and random reads within 10 %; against Ramulator 2,
  // whose rules these are, the same number of cycles.
  bool agrees() const;
};

std::vector<DramCheck> check_dram(std::span<const DramReference> references);
std::string dram_check_table(std::span<const DramCheck> checks);  // Markdown

}  // namespace pipegs
