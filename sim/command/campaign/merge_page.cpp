// SPDX-License-Identifier: Apache-2.0
// merge_page.cpp: see merge_page.hpp.
#include "sim/command/campaign/merge_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostBars = 12;  // of views; more of them are lines

struct Drawn {
  const char *title, *unit, *place;
};
constexpr Drawn kDrawn[] = {{"Cycles by view", "cycles", "/cycles"},
                            {"PSNR against the truth by view", "dB, total", "/psnr_total_db"},
                            {"Blended splats by view", "blended", "/work/blended"}};

struct CostColumn {
  const char *key, *name;
  double unit;
};
constexpr CostColumn kCosts[] = {
    {"cpu_seconds", "CPU s", 1}, {"wall_seconds", "wall s", 1}, {"peak_memory_bytes", "memory, MB", 1e6}};

std::string window_of(const ViewArguments& view) {
  return view.window.empty() ? "" : fmt::format("{},{}", view.window[0], view.window[1]);
}

std::string view_name(const PointResult& one) {
  const std::string window = window_of(one.point.arguments.view);
  return fmt::format("{} {}{}", one.point.scene, one.point.arguments.view.view, window.empty() ? "" : " @ " + window);
}

size_t place_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

// A series for each configuration and design point, a category for each view; a point that is missing leaves a gap.
std::optional<Chart> chart_of(const Drawn& drawn, const std::vector<PointResult>& points) {
  std::vector<std::string> views, machines;
  std::vector<std::vector<double>> values;
  bool any = false;
  const bool one_configuration = std::all_of(points.begin(), points.end(), [&](const PointResult& one) {
    return one.point.configuration == points.front().point.configuration;
  });
  for (const PointResult& one : points) {
    const size_t view = place_of(views, view_name(one));
    const std::string& design_point = one.point.arguments.view.design_point;
    const size_t machine = place_of(
        machines, one_configuration ? design_point : fmt::format("{}, {}", one.point.configuration, design_point));
    if (values.size() < machines.size()) values.emplace_back();
    std::vector<double>& row = values[machine];
    row.resize(std::max(row.size(), view + 1), std::numeric_limits<double>::quiet_NaN());
    const std::optional<double> value =
        one.kept ? field_cell(figure_text((*one.kept)["result"], drawn.place)).value : std::nullopt;
    if (!value) continue;
    row[view] = *value;
    any = true;
  }
  if (!any) return std::nullopt;
  const bool lines = views.size() > kMostBars;
  Chart chart{.form = lines ? Chart::Form::kLines : Chart::Form::kBars,
              .title = drawn.title,
              .x_label = "scene and view",
              .y_label = drawn.unit,
              .categories = views};
  for (size_t i = 0; lines && i < views.size(); ++i) chart.x.push_back(static_cast<double>(i));
  for (size_t k = 0; k < machines.size(); ++k) {
    values[k].resize(views.size(), std::numeric_limits<double>::quiet_NaN());
    chart.series.push_back({.name = machines[k], .values = values[k]});
  }
  if (std::any_of(points.begin(), points.end(), [](const PointResult& one) { return !one.kept; }))
    chart.note = "points that are missing leave gaps";
  return chart;
}

Table points_table(const std::vector<PointResult>& points) {
  Table table{.title = ""};
  for (const char* name : {"scene", "view", "camera", "configuration", "design point", "window", "measured"})
    table.columns.push_back({.heading = name, .word = true});
  for (const FigureColumn& column : point_figures()) table.columns.push_back({.heading = column.name});
  for (const CostColumn& cost : kCosts) table.columns.push_back({.heading = cost.name});
  table.columns.push_back({.heading = "machine", .word = true, .wrapped = true, .copies = true});
  for (const PointResult& one : points) {
    const PointArguments& point = one.point.arguments;
    std::vector<TableCell> row = {{.text = one.point.scene},
                                  field_cell(std::to_string(point.view.view)),
                                  {.text = one.camera},
                                  {.text = one.point.configuration},
                                  {.text = point.view.design_point},
                                  {.text = window_of(point.view)},
                                  {.text = one.kept ? "yes" : "missing"}};
    for (const FigureColumn& column : point_figures())
      row.push_back(field_cell(one.kept ? figure_text((*one.kept)["result"], column.place) : ""));
    for (const CostColumn& cost : kCosts)
      row.push_back(one.kept
                        ? field_cell(fmt::format("{:.1f}", (*one.kept)["cost"][cost.key].get<double>() / cost.unit))
                        : TableCell{});
    std::string settings = "--design " + point.view.design_point;
    for (const std::string& setting : point.view.settings) settings += " --set " + setting;
    row.push_back({.text = settings});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

void add_campaign(StudyPage& page, const std::vector<PointResult>& points) {
  const auto missing = std::count_if(points.begin(), points.end(), [](const PointResult& one) { return !one.kept; });
  page.lead(fmt::format("{} of {} points measured. {}", points.size() - static_cast<size_t>(missing), points.size(),
                        cost_text(points)));
  if (missing > 0) {
    page.section("What is missing");
    Table table{.title = "",
                .columns = {{.heading = "point", .word = true},
                            {.heading = "command", .word = true, .wrapped = true, .copies = true}}};
    for (const PointResult& one : points) {
      if (one.kept) continue;
      const std::string name =
          fmt::format("{}, {}, {}", view_name(one), one.point.configuration, one.point.arguments.view.design_point);
      table.rows.push_back({{.text = name}, {.text = one.point.arguments.line()}});
    }
    page.table(table);
  }
  page.section("Charts");
  for (const Drawn& drawn : kDrawn) {
    if (const std::optional<Chart> chart = chart_of(drawn, points)) page.charts({*chart});
  }
  page.section("Every point");
  page.table(points_table(points));
}

}  // namespace pipegs
