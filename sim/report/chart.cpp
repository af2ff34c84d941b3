// SPDX-License-Identifier: Apache-2.0
// chart.cpp: see chart.hpp.
#include "sim/report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Chart::Form form) {
  switch (form) {
    case Chart::Form::kBars: return "bars";
    case Chart::Form::kStacked: return "stacked";
    case Chart::Form::kLines: return "lines";
    case Chart::Form::kHistogram: return "histogram";
    case Chart::Form::kScatter: return "scatter";
  }
  return "";
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(finite_json(value));
  return list;
}

// How many values each series has.
size_t places_of(const Chart& chart, const Series& series) {
  switch (chart.form) {
    case Chart::Form::kLines: return chart.x.size();
    case Chart::Form::kHistogram: return chart.x.size() - 1;
    case Chart::Form::kScatter: return series.labels.size();
    default: return chart.categories.size();
  }
}

void check(const Chart& chart, const Series& series) {
  const size_t places = places_of(chart, series);
  const bool placed = chart.form != Chart::Form::kScatter || series.x.size() == places;
  const bool named = chart.form != Chart::Form::kLines || chart.categories.empty() || chart.categories.size() == places;
  const auto fits = [&](const std::vector<double>& ends) { return ends.empty() || ends.size() == places; };
  if (series.values.size() == places && placed && named && fits(series.low) && fits(series.high)) return;
  throw std::invalid_argument(fmt::format("chart '{}': series '{}' has {} values for {} places", chart.title,
                                          series.name, series.values.size(), places));
}

Json chart_json(const Chart& chart) {
  Json json = {{"name", chart.name},       {"form", name_of(chart.form)},  {"title", chart.title},
               {"x_label", chart.x_label}, {"y_label", chart.y_label},     {"categories", chart.categories},
               {"x", numbers(chart.x)},    {"log_x", chart.log_x},         {"log_y", chart.log_y},
               {"note", chart.note},       {"from_zero", chart.from_zero}, {"series", Json::array()}};
  for (const Series& series : chart.series) {
    check(chart, series);
    Json one = {{"name", series.name}, {"values", numbers(series.values)}, {"outlined", series.outlined}};
    if (chart.form == Chart::Form::kScatter) {
      one.update({{"x", numbers(series.x)}, {"labels", series.labels}, {"named", series.named}});
      if (!series.copies.empty()) one["copies"] = series.copies;
    }
    if (!series.low.empty()) one.update({{"low", numbers(series.low)}, {"high", numbers(series.high)}});
    json["series"].push_back(std::move(one));
  }
  return json;
}

}  // namespace

Chart histogram(const std::string& name, const std::string& title, const std::string& x_label,
                const std::vector<double>& values, int bins, bool log_x) {
  Chart chart{.name = name,
              .form = Chart::Form::kHistogram,
              .title = title,
              .x_label = x_label,
              .y_label = "count",
              .log_x = log_x};
  double low = 0, high = 0;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value) || (log_x && value <= 0)) continue;
    low = any ? std::min(low, value) : value, high = any ? std::max(high, value) : value;
    any = true;
  }
  if (!any) low = 1, high = 2;
  if (!(high > low)) high = low + (log_x ? low : 1);
  const auto share = [&](double value) {
    return log_x ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  };
  chart.series.push_back({"count", std::vector<double>(bins, 0)});
  for (int i = 0; i <= bins; ++i)
    chart.x.push_back(log_x ? low * std::pow(high / low, static_cast<double>(i) / bins)
                            : low + (high - low) * i / bins);
  for (const double value : values) {
    if (!std::isfinite(value) || (log_x && value <= 0)) continue;
    ++chart.series[0].values[std::clamp(static_cast<int>(share(value) * bins), 0, bins - 1)];
  }
  return chart;
}

Json charts_json(const std::vector<Chart>& charts) {
  Json list = Json::array();
  for (const Chart& chart : charts) list.push_back(chart_json(chart));
  return list;
}

}  // namespace pipegs
