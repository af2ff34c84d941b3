// SPDX-License-Identifier: Apache-2.0
// report.hpp: the counts of a view as tables and as JSON, each with its unit and what it counts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/table.hpp"
#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

struct CountRow {
  std::string section, key;  // key: of JSON
  uint64_t value = 0;
  std::string unit, what;
};
std::vector<CountRow> count_rows(const FrameCounts& counts, const CountOptions& options);

// {"counts": {SECTION: {KEY: VALUE}}, "lists": [...], "definitions": {SECTION: {KEY: "UNIT: WHAT"}}}, and where voxels
// of other edges were counted "other_voxels": [...], with keys of the section voxels.
nlohmann::ordered_json counts_json(const FrameCounts& counts, const CountOptions& options);
std::vector<Table> counts_tables(const FrameCounts& counts, const CountOptions& options);

}  // namespace pipegs
