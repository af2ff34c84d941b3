// SPDX-License-Identifier: Apache-2.0
// report_page.cpp: see report_page.hpp.
#include "sim/command/report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "sim/report/html/pictures.hpp"

namespace pipegs {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kMostBars = 16;  // more results are a line

TableCell count(std::optional<uint64_t> value) {
  if (!value) return {.text = "not run"};
  return {.text = std::to_string(*value), .value = static_cast<double>(*value)};
}
TableCell real(std::optional<double> value, int digits) {
  if (!value) return {.text = "-"};
  return {.text = fmt::format("{:.{}f}", *value, digits), .value = *value};
}
TableCell mb(std::optional<uint64_t> bytes) {
  return real(bytes ? std::optional(1e-6 * static_cast<double>(*bytes)) : std::nullopt, 2);
}

std::vector<TableColumn> columns(std::initializer_list<const char*> words, std::initializer_list<const char*> numbers) {
  std::vector<TableColumn> all;
  for (const char* name : words) all.push_back({.heading = name, .word = true});
  for (const char* name : numbers) all.push_back({.heading = name});
  return all;
}

std::string picture_id(const char* kind, size_t at) { return fmt::format("{}-{}", kind, at); }

Table frames_table(const std::vector<FrameResult>& frames) {
  Table table{.title = "Frames"};
  table.columns = columns({"result", "scene", "camera", "pixels", "memory"},
                          {"Gaussians", "cycles", "frames/s at 1 GHz", "MB read", "MB written", "numeric dB",
                           "order dB", "total dB", "mismatches"});
  table.columns.push_back({.heading = "machine", .word = true, .wrapped = true, .copies = true});
  for (size_t i = 0; i < frames.size(); ++i) {
    const FrameResult& one = frames[i];
    const bool timed = one.cycles && *one.cycles > 0;
    table.rows.push_back({{.text = one.name, .link = one.picture ? picture_id("frame", i) : ""},
                          {.text = one.scene},
                          {.text = one.camera},
                          {.text = fmt::format("{}x{}", one.width, one.height)},
                          {.text = one.memory},
                          count(one.gaussians),
                          count(one.cycles),
                          real(timed ? std::optional(1e9 / static_cast<double>(*one.cycles)) : std::nullopt, 1),
                          mb(one.bytes_read),
                          mb(one.bytes_written),
                          real(one.numeric_db, 2),
                          real(one.order_db, 2),
                          real(one.total_db, 2),
                          count(one.mismatches),
                          {.text = one.settings}});
  }
  return table;
}

// A chart over all frames: bars, or lines where they are many.
Chart over_frames(const std::vector<FrameResult>& frames, const char* title, const char* unit) {
  Chart chart{.form = Chart::Form::kBars, .title = title, .x_label = "", .y_label = unit};
  if (frames.size() > kMostBars) {
    chart.form = Chart::Form::kLines;
    for (size_t i = 0; i < frames.size(); ++i) chart.x.push_back(static_cast<double>(i));
  }
  for (const FrameResult& one : frames) chart.categories.push_back(one.name);
  return chart;
}

void add_series(Chart& chart, const std::vector<FrameResult>& frames, const std::string& name,
                const std::function<double(const FrameResult&)>& value) {
  Series series{.name = name};
  bool any = false;
  for (const FrameResult& one : frames) {
    series.values.push_back(value(one));
    any = any || series.values.back() == series.values.back();
  }
  if (any) chart.series.push_back(std::move(series));
}

double or_none(const std::optional<double>& value) { return value.value_or(kNone); }

void add_frames(StudyPage& page, const std::vector<FrameResult>& frames) {
  page.section("Frames");
  page.table(frames_table(frames));
  std::vector<Chart> charts = {over_frames(frames, "Cycles of a frame", "cycles")};
  add_series(charts.back(), frames, "cycles",
             [](const FrameResult& one) { return one.cycles ? static_cast<double>(*one.cycles) : kNone; });
  charts.push_back(over_frames(frames, "PSNR", "dB"));
  charts.back().from_zero = false;
  add_series(charts.back(), frames, "numeric", [](const FrameResult& one) { return or_none(one.numeric_db); });
  add_series(charts.back(), frames, "order", [](const FrameResult& one) { return or_none(one.order_db); });
  add_series(charts.back(), frames, "total", [](const FrameResult& one) { return or_none(one.total_db); });
  std::erase_if(charts, [](const Chart& chart) { return chart.series.empty(); });
  page.charts(charts);
}

Table walk_table(const WalkResult& walk) {
  Table table{.title = walk.name};
  table.columns = columns({"camera"}, {"frame", "view", "cycles", "queued", "mismatches", "MB read", "MB written", "us",
                                       "chip uJ", "DRAM uJ"});
  for (size_t i = 0; i < walk.frames.size(); ++i) {
    const WalkFrame& one = walk.frames[i];
    table.rows.push_back({{.text = one.camera},
                          count(i),
                          field_cell(one.view),
                          count(one.cycles),
                          count(one.queued),
                          count(one.mismatches),
                          mb(one.bytes_read),
                          mb(one.bytes_written),
                          real(one.us, 1),
                          real(one.chip_uj, 1),
                          real(one.dram_uj, 1)});
  }
  if (!walk.scene.empty()) table.notes.push_back(fmt::format("{}, memory {}", walk.scene, walk.memory));
  if (!walk.configuration.empty()) table.notes.push_back(walk.configuration);
  return table;
}

Chart walk_chart(const WalkResult& walk) {
  Chart chart{.form = Chart::Form::kLines,
              .title = fmt::format("{}: cycles of each frame", walk.name),
              .x_label = "frame",
              .y_label = "cycles"};
  Series alone{.name = "alone"}, queued{.name = "queued"};
  for (size_t i = 0; i < walk.frames.size(); ++i) {
    chart.x.push_back(static_cast<double>(i));
    alone.values.push_back(static_cast<double>(walk.frames[i].cycles));
    queued.values.push_back(walk.frames[i].queued ? static_cast<double>(*walk.frames[i].queued) : kNone);
  }
  chart.series = {alone};
  if (walk.frames.front().queued) chart.series.push_back(queued);
  return chart;
}

Table trained_table(const std::vector<TrainResult>& trained) {
  Table table{.title = ""};
  table.columns = columns({"result", "input", "held out, drawn by"},
                          {"steps", "Gaussians", "minutes", "dB", "SSIM", "cycles a frame"});
  for (const TrainResult& one : trained) {
    for (const TrainedBy& by : one.held_out) {
      table.rows.push_back({{.text = one.name},
                            {.text = one.input},
                            {.text = by.who},
                            count(one.steps),
                            count(one.gaussians),
                            real(one.minutes, 1),
                            real(by.psnr, 2),
                            real(by.ssim, 4),
                            by.cycles ? count(by.cycles) : TableCell{.text = "-"}});
    }
  }
  return table;
}

void add_pictures(StudyPage& page, const FolderResults& results) {
  std::vector<NamedPicture> pictures;
  for (size_t i = 0; i < results.frames.size(); ++i) {
    if (results.frames[i].picture)
      pictures.push_back({results.frames[i].name, picture_id("frame", i), &*results.frames[i].picture});
  }
  for (size_t i = 0; i < results.walks.size(); ++i) {
    if (results.walks[i].picture)
      pictures.push_back({results.walks[i].name + ", first frame", picture_id("walk", i), &*results.walks[i].picture});
  }
  if (pictures.empty()) return;
  page.section("Pictures");
  for (const SmallPicture& one : small_pictures(pictures)) page.picture(one.caption, one.png, one.id);
}

}  // namespace

void add_results(StudyPage& page, const FolderResults& results) {
  page.lead(
      fmt::format("{} results: {} frames, {} sequences of frames, {} trained scenes.{}", results.count(),
                  results.frames.size(), results.walks.size(), results.trained.size(),
                  results.left_out.empty() ? "" : fmt::format(" {} files are left out.", results.left_out.size())));
  if (!results.frames.empty()) add_frames(page, results.frames);
  if (!results.walks.empty()) page.section("Sequences of frames");
  for (const WalkResult& walk : results.walks) page.charts({walk_chart(walk)}), page.table(walk_table(walk));
  if (!results.trained.empty()) page.section("Trained scenes"), page.table(trained_table(results.trained));
  add_pictures(page, results);
  if (results.left_out.empty()) return;
  page.section("Left out");
  Table table{.title = "",
              .columns = {{.heading = "file", .word = true, .wrapped = true},
                          {.heading = "why", .word = true, .wrapped = true}}};
  for (const LeftOut& one : results.left_out) table.rows.push_back({{.text = one.file}, {.text = one.reason}});
  page.table(table);
}

}  // namespace pipegs
