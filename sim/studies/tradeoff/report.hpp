// SPDX-License-Identifier: Apache-2.0
// report.hpp: measured trade-offs as JSON, as a table and as a chart, and what a decibel costs.
//
// Idea    The front from its most accurate point down, in legs: each ends at the fastest point that still has 50, 40
//         or 30 dB. A decibel's price is a leg's microseconds over its decibels.
// Rule    Microseconds are cycles / 1000 / `ghz`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/studies/tradeoff/ways.hpp"

namespace pipegs {

struct Leg {
  const TradeoffPoint *from, *to;
  double us, us_per_db;
};

// Of points whose places are known. A level that changes nothing has no leg.
std::vector<Leg> price(const std::vector<TradeoffPoint>& points, double ghz);

nlohmann::ordered_json to_json(const std::vector<TradeoffPoint>& points, double ghz);
nlohmann::ordered_json to_json(const std::vector<Leg>& legs);
Table to_table(const std::vector<TradeoffPoint>& points, double ghz);
Chart tradeoff_chart(const std::string& title, const std::vector<TradeoffPoint>& points, double ghz);

}  // namespace pipegs
