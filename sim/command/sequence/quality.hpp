// SPDX-License-Identifier: Apache-2.0
// quality.hpp: how good the pictures of several views are: of each, their mean and the least, as table, JSON and chart.
//
// Idea    A measure is decibels or SSIM, to a photograph (--against) or to float64 (--truth). Views that lack it count
//         in none of its figures; a measure that no view has is left out.
// Rule    Of equal pictures a PSNR is infinite, and so is a mean with one of them: null in JSON, "equal" in text.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "sim/command/frame/against_argument.hpp"
#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"

namespace pipegs {

struct Quality {
  std::optional<AgainstFigures> against = {};
  struct Truth {
    double numeric_db = 0, order_db = 0, total_db = 0;  // as in report.json
  };
  std::optional<Truth> truth = {};
};

// Columns and cells of a table with a row for each view; their keys are those of the JSON.
void add_columns(Table& table, const std::vector<Quality>& views);
void add_cells(std::vector<TableCell>& row, const std::vector<Quality>& views, size_t view);
// Mean and least of each measure; no table without one.
std::vector<Table> summary_tables(const std::vector<Quality>& views);
// Keys of one view, and under "quality" the summary of all.
void add_view(nlohmann::ordered_json& json, const Quality& view);
void add_summary(nlohmann::ordered_json& json, const std::vector<Quality>& views);
std::vector<Chart> quality_charts(const std::vector<Quality>& views);

}  // namespace pipegs
