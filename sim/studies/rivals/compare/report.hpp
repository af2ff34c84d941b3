// SPDX-License-Identifier: Apache-2.0
// report.hpp: the machines of a view side by side: table, what the paper prints against what this frame shows, the
// models' checks and their parameters; as tables, JSON and charts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/studies/rivals/compare/checks.hpp"
#include "sim/studies/rivals/compare/ranges.hpp"

namespace pipegs {

struct Variant {  // of a rival, shown beside it: what if
  const Rival* rival;
  std::string key, what;
  MachineFrame frame;
};
// All that our format has of a Gaussian: 32 bytes of geometry and base colour, 64 of three bands of SH.
inline constexpr double kOwnRecordBytes = 96;

struct Comparison {
  std::vector<RivalResult> rivals;
  std::vector<Variant> variants;
  std::vector<OwnMachine> ours;
  std::vector<Check> checks;
  double lego_cycles = 0;  // lego_least_cycles() of the memory
};
// Of all rivals; `ours` are taken over.
Comparison compare(const FrameCounts& counts, PlayedMemory& memory, std::vector<OwnMachine> ours);

// One rival's published figures against the paper's PipeGS, multiplied. 0: the papers print too little.
struct Chained {
  double area = 0, energy = 0;  // PipeGS over the rival, frames/s/mm2 and frames/J
};
Chained chained(const Rival& rival);

nlohmann::ordered_json comparison_json(const Comparison& comparison);
std::vector<Table> comparison_tables(const Comparison& comparison);
std::vector<Chart> comparison_charts(const Comparison& comparison);

}  // namespace pipegs
