// SPDX-License-Identifier: Apache-2.0
// what_if.cpp: see what_if.hpp.
#include "sim/ladder/what_if.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <functional>
#include <limits>

#include "sim/report/finite.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool clock_known(const WhatIfRow& row) { return row.silicon && row.silicon->path_fo4; }

// What is compared with the base's in percent, less is better in all but the clock.
struct Quantity {
  const char *key, *name, *unit;
  int digits;
  std::function<double(const WhatIfRow&)> of;          // NaN: not known
  std::function<bool(const FrameCost&)> extrapolated;  // none of what is counted
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> kQuantities = {
      {"cycles", "cycles", "", 0, [](const WhatIfRow& row) { return static_cast<double>(row.frame.cycles); }, {}},
      {"ghz", "clock", "GHz", 3, [](const WhatIfRow& row) { return clock_known(row) ? *row.silicon->ghz() : kUnknown; },
       [](const FrameCost& cost) { return cost.extrapolated_path; }},
      {"us", "time", "us", 1, [](const WhatIfRow& row) { return clock_known(row) ? row.silicon->us : kUnknown; },
       [](const FrameCost& cost) { return cost.extrapolated_path; }},
      {"megabytes", "memory", "MB", 2, [](const WhatIfRow& row) { return row.frame.megabytes(); }, {}},
      {"mm2", "area", "mm2", 3, [](const WhatIfRow& row) { return row.silicon ? row.silicon->mm2.mid : kUnknown; },
       [](const FrameCost& cost) { return cost.extrapolated_area; }},
      {"mj", "energy", "mJ", 3,
       [](const WhatIfRow& row) { return row.silicon ? row.silicon->joules() * 1e3 : kUnknown; },
       [](const FrameCost& cost) { return cost.extrapolated_energy; }}};
  return kQuantities;
}

// Of what the tables under synth/data have no such machine: "area, energy".
std::string unseen(const WhatIfRow& row) {
  if (!row.silicon) return "no such kind";
  std::vector<std::string> models;
  if (row.silicon->extrapolated_area) models.emplace_back("area");
  if (!row.silicon->path_fo4 || row.silicon->extrapolated_path) models.emplace_back("clock");
  if (row.silicon->extrapolated_energy) models.emplace_back("energy");
  return models.empty() ? "yes" : fmt::format("not {}", fmt::join(models, ", "));
}

double percent(const Quantity& quantity, const WhatIfRow& row, const WhatIfRow& base) {
  return 100 * (quantity.of(row) / quantity.of(base) - 1);
}

TableCell cell_of(const Quantity& quantity, const WhatIfRow& row) {
  const double value = quantity.of(row);
  if (std::isnan(value)) return text_cell("-");
  const bool extrapolated = quantity.extrapolated && quantity.extrapolated(*row.silicon);
  return {.text = interpolated_text(value, extrapolated, quantity.digits), .value = value};
}

// A change: "+5.1", "0.0"; nothing where one of the two is not known.
TableCell change_cell(double value, int digits, const char* unit = "") {
  if (!std::isfinite(value)) return {};
  std::string text = fmt::format("{:+.{}f}", value, digits);
  if (text.find_first_of("123456789") == text.npos) text.erase(0, 1);
  return {.text = text + unit, .value = value};
}

TableCell decibels(double value) {
  TableCell cell = decibel_cell(value);
  if (cell.value) cell.text = fmt::format("{:.2f}", value);
  return cell;
}

std::string with_unit(const Quantity& quantity) {
  return quantity.unit[0] == '\0' ? quantity.name : fmt::format("{}, {}", quantity.name, quantity.unit);
}

// Each row's cell of one figure, and behind those of changes what it differs by.
std::vector<TableCell> line_of(const std::string& name, const std::vector<WhatIfRow>& rows,
                               const std::function<TableCell(const WhatIfRow&)>& shown,
                               const std::function<TableCell(const WhatIfRow&)>& change = {}) {
  std::vector<TableCell> cells = {text_cell(name)};
  for (const WhatIfRow& row : rows) {
    cells.push_back(shown(row));
    if (&row != &rows.front()) cells.push_back(change ? change(row) : TableCell{});
  }
  return cells;
}

std::vector<std::string> notes_of(const std::vector<WhatIfRow>& rows) {
  std::vector<std::string> notes = {
      "cycles, MB: timing model; dB: golden model against float64 in depth order, and against the base's picture"};
  const WhatIfRow& base = rows.front();
  if (base.silicon)
    notes.emplace_back(
        "GHz, mm2, mJ: 28 nm, mid, interpolated between machines that were synthesised; energy is not validated; ~: "
        "beyond them");
  for (const WhatIfRow& row : rows) {
    if (!row.silicon)
      notes.push_back(row.name + ": no machine of its kind was synthesised: clock, area, energy not known");
    if (&row != &base && row.config == base.config) notes.push_back(row.name + ": as in the base, so nothing changes");
  }
  return notes;
}

}  // namespace

Table what_if_table(const std::vector<WhatIfRow>& rows) {
  const WhatIfRow& base = rows.front();
  Table table{.columns = {{.key = "figure", .heading = "figure", .word = true}}, .notes = notes_of(rows)};
  for (const WhatIfRow& row : rows) {
    table.columns.push_back({.key = row.name, .heading = row.name});
    if (&row != &base) table.columns.push_back({.key = row.name + " %", .heading = "%"});
  }
  for (const Quantity& quantity : quantities()) {
    table.rows.push_back(line_of(
        with_unit(quantity), rows, [&](const WhatIfRow& row) { return cell_of(quantity, row); },
        [&](const WhatIfRow& row) { return change_cell(percent(quantity, row, base), 1); }));
  }
  table.rows.push_back(line_of(
      "to the truth, dB", rows, [](const WhatIfRow& row) { return decibels(row.truth_db); },
      [&](const WhatIfRow& row) { return change_cell(row.truth_db - base.truth_db, 2, " dB"); }));
  table.rows.push_back(line_of("to the base, dB", rows, [&](const WhatIfRow& row) {
    return &row == &base ? TableCell{} : decibels(row.base_db);
  }));
  table.rows.push_back(line_of("bound by", rows, [](const WhatIfRow& row) { return text_cell(row.frame.bound); }));
  table.rows.push_back(line_of("roofline ratio", rows, [](const WhatIfRow& row) {
    TableCell cell = figure_cell(row.frame.over_bound);
    if (cell.value) cell.text = fmt::format("{:.2f}", *cell.value);
    return cell;
  }));
  table.rows.push_back(
      line_of("seen by the models", rows, [](const WhatIfRow& row) { return text_cell(unseen(row)); }));
  return table;
}

Json what_if_json(const std::vector<WhatIfRow>& rows) {
  const WhatIfRow& base = rows.front();
  Json list = Json::array();
  for (const WhatIfRow& row : rows) {
    Json json = {{"name", row.name}, {"configuration", config_difference(row.config)}};
    for (const Quantity& quantity : quantities()) json[quantity.key] = finite_json(quantity.of(row));
    json["cycles"] = row.frame.cycles;
    for (const Quantity& quantity : quantities())
      json["of_base"][quantity.key] = finite_json(quantity.of(row) / quantity.of(base));
    json["psnr_truth_db"] = finite_json(row.truth_db);
    json["psnr_base_db"] = finite_json(row.base_db);
    json["largest_bound"] = row.frame.bound;
    json["cycles_over_largest_bound"] = finite_json(row.frame.over_bound);
    json["silicon"] = nullptr;
    if (row.silicon) {
      json["silicon"] = {{"mm2", to_json(row.silicon->mm2)},
                         {"chip_mj", to_json(row.silicon->chip * 1e3)},
                         {"dram_mj", to_json(row.silicon->dram * 1e3)},
                         {"extrapolated_area", row.silicon->extrapolated_area},
                         {"extrapolated_path", clock_known(row) ? Json(row.silicon->extrapolated_path) : Json(nullptr)},
                         {"extrapolated_energy", row.silicon->extrapolated_energy}};
    }
    list.push_back(json);
  }
  return list;
}

std::vector<Chart> what_if_charts(const std::vector<WhatIfRow>& rows) {
  const WhatIfRow& base = rows.front();
  Chart chart{.name = "of_base", .form = Chart::Form::kBars, .title = "Beside the base", .y_label = "% of the base"};
  for (const Quantity& quantity : quantities()) {
    if (!std::isnan(quantity.of(base))) chart.categories.emplace_back(quantity.name);
  }
  for (const WhatIfRow& row : rows) {
    Series series{.name = row.name, .values = {}};
    for (const Quantity& quantity : quantities()) {
      if (!std::isnan(quantity.of(base))) series.values.push_back(100 + percent(quantity, row, base));
    }
    chart.series.push_back(series);
  }
  return {chart};
}

}  // namespace pipegs
