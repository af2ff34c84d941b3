// SPDX-License-Identifier: Apache-2.0
// report.hpp: measured shapes as a table, as JSON and as a chart.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/studies/shapes/shapes.hpp"

namespace pipegs {

// `mm2`: the wanted area. The base is the first.
std::vector<Table> shapes_tables(const std::vector<Shape>& shapes, double mm2);
nlohmann::ordered_json shapes_json(const std::vector<Shape>& shapes, double mm2);
Chart shapes_chart(const std::string& title, const std::vector<Shape>& shapes);

}  // namespace pipegs
