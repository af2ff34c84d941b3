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

std::string shape_row(const Shape& shape, const std::string& name, size_t width, double mm2) {
  const FrameCost& cost = shape.cost;
  return fmt::format("  {:<{}}{:>10}{:>8.1f}{:>8}{:>10}{:>9}{:>14.1f}{:>10}{:>6}{:>7}\n", name, width,
                     shape.frame.cycles, static_cast<double>(shape.frame.bytes) / 1e6,
                     cost.ghz() ? interpolated_text(*cost.ghz(), cost.extrapolated_path, 3) : "-",
                     interpolated_text(cost.us, cost.extrapolated_path, 1), shape_area(shape), fps_per_mm2(shape),
                     interpolated_text(frames_per_joule(shape), cost.extrapolated_energy, 0),
                     shape.mm2() <= mm2 ? "yes" : "", shape.front > 0 ? std::to_string(shape.front) : "");
}

std::string best_shape_text(const std::vector<Shape>& shapes, double mm2) {
  const Shape* best = best_within(shapes, mm2);
  if (best == nullptr) return fmt::format("  no shape that was measured fits {:g} mm2\n", mm2);
  return fmt::format("  best within {:g} mm2: {}: {} cycles, {:.1f} us, {} mm2\n", mm2,
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

std::string shapes_text(const std::vector<Shape>& shapes, double mm2) {
  const Config& base = shapes.front().config;
  size_t width = 8;
  for (const Shape& shape : shapes) width = std::max(width, shape_name(shape, base).size() + 2);
  const auto head = [&](const char* title) {
    return fmt::format("  {:<{}}{:>10}{:>8}{:>8}{:>10}{:>9}{:>14}{:>10}{:>6}{:>7}\n", title, width, "cycles", "MB",
                       "GHz", "us", "mm2", "frames/s/mm2", "frames/J", "fits", "front");
  };
  std::string text = head("shape");
  for (const Shape& shape : shapes) text += shape_row(shape, shape_name(shape, base), width, mm2);
  text += "\n" + head("front");
  for (const Shape* shape : front_of(shapes)) text += shape_row(*shape, shape_name(*shape, base), width, mm2);
  text += fmt::format(
      "\n  mm2, frames/J: 28 nm, mid, with SRAMs and DRAM, interpolated (docs/numerics/accuracy.md); ~: beyond what "
      "was "
      "synthesised or measured;\n  fits: at most {:g} mm2; front: places of those that no other one beats in both us "
      "and mm2\n",
      mm2);
  text += shapes.front().cost.path_fo4 ? "  GHz: what the longest path allows, interpolated; us: cycles / GHz\n"
                                       : "  GHz: no longest path of such a machine is known, so us count at 1 GHz\n";
  return text + best_shape_text(shapes, mm2);
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
  Chart chart{.form = Chart::Form::kScatter,
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
