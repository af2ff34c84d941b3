// SPDX-License-Identifier: Apache-2.0
// frame_table.cpp: see frame_table.hpp.
#include "sim/command/sequence/frame_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "scenes/percentile.hpp"
#include "sim/command/sequence/gaze_table.hpp"
#include "sim/design/design_point.hpp"
#include "sim/report/finite.hpp"
#include "sim/report/table.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kShown = 24;  // frames of which the text has a line each

struct Quantity {
  const char *key, *name;
  int digits;
  std::function<double(const FrameRow&)> of;
};

const Quantity kCycles = {"cycles", "cycles", 0, [](const FrameRow& row) { return static_cast<double>(row.cycles); }};
const Quantity kBytes = {"megabytes", "MB", 1, [](const FrameRow& row) {
                           return 1e-6 * static_cast<double>(row.bytes.read + row.bytes.written);
                         }};
const Quantity kTime = {"us", "us", 0, [](const FrameRow& row) { return row.cost->us; }};
const Quantity kChip = {"chip_uj", "uJ, chip", 0, [](const FrameRow& row) { return 1e6 * row.cost->chip.mid; }};
const Quantity kDram = {"dram_uj", "uJ, DRAM", 0, [](const FrameRow& row) { return 1e6 * row.cost->dram.mid; }};

std::vector<Quantity> quantities(const FrameTable& table) {
  if (!table.priced()) return {kCycles, kBytes};
  return {kCycles, kTime, kBytes, kChip, kDram};
}

std::vector<double> values(const FrameTable& table, const Quantity& quantity) {
  std::vector<double> all;
  for (const FrameRow& row : table.rows) all.push_back(quantity.of(row));
  return all;
}

struct Rank {
  const char *key, *name;
  double percent;
};
constexpr Rank kMedian = {"median", "median", 50}, kTail = {"p99", "99 %", 99};
const Rank kRanks[] = {kMedian, {"p90", "90 %", 90}, kTail, {"max", "max", 100}};

// A percentile, and the frame that has it.
struct Ranked {
  size_t frame;
  double value;
};

Ranked ranked(const FrameTable& table, const Quantity& quantity, const Rank& rank) {
  const std::vector<double> all = values(table, quantity);
  std::vector<size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return all[a] < all[b]; });
  const size_t frame = order[nearest_rank(all.size(), rank.percent / 100)];
  return {frame, all[frame]};
}

// A number of a view as JSON: whole where it is.
Json view_json(double view) {
  if (view == std::floor(view)) return static_cast<int>(view);
  return view;
}

TableCell cell(const std::optional<uint64_t>& value) {
  return value ? number_cell(static_cast<double>(*value)) : TableCell{};
}
TableCell cell(const Quantity& quantity, const FrameRow& row) {
  return row.cost ? number_cell(quantity.of(row)) : TableCell{};
}

std::vector<double> given_up(const FrameTable& table, std::optional<double> FrameRow::*field) {
  std::vector<double> all;
  for (const FrameRow& row : table.rows) all.push_back((row.*field).value_or(0));
  return all;
}

std::vector<Quality> qualities(const FrameTable& table) {
  std::vector<Quality> all;
  for (const FrameRow& row : table.rows) all.push_back(row.quality);
  return all;
}

// A row for each frame, all that is known of it.
Table frames_table(const FrameTable& table) {
  Table frames{.columns = {{.key = "frame", .heading = "frame"},
                           {.key = "view", .heading = "view"},
                           {.key = "camera", .heading = "camera", .word = true},
                           {.key = "width", .heading = "width"},
                           {.key = "height", .heading = "height"},
                           {.key = "sample", .heading = "sample, pixels"},
                           {.key = "rest", .heading = "rest", .digits = 4},
                           {.key = "lod_pixels", .heading = "lod, pixels", .digits = 2},
                           {.key = "cycles", .heading = "cycles"},
                           {.key = "gap_alone", .heading = "gap"},
                           {.key = "cycles_queued", .heading = "queued"},
                           {.key = "gap_queued", .heading = "gap"},
                           {.key = "mismatches", .heading = "mismatches"},
                           {.key = "bytes_read", .heading = "read, bytes"},
                           {.key = "bytes_written", .heading = "written"},
                           {.key = "us", .heading = "us", .digits = 1},
                           {.key = "chip_uj", .heading = "uJ, chip", .digits = 1},
                           {.key = "dram_uj", .heading = "uJ, DRAM", .digits = 1},
                           {.key = "steady_db", .heading = "dB to the frame before", .digits = 2}}};
  const std::vector<Quality> quality = qualities(table);
  add_columns(frames, quality);
  for (size_t i = 0; i < table.rows.size(); ++i) {
    const FrameRow& row = table.rows[i];
    frames.rows.push_back({cell(i), view_cell(row.view), text_cell(row.camera.name), number_cell(row.camera.width),
                           number_cell(row.camera.height), row.sample ? number_cell(*row.sample) : TableCell{},
                           row.rest ? number_cell(*row.rest) : TableCell{},
                           row.lod_pixels ? number_cell(*row.lod_pixels) : TableCell{}, cell(row.cycles),
                           cell(row.gap_alone), cell(row.cycles_queued), cell(row.gap_queued), cell(row.mismatches),
                           cell(row.bytes.read), cell(row.bytes.written), cell(kTime, row), cell(kChip, row),
                           cell(kDram, row), row.steady ? number_cell(*row.steady) : TableCell{}});
    add_cells(frames.rows.back(), quality, i);
  }
  return frames;
}

Table percentiles_table(const FrameTable& table) {
  Table ranks{.columns = {{.word = true}}};
  for (const Rank& rank : kRanks) ranks.columns.push_back({.heading = rank.name});
  const auto add = [&](const std::string& name, const std::function<std::string(const Rank&)>& shown) {
    std::vector<TableCell>& row = ranks.rows.emplace_back();
    row.push_back(text_cell(name));
    for (const Rank& rank : kRanks) row.push_back(text_cell(shown(rank)));
  };
  for (const Quantity& quantity : quantities(table))
    add(quantity.name,
        [&](const Rank& rank) { return fmt::format("{:.{}f}", ranked(table, quantity, rank).value, quantity.digits); });
  add("frame", [&](const Rank& rank) { return fmt::to_string(ranked(table, kCycles, rank).frame); });  // of the cycles
  ranks.notes.push_back(fmt::format("the 99th percentile takes {:.2f} times the cycles of the median",
                                    ranked(table, kCycles, kTail).value / ranked(table, kCycles, kMedian).value));
  return ranks;
}

uint64_t sum(const FrameTable& table, const std::function<uint64_t(const FrameRow&)>& of) {
  uint64_t all = 0;
  for (const FrameRow& row : table.rows) all += of(row);
  return all;
}

uint64_t alone(const FrameTable& table) {
  return sum(table, [](const FrameRow& row) { return row.cycles; });
}
uint64_t queued(const FrameTable& table) {
  return sum(table, [](const FrameRow& row) { return *row.cycles_queued; });
}

Chart over_frames(const std::string& name, const std::string& title, const std::string& unit,
                  std::vector<Series> series) {
  Chart chart{.name = name, .form = Chart::Form::kLines, .title = title, .x_label = "frame", .y_label = unit};
  for (size_t i = 0; i < series[0].values.size(); ++i) chart.x.push_back(static_cast<double>(i));
  chart.series = std::move(series);
  return chart;
}

}  // namespace

std::vector<FrameRow> views_of(const std::vector<Camera>& cameras, const std::vector<int>& views) {
  const auto all = static_cast<int>(cameras.size());
  const int first = views.empty() ? 0 : views[0], last = views.empty() || views[1] < 0 ? all - 1 : views[1];
  if (last >= all) throw ConfigError(fmt::format("--views: found {}, expected 0 to {}", last, all - 1));
  std::vector<FrameRow> rows;
  for (int view = first; view <= last; ++view)
    rows.push_back({.view = static_cast<double>(view), .camera = cameras[static_cast<size_t>(view)]});
  return rows;
}

std::vector<Camera> cameras_of(const std::vector<FrameRow>& rows) {
  std::vector<Camera> cameras;
  for (const FrameRow& row : rows) cameras.push_back(row.camera);
  return cameras;
}

TableCell view_cell(double view) { return {.text = fmt::format("{:.6g}", view), .value = view}; }

std::string frames_csv(const FrameTable& table) { return table_csv(frames_table(table)); }

Json to_json(const FrameTable& table) {
  Json json = {{"scene", table.scene}, {"configuration", config_difference(table.config)}, {"memory", table.memory}};
  for (const FrameRow& row : table.rows) {
    Json one = {{"view", view_json(row.view)},
                {"camera", row.camera.name},
                {"width", row.camera.width},
                {"height", row.camera.height}};
    if (row.sample) one["sample"] = *row.sample;
    if (row.rest) one["rest"] = *row.rest;
    if (row.lod_pixels) one["lod_pixels"] = *row.lod_pixels;
    if (row.steady) one["steady_db"] = finite_json(*row.steady);
    if (row.mismatches) one["mismatches"] = *row.mismatches;
    if (row.cycles_queued) one["cycles_queued"] = *row.cycles_queued;
    one["cycles_alone"] = row.cycles;
    if (row.gap_queued) one["gap_queued"] = *row.gap_queued;
    if (row.gap_alone) one["gap_alone"] = *row.gap_alone;
    one["bytes_read"] = row.bytes.read;
    one["bytes_written"] = row.bytes.written;
    if (row.cost) one["us"] = kTime.of(row), one["chip_uj"] = kChip.of(row), one["dram_uj"] = kDram.of(row);
    add_view(one, row.quality);
    json["views"].push_back(one);
  }
  if (table.rtl()) json["cycles_queued"] = queued(table);
  json["cycles_alone"] = alone(table);
  if (!table.gaze.empty()) json["gaze"] = gaze_json(table);
  for (const Quantity& quantity : quantities(table)) {
    for (const Rank& rank : kRanks) {
      const Ranked one = ranked(table, quantity, rank);
      json["percentiles"][quantity.key][rank.key] = {{"value", one.value}, {"frame", one.frame}};
    }
  }
  add_summary(json, qualities(table));
  json["energy_extrapolated"] = table.priced() ? Json(table.rows[0].cost->extrapolated_energy) : Json(nullptr);
  json["charts"] = charts_json(frame_charts(table));
  return json;
}

std::string head_of(const FrameTable& table) {
  return fmt::format("{}: {} frames, {}, memory {}; {}", table.scene, table.rows.size(), machine_name(table.config),
                     table.memory,
                     table.rtl() ? "the RTL, each frame alone and queued behind the one before"
                                 : "the timing model, each frame alone; no RTL, nothing compared");
}

std::vector<Table> frame_tables(const FrameTable& table, bool all) {
  std::vector<Table> tables = summary_tables(qualities(table));
  for (const Table& one : gaze_tables(table)) tables.push_back(one);
  tables.insert(tables.begin(), percentiles_table(table));
  if (all || table.rows.size() <= kShown) tables.insert(tables.begin(), frames_table(table));
  return tables;
}

std::string to_text(const FrameTable& table) {
  std::string text = fmt::format("{}\n\n{}", head_of(table), tables_text(frame_tables(table, false)));
  if (!table.priced()) text += "  time and energy: not known of this machine\n";
  else if (table.rows[0].cost->extrapolated_energy)
    text += "  energy is extrapolated: no frame of this machine was measured\n";
  if (table.priced()) text += "  energy is not validated\n";
  if (table.rtl())
    text += fmt::format("  queued {} cycles, alone {}: queued saves {:.1f} %\n", queued(table), alone(table),
                        100 - 100 * static_cast<double>(queued(table)) / static_cast<double>(alone(table)));
  return text;
}

std::vector<Chart> frame_charts(const FrameTable& table) {
  std::vector<Series> cycles = {{.name = "alone", .values = values(table, kCycles)}}, bytes, energy;
  if (table.rtl()) {
    cycles.push_back({.name = "queued", .values = {}});
    for (const FrameRow& row : table.rows) cycles.back().values.push_back(static_cast<double>(*row.cycles_queued));
  }
  bytes = {{.name = "read", .values = {}}, {.name = "written", .values = {}}};
  for (const FrameRow& row : table.rows) {
    bytes[0].values.push_back(1e-6 * static_cast<double>(row.bytes.read));
    bytes[1].values.push_back(1e-6 * static_cast<double>(row.bytes.written));
  }
  std::vector<Chart> charts = {over_frames("cycles", "Cycles of each frame", "cycles", cycles),
                               over_frames("bytes", "Bytes of each frame", "MB", bytes)};
  if (table.priced())
    charts.push_back(over_frames(
        "energy", "Energy of each frame, 28 nm", "uJ",
        {{.name = "chip", .values = values(table, kChip)}, {.name = "DRAM", .values = values(table, kDram)}}));
  if (table.rows[0].lod_pixels)
    charts.push_back(over_frames("lod", "Level of detail of each frame", "pixels",
                                 {{.name = "lod_pixels", .values = given_up(table, &FrameRow::lod_pixels)}}));
  if (table.rows[0].rest)
    charts.push_back(over_frames("rest", "Transmittance below which a pixel's next Gaussian is its last", "",
                                 {{.name = "rest", .values = given_up(table, &FrameRow::rest)}}));
  for (const Chart& chart : quality_charts(qualities(table))) charts.push_back(chart);
  charts.push_back(histogram("frames_by_cycles", "How many frames take so many cycles", "cycles",
                             values(table, kCycles),
                             static_cast<int>(std::clamp<size_t>(table.rows.size() / 4, 2, 40))));
  return charts;
}

}  // namespace pipegs
