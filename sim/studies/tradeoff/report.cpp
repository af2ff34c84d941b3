// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/tradeoff/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

double us(const TradeoffPoint& point, double ghz) { return static_cast<double>(point.cycles) / 1000 / ghz; }

std::string name_of(const Way& way) { return way.knob == "together" ? way.label : way.knob + " " + way.label; }

}  // namespace

std::vector<Leg> price(const std::vector<TradeoffPoint>& points, double ghz) {
  std::vector<Leg> legs;
  const std::vector<const TradeoffPoint*> front = front_of(points);
  if (front.empty()) return legs;
  const TradeoffPoint* from = front.front();
  for (const double level : {50, 40, 30}) {
    const TradeoffPoint* to = from;
    for (const TradeoffPoint* point : front) to = point->psnr >= level && point->cycles < to->cycles ? point : to;
    if (to == from || !std::isfinite(from->psnr)) continue;
    const double saved = us(*from, ghz) - us(*to, ghz);
    legs.push_back({from, to, saved, saved / (from->psnr - to->psnr)});
    from = to;
  }
  return legs;
}

nlohmann::ordered_json to_json(const std::vector<TradeoffPoint>& points, double ghz) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const TradeoffPoint& point : points) {
    list.push_back({{"knob", point.way.knob},
                    {"label", point.way.label},
                    {"configuration", config_difference(point.config)},
                    {"width", point.width},
                    {"height", point.height},
                    {"gaussians", point.gaussians},
                    {"cycles", point.cycles},
                    {"us", us(point, ghz)},
                    {"bytes", point.bytes},
                    {"psnr_db", finite_json(point.psnr)},
                    {"ssim", finite_json(point.ssim)},
                    {"front", point.front > 0 ? nlohmann::ordered_json(point.front) : nullptr}});
  }
  return list;
}

nlohmann::ordered_json to_json(const std::vector<Leg>& legs) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Leg& leg : legs) {
    list.push_back({{"from_db", leg.from->psnr},
                    {"to_db", leg.to->psnr},
                    {"from", leg.from->front},
                    {"to", leg.to->front},
                    {"us", leg.us},
                    {"us_per_db", leg.us_per_db}});
  }
  return list;
}

Table to_table(const std::vector<TradeoffPoint>& points, double ghz) {
  const double base = static_cast<double>(points.front().cycles);
  Table table{.columns = {{.key = "with_less", .heading = "with less", .word = true},
                          {.key = "us", .unit = "us", .digits = 1},
                          {.key = "share", .heading = "of all", .unit = "%", .digits = 1},
                          {.key = "megabytes", .unit = "MB", .digits = 1},
                          {.key = "psnr_db", .unit = "dB", .digits = 2},
                          {.key = "ssim", .heading = "SSIM", .digits = 4},
                          {.key = "front", .heading = "front"}}};
  for (const TradeoffPoint& point : points)
    table.rows.push_back({text_cell(name_of(point.way)), number_cell(us(point, ghz)),
                          number_cell(100 * static_cast<double>(point.cycles) / base),
                          number_cell(static_cast<double>(point.bytes) / 1e6), number_cell(point.psnr),
                          number_cell(point.ssim),
                          point.front > 0 ? number_cell(static_cast<double>(point.front)) : TableCell{}});
  table.notes.push_back(fmt::format(
      "us: of a frame at {:g} GHz; dB, SSIM: the picture at full size against the float64 truth; front: the places of "
      "those that no other one beats in both us and dB",
      ghz));
  for (const Leg& leg : price(points, ghz))
    table.notes.push_back(fmt::format("from {:.1f} to {:.1f} dB, front {} to {}: {:.1f} us, {:.1f} us a decibel",
                                      leg.from->psnr, leg.to->psnr, leg.from->front, leg.to->front, leg.us,
                                      leg.us_per_db));
  return table;
}

Chart tradeoff_chart(const std::string& title, const std::vector<TradeoffPoint>& points, double ghz) {
  Chart chart{.name = "quality_by_time",
              .form = Chart::Form::kScatter,
              .title = title,
              .x_label = fmt::format("microseconds of a frame at {:g} GHz", ghz),
              .y_label = "dB against the truth",
              .series = {},
              .from_zero = false,
              .note = "numbers: places on the front"};
  for (const TradeoffPoint& point : points) {
    auto one = std::find_if(chart.series.begin(), chart.series.end(),
                            [&](const Series& series) { return series.name == point.way.knob; });
    if (one == chart.series.end()) one = chart.series.insert(one, Series{.name = point.way.knob, .values = {}});
    one->x.push_back(us(point, ghz));
    one->values.push_back(point.psnr);
    one->labels.push_back(point.way.label);
  }
  Series joined{.name = "front", .values = {}, .outlined = true, .named = true};
  for (const TradeoffPoint* point : front_of(points)) {
    joined.x.push_back(us(*point, ghz));
    joined.values.push_back(point->psnr);
    joined.labels.push_back(std::to_string(point->front));
  }
  chart.series.push_back(joined);
  return chart;
}

}  // namespace pipegs
