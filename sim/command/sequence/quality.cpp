// SPDX-License-Identifier: Apache-2.0
// quality.cpp: see quality.hpp.
#include "sim/command/sequence/quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/ladder/frame_figures.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Measure {
  const char *key, *heading;
  int digits;
  bool (*has)(const Quality&);
  double (*of)(const Quality&);
};

bool has_photograph(const Quality& view) { return view.against.has_value(); }
bool has_truth(const Quality& view) { return view.truth.has_value(); }

const Measure kMeasures[] = {
    {"psnr_db", "dB, photograph", 2, has_photograph, [](const Quality& view) { return view.against->psnr_db; }},
    {"ssim", "SSIM, photograph", 4, has_photograph, [](const Quality& view) { return view.against->ssim; }},
    {"psnr_numeric_db", "dB, numeric", 2, has_truth, [](const Quality& view) { return view.truth->numeric_db; }},
    {"psnr_order_db", "dB, order", 2, has_truth, [](const Quality& view) { return view.truth->order_db; }},
    {"psnr_total_db", "dB, total", 2, has_truth, [](const Quality& view) { return view.truth->total_db; }}};

std::vector<const Measure*> measures(const std::vector<Quality>& views) {
  std::vector<const Measure*> known;
  for (const Measure& measure : kMeasures) {
    if (std::any_of(views.begin(), views.end(), measure.has)) known.push_back(&measure);
  }
  return known;
}

TableCell cell(const Measure& measure, double value) {
  TableCell cell = decibel_cell(value);
  if (cell.value) cell.text = fmt::format("{:.{}f}", value, measure.digits);
  return cell;
}

struct Summary {
  double mean = 0, least = kNone;
  size_t view = 0, views = 0;  // which has the least; how many have one
};

Summary summary(const Measure& measure, const std::vector<Quality>& views) {
  Summary sum;
  for (size_t i = 0; i < views.size(); ++i) {
    if (!measure.has(views[i])) continue;
    const double value = measure.of(views[i]);
    sum.mean += value;
    if (sum.views++ == 0 || value < sum.least) sum.least = value, sum.view = i;
  }
  sum.mean /= static_cast<double>(sum.views);
  return sum;
}

}  // namespace

void add_columns(Table& table, const std::vector<Quality>& views) {
  for (const Measure* measure : measures(views))
    table.columns.push_back({.key = measure->key, .heading = measure->heading});
  if (std::any_of(views.begin(), views.end(), has_photograph))
    table.columns.push_back({.key = "photograph", .heading = "photograph", .word = true});
}

void add_cells(std::vector<TableCell>& row, const std::vector<Quality>& views, size_t view) {
  const Quality& one = views[view];
  for (const Measure* measure : measures(views))
    row.push_back(measure->has(one) ? cell(*measure, measure->of(one)) : TableCell{});
  if (std::any_of(views.begin(), views.end(), has_photograph))
    row.push_back(one.against ? text_cell(one.against->photograph) : TableCell{});
}

std::vector<Table> summary_tables(const std::vector<Quality>& views) {
  Table table{
      .title = "how good the pictures are",
      .columns = {
          {.word = true}, {.heading = "mean"}, {.heading = "least"}, {.heading = "of frame"}, {.heading = "frames"}}};
  for (const Measure* measure : measures(views)) {
    const Summary sum = summary(*measure, views);
    table.rows.push_back({text_cell(measure->heading), cell(*measure, sum.mean), cell(*measure, sum.least),
                          number_cell(static_cast<double>(sum.view)), number_cell(static_cast<double>(sum.views))});
  }
  if (table.rows.empty()) return {};
  return {table};
}

void add_view(Json& json, const Quality& view) {
  for (const Measure& measure : kMeasures) {
    if (measure.has(view)) json[measure.key] = finite_json(measure.of(view));
  }
  if (view.against) json["photograph"] = view.against->photograph;
}

void add_summary(Json& json, const std::vector<Quality>& views) {
  for (const Measure* measure : measures(views)) {
    const Summary sum = summary(*measure, views);
    json["quality"][measure->key] = {
        {"mean", finite_json(sum.mean)}, {"least", finite_json(sum.least)}, {"frame", sum.view}, {"frames", sum.views}};
  }
}

std::vector<Chart> quality_charts(const std::vector<Quality>& views) {
  Chart chart{.name = "quality",
              .form = Chart::Form::kLines,
              .title = "How good each picture is",
              .x_label = "frame",
              .y_label = "dB",
              .from_zero = false};
  for (size_t i = 0; i < views.size(); ++i) chart.x.push_back(static_cast<double>(i));
  for (const Measure* measure : measures(views)) {
    if (measure->of == kMeasures[1].of) continue;  // no decibels
    Series& series = chart.series.emplace_back(Series{.name = measure->heading, .values = {}});
    for (const Quality& view : views) series.values.push_back(measure->has(view) ? measure->of(view) : kNone);
  }
  if (chart.series.empty()) return {};
  return {chart};
}

}  // namespace pipegs
