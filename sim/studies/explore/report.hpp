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

// One point in a line: its errors, what it costs, and how it differs from the base.
std::string point_text(const Point& point, const Config& base);
// The entries in which a configuration differs from the base, "base" if in none.
std::string difference(const Config& config, const Config& base);
std::string decibels(double psnr);  // "65.2", "inf"

}  // namespace pipegs
