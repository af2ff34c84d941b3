// SPDX-License-Identifier: Apache-2.0
// ladder.cpp: see ladder.hpp.
#include "sim/ladder/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/report/finite.hpp"
#include "sim/report/report.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kClock = 1e9;  // Hz, Sec. 5.4

double ratio(double a, double b) { return b > 0 ? a / b : kNone; }

const LadderRow* row_of(const std::vector<LadderRow>& rows, std::string_view name) {
  for (const LadderRow& row : rows) {
    if (row.failure.empty() && row.design_point->name == name) return &row;
  }
  return nullptr;
}

double speedup(const std::vector<LadderRow>& rows, const LadderRow& row) {
  const LadderRow* base = row_of(rows, "baseline");
  return base == nullptr ? kNone : ratio(static_cast<double>(base->cycles), static_cast<double>(row.cycles));
}

// Of whole frames only.
double fps(const LadderRow& row) { return row.options.window ? kNone : ratio(kClock, static_cast<double>(row.cycles)); }

uint64_t bytes(const MemoryTraffic& traffic) { return traffic.bytes_read + traffic.bytes_written; }

double megabytes(const LadderRow& row) {
  uint64_t sum = 0;
  for (const MemoryTraffic& traffic : row.traffic) sum += bytes(traffic);
  return static_cast<double>(sum) / 1e6;
}

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

std::string decibel(const LadderRow& row, double value) {
  if (!row.with_truth || std::isnan(value)) return "-";
  return std::isinf(value) ? "equal" : fmt::format("{:.1f}", value);
}

// Lines of text as columns: the first one to the left, the others to the right.
std::string columns(const std::vector<std::vector<std::string>>& table) {
  std::vector<size_t> widths;
  for (const auto& line : table) {
    widths.resize(std::max(widths.size(), line.size()), 0);
    for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const auto& line : table) {
    for (size_t i = 0; i < line.size(); ++i) {
      text += i == 0 ? fmt::format("  {:<{}}", line[i], widths[i]) : fmt::format("  {:>{}}", line[i], widths[i]);
    }
    text += "\n";
  }
  return text;
}

Json cost_json(const StaticCost& cost) {
  Json json = {{"row_lanes", cost.row_lanes}, {"blend_lanes", cost.blend_lanes}};
  for (const char* kind : {"power", "color", "projection", "blend", "partition", ""}) {
    const std::string key = *kind == 0 ? "all" : kind;
    json["multipliers"][key] = cost.multipliers(kind);
    json["adders"][key] = cost.adders(kind);
  }
  Json modules = Json::array(), buffers = Json::array();
  for (const ArithmeticCost& row : cost.arithmetic) {
    modules.push_back({{"module", row.module},
                       {"kind", row.kind},
                       {"unit", row.unit},
                       {"instances", row.instances},
                       {"multipliers", row.multipliers},
                       {"adders", row.adders},
                       {"constant_product_adders", row.constant_adders}});
  }
  for (const BufferCost& row : cost.buffers) {
    buffers.push_back({{"buffer", row.buffer},
                       {"purpose", row.purpose},
                       {"width", row.width},
                       {"depth", row.depth},
                       {"count", row.count},
                       {"bytes", static_cast<double>(row.bits()) / 8}});
  }
  json["modules"] = modules;
  json["buffers"] = buffers;
  json["buffer_bytes"] = cost.buffer_kb("") * 1024;
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
  row.cycles = simulation.rtl.cycles;
  row.mismatches = simulation.mismatches;
  row.ru = simulation.rtl.ru;
  const auto raster = static_cast<double>(busy_cycles(simulation.rtl.ru)),
             sort = static_cast<double>(busy_cycles(simulation.rtl.su));
  row.raster_over_sort = ratio(raster, sort);
  row.raster_over_sort_window = mean(window_ratios(watch.windows()));
  row.bubbles = all > 0 ? 1 - raster / all : kNone;
  row.exposed = watch.first_line() == ~uint64_t{0} ? kNone : static_cast<double>(watch.first_line());
  row.traffic = simulation.traffic;
  row.has_alpha_stores = watch.has_alpha_stores();
  row.peak_alpha_lines = watch.peak_alpha_lines();
  row.peak_records = watch.peak_records();
  row.psnr_order = simulation.psnr_order;
  row.psnr_numeric = simulation.psnr_numeric;
  const Bounds bounds = work_bounds(simulation, row.options);
  row.over_bound = ratio(static_cast<double>(row.cycles), bounds.largest);
  row.bound = bounds.largest_name;
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
    json["cycles"] = row.cycles;
    json["fps"] = finite_json(fps(row));
    json["speedup"] = finite_json(speedup(rows, row));
    json["paper_speedup"] = row.design_point->paper_speedup > 0 ? Json(row.design_point->paper_speedup) : Json(nullptr);
    json["raster_over_sort"] = finite_json(row.raster_over_sort);
    json["raster_over_sort_per_window"] = finite_json(row.raster_over_sort_window);
    json["paper_raster_over_sort"] =
        row.design_point->paper_ratio > 0 ? Json(row.design_point->paper_ratio) : Json(nullptr);
    json["bubbles"] = finite_json(row.bubbles);
    json["exposed_cycles"] = finite_json(row.exposed);
    json["exposed_share"] = finite_json(ratio(row.exposed, static_cast<double>(row.cycles)));
    for (const MemoryTraffic& traffic : row.traffic) {
      json["bytes_by_stream"][traffic.stream] = {{"read", traffic.bytes_read}, {"written", traffic.bytes_written}};
    }
    json["peak_alpha_lines"] = row.has_alpha_stores ? Json(row.peak_alpha_lines) : Json(nullptr);
    json["peak_records"] = row.peak_records;
    json["ran"] = {{"truth", row.with_truth}, {"rtl", true}};
    json["psnr_order_db"] = row.with_truth ? finite_json(row.psnr_order) : Json(nullptr);
    json["psnr_numeric_db"] = row.with_truth ? finite_json(row.psnr_numeric) : Json(nullptr);
    json["cycles_over_largest_bound"] = finite_json(row.over_bound);
    json["largest_bound"] = row.bound;
    json["mismatches"] = row.mismatches;
    json["same_pixels_as"] = row.same_pixels.empty() ? Json(nullptr) : Json(row.same_pixels);
    json["pixels_unlike_same_order"] = row.different_pixels;
    json["static"] = cost_json(row.cost);
    list.push_back(json);
  }
  return list;
}

std::string ladder_text(const std::vector<LadderRow>& rows) {
  const std::vector<const LadderRow*> done = complete(rows);
  std::string text;
  std::vector<std::vector<std::string>> table = {
      {"design point", "cycles", "fps@1GHz", "speed-up", "(paper)", "raster/sort", "per window", "(paper)", "bubbles",
       "exposed", "share", "MB", "roofline ratio", "bound by", "order dB", "numeric dB", "mismatches"}};
  for (const LadderRow* row : done) {
    const DesignPoint& design_point = *row->design_point;
    table.push_back({std::string(design_point.name), std::to_string(row->cycles), cell(fps(*row), 1),
                     cell(speedup(rows, *row), 2, "x"),
                     design_point.paper_speedup > 0 ? cell(design_point.paper_speedup, 2, "x") : "-",
                     cell(row->raster_over_sort, 2), cell(row->raster_over_sort_window, 2),
                     design_point.paper_ratio > 0 ? cell(design_point.paper_ratio, 2) : "-",
                     cell(100 * row->bubbles, 1, "%"), cell(row->exposed, 0),
                     cell(100 * ratio(row->exposed, static_cast<double>(row->cycles)), 1, "%"),
                     cell(megabytes(*row), 1), cell(row->over_bound, 2), row->bound, decibel(*row, row->psnr_order),
                     decibel(*row, row->psnr_numeric), std::to_string(row->mismatches)});
  }
  if (!done.empty()) text += columns(table);

  const LadderRow *base = row_of(rows, "baseline"), *hgr = row_of(rows, "tspp"), *dop = row_of(rows, "dop");
  if (hgr != nullptr && dop != nullptr) {
    text += fmt::format("  dop over tspp {} (paper: up to 1.22x)",
                        cell(ratio(static_cast<double>(hgr->cycles), static_cast<double>(dop->cycles)), 2, "x"));
    text += fmt::format("; preprocessing before the first line: {} of tspp's",
                        cell(100 * ratio(dop->exposed, hgr->exposed), 1, " %"));
    if (base != nullptr)
      text += fmt::format(", {} of the baseline's (paper: 37 % of the original)",
                          cell(100 * ratio(dop->exposed, base->exposed), 1, " %"));
    text += "\n";
  }
  for (const LadderRow* row : done) {
    if (row->different_pixels > 0) {
      text += fmt::format("  {}: {} pixels unlike another design point of the same picture\n", row->design_point->name,
                          row->different_pixels);
    } else if (!row->same_pixels.empty()) {
      text += fmt::format("  {}: same pixels as {}\n", row->design_point->name, row->same_pixels);
    }
  }

  if (!done.empty()) {
    table = {{"memory traffic, MB"}};
    std::vector<std::string> streams;
    for (const LadderRow* row : done) {
      for (const MemoryTraffic& traffic : row->traffic) {
        if (bytes(traffic) > 0 && std::find(streams.begin(), streams.end(), traffic.stream) == streams.end())
          streams.push_back(traffic.stream);
      }
    }
    table[0].insert(table[0].end(), streams.begin(), streams.end());
    table[0].insert(table[0].end(), {"alpha lines, peak of one store", "records waiting, peak"});
    for (const LadderRow* row : done) {
      std::vector<std::string> line = {std::string(row->design_point->name)};
      for (const std::string& stream : streams) {
        double sum = kNone;
        for (const MemoryTraffic& traffic : row->traffic)
          sum = traffic.stream == stream ? static_cast<double>(bytes(traffic)) / 1e6 : sum;
        line.push_back(cell(sum, 1));
      }
      line.push_back(row->has_alpha_stores
                         ? fmt::format("{} of {}", row->peak_alpha_lines, row->options.config.alpha_lines)
                         : "-");
      line.push_back(std::to_string(row->peak_records));
      table.push_back(line);
    }
    text += "\n" + columns(table);

    table = {{"built of", "row lanes", "blend lanes", "multipliers: power", "colour", "projection", "blend", "all",
              "adders: power", "colour", "projection", "blend", "all", "buffers KB"}};
    for (const LadderRow* row : done) {
      std::vector<std::string> line = {std::string(row->design_point->name), std::to_string(row->cost.row_lanes),
                                       std::to_string(row->cost.blend_lanes)};
      for (const char* kind : {"power", "color", "projection", "blend", ""})
        line.push_back(std::to_string(row->cost.multipliers(kind)));
      for (const char* kind : {"power", "color", "projection", "blend", ""})
        line.push_back(std::to_string(row->cost.adders(kind)));
      line.push_back(cell(row->cost.buffer_kb(""), 1));
      table.push_back(line);
    }
    text += "\n" + columns(table);
  }
  for (const LadderRow& row : rows) {
    if (!row.failure.empty()) text += fmt::format("  {}: not run: {}\n", row.design_point->name, row.failure);
  }
  return text;
}

std::vector<Chart> ladder_charts(const std::vector<LadderRow>& rows) {
  const std::vector<const LadderRow*> done = complete(rows);
  Chart speed{.form = Chart::Form::kBars, .title = "Speed-up over the baseline (paper: Fig. 9)", .y_label = "times"};
  Chart cycles{.form = Chart::Form::kBars, .title = "Cycles of a frame", .y_label = "cycles"};
  Chart ratios{.form = Chart::Form::kBars, .title = "Raster time over sort time (paper: Fig. 8a)", .y_label = "times"};
  Chart raster{.form = Chart::Form::kStacked, .title = "Where the RUs' cycles go", .y_label = "% of cycles"};
  Chart front{.form = Chart::Form::kBars,
              .title = "Cycles before the first line is blended (paper: Fig. 8b)",
              .y_label = "% of the frame"};
  Chart memory{.form = Chart::Form::kStacked, .title = "External memory", .y_label = "MB"};
  speed.series = {{"here", {}}, {"paper, up to", {}, true}};
  cycles.series = {{"cycles", {}}};
  ratios.series = {{"here, all cycles", {}}, {"here, mean of windows", {}}, {"paper", {}, true}};
  raster.series = {{"busy", {}}, {"starved", {}}, {"blocked", {}}, {"memory", {}}};
  front.series = {{"here", {}}};
  for (const LadderRow* row : done) {
    for (const MemoryTraffic& traffic : row->traffic) {
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
    cycles.series[0].values.push_back(static_cast<double>(row->cycles));
    ratios.series[0].values.push_back(row->raster_over_sort);
    ratios.series[1].values.push_back(row->raster_over_sort_window);
    ratios.series[2].values.push_back(row->design_point->paper_ratio > 0 ? row->design_point->paper_ratio : kNone);
    const double all = static_cast<double>(row->cycles) * row->options.config.units;
    uint64_t sums[4] = {};
    for (const UnitCycles& unit : row->ru)
      sums[0] += unit.busy, sums[1] += unit.starved, sums[2] += unit.blocked, sums[3] += unit.memory;
    for (size_t i = 0; i < 4; ++i) raster.series[i].values.push_back(100 * ratio(static_cast<double>(sums[i]), all));
    front.series[0].values.push_back(100 * ratio(row->exposed, static_cast<double>(row->cycles)));
    for (Series& series : memory.series) {
      double sum = 0;
      for (const MemoryTraffic& traffic : row->traffic)
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
