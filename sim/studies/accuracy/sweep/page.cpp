// SPDX-License-Identifier: Apache-2.0
// page.cpp: see page.hpp.
#include "sim/studies/accuracy/sweep/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/design/design_point.hpp"
#include "sim/report/html/pictures.hpp"

#include "sim/report/html/document.hpp"

namespace pipegs {
namespace {

constexpr int kPictureWidth = 480;

TableCell number(double value, int digits) { return {.text = fmt::format("{:.{}f}", value, digits), .value = value}; }

// Of "~1.2" and of "12 *", too.
std::optional<double> number_in(const std::string& text) {
  const size_t from = text.starts_with('~') ? 1 : 0;
  return field_cell(text.substr(from, text.find(' ') - from)).value;
}

TableCell told(const std::string& text) {
  return {.text = text, .value = text == "inf" ? std::optional(1e9) : number_in(text)};
}

// Knob and value of a row, and what was measured.
struct NamedPoint {
  std::string knob, value;
  const MeasuredPoint* point;
};

std::vector<NamedPoint> all_points(const AccuracySweep& sweep) {
  std::vector<NamedPoint> rows = {{"base", "", &sweep.base}};
  for (const SweptKnob& knob : sweep.knobs) {
    for (size_t i = 0; i < knob.points.size(); ++i) {
      const bool is_base = knob.points[i].config == sweep.base.config;
      rows.push_back({knob.knob->name, knob.values[i]->label + (is_base ? " *" : ""), &knob.points[i]});
    }
  }
  for (size_t i = 0; i < sweep.together.size(); ++i)
    rows.push_back({"together", fmt::format("{}", i + 1), &sweep.together[i]});
  return rows;
}

std::vector<TableCell> row_of(const NamedPoint& row, const AccuracySweep& sweep) {
  const Accuracy& a = row.point->figures;
  const auto cycles = static_cast<double>(a.cycles);
  return {{.text = row.knob},
          {.text = row.value, .value = number_in(row.value)},
          told(decibels(a.numeric.psnr)),
          told(decibels(a.order.psnr)),
          told(decibels(a.total.psnr)),
          number(a.total.ssim, 5),
          number(a.numeric.max, 4),
          number(a.numeric.p999, 4),
          number(100 * a.flips.share(), 4),
          {.text = std::to_string(a.cycles), .value = cycles},
          number(100 * (cycles / static_cast<double>(sweep.base.figures.cycles) - 1), 2),
          number(cycles * 1e-6, 3),
          told(clock_text(*row.point)),
          told(time_text(*row.point)),
          number(static_cast<double>(a.bytes) / 1e6, 1),
          number(a.gbps(), 1),
          number(a.buffer_kb(), 1),
          told(area_text(*row.point)),
          told(energy_text(*row.point)),
          number(a.seconds_golden + a.seconds_truth + a.seconds_trace + a.seconds_model, 1),
          {.text = difference(row.point->config, sweep.base.config), .copy = machine_words(row.point->config)}};
}

Table table_of(const std::string& title, const std::vector<NamedPoint>& rows, const AccuracySweep& sweep) {
  Table table{.title = title};
  table.columns = {{.heading = "knob", .word = true}, {.heading = "value", .word = true}};
  for (const char* name : {"numeric dB", "order dB", "total dB", "SSIM", "max", "99.9 %", "flips %", "cycles", "% more",
                           "ms at 1 GHz", "GHz", "us", "MB", "GB/s", "buffers KB", "mm2", "mJ", "host s"})
    table.columns.push_back({.heading = name});
  table.columns.push_back({.heading = "configuration", .word = true, .wrapped = true, .copies = true});
  for (const NamedPoint& row : rows) {
    if (row.point->figures.failure.empty()) table.rows.push_back(row_of(row, sweep));
    else table.notes.push_back(fmt::format("{} {}: {}", row.knob, row.value, row.point->figures.failure));
  }
  return table;
}

Table front_table(const AccuracySweep& sweep, const std::vector<NamedPoint>& rows, Cost cost, const char* name) {
  const std::vector<MeasuredPoint> all = sweep.all();
  std::vector<NamedPoint> front;
  for (const MeasuredPoint* point : pareto_front(all, cost)) {
    // By the name under which it stands among all points.
    const auto known = std::find_if(rows.begin(), rows.end(),
                                    [&](const NamedPoint& row) { return row.point->config == point->config; });
    front.push_back(*known);
  }
  Table table = table_of(fmt::format("Front over {}", name), front, sweep);
  if (front.empty() && cost == Cost::kTime) table.notes.emplace_back("No longest path of such a machine is known.");
  return table;
}

}  // namespace

Rgb8 error_picture(const Image& image, const Image& truth, double gain, int width) {
  const int step = std::max(1, (image.width + width - 1) / width);
  Image small((image.width + step - 1) / step, (image.height + step - 1) / step);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const glm::dvec3 error = gain * glm::abs(image.rgb[image.at(x, y)] - truth.rgb[truth.at(x, y)]);
      glm::dvec3& largest = small.rgb[small.at(x / step, y / step)];
      largest = glm::max(largest, error);
    }
  }
  return to_rgb8(small, glm::dvec3(0));
}

std::vector<ErrorPicture> error_pictures(const AccuracyView& view, const AccuracySweep& sweep) {
  const std::vector<MeasuredPoint> all = sweep.all();
  std::vector<std::pair<std::string, const MeasuredPoint*>> chosen = {{"base", &all.front()}};
  for (const int level : {40, 50, 60, 70, 80}) {
    const MeasuredPoint* point = cheapest(all, level);
    if (point != nullptr) chosen.emplace_back(fmt::format("cheapest at {} dB", level), point);
  }
  const std::vector<const MeasuredPoint*> front = pareto_front(all, Cost::kCycles);
  if (!front.empty()) chosen.emplace_back("most accurate", front.back());
  std::vector<ErrorPicture> pictures;
  std::vector<const MeasuredPoint*> shown;
  for (const auto& [name, point] : chosen) {
    if (std::find(shown.begin(), shown.end(), point) != shown.end()) continue;
    shown.push_back(point);
    const Rgb8 picture = error_picture(view.golden(point->config), view.exact(), kErrorGain, kPictureWidth);
    pictures.push_back({fmt::format("{}: {} dB numeric, {} dB total: {}", name, decibels(point->figures.numeric.psnr),
                                    decibels(point->figures.total.psnr), difference(point->config, sweep.base.config)),
                        png_bytes(picture)});
  }
  return pictures;
}

void add_accuracy(StudyPage& page, const AccuracySweep& sweep, const std::vector<ErrorPicture>& pictures) {
  const std::vector<NamedPoint> rows = all_points(sweep);
  page.section("The base");
  page.note(fmt::format(
      "numeric: golden model against float64 in the same order; order: float64 in that order against depth order; "
      "total: golden model against depth order. Cycles and bytes by the timing model, milliseconds at 1 GHz, SSIM of "
      "the total, max and 99.9th percentile of the numeric error, flips: decisions at 1/255 unlike the truth's, of "
      "{:.0f} % of the pixels. Area, clock and energy with DRAM: 28 nm, mid, interpolated; ~ beyond what was "
      "synthesised or measured, - where no machine of the kind was. host s: of one core. * the base.",
      100 * sweep.flips_sampled));
  page.note(fmt::format("{} points were measured.", sweep.all().size()));
  page.table(table_of("", {rows.front()}, sweep));
  page.section("What is worth having");
  page.note("Points of a front can be copied by a click: the settings go to the clipboard, the rows are marked.");
  page.charts(front_charts(sweep));
  for (const auto& [cost, name] : {std::pair{Cost::kCycles, "cycles"},
                                   {Cost::kTime, "time"},
                                   {Cost::kBytes, "bytes"},
                                   {Cost::kBuffers, "buffers"},
                                   {Cost::kArea, "area"},
                                   {Cost::kEnergy, "energy"}})
    page.table(front_table(sweep, rows, cost, name));
  page.section("Knob by knob");
  for (const std::string& reason : sweep.skipped) page.note("Left out: " + reason);
  for (const SweptKnob& knob : sweep.knobs) {
    Chart chart = knob_chart(knob);
    chart.note = fmt::format("{}. {}", knob.knob->what, knob_sentence(knob));
    page.charts({chart});
  }
  page.section("Where the error is");
  page.note(fmt::format("|golden - truth in depth order|, {:g} times brighter.", kErrorGain));
  for (const ErrorPicture& picture : pictures) page.picture(picture.caption, picture.png);
  page.section("Every point");
  page.table(table_of("", rows, sweep));
}

}  // namespace pipegs
