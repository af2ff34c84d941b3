// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/silicon/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "sim/silicon/published.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDisplay = 60;  // frames/s

const PublishedRow* paper_row(const std::string& unit) {
  const auto found = std::find_if(kPipegsTable2.begin(), kPipegsTable2.end(),
                                  [&](const PublishedRow& row) { return row.unit == unit; });
  return found == kPipegsTable2.end() ? nullptr : &*found;
}

TableCell range_cell(const Range& range, int digits) {
  return {.text = fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", range.mid, digits, range.low, digits, range.high, digits),
          .value = range.mid};
}

// What is 0 is not shown.
TableCell positive(double value) { return value > 0 ? number_cell(value) : TableCell{}; }

Table area_table(const SiliconPoint& design_point) {
  Table table{.title = fmt::format("{}, gates of {}", design_point.name, design_point.synth.library),
              .columns = {{.key = "row", .word = true},
                          {.key = "units", .heading = "units"},
                          {.key = "kilo_nand2", .heading = "kNAND2"},
                          {.key = "kb", .heading = "KB"},
                          {.key = "area_mm2", .heading = "mm2 in 28 nm"},
                          {.key = "path_ps", .heading = "longest path, ps"},
                          {.key = "paper_mm2", .heading = "paper mm2", .digits = 3}}};
  for (const SiliconRow& row : design_point.rows) {
    const PublishedRow* paper = paper_row(row.name);
    table.rows.push_back({text_cell(row.name), positive(row.count), positive(row.kilo_nand2), positive(row.kb),
                          range_cell(row.area_mm2, 3), row.path_ps.mid > 0 ? range_cell(row.path_ps, 0) : TableCell{},
                          paper == nullptr ? TableCell{} : number_cell(paper->area_mm2)});
  }
  return table;
}

Table clocks_table(const SiliconPoint& design_point) {
  Table table{.columns = {{.key = "row", .word = true},
                          {.key = "flipflops", .heading = "flip-flops"},
                          {.key = "gated", .heading = "gated", .unit = "%", .digits = 1},
                          {.key = "unseen", .heading = "unseen", .unit = "%", .digits = 1},
                          {.key = "clocks_uj", .heading = "uJ of clocks", .digits = 1},
                          {.key = "enables", .heading = "gates' enables", .unit = "%", .digits = 1},
                          {.key = "ungated_uj", .heading = "no enable", .digits = 1},
                          {.key = "gates_uj", .heading = "the gates", .digits = 1}},
              .notes = {"gated: flip-flops whose clock an enable gates; unseen: those whose enable the waves do not "
                        "show, counted as high; gates' enables: share of the edges that pass"}};
  for (const EnergyRow& row : design_point.energy) {
    if (row.flipflops == 0) continue;
    const double count = static_cast<double>(row.flipflops) / 100;
    table.rows.push_back({text_cell(row.name), number_cell(static_cast<double>(row.flipflops)),
                          positive(static_cast<double>(row.gated) / count),
                          positive(static_cast<double>(row.unseen) / count), number_cell(row.clocks_j * 1e6),
                          positive(100 * row.gated_j() / row.open_j), number_cell(row.ungated_j * 1e6),
                          number_cell(row.gates_j * 1e6)});
  }
  return table;
}

constexpr size_t kDearest = 12;  // modules whose clocks are shown

Table modules_table(const SiliconPoint& design_point) {
  Table table{.title = "modules whose clocks take most",
              .columns = {{.key = "row", .word = true},
                          {.key = "module", .heading = "module", .word = true},
                          {.key = "flipflops", .heading = "flip-flops"},
                          {.key = "gated", .heading = "gated"},
                          {.key = "clocks_uj", .heading = "uJ of clocks", .digits = 1},
                          {.key = "ungated_uj", .heading = "no enable", .digits = 1}}};
  for (size_t i = 0; i < std::min(kDearest, design_point.clocks.size()); ++i) {
    const ModuleClocks& one = design_point.clocks[i];
    table.rows.push_back({text_cell(one.row), text_cell(one.module), number_cell(static_cast<double>(one.flipflops)),
                          number_cell(static_cast<double>(one.gated)), number_cell(one.all_j() * 1e6),
                          number_cell(one.ungated_j * 1e6)});
  }
  return table;
}

Table energy_table(const SiliconPoint& design_point) {
  const double full = design_point.fps(), display = std::min(full, kDisplay);
  Table table{.columns = {{.key = "row", .word = true},
                          {.key = "awake", .heading = "awake", .unit = "%"},
                          {.key = "frame_uj", .heading = "uJ of a frame"},
                          {.key = "clocks", .heading = "clocks", .unit = "%"},
                          {.key = "halves", .heading = "halves", .unit = "%", .digits = 1},
                          {.key = "leakage_mw", .heading = "leakage, mW"},
                          {.key = "display_mw", .heading = fmt::format("mW at {:.0f} frames/s", display)},
                          {.key = "full_w", .heading = fmt::format("W at {:.0f} frames/s", full)},
                          {.key = "paper_w", .heading = "paper W", .digits = 3}},
              .notes = {"awake: cycles in which a unit has its clock; uJ: without leakage; clocks: share of "
                        "flip-flops' clocks; halves of the samples differ by so much"}};
  for (const EnergyRow& row : design_point.energy) {
    const PublishedRow* paper = paper_row(row.name);
    table.rows.push_back({text_cell(row.name), positive(100 * row.awake), range_cell(row.frame_j * 1e6, 0),
                          positive(100 * row.clocks_j / row.frame_j.mid), positive(100 * row.halves_differ),
                          range_cell(row.leakage_w * 1e3, 1), range_cell(row.watts(display) * 1e3, 0),
                          range_cell(row.watts(full), 3),
                          paper == nullptr ? TableCell{} : number_cell(paper->power_w)});
  }
  return table;
}

// A quantity of the design points, and how much better than the baseline's it is.
struct Compared {
  TableColumn column;
  std::function<std::optional<double>(const SiliconPoint&)> value;
  bool less = false;  // less is better
};

std::vector<Compared> compared() {
  const auto with_energy = [](double (SiliconPoint::*of)() const) {
    return
        [of](const SiliconPoint& point) { return point.energy.empty() ? std::nullopt : std::optional((point.*of)()); };
  };
  return {{{.key = "us", .heading = "us", .digits = 1}, &SiliconPoint::us, true},
          {{.key = "fps_per_mm2", .heading = "frames/s/mm2", .digits = 1}, &SiliconPoint::fps_per_mm2},
          {{.key = "frames_per_joule", .heading = "frames/J"}, with_energy(&SiliconPoint::frames_per_joule)},
          {{.key = "with_dram", .heading = "with DRAM"}, with_energy(&SiliconPoint::frames_per_joule_with_dram)}};
}

// The design points against each other, as Figs. 10 and 11 do: over the baseline where it is among them.
Table design_points_table(const std::vector<SiliconPoint>& design_points) {
  const SiliconPoint& first = design_points.front();
  const bool over = first.name == "baseline";
  Table table{.columns = {{.key = "design_point", .heading = "design point", .word = true},
                          {.key = "cycles", .heading = "cycles"},
                          {.key = "ghz", .heading = "GHz", .digits = 3},
                          {.key = "mm2", .heading = "mm2", .digits = 2}},
              .notes = {"GHz: the clock that the longest path allows, at most 1; x: over the baseline"}};
  for (const SiliconPoint& point : design_points)
    table.rows.push_back({text_cell(point.name), number_cell(static_cast<double>(point.cycles)),
                          number_cell(point.ghz()), number_cell(point.mm2())});
  for (const Compared& one : compared()) {
    table.columns.push_back(one.column);
    table.columns.push_back({.key = one.column.key + "_x", .heading = "x", .digits = 2});
    for (size_t i = 0; i < design_points.size(); ++i) {
      const std::optional<double> value = one.value(design_points[i]), base = one.value(first);
      table.rows[i].push_back({.value = value});
      const bool known = over && value && base;
      table.rows[i].push_back(known ? number_cell(one.less ? *base / *value : *value / *base) : TableCell{});
    }
  }
  return table;
}

Table gscore_table() {
  std::string text = "GSCore, as published:";
  for (const PublishedRow& row : kGscore)
    text += fmt::format("{} {} {:.2f} mm2 {:.2f} W", &row == &kGscore.front() ? "" : ",", row.unit, row.area_mm2,
                        row.power_w);
  return {.notes = {text}};
}

// Bars of the design points, stacked by the rows that Table 2 has too, and the paper's.
template <class Rows, class Value>
Chart stack(const char* chart_name, const char* title, const char* y_label,
            const std::vector<SiliconPoint>& design_points, Rows rows, Value value, double PublishedRow::*paper_value) {
  Chart chart{.name = chart_name, .form = Chart::Form::kStacked, .title = title, .y_label = y_label};
  for (size_t row = 0; row < rows(design_points.front()).size(); ++row) {
    const std::string name = rows(design_points.front())[row].name;
    if (name == "Total" || name == "DRAM") continue;
    Series series{.name = name, .values = {}};
    for (const SiliconPoint& design_point : design_points)
      series.values.push_back(value(design_point, rows(design_point)[row]));
    const PublishedRow* paper = paper_row(name);
    series.values.push_back(paper == nullptr ? 0 : paper->*paper_value);
    chart.series.push_back(series);
  }
  for (const SiliconPoint& design_point : design_points) chart.categories.push_back(design_point.name);
  chart.categories.push_back("paper");
  chart.note = "mid of the ranges";
  return chart;
}

Chart efficiency(const char* name, const char* title, const char* y_label,
                 const std::vector<SiliconPoint>& design_points, double (SiliconPoint::*value)() const) {
  Chart chart{.name = name, .form = Chart::Form::kBars, .title = title, .y_label = y_label};
  Series series{.name = y_label, .values = {}};
  for (const SiliconPoint& design_point : design_points) {
    chart.categories.push_back(design_point.name);
    series.values.push_back((design_point.*value)());
  }
  chart.series = {series};
  return chart;
}

}  // namespace

Json to_json(const Range& range) { return {{"low", range.low}, {"mid", range.mid}, {"high", range.high}}; }

Json to_json(const std::vector<SiliconPoint>& design_points) {
  Json list = Json::array();
  for (const SiliconPoint& design_point : design_points) {
    Json json = {{"name", design_point.name},
                 {"configuration", design_point.synth.configuration},
                 {"library", design_point.synth.library},
                 {"cycles", design_point.cycles},
                 {"ghz", design_point.ghz()},
                 {"us", design_point.us()},
                 {"fps", design_point.fps()},
                 {"fps_per_mm2", design_point.fps_per_mm2()},
                 {"fps_per_mm2_at_1_ghz", design_point.fps_per_mm2() / design_point.ghz()},
                 {"rows", Json::array()}};
    for (const SiliconRow& row : design_point.rows) {
      json["rows"].push_back({{"name", row.name},
                              {"count", row.count},
                              {"kilo_nand2", row.kilo_nand2},
                              {"kb", row.kb},
                              {"area_mm2", to_json(row.area_mm2)},
                              {"path_ps", to_json(row.path_ps)}});
    }
    if (!design_point.energy.empty()) {
      json["frames_per_joule"] = design_point.frames_per_joule();
      json["frames_per_joule_with_dram"] = design_point.frames_per_joule_with_dram();
      for (const EnergyRow& row : design_point.energy) {
        json["energy"].push_back({{"name", row.name},
                                  {"frame_j", to_json(row.frame_j)},
                                  {"awake", row.awake},
                                  {"clocks_j", row.clocks_j},
                                  {"ungated_j", row.ungated_j},
                                  {"gates_j", row.gates_j},
                                  {"open_j", row.open_j},
                                  {"flipflops", row.flipflops},
                                  {"gated", row.gated},
                                  {"unseen", row.unseen},
                                  {"halves_differ", row.halves_differ},
                                  {"leakage_w", to_json(row.leakage_w)},
                                  {"watts_60", to_json(row.watts(std::min(design_point.fps(), kDisplay)))},
                                  {"watts_full", to_json(row.watts(design_point.fps()))}});
      }
      for (const ModuleClocks& one : design_point.clocks) {
        json["clocks"].push_back({{"row", one.row},
                                  {"module", one.module},
                                  {"flipflops", one.flipflops},
                                  {"gated", one.gated},
                                  {"ungated_j", one.ungated_j},
                                  {"gated_j", one.gated_j},
                                  {"gates_j", one.gates_j},
                                  {"open_j", one.open_j}});
      }
    }
    list.push_back(json);
  }
  const auto published = [](const auto& rows) {
    Json json = Json::array();
    for (const PublishedRow& row : rows)
      json.push_back({{"name", row.unit},
                      {"count", row.count},
                      {"kb", row.kb},
                      {"area_mm2", row.area_mm2},
                      {"power_w", row.power_w}});
    return json;
  };
  return {{"designs", list}, {"paper", published(kPipegsTable2)}, {"gscore", published(kGscore)}};
}

std::vector<Table> silicon_tables(const std::vector<SiliconPoint>& design_points) {
  std::vector<Table> tables;
  for (const SiliconPoint& point : design_points) {
    tables.push_back(area_table(point));
    if (point.energy.empty()) continue;
    tables.push_back(energy_table(point));
    tables.push_back(clocks_table(point));
    if (!point.clocks.empty()) tables.push_back(modules_table(point));
  }
  tables.push_back(design_points_table(design_points));
  tables.push_back(gscore_table());
  return tables;
}

std::vector<Chart> silicon_charts(const std::vector<SiliconPoint>& design_points) {
  std::vector<Chart> charts = {stack(
      "area", "Area in 28 nm", "mm2", design_points,
      [](const SiliconPoint& design_point) -> const std::vector<SiliconRow>& { return design_point.rows; },
      [](const SiliconPoint&, const SiliconRow& row) { return row.area_mm2.mid; }, &PublishedRow::area_mm2)};
  const bool energy = !design_points.front().energy.empty();
  if (energy) {
    charts.push_back(stack(
        "power", "Power at full speed", "W", design_points,
        [](const SiliconPoint& design_point) -> const std::vector<EnergyRow>& { return design_point.energy; },
        [](const SiliconPoint& design_point, const EnergyRow& row) { return row.watts(design_point.fps()).mid; },
        &PublishedRow::power_w));
  }
  charts.push_back(efficiency("fps_per_mm2", "Frames per second for each mm2", "frames/s/mm2", design_points,
                              &SiliconPoint::fps_per_mm2));
  if (energy)
    charts.push_back(efficiency("frames_per_joule", "Frames for each joule", "frames/J", design_points,
                                &SiliconPoint::frames_per_joule));
  return charts;
}

}  // namespace pipegs
