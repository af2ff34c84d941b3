// SPDX-License-Identifier: Apache-2.0
// dram_worth.hpp: what the mapping and each rule of the controller are worth: bandwidths of the traces, row by row.
//
// Idea    A row is a timing and its name; the traces of the check are played through it, lines offered as fast as they
//         are taken. One list holds a preset with each mapping, one goes step by step from the preset to the machine's
//         memory: each step takes over one more of the machine's settings, so the last step is the machine's memory.
// Docs    docs/cycles/memory_timing.md
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

struct DramRow {
  std::string preset, what;
  int interleave_bytes;
  DramTiming timing;
};

// Every mapping, with one burst, one line and four lines in a row in one channel.
std::vector<DramRow> dram_mapping_rows(const DramTiming& preset);
// From the preset, a line in each channel, to `machine`; behind it the machine without any refresh. What the machine
// leaves as it is has no row.
std::vector<DramRow> dram_step_rows(const DramTiming& preset, const DramTiming& machine);

// Markdown: GB/s at the pins, a column for each trace of kDramTraces. Mappings show their interleave.
std::string dram_mapping_table(std::span<const DramRow> rows);
std::string dram_step_table(std::span<const DramRow> rows);

}  // namespace pipegs
