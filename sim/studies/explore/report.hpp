// SPDX-License-Identifier: Apache-2.0
// report.hpp: what a question found, as JSON, tables and charts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/studies/explore/accuracy.hpp"
#include "sim/studies/explore/tradeoff.hpp"

namespace pipegs {

struct Answer {
  nlohmann::ordered_json json;  // behind what says of which view
  std::vector<Table> tables;    // the first one has every point
  std::vector<Chart> charts;
};

Answer accuracy_answer(const AccuracySweep& sweep);
// Microseconds are cycles / 1000 / `ghz`.
Answer tradeoff_answer(std::vector<Point> points, const View& view, double ghz);
// `mm2`: the wanted area.
Answer shapes_answer(const std::vector<Point>& shapes, double mm2);

// The cheapest point that reaches so many decibels, and the words that name its machine to every command.
Table target_table(const std::vector<Point>& points, double target);

}  // namespace pipegs
