// SPDX-License-Identifier: Apache-2.0
// dram_worth.cpp: see dram_worth.hpp.
#include "sim/memory/dram/check/dram_worth.hpp"

#include <cstdio>

#include "sim/memory/dram/check/dram_check.hpp"

namespace pipegs {
namespace {

constexpr int kLineBytes = 64;
constexpr int kNoLimit = 1 << 20;       // of bursts in flight: more than all queues hold
constexpr int kNeverRefresh = 1 << 28;  // cycles, far beyond the end of a trace

const char* mapping_name(DramMapping mapping) {
  switch (mapping) {
    case DramMapping::kRoBaRaCoCh: return "RoBaRaCoCh";
    case DramMapping::kRoBaCoGrCh: return "RoBaCoGrCh";
    default: return "MOP4CLXOR";
  }
}

std::string table(std::span<const DramRow> rows, bool interleave) {
  std::string head = interleave ? "| preset | mapping | interleave bytes |" : "| preset | controller |",
              line = interleave ? "|---|---|---|" : "|---|---|";
  std::vector<std::vector<DramTransfer>> traces;
  for (const std::string_view trace : kDramTraces) {
    head += " " + std::string(trace) + " |", line += "---|";
    traces.push_back(dram_trace(trace));
  }
  std::string text = head + "\n" + line + "\n";
  for (const DramRow& row : rows) {
    text += "| " + row.preset + " | " + row.what + " |" +
            (interleave ? " " + std::to_string(row.interleave_bytes) + " |" : "");
    for (const std::vector<DramTransfer>& trace : traces) {
      char cell[32];
      std::snprintf(cell, sizeof cell, " %.1f |", play_dram(row.timing, trace, kNoLimit).pin_gbps);
      text += cell;
    }
    text += "\n";
  }
  return text;
}

}  // namespace

std::vector<DramRow> dram_mapping_rows(const DramTiming& preset) {
  std::vector<DramRow> rows;
  for (const DramMapping mapping : {DramMapping::kRoBaRaCoCh, DramMapping::kMop4ClXor, DramMapping::kRoBaCoGrCh}) {
    for (const int bytes : {kLineBytes / 2, kLineBytes, 4 * kLineBytes}) {
      if (bytes < preset.burst_bytes() || (preset.channels == 1 && bytes != kLineBytes)) continue;
      DramTiming timing = preset;
      timing.mapping = mapping;
      timing.interleave_bytes = bytes;
      rows.push_back({preset.name, mapping_name(mapping), bytes, timing});
    }
  }
  return rows;
}

std::vector<DramRow> dram_step_rows(const DramTiming& preset, const DramTiming& machine) {
  DramTiming timing = preset;
  std::vector<DramRow> rows;
  const auto step = [&](const std::string& what) { rows.push_back({preset.name, what, kLineBytes, timing}); };
  timing.interleave_bytes = machine.interleave_bytes;
  step(mapping_name(timing.mapping));
  timing.mapping = machine.mapping, timing.group_bytes = machine.group_bytes;
  step(mapping_name(timing.mapping));
  timing.hits_first = machine.hits_first;
  step("and hits first");
  timing.read_queue = machine.read_queue, timing.write_queue = machine.write_queue;
  step("and queues of " + std::to_string(timing.read_queue));
  timing.write_high = machine.write_high, timing.write_low = machine.write_low;
  char drain[64];
  std::snprintf(drain, sizeof drain, "and writes %.0f %%..%.0f %%", 100 * timing.write_high, 100 * timing.write_low);
  step(drain);
  timing.t_rfcpb = machine.t_rfcpb;
  if (timing.t_rfcpb > 0) step("and refresh bank by bank");
  timing.t_rfcpb = 0, timing.t_refi = kNeverRefresh;
  step("(no refresh at all)");
  return rows;
}

std::string dram_mapping_table(std::span<const DramRow> rows) { return table(rows, true); }
std::string dram_step_table(std::span<const DramRow> rows) { return table(rows, false); }

}  // namespace pipegs
