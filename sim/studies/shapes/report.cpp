// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/shapes/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/design/design_point.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// The entries in which a shape differs from the base.
std::string shape_name(const Shape& shape, const Config& base) {
  std::string text;
  for (const ConfigEntry& entry : config_entries(shape.config)) {
    if (entry.member == nullptr || base.*entry.member == entry.value) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", entry.name, entry.value);
  }
  return text.empty() ? "base" : text;
}

const char* step_name(const Shape& shape) {
  if (shape.step == Shape::Step::kBase) return "base";
  return shape.step == Shape::Step::kAlone ? "alone" : "together";
}

std::string shape_area(const Shape& shape) { return interpolated_text(shape.mm2(), shape.cost.extrapolated_area, 3); }
double fps_per_mm2(const Shape& shape) { return 1e6 / shape.us() / shape.mm2(); }
double frames_per_joule(const Shape& shape) { return 1 / shape.cost.joules(); }

std::vector<TableCell> shape_row(const Shape& shape, const std::string& name, double mm2) {
  const FrameCost& cost = shape.cost;
  const auto interpolated = [](double value, bool extrapolated) { return number_cell(value, extrapolated ? "~" : ""); };
  return {text_cell(name),
          number_cell(static_cast<double>(shape.frame.cycles)),
          number_cell(static_cast<double>(shape.frame.bytes) / 1e6),
          cost.ghz() ? interpolated(*cost.ghz(), cost.extrapolated_path) : text_cell("-"),
          interpolated(cost.us, cost.extrapolated_path),
          interpolated(shape.mm2(), cost.extrapolated_area),
          number_cell(fps_per_mm2(shape)),
          interpolated(frames_per_joule(shape), cost.extrapolated_energy),
          text_cell(shape.mm2() <= mm2 ? "yes" : ""),
          shape.front > 0 ? number_cell(static_cast<double>(shape.front)) : TableCell{}};
}

std::string best_shape_text(const std::vector<Shape>& shapes, double mm2) {
  const Shape* best = best_within(shapes, mm2);
  if (best == nullptr) return fmt::format("no shape that was measured fits {:g} mm2", mm2);
  return fmt::format("best within {:g} mm2: {}: {} cycles, {:.1f} us, {} mm2", mm2,
                     shape_name(*best, shapes.front().config), best->frame.cycles, best->us(), shape_area(*best));
}

Json shape_json(const Shape& shape, const Config& base, double mm2) {
  const FrameCost& cost = shape.cost;
  return {{"shape", shape_name(shape, base)},
          {"configuration", config_difference(shape.config)},
          {"step", step_name(shape)},
          {"cycles", shape.frame.cycles},
          {"bytes", shape.frame.bytes},
          {"path_ps", cost.path_fo4 ? to_json(kFo4Ps * *cost.path_fo4) : Json(nullptr)},
          {"ghz", cost.ghz() ? Json(*cost.ghz()) : Json(nullptr)},
          {"us", cost.us},
          {"mm2", to_json(cost.mm2)},
          {"extrapolated_area", cost.extrapolated_area},
          {"extrapolated_path", cost.extrapolated_path},
          {"extrapolated_energy", cost.extrapolated_energy},
          {"fps_per_mm2", fps_per_mm2(shape)},
          {"frames_per_joule_with_dram", frames_per_joule(shape)},
          {"within", shape.mm2() <= mm2},
          {"front", shape.front > 0 ? Json(shape.front) : Json(nullptr)}};
}

}  // namespace

std::vector<Table> shapes_tables(const std::vector<Shape>& shapes, double mm2) {
  const Config& base = shapes.front().config;
  const auto empty = [](const char* heading) {
    return Table{.columns = {{.key = "shape", .heading = heading, .word = true},
                             {.key = "cycles", .heading = "cycles"},
                             {.key = "megabytes", .unit = "MB", .digits = 1},
                             {.key = "ghz", .unit = "GHz", .digits = 3},
                             {.key = "us", .unit = "us", .digits = 1},
                             {.key = "mm2", .unit = "mm2", .digits = 3},
                             {.key = "fps_per_mm2", .unit = "frames/s/mm2", .digits = 1},
                             {.key = "frames_per_joule", .unit = "frames/J"},
                             {.key = "within", .heading = "fits"},
                             {.key = "front", .heading = "front"}}};
  };
  Table all = empty("shape"), front = empty("front");
  for (const Shape& shape : shapes) all.rows.push_back(shape_row(shape, shape_name(shape, base), mm2));
  for (const Shape* shape : front_of(shapes)) front.rows.push_back(shape_row(*shape, shape_name(*shape, base), mm2));
  Table read;  // how to read both
  read.notes = {
      "mm2, frames/J: 28 nm, mid, with SRAMs and DRAM, interpolated (docs/numerics/accuracy.md); ~: beyond what was "
      "synthesised or measured;",
      fmt::format("fits: at most {:g} mm2; front: places of those that no other one beats in both us and mm2", mm2),
      shapes.front().cost.path_fo4 ? "GHz: what the longest path allows, interpolated; us: cycles / GHz"
                                   : "GHz: no longest path of such a machine is known, so us count at 1 GHz",
      best_shape_text(shapes, mm2)};
  return {all, front, read};
}

Json shapes_json(const std::vector<Shape>& shapes, double mm2) {
  const Config& base = shapes.front().config;
  Json json = {{"mm2", mm2},
               {"clock_known", shapes.front().cost.path_fo4.has_value()},
               {"shapes", Json::array()},
               {"front", Json::array()},
               {"best", nullptr}};
  for (const Shape& shape : shapes) json["shapes"].push_back(shape_json(shape, base, mm2));
  for (const Shape* shape : front_of(shapes)) json["front"].push_back(shape_name(*shape, base));
  if (const Shape* best = best_within(shapes, mm2)) json["best"] = shape_name(*best, base);
  return json;
}

Chart shapes_chart(const std::string& title, const std::vector<Shape>& shapes) {
  Chart chart{.name = "time_by_area",
              .form = Chart::Form::kScatter,
              .title = title,
              .x_label = "mm2 in 28 nm, mid, interpolated",
              .y_label = shapes.front().cost.path_fo4 ? "us of a frame" : "us of a frame at 1 GHz"};
  const auto add = [&](Series& series, const Shape& shape) {
    series.x.push_back(shape.mm2());
    series.values.push_back(shape.us());
    series.labels.push_back(shape_name(shape, shapes.front().config));
    series.copies.push_back(machine_words(shape.config));
  };
  Series alone{.name = "one entry"}, together{.name = "together"}, base{.name = "base"},
      front{.name = "front", .outlined = true};
  add(base, shapes.front());
  for (const Shape& shape : shapes) {
    if (shape.step == Shape::Step::kAlone) add(alone, shape);
    if (shape.step == Shape::Step::kTogether) add(together, shape);
  }
  for (const Shape* shape : front_of(shapes)) add(front, *shape);
  chart.series = {alone, together, base, front};
  return chart;
}

}  // namespace pipegs
