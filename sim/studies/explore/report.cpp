// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/explore/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/design/design_point.hpp"
#include "sim/report/finite.hpp"
#include "sim/silicon/report.hpp"
#include "sim/studies/explore/shapes.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

// How the energy of a frame is written.
struct EnergyUnit {
  std::string key, name;
  double of_joule;
  int digits;
};
const EnergyUnit kMillijoules = {"mj", "mJ", 1e3, 2}, kMicrojoules = {"uj", "uJ", 1e6, 0};

// How points stand in a table.
struct Columns {
  Measured measured = Measured::kCycles;
  const EnergyUnit* energy = &kMillijoules;
  double ghz = 0;  // of the microseconds; 0: the clock of each machine, 1 GHz where it is not known
  double mm2 = 0;  // the wanted area; 0: none
};

double us_of(const Point& point, double ghz) {
  if (ghz > 0) return point.cycles() / 1000 / ghz;
  return point.silicon ? point.silicon->us : std::nan("");
}
double fps_per_mm2(const Point& point) { return 1e6 / us_of(point, 0) / point.mm2(); }
double frames_per_joule(const Point& point) { return 1 / point.joules(); }

// "65.20", "inf"
std::string decibels(double psnr) { return std::isfinite(psnr) ? fmt::format("{:.2f}", psnr) : "inf"; }

// The entries in which a configuration differs from the base, "base" if in none.
std::string difference(const Config& config, const Config& base) {
  std::string text;
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member == nullptr || base.*entry.member == entry.value) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", entry.name, entry.value);
  }
  return text.empty() ? "base" : text;
}

// The options that say what less is drawn, each after a blank: what a machine's frame is told.
std::string frame_words(const Less& less) {
  std::string words;
  if (less.rest != 0) words += fmt::format(" --rest {:g}", less.rest);
  if (less.lod != 0) words += fmt::format(" --lod-pixels {:g}", less.lod);
  return words;
}

std::string difference(const Point& point, const Config& base) {
  return difference(point.config, base) + frame_words(point.value.less);
}

// As every command takes it.
std::string words_of(const Point& point) { return machine_words(point.config) + frame_words(point.value.less); }

// One point in a line: its errors, what it costs, and how it differs from the base.
std::string point_text(const Point& point, const Config& base) {
  const Figures& a = point.figures;
  std::string text =
      fmt::format("{} dB numeric, {} dB order, {} cycles, {:.1f} MB, {:.1f} KB of buffers", decibels(a.numeric.psnr),
                  decibels(a.order.psnr), a.cycles, point.bytes() / 1e6, a.buffer_kb());
  if (point.silicon) {
    text += fmt::format(", {} mm2, {} mJ", interpolated_text(point.mm2(), point.silicon->extrapolated_area, 2),
                        interpolated_text(point.joules() * 1e3, point.silicon->extrapolated_energy, 2));
  }
  return fmt::format("{}: {}", text, difference(point, base));
}

// What is not known is empty.
TableCell known(double value, bool extrapolated = false) {
  return std::isnan(value) ? TableCell{} : number_cell(value, extrapolated ? "~" : "");
}

// Its name, and on what it stands.
struct PointRow {
  std::string over;
  const Point* point;
};

std::vector<TableCell> cells_of(const PointRow& row, const Point& base, const Columns& columns) {
  const Point& point = *row.point;
  const Figures& f = point.figures;
  const FrameCost cost = point.silicon.value_or(FrameCost{});
  const double none = std::nan("");
  const bool picture = columns.measured != Measured::kCycles, errors = columns.measured == Measured::kErrors;
  const bool is_base = point.knob != kBase && point.config == base.config && point.value.less == base.value.less;
  const bool areas = columns.mm2 > 0, clock = point.clock_known() && columns.ghz == 0;
  return {text_cell(row.over),
          text_cell(point.knob),
          text_cell(point.value.label + (is_base ? " *" : "")),
          known(errors ? f.numeric.psnr : none),
          known(errors ? f.order.psnr : none),
          known(picture ? f.total.psnr : none),
          known(picture ? f.total.ssim : none),
          known(errors ? f.numeric.max : none),
          known(errors ? f.numeric.p999 : none),
          known(point.cycles()),
          known(100 * point.cycles() / base.cycles()),
          known(clock ? *cost.ghz() : none, cost.extrapolated_path),
          known(us_of(point, columns.ghz), columns.ghz == 0 && cost.extrapolated_path),
          known(point.bytes() / 1e6),
          known(errors ? f.gbps() : none),
          known(f.buffer_kb()),
          known(point.mm2(), cost.extrapolated_area),
          known(point.joules() * columns.energy->of_joule, cost.extrapolated_energy),
          known(areas ? fps_per_mm2(point) : none),
          known(areas ? frames_per_joule(point) : none, cost.extrapolated_energy),
          text_cell(areas && point.mm2() <= columns.mm2 ? "yes" : ""),
          known(point.front > 0 ? point.front : none),
          {.text = difference(point, base.config), .copy = words_of(point)}};
}

Table points_table(const std::string& title, const std::vector<PointRow>& rows, const Point& base,
                   const Columns& columns) {
  Table table{
      .title = title,
      .columns = {{.key = "over", .heading = "front over", .word = true},
                  {.key = "knob", .heading = "knob", .word = true},
                  {.key = "value", .heading = "value", .word = true},
                  {.key = "numeric_db", .heading = "numeric", .unit = "dB", .digits = 2},
                  {.key = "order_db", .heading = "order", .unit = "dB", .digits = 2},
                  {.key = "total_db", .heading = "total", .unit = "dB", .digits = 2},
                  {.key = "ssim", .heading = "SSIM", .digits = 5},
                  {.key = "max", .heading = "max", .digits = 4},
                  {.key = "p999", .heading = "99.9 %", .digits = 4},
                  {.key = "cycles", .heading = "cycles"},
                  {.key = "of_base", .heading = "of base", .unit = "%", .digits = 2},
                  {.key = "ghz", .unit = "GHz", .digits = 3},
                  {.key = "us", .unit = "us", .digits = 1},
                  {.key = "megabytes", .unit = "MB", .digits = 1},
                  {.key = "gbps", .unit = "GB/s", .digits = 1},
                  {.key = "buffers_kb", .heading = "buffers", .unit = "KB", .digits = 1},
                  {.key = "mm2", .unit = "mm2", .digits = 3},
                  {.key = columns.energy->key, .unit = columns.energy->name, .digits = columns.energy->digits},
                  {.key = "fps_per_mm2", .unit = "frames/s/mm2", .digits = 1},
                  {.key = "frames_per_joule", .unit = "frames/J"},
                  {.key = "within", .heading = "fits"},
                  {.key = "front", .heading = "front"},
                  {.key = "configuration", .heading = "configuration", .word = true, .wrapped = true, .copies = true}}};
  for (const PointRow& row : rows) {
    const Point& point = *row.point;
    if (point.figures.failure.empty()) table.rows.push_back(cells_of(row, base, columns));
    else table.notes.push_back(fmt::format("{} {}: {}", point.knob, point.value.label, point.figures.failure));
  }
  return table;
}

std::vector<PointRow> rows_of(const std::vector<Point>& points) {
  std::vector<PointRow> rows;
  for (const Point& point : points) rows.push_back({"", &point});
  return rows;
}

// How to read a table of points.
Table legend(const Point& base, std::vector<std::string> notes, const EnergyUnit& energy = kMillijoules) {
  if (base.silicon)
    notes.push_back(fmt::format(
        "mm2, {}: 28 nm, mid, with SRAMs and DRAM, interpolated (docs/numerics/accuracy.md); energy is not validated; "
        "~: beyond what was synthesised or measured",
        energy.name));
  else notes.emplace_back("no machine of the kind was synthesised: its area and energy are not known");
  return {.notes = notes};
}

std::string clock_note(const Point& base) {
  return base.clock_known() ? "GHz: what the longest path allows, 28 nm, mid, interpolated; us: cycles / GHz"
                            : "GHz: no longest path of such a machine is known, so cycles count at 1 GHz";
}

std::string series_of(const Point& point) {
  return point.knob == kBase || point.knob == kTogether ? point.knob : "one knob";
}

struct Marks {
  std::vector<std::string> series;                       // that come first
  std::function<std::string(const Point&)> name, label;  // of a point's series, and of the point
  std::function<std::string(const Point&)> front_label;  // stands beside it where `numbered`
  bool numbered = false;
};

// Points as marks, those of the front joined; what is not known is left out.
void scatter(Chart& chart, const std::vector<Point>& points, const std::vector<const Point*>& front, const Quantity& x,
             const Quantity& y, const Marks& marks) {
  chart.form = Chart::Form::kScatter;
  for (const std::string& name : marks.series) chart.series.push_back({.name = name, .values = {}});
  const auto add = [&](Series& series, const Point& point, const std::string& label) {
    if (!point.figures.failure.empty() || std::isnan(x(point))) return;
    series.x.push_back(x(point));
    series.values.push_back(y(point));
    series.labels.push_back(label);
    series.copies.push_back(words_of(point));
  };
  for (const Point& point : points) {
    const std::string name = marks.name(point);
    auto one = std::find_if(chart.series.begin(), chart.series.end(),
                            [&](const Series& series) { return series.name == name; });
    if (one == chart.series.end()) one = chart.series.insert(one, Series{.name = name, .values = {}});
    add(*one, point, marks.label(point));
  }
  Series joined{.name = "front", .values = {}, .outlined = true, .named = marks.numbered};
  for (const Point* point : front) add(joined, *point, marks.front_label(*point));
  chart.series.push_back(joined);
}

// Marks that are named by how they differ from the base.
Marks by_difference(const Config& base) {
  const auto label = [base](const Point& point) { return difference(point, base); };
  return {.series = {"one knob", kTogether, kBase}, .name = series_of, .label = label, .front_label = label};
}

// PSNR by value.
Chart knob_chart(const SweptKnob& knob) {
  Chart chart{.name = knob.knob->name,
              .form = Chart::Form::kLines,
              .title = knob.knob->name,
              .x_label = knob.knob->name + ", coarse to fine",
              .y_label = "PSNR, dB",
              .from_zero = false,
              .note = knob.knob->what};
  chart.series = {{.name = "numeric", .values = {}}, {.name = "order", .values = {}}, {.name = "total", .values = {}}};
  for (size_t i = 0; i < knob.points.size(); ++i) {
    const Figures& a = knob.points[i].figures;
    chart.x.push_back(static_cast<double>(i));
    chart.categories.push_back(knob.points[i].value.label);
    const double values[3] = {a.numeric.psnr, a.order.psnr, a.total.psnr};
    for (int k = 0; k < 3; ++k) chart.series[k].values.push_back(a.failure.empty() ? values[k] : std::nan(""));
  }
  return chart;
}

std::vector<Chart> accuracy_charts(const AccuracySweep& sweep, const std::vector<Point>& all) {
  std::vector<Chart> charts;
  for (const Cost& cost : costs()) {
    if (std::all_of(all.begin(), all.end(), [&](const Point& point) { return std::isnan(cost.of(point)); })) continue;
    charts.push_back({.name = std::string("by_") + cost.name,
                      .title = cost.title,
                      .x_label = cost.axis,
                      .y_label = "numeric PSNR, dB",
                      .series = {}});
    scatter(
        charts.back(), all, accuracy_front(all, cost), [&](const Point& p) { return cost.of(p) / cost.unit; },
        [](const Point& p) { return p.figures.numeric.psnr; }, by_difference(sweep.base.config));
  }
  for (const SweptKnob& knob : sweep.knobs) charts.push_back(knob_chart(knob));
  return charts;
}

// null of a machine whose area is not known.
Json silicon_json(const Point& point) {
  if (!point.silicon) return nullptr;
  const FrameCost& silicon = *point.silicon;
  Json json = {{"mm2", to_json(silicon.mm2)},
               {"chip_mj", to_json(silicon.chip * 1e3)},
               {"dram_mj", to_json(silicon.dram * 1e3)},
               {"extrapolated_area", silicon.extrapolated_area},
               {"extrapolated_energy", silicon.extrapolated_energy},
               {"path_ps", nullptr},
               {"ghz", nullptr},
               {"us", nullptr}};
  if (point.clock_known()) {
    json.update({{"path_ps", to_json(kFo4Ps * *silicon.path_fo4)},
                 {"ghz", *silicon.ghz()},
                 {"us", silicon.us},
                 {"extrapolated_path", silicon.extrapolated_path}});
  }
  return json;
}

Json accuracy_row(const Point& point) {
  Json json = to_json(point.figures, Measured::kErrors);
  if (point.figures.failure.empty()) json["silicon"] = silicon_json(point);
  json.update({{"configuration", config_difference(point.config)}, {"lod_pixels", point.value.less.lod}});
  return json;
}

Json accuracy_json(const AccuracySweep& sweep, const std::vector<Point>& all) {
  Json json = {{"base", accuracy_row(sweep.base)}, {"knobs", Json::array()}, {"together", Json::array()}};
  for (const SweptKnob& knob : sweep.knobs) {
    Json one = {{"name", knob.knob->name}, {"what", knob.knob->what}, {"values", Json::array()}};
    for (const Point& point : knob.points) {
      one["values"].push_back(accuracy_row(point));
      one["values"].back()["label"] = point.value.label;
    }
    json["knobs"].push_back(one);
  }
  for (const Point& point : sweep.together) json["together"].push_back(accuracy_row(point));
  for (const Cost& cost : costs()) {
    json["front"][cost.name] = Json::array();
    for (const Point* point : accuracy_front(all, cost))
      json["front"][cost.name].push_back(config_difference(point->config) + frame_words(point->value.less));
  }
  json["skipped"] = sweep.skipped;
  return json;
}

Json place_json(const Point& point) { return point.front > 0 ? Json(point.front) : Json(nullptr); }

Json tradeoff_row(const Point& point, const View& view, double ghz) {
  const Less& less = point.value.less;
  const Camera camera = view.camera(less);
  return {{"knob", point.knob},
          {"label", point.value.label},
          {"configuration", config_difference(point.config)},
          {"width", camera.width},
          {"height", camera.height},
          {"gaussians", view.gaussians(less)},
          {"rest", less.rest},
          {"lod_pixels", less.lod},
          {"cycles", point.figures.cycles},
          {"us", us_of(point, ghz)},
          {"bytes", point.figures.bytes},
          {"psnr_db", finite_json(point.figures.total.psnr)},
          {"ssim", finite_json(point.figures.total.ssim)},
          {"silicon", silicon_json(point)},
          {"front", place_json(point)}};
}

Json shape_row(const Point& point, const Point& base, double mm2) {
  const FrameCost& cost = *point.silicon;
  return {{"shape", difference(point.config, base.config)},
          {"configuration", config_difference(point.config)},
          {"step", point.knob == kBase || point.knob == kTogether ? point.knob : "alone"},
          {"cycles", point.figures.cycles},
          {"bytes", point.figures.bytes},
          {"path_ps", cost.path_fo4 ? to_json(kFo4Ps * *cost.path_fo4) : Json(nullptr)},
          {"ghz", cost.ghz() ? Json(*cost.ghz()) : Json(nullptr)},
          {"us", cost.us},
          {"mm2", to_json(cost.mm2)},
          {"extrapolated_area", cost.extrapolated_area},
          {"extrapolated_path", cost.extrapolated_path},
          {"extrapolated_energy", cost.extrapolated_energy},
          {"fps_per_mm2", fps_per_mm2(point)},
          {"frames_per_joule_with_dram", frames_per_joule(point)},
          {"within", point.mm2() <= mm2},
          {"front", place_json(point)}};
}

std::string best_shape_text(const Point* best, const Point& base, double mm2) {
  if (best == nullptr) return fmt::format("no shape that was measured fits {:g} mm2", mm2);
  return fmt::format("best within {:g} mm2: {}: {} cycles, {:.1f} us, {} mm2", mm2,
                     difference(best->config, base.config), best->figures.cycles, us_of(*best, 0),
                     interpolated_text(best->mm2(), best->silicon->extrapolated_area, 3));
}

}  // namespace

Table target_table(const std::vector<Point>& points, double target) {
  if (const Point* point = cheapest(points, target))
    return {.notes = {fmt::format("target {:g} dB numeric: {}", target, point_text(*point, points.front().config)),
                      "use it with " + words_of(*point)}};
  const std::vector<const Point*> front = accuracy_front(points, costs().front());
  return {.notes = {fmt::format("target {:g} dB numeric: not reached; the most accurate point has {} dB", target,
                                front.empty() ? "no" : decibels(front.back()->figures.numeric.psnr))}};
}

Answer accuracy_answer(const AccuracySweep& sweep) {
  const std::vector<Point> all = sweep.all();
  const Columns columns{.measured = Measured::kErrors};
  std::vector<PointRow> rows = {{"", &sweep.base}}, fronts;
  Table knobs{.columns = {{.key = "knob", .heading = "knob", .word = true},
                          {.key = "what", .heading = "what it is", .word = true, .wrapped = true}},
              .notes = {}};
  for (const SweptKnob& knob : sweep.knobs) {
    for (const Point& point : knob.points) rows.push_back({"", &point});
    knobs.rows.push_back({text_cell(knob.knob->name), text_cell(knob.knob->what)});
  }
  for (const Point& point : sweep.together) rows.push_back({"", &point});
  for (const std::string& reason : sweep.skipped) knobs.notes.push_back("left out: " + reason);
  for (const Cost& cost : costs()) {
    for (const Point* point : accuracy_front(all, cost)) fronts.push_back({cost.name, point});
  }
  const Table read = legend(
      sweep.base,
      {"numeric: golden model against float64 in the same order; order: float64 in that order against depth order; "
       "total: golden model against depth order",
       "SSIM: of the total; max, 99.9 %: of the numeric error; *: the base", clock_note(sweep.base)});
  return {.json = accuracy_json(sweep, all),
          .tables = {points_table("", rows, sweep.base, columns), knobs, points_table("", fronts, sweep.base, columns),
                     read},
          .charts = accuracy_charts(sweep, all)};
}

Answer tradeoff_answer(std::vector<Point> points, const View& view, double ghz) {
  const std::vector<const Point*> front = find_tradeoff_front(points);
  Answer answer{
      .json = {{"ghz", ghz}, {"points", Json::array()}, {"price", Json::array()}}, .tables = {}, .charts = {}};
  for (const Point& point : points) answer.json["points"].push_back(tradeoff_row(point, view, ghz));
  Table read =
      legend(points.front(),
             {fmt::format("us: of a frame at {:g} GHz; total, SSIM: the picture at full size against the "
                          "float64 truth; front: the places of those that no other one beats in both us and dB",
                          ghz)},
             kMicrojoules);
  for (const PricedStep& step : price(front)) {
    const double from = step.from->figures.total.psnr, to = step.to->figures.total.psnr, us = step.cycles / 1000 / ghz,
                 us_per_db = step.cycles_per_db / 1000 / ghz;
    read.notes.push_back(fmt::format("from {:.1f} to {:.1f} dB, front {} to {}: {:.1f} us, {:.1f} us a decibel", from,
                                     to, step.from->front, step.to->front, us, us_per_db));
    answer.json["price"].push_back({{"from_db", from},
                                    {"to_db", to},
                                    {"from", step.from->front},
                                    {"to", step.to->front},
                                    {"us", us},
                                    {"us_per_db", us_per_db}});
  }
  answer.tables = {points_table("", rows_of(points), points.front(),
                                {.measured = Measured::kPicture, .energy = &kMicrojoules, .ghz = ghz}),
                   read};
  Chart chart{.name = "quality_by_time",
              .title = "Accuracy against time",
              .x_label = fmt::format("microseconds of a frame at {:g} GHz", ghz),
              .y_label = "dB against the truth",
              .series = {},
              .from_zero = false,
              .note = "numbers: places on the front"};
  scatter(
      chart, points, front, [&](const Point& p) { return us_of(p, ghz); },
      [](const Point& p) { return p.figures.total.psnr; },
      {.series = {},
       .name = [](const Point& p) { return p.knob; },
       .label = [](const Point& p) { return p.value.label; },
       .front_label = [](const Point& p) { return std::to_string(p.front); },
       .numbered = true});
  answer.charts = {chart};
  return answer;
}

Answer shapes_answer(const std::vector<Point>& shapes, double mm2) {
  const Point& base = shapes.front();
  const std::vector<const Point*> places = shape_front(shapes);
  const Point* best = best_within(shapes, mm2);
  Json json = {{"mm2", mm2},
               {"clock_known", base.clock_known()},
               {"shapes", Json::array()},
               {"front", Json::array()},
               {"best", best == nullptr ? Json(nullptr) : Json(difference(best->config, base.config))}};
  for (const Point& shape : shapes) json["shapes"].push_back(shape_row(shape, base, mm2));
  std::vector<PointRow> front;
  for (const Point* shape : places) {
    json["front"].push_back(difference(shape->config, base.config));
    front.push_back({"", shape});
  }
  const Columns columns{.mm2 = mm2};
  const Table read = legend(
      base,
      {fmt::format("fits: at most {:g} mm2; front: places of those that no other one beats in both us and mm2", mm2),
       clock_note(base), best_shape_text(best, base, mm2)});
  Chart chart{.name = "time_by_area",
              .title = "Time against area",
              .x_label = "mm2 in 28 nm, mid, interpolated",
              .y_label = base.clock_known() ? "us of a frame" : "us of a frame at 1 GHz",
              .series = {}};
  scatter(
      chart, shapes, places, [](const Point& p) { return p.mm2(); }, [](const Point& p) { return us_of(p, 0); },
      by_difference(base.config));
  return {.json = json,
          .tables = {points_table("", rows_of(shapes), base, columns), points_table("", front, base, columns), read},
          .charts = {chart}};
}

}  // namespace pipegs
