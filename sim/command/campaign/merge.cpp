// SPDX-License-Identifier: Apache-2.0
// merge.cpp: see merge.hpp.
#include "sim/command/campaign/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "scenes/text/json.hpp"
#include "sim/command/outputs.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

constexpr size_t kMostBars = 12;  // of views; more of them are lines

struct Figure {
  const char *key, *place;  // in the tables, and in what was measured
  int digits = 0;           // shown in a page
};

const std::vector<Figure> kFigures = {{"cycles", "/result/cycles"},
                                      {"bytes_read", "/result/memory/bytes_read"},
                                      {"bytes_written", "/result/memory/bytes_written"},
                                      {"overflow_lines", "/result/work/overflow_lines"},
                                      {"fetched", "/result/work/fetched"},
                                      {"blended", "/result/work/blended"},
                                      {"psnr_numeric_db", "/result/psnr_numeric_db", 2},
                                      {"psnr_order_db", "/result/psnr_order_db", 2},
                                      {"psnr_total_db", "/result/psnr_total_db", 2},
                                      {"beats_compared", "/result/beats_compared"},
                                      {"mismatches", "/result/mismatches"}};
const std::vector<Figure> kCosts = {
    {"read_seconds", "/cost/read_seconds", 1},     {"pack_seconds", "/cost/pack_seconds", 1},
    {"golden_seconds", "/cost/golden_seconds", 1}, {"cpu_seconds", "/cost/cpu_seconds", 1},
    {"wall_seconds", "/cost/wall_seconds", 1},     {"peak_memory_bytes", "/cost/peak_memory_bytes"}};

struct Drawn {
  const char *title, *unit, *place;
};
constexpr Drawn kDrawn[] = {{"Cycles by view", "cycles", "/result/cycles"},
                            {"PSNR against the truth by view", "dB, total", "/result/psnr_total_db"},
                            {"Blended splats by view", "blended", "/result/work/blended"}};

// Nothing of what was not measured: where the RTL did not run its whole branch is null.
std::optional<double> figure_of(const PointResult& one, const char* place) {
  const Pointer pointer(place);
  for (Pointer above = pointer; !above.empty(); above = above.parent_pointer()) {
    if (!one.kept || !one.kept->contains(above) || (*one.kept)[above].is_null()) return std::nullopt;
  }
  return (*one.kept)[pointer].get<double>();
}

// A row for each point that is there.
Table table_of(const std::vector<PointResult>& points, const std::vector<Figure>& figures) {
  Table table;
  for (const char* name : {"scene", "view", "camera", "configuration", "design"})
    table.columns.push_back({.key = name, .heading = name, .word = true});
  for (const Figure& figure : figures)
    table.columns.push_back({.key = figure.key, .heading = figure.key, .digits = figure.digits});
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const ViewArguments& view = one.point.arguments.view;
    std::vector<TableCell> row = {text_cell(one.point.scene), number_cell(view.view), text_cell(one.camera),
                                  text_cell(one.point.configuration), text_cell(view.design_point)};
    for (const Figure& figure : figures) row.push_back({.value = figure_of(one, figure.place)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json results_json(const std::vector<PointResult>& points) {
  Json list = Json::array();
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const PointArguments& point = one.point.arguments;
    list.push_back({{"scene", one.point.scene},
                    {"view", point.view.view},
                    {"camera", one.camera},
                    {"configuration", one.point.configuration},
                    {"design", point.view.design_point},
                    {"set", point.view.settings},
                    {"engine", point.engine},
                    {"key", one.file.stem().string()},
                    {"result", (*one.kept)["result"]}});
  }
  return {{"points", points.size()}, {"results", std::move(list)}};
}

std::string view_name(const PointResult& one) {
  return fmt::format("{} {}", one.point.scene, one.point.arguments.view.view);
}

std::string machine_of(const PointResult& one) {
  return fmt::format("{}, {}", one.point.configuration, one.point.arguments.view.design_point);
}

size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

// A series for each configuration and design point, a category for each view; a point that is missing leaves a gap.
std::optional<Chart> chart_of(const Drawn& drawn, const std::vector<PointResult>& points) {
  Chart chart{.form = Chart::Form::kBars, .title = drawn.title, .x_label = "scene and view", .y_label = drawn.unit};
  std::vector<std::string> machines;
  bool any = false;
  for (const PointResult& one : points) place_of(chart.categories, view_name(one)), place_of(machines, machine_of(one));
  const std::vector<double> gaps(chart.categories.size(), std::numeric_limits<double>::quiet_NaN());
  for (const std::string& machine : machines) chart.series.push_back({.name = machine, .values = gaps});
  for (const PointResult& one : points) {
    if (!one.kept) chart.note = "points that are missing leave gaps";
    const std::optional<double> value = figure_of(one, drawn.place);
    if (!value) continue;
    any = true;
    chart.series[place_of(machines, machine_of(one))].values[place_of(chart.categories, view_name(one))] = *value;
  }
  if (!any) return std::nullopt;
  if (chart.categories.size() > kMostBars) {
    chart.form = Chart::Form::kLines;
    for (size_t i = 0; i < chart.categories.size(); ++i) chart.x.push_back(static_cast<double>(i));
  }
  return chart;
}

}  // namespace

std::string cost_text(const std::vector<PointResult>& points) {
  size_t count = 0;
  double seconds = 0, again = 0;
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const Json& cost = (*one.kept)["cost"];
    ++count;
    seconds += cost["cpu_seconds"].get<double>();
    again += cost["read_seconds"].get<double>() + cost["pack_seconds"].get<double>();
  }
  if (count == 0 || seconds <= 0) return "Nothing measured yet.";
  return fmt::format(
      "They took {:.1f} s of one core, {:.1f} % of it reading and packing scenes: {:.0f} points an hour and core.",
      seconds, 100 * again / seconds, 3600 * static_cast<double>(count) / seconds);
}

void write_merged(const std::filesystem::path& out, const std::vector<PointResult>& points) {
  write_text(out / "results.csv", table_csv(table_of(points, kFigures)));
  write_text(out / "results.json", json_text(results_json(points), 1) + "\n");
  write_text(out / "costs.csv", table_csv(table_of(points, kCosts)));
}

void add_campaign(StudyPage& page, const std::vector<PointResult>& points) {
  const auto missing = std::count_if(points.begin(), points.end(), [](const PointResult& one) { return !one.kept; });
  page.lead(fmt::format("{} of {} points measured. {}", points.size() - static_cast<size_t>(missing), points.size(),
                        cost_text(points)));
  if (missing > 0) {
    page.section("What is missing");
    Table table{.columns = {{.heading = "point", .word = true},
                            {.heading = "command", .word = true, .wrapped = true, .copies = true}}};
    for (const PointResult& one : points) {
      if (!one.kept)
        table.rows.push_back(
            {text_cell(view_name(one) + ", " + machine_of(one)), text_cell(one.point.arguments.line())});
    }
    page.table(table);
  }
  page.section("Charts");
  for (const Drawn& drawn : kDrawn) {
    if (const std::optional<Chart> chart = chart_of(drawn, points)) page.charts({*chart});
  }
  page.section("Every point");
  page.table(table_of(points, kFigures));
  page.section("What each took");
  page.table(table_of(points, kCosts));
}

}  // namespace pipegs
