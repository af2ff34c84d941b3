// SPDX-License-Identifier: Apache-2.0
// ladder.cpp: see ladder.hpp.
#include "sim/ladder/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kClock = 1e9;  // Hz, Sec. 5.4

const LadderRow* row_of(const std::vector<LadderRow>& rows, std::string_view name) {
  for (const LadderRow& row : rows) {
    if (row.failure.empty() && row.design_point->name == name) return &row;
  }
  return nullptr;
}

double cycles_of(const LadderRow& row) { return static_cast<double>(row.frame.cycles); }

double speedup(const std::vector<LadderRow>& rows, const LadderRow& row) {
  const LadderRow* base = row_of(rows, "baseline");
  return base == nullptr ? kNone : ratio(cycles_of(*base), cycles_of(row));
}

// Of whole frames only.
double fps(const LadderRow& row) { return row.options.window ? kNone : ratio(kClock, cycles_of(row)); }

uint64_t bytes(const MemoryTraffic& traffic) { return traffic.bytes_read + traffic.bytes_written; }

std::vector<const LadderRow*> complete(const std::vector<LadderRow>& rows) {
  std::vector<const LadderRow*> found;
  for (const LadderRow& row : rows) {
    if (row.failure.empty()) found.push_back(&row);
  }
  return found;
}

// A cell of a table; "-" when there is no figure.
std::string cell(double value, int digits, const char* unit = "") {
  return std::isfinite(value) ? fmt::format("{:.{}f}{}", value, digits, unit) : std::string("-");
}

TableCell count(uint64_t value) { return number_cell(static_cast<double>(value)); }
// The paper's figure, where it has one.
TableCell paper(double value) { return figure_cell(value > 0 ? value : kNone); }

TableCell decibel(const LadderRow& row, double value) { return decibel_cell(row.with_truth ? value : kNone); }

Json cost_json(const StaticCost& cost) {
  Json json = {{"row_lanes", cost.row_lanes}, {"blend_lanes", cost.blend_lanes}, {"buffers", Json::array()}};
  for (const BufferCost& row : cost.buffers) {
    json["buffers"].push_back({{"buffer", row.buffer},
                               {"purpose", row.purpose},
                               {"width", row.width},
                               {"depth", row.depth},
                               {"count", row.count},
                               {"bytes", static_cast<double>(row.bits()) / 8}});
  }
  json["buffer_bytes"] = cost.buffer_kb() * 1024;
  return json;
}

}  // namespace

WindowCycles& FigureWatch::at(uint64_t window) {
  if (windows_.size() <= window) windows_.resize(window + 1);
  return windows_[window];
}

void FigureWatch::cycle(uint64_t, const uint8_t* states) {
  const int units = config().units;
  for (int k = 0; k < units; ++k) {
    if (states[1 + units + k] == kBusy) ++at(su_place().window).sort;
    if (states[1 + 2 * units + k] == kBusy) ++at(ru_place(k).window).raster;
  }
}

uint64_t busy_cycles(const std::vector<UnitCycles>& units) {
  return std::accumulate(units.begin(), units.end(), uint64_t{0},
                         [](uint64_t sum, const UnitCycles& unit) { return sum + unit.busy; });
}

std::vector<double> window_ratios(const std::vector<WindowCycles>& windows) {
  std::vector<double> ratios;
  for (const WindowCycles& window : windows) {
    if (window.sort > 0 && window.raster > 0)
      ratios.push_back(static_cast<double>(window.raster) / static_cast<double>(window.sort));
  }
  return ratios;
}

double mean(const std::vector<double>& values) {
  return values.empty() ? kNone
                        : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void ladder_figures(LadderRow& row, const Simulation& simulation, const FigureWatch& watch) {
  const double all = static_cast<double>(simulation.rtl.cycles) * row.options.config.units;
  row.frame = frame_figures(simulation, row.options, simulation.rtl.cycles);
  row.mismatches = simulation.mismatches;
  row.ru = simulation.rtl.ru;
  const auto raster = static_cast<double>(busy_cycles(simulation.rtl.ru)),
             sort = static_cast<double>(busy_cycles(simulation.rtl.su));
  row.raster_over_sort = ratio(raster, sort);
  row.raster_over_sort_window = mean(window_ratios(watch.windows()));
  row.bubbles = all > 0 ? 1 - raster / all : kNone;
  row.exposed = watch.first_line() == ~uint64_t{0} ? kNone : static_cast<double>(watch.first_line());
  row.has_alpha_stores = watch.has_alpha_stores();
  row.peak_alpha_lines = watch.peak_alpha_lines();
  row.peak_records = watch.peak_records();
  row.psnr_order = simulation.psnr_order;
  row.psnr_numeric = simulation.psnr_numeric;
  row.cost = static_cost(row.options.config);
}

Json ladder_json(const std::vector<LadderRow>& rows) {
  Json list = Json::array();
  for (const LadderRow& row : rows) {
    Json json = {{"name", row.design_point->name},
                 {"what", row.design_point->what},
                 {"in_paper", row.design_point->in_paper},
                 {"settings",
                  {{"late", row.options.config.late},
                   {"order", row.options.config.order},
                   {"quadratic", row.options.config.quadratic}}}};
    if (!row.failure.empty()) {
      json["failure"] = row.failure;
      list.push_back(json);
      continue;
    }
    json["cycles"] = row.frame.cycles;
    json["fps"] = finite_json(fps(row));
    json["speedup"] = finite_json(speedup(rows, row));
    json["paper_speedup"] = row.design_point->paper_speedup > 0 ? Json(row.design_point->paper_speedup) : Json(nullptr);
    json["raster_over_sort"] = finite_json(row.raster_over_sort);
    json["raster_over_sort_per_window"] = finite_json(row.raster_over_sort_window);
    json["paper_raster_over_sort"] =
        row.design_point->paper_ratio > 0 ? Json(row.design_point->paper_ratio) : Json(nullptr);
    json["bubbles"] = finite_json(row.bubbles);
    json["exposed_cycles"] = finite_json(row.exposed);
    json["exposed_share"] = finite_json(ratio(row.exposed, cycles_of(row)));
    for (const MemoryTraffic& traffic : row.frame.traffic) {
      json["bytes_by_stream"][traffic.stream] = {{"read", traffic.bytes_read}, {"written", traffic.bytes_written}};
    }
    json["peak_alpha_lines"] = row.has_alpha_stores ? Json(row.peak_alpha_lines) : Json(nullptr);
    json["peak_records"] = row.peak_records;
    json["ran"] = {{"truth", row.with_truth}, {"rtl", true}};
    json["psnr_order_db"] = row.with_truth ? finite_json(row.psnr_order) : Json(nullptr);
    json["psnr_numeric_db"] = row.with_truth ? finite_json(row.psnr_numeric) : Json(nullptr);
    json["cycles_over_largest_bound"] = finite_json(row.frame.over_bound);
    json["largest_bound"] = row.frame.bound;
    json["mismatches"] = row.mismatches;
    json["same_pixels_as"] = row.same_pixels.empty() ? Json(nullptr) : Json(row.same_pixels);
    json["pixels_unlike_same_order"] = row.different_pixels;
    json["static"] = cost_json(row.cost);
    list.push_back(json);
  }
  return list;
}

namespace {

Table design_points_table(const std::vector<LadderRow>& rows) {
  Table table{.columns = {{.key = "design", .heading = "design point", .word = true},
                          {.key = "cycles", .heading = "cycles"},
                          {.key = "fps", .heading = "fps@1GHz", .digits = 1},
                          {.key = "speedup", .heading = "speed-up", .unit = "x", .digits = 2},
                          {.key = "paper_speedup", .heading = "(paper)", .digits = 2},
                          {.key = "raster_over_sort", .heading = "raster/sort", .digits = 2},
                          {.key = "raster_over_sort_per_window", .heading = "per window", .digits = 2},
                          {.key = "paper_raster_over_sort", .heading = "(paper)", .digits = 2},
                          {.key = "bubbles", .heading = "bubbles", .unit = "%", .digits = 1},
                          {.key = "exposed_cycles", .heading = "exposed"},
                          {.key = "exposed_share", .heading = "share", .unit = "%", .digits = 1},
                          {.key = "megabytes", .unit = "MB", .digits = 1},
                          {.key = "cycles_over_largest_bound", .heading = "roofline ratio", .digits = 2},
                          {.key = "largest_bound", .heading = "bound by", .word = true},
                          {.key = "psnr_order_db", .heading = "order", .unit = "dB", .digits = 1},
                          {.key = "psnr_numeric_db", .heading = "numeric", .unit = "dB", .digits = 1},
                          {.key = "mismatches", .heading = "mismatches"}}};
  for (const LadderRow* row : complete(rows)) {
    const DesignPoint& point = *row->design_point;
    table.rows.push_back({text_cell(std::string(point.name)), count(row->frame.cycles), figure_cell(fps(*row)),
                          figure_cell(speedup(rows, *row)), paper(point.paper_speedup),
                          figure_cell(row->raster_over_sort), figure_cell(row->raster_over_sort_window),
                          paper(point.paper_ratio), figure_cell(100 * row->bubbles), figure_cell(row->exposed),
                          figure_cell(100 * ratio(row->exposed, cycles_of(*row))), figure_cell(row->frame.megabytes()),
                          figure_cell(row->frame.over_bound), text_cell(row->frame.bound),
                          decibel(*row, row->psnr_order), decibel(*row, row->psnr_numeric), count(row->mismatches)});
  }
  const LadderRow *base = row_of(rows, "baseline"), *hgr = row_of(rows, "tspp"), *dop = row_of(rows, "dop");
  if (hgr != nullptr && dop != nullptr) {
    std::string note =
        fmt::format("dop over tspp {} (paper: up to 1.22x)", cell(ratio(cycles_of(*hgr), cycles_of(*dop)), 2, "x"));
    note += fmt::format("; preprocessing before the first line: {} of tspp's",
                        cell(100 * ratio(dop->exposed, hgr->exposed), 1, " %"));
    if (base != nullptr)
      note += fmt::format(", {} of the baseline's (paper: 37 % of the original)",
                          cell(100 * ratio(dop->exposed, base->exposed), 1, " %"));
    table.notes.push_back(note);
  }
  for (const LadderRow* row : complete(rows)) {
    if (row->different_pixels > 0) {
      table.notes.push_back(fmt::format("{}: {} pixels unlike another design point of the same picture",
                                        row->design_point->name, row->different_pixels));
    } else if (!row->same_pixels.empty()) {
      table.notes.push_back(fmt::format("{}: same pixels as {}", row->design_point->name, row->same_pixels));
    }
  }
  for (const LadderRow& row : rows) {
    if (!row.failure.empty())
      table.notes.push_back(fmt::format("{}: not run: {}", row.design_point->name, row.failure));
  }
  return table;
}

Table traffic_table(const std::vector<const LadderRow*>& rows) {
  Table table{.columns = {{.key = "design", .heading = "memory traffic, MB", .word = true}}};
  std::vector<std::string> streams;
  for (const LadderRow* row : rows) {
    for (const MemoryTraffic& traffic : row->frame.traffic) {
      if (bytes(traffic) > 0 && std::find(streams.begin(), streams.end(), traffic.stream) == streams.end())
        streams.push_back(traffic.stream);
    }
  }
  for (const std::string& stream : streams) table.columns.push_back({.key = stream, .heading = stream, .digits = 1});
  table.columns.push_back({.key = "peak_alpha_lines", .heading = "alpha lines, peak of one store"});
  table.columns.push_back({.key = "peak_records", .heading = "records waiting, peak"});
  for (const LadderRow* row : rows) {
    std::vector<TableCell>& cells = table.rows.emplace_back();
    cells.push_back(text_cell(std::string(row->design_point->name)));
    for (const std::string& stream : streams) {
      double sum = kNone;
      for (const MemoryTraffic& traffic : row->frame.traffic)
        sum = traffic.stream == stream ? static_cast<double>(bytes(traffic)) / 1e6 : sum;
      cells.push_back(figure_cell(sum));
    }
    const auto peak = static_cast<double>(row->peak_alpha_lines);
    if (row->has_alpha_stores)
      cells.push_back(
          {.text = fmt::format("{} of {}", row->peak_alpha_lines, row->options.config.alpha_lines), .value = peak});
    else cells.push_back(text_cell("-"));
    cells.push_back(count(row->peak_records));
  }
  return table;
}

Table parts_table(const std::vector<const LadderRow*>& rows) {
  Table table{.columns = {{.key = "design", .heading = "built of", .word = true},
                          {.key = "row_lanes", .heading = "row lanes"},
                          {.key = "blend_lanes", .heading = "blend lanes"},
                          {.key = "buffers_kb", .heading = "buffers", .unit = "KB", .digits = 1}}};
  for (const LadderRow* row : rows) {
    table.rows.push_back({text_cell(std::string(row->design_point->name)), number_cell(row->cost.row_lanes),
                          number_cell(row->cost.blend_lanes), number_cell(row->cost.buffer_kb())});
  }
  return table;
}

}  // namespace

std::vector<Table> ladder_tables(const std::vector<LadderRow>& rows) {
  const std::vector<const LadderRow*> done = complete(rows);
  if (done.empty()) return {{.notes = design_points_table(rows).notes}};
  return {design_points_table(rows), traffic_table(done), parts_table(done)};
}

std::vector<Chart> ladder_charts(const std::vector<LadderRow>& rows) {
  const std::vector<const LadderRow*> done = complete(rows);
  Chart speed{.name = "speedup",
              .form = Chart::Form::kBars,
              .title = "Speed-up over the baseline (paper: Fig. 9)",
              .y_label = "times"};
  Chart cycles{.name = "cycles", .form = Chart::Form::kBars, .title = "Cycles of a frame", .y_label = "cycles"};
  Chart ratios{.name = "raster_over_sort",
               .form = Chart::Form::kBars,
               .title = "Raster time over sort time (paper: Fig. 8a)",
               .y_label = "times"};
  Chart raster{.name = "ru_cycles",
               .form = Chart::Form::kStacked,
               .title = "Where the RUs' cycles go",
               .y_label = "% of cycles"};
  Chart front{.name = "exposed",
              .form = Chart::Form::kBars,
              .title = "Cycles before the first line is blended (paper: Fig. 8b)",
              .y_label = "% of the frame"};
  Chart memory{.name = "memory", .form = Chart::Form::kStacked, .title = "External memory", .y_label = "MB"};
  speed.series = {{"here", {}}, {"paper, up to", {}, true}};
  cycles.series = {{"cycles", {}}};
  ratios.series = {{"here, all cycles", {}}, {"here, mean of windows", {}}, {"paper", {}, true}};
  raster.series = {{"busy", {}}, {"starved", {}}, {"blocked", {}}, {"memory", {}}};
  front.series = {{"here", {}}};
  for (const LadderRow* row : done) {
    for (const MemoryTraffic& traffic : row->frame.traffic) {
      const auto same = [&](const Series& series) { return series.name == traffic.stream; };
      if (bytes(traffic) > 0 && std::none_of(memory.series.begin(), memory.series.end(), same))
        memory.series.push_back({traffic.stream, {}});
    }
  }
  for (const LadderRow* row : done) {
    for (Chart* chart : {&speed, &cycles, &ratios, &raster, &front, &memory})
      chart->categories.emplace_back(row->design_point->name);
    speed.series[0].values.push_back(speedup(rows, *row));
    speed.series[1].values.push_back(row->design_point->paper_speedup > 0 ? row->design_point->paper_speedup : kNone);
    cycles.series[0].values.push_back(cycles_of(*row));
    ratios.series[0].values.push_back(row->raster_over_sort);
    ratios.series[1].values.push_back(row->raster_over_sort_window);
    ratios.series[2].values.push_back(row->design_point->paper_ratio > 0 ? row->design_point->paper_ratio : kNone);
    const double all = cycles_of(*row) * row->options.config.units;
    uint64_t sums[4] = {};
    for (const UnitCycles& unit : row->ru)
      sums[0] += unit.busy, sums[1] += unit.starved, sums[2] += unit.blocked, sums[3] += unit.memory;
    for (size_t i = 0; i < 4; ++i) raster.series[i].values.push_back(100 * ratio(static_cast<double>(sums[i]), all));
    front.series[0].values.push_back(100 * ratio(row->exposed, cycles_of(*row)));
    for (Series& series : memory.series) {
      double sum = 0;
      for (const MemoryTraffic& traffic : row->frame.traffic)
        sum += traffic.stream == series.name ? static_cast<double>(bytes(traffic)) / 1e6 : 0;
      series.values.push_back(sum);
    }
  }
  std::vector<Chart> charts;
  if (row_of(rows, "baseline") != nullptr) charts.push_back(speed);
  charts.insert(charts.end(), {cycles, ratios, raster, front, memory});
  for (Chart& chart : charts) {
    std::erase_if(chart.series, [](const Series& series) {
      return std::none_of(series.values.begin(), series.values.end(),
                          [](double value) { return std::isfinite(value); });
    });
  }
  return charts;
}

}  // namespace pipegs
