// SPDX-License-Identifier: Apache-2.0
// dram_references.hpp: runs of other DRAM simulators, as verif/dram/references.csv holds them.
//
// Errors  InputError that names line and column: a trace or configuration that we cannot play is one too.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/memory/dram/dram_timing.hpp"

namespace pipegs {

// One run of a reference simulator.
struct DramReference {
  std::string source, configuration, trace;
  int max_out = 0;
  uint64_t bursts = 0;
  int64_t cycles = 0;
  double gbps = 0, latency_ns = 0;
};

std::vector<DramReference> read_dram_references(const std::filesystem::path& csv);
// The same of a text; `file` is its name in errors.
std::vector<DramReference> parse_dram_references(std::string_view file, std::string_view text);

// The timing of a reference configuration such as "lpddr5_4ch_mop4"; std::invalid_argument for an unknown one.
DramTiming dram_reference_timing(const std::string& configuration);

}  // namespace pipegs
