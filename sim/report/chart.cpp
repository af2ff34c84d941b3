// SPDX-License-Identifier: Apache-2.0
// chart.cpp: see chart.hpp. Lengths are SVG user units (pixels at normal size).
#include "sim/report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/report/svg.hpp"

namespace pipegs {
namespace {

constexpr double kWidth = 480, kHeight = 320;  // of one chart
constexpr double kLeft = 62, kRight = 14, kBottom = 46;
constexpr double kCharacter = 6.2;  // mean width of one at 11 pixels
constexpr double kLegendLine = 16;

// "12k", "3.4M", "0.25", "102.4": three digits or four.
std::string short_number(double value) {
  const double size = std::abs(value);
  if (size >= 9.995e8) return fmt::format("{:.3g}G", value / 1e9);
  if (size >= 9.995e5) return fmt::format("{:.3g}M", value / 1e6);
  if (size >= 9995) return fmt::format("{:.3g}k", value / 1e3);
  return size >= 99.95 ? fmt::format("{:.4g}", value) : fmt::format("{:.3g}", value);
}

struct Axis {
  double low = 0, high = 1, from = 0, to = 1;  // values, and where they lie
  bool logarithmic = false;
  double place(double value) const {
    const double share = logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + share * (to - from);
  }
  bool holds(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
};

class Drawing {
 public:
  Drawing(const Chart& chart, double x, double y) : chart_(chart), x_(x), y_(y) {}
  std::string draw();

 private:
  void check() const;
  void text(double x, double y, const std::string& anchor, const std::string& words, const std::string& more = "");
  void legend();
  void axes();
  void vertical_axis();
  void bars();
  void stacked();
  void lines();
  void points();
  void histogram_bars();
  double largest() const;
  double smallest() const;
  std::string color(size_t series) const { return svg_color(series); }
  std::string paint(size_t series) const;
  void box(double x, double y0, double y1, double width, size_t series, const std::string& what);

  const Chart& chart_;
  const double x_, y_;  // of the chart's top left corner
  double top_ = 0, bottom_ = 0;
  Axis across_, up_;
  std::string out_;
};

void Drawing::check() const {
  const size_t points = chart_.form == Chart::Form::kLines       ? chart_.x.size()
                        : chart_.form == Chart::Form::kHistogram ? chart_.x.size() - 1
                                                                 : chart_.categories.size();
  if (chart_.form == Chart::Form::kHistogram && (chart_.x.size() < 2 || chart_.series.size() != 1)) {
    throw std::invalid_argument(fmt::format("chart '{}': a histogram has bins and one series", chart_.title));
  }
  const bool lines = chart_.form == Chart::Form::kLines;
  if (lines && !chart_.categories.empty() && chart_.categories.size() != points) {
    throw std::invalid_argument(
        fmt::format("chart '{}': {} categories, expected {}", chart_.title, chart_.categories.size(), points));
  }
  for (const Series& series : chart_.series) {
    if (chart_.form == Chart::Form::kScatter) {
      if (series.x.size() == series.values.size() && series.labels.size() == series.values.size()) continue;
      throw std::invalid_argument(fmt::format("chart '{}': series '{}' has {} values at {} places with {} labels",
                                              chart_.title, series.name, series.values.size(), series.x.size(),
                                              series.labels.size()));
    }
    if (series.values.size() == points) continue;
    throw std::invalid_argument(fmt::format("chart '{}': series '{}' has {} values, expected {}", chart_.title,
                                            series.name, series.values.size(), points));
  }
}

void Drawing::text(double x, double y, const std::string& anchor, const std::string& words, const std::string& more) {
  out_ += svg_text(x, y, anchor, words, more);
}

std::string Drawing::paint(size_t series) const {
  if (!chart_.series[series].outlined) return fmt::format("fill=\"{}\"", color(series));
  return fmt::format("fill=\"{0}\" fill-opacity=\"0.12\" stroke=\"{0}\" stroke-width=\"1.5\" stroke-dasharray=\"4 3\"",
                     color(series));
}

// Names of the series, in as many lines as they need; sets where the plot begins.
void Drawing::legend() {
  double x = x_ + kLeft, y = y_ + 40;
  top_ = y_ + 36;
  if (chart_.series.size() < 2 && (chart_.series.empty() || !chart_.series[0].outlined)) return;
  for (size_t i = 0; i < chart_.series.size(); ++i) {
    const double width = 24 + kCharacter * static_cast<double>(chart_.series[i].name.size());
    if (x + width > x_ + kWidth - kRight && x > x_ + kLeft) x = x_ + kLeft, y += kLegendLine;
    out_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"11\" height=\"11\" {}/>\n", x, y - 9.5, paint(i));
    text(x + 15, y, "start", chart_.series[i].name);
    x += width;
  }
  top_ = y + 14;
}

double Drawing::largest() const {
  double top = 0;
  if (chart_.form == Chart::Form::kStacked) {
    for (size_t i = 0; i < chart_.categories.size(); ++i) {
      double sum = 0;
      for (const Series& series : chart_.series)
        sum += std::isfinite(series.values[i]) ? std::max(series.values[i], 0.0) : 0;
      top = std::max(top, sum);
    }
    return top;
  }
  for (const Series& series : chart_.series) {
    for (const double value : series.values) top = std::isfinite(value) ? std::max(top, value) : top;
  }
  return top;
}

// Of what is drawn, or 0.
double Drawing::smallest() const {
  double low = largest();
  for (const Series& series : chart_.series) {
    for (const double value : series.values) low = std::isfinite(value) ? std::min(low, value) : low;
  }
  return low;
}

void Drawing::vertical_axis() {
  up_.logarithmic = chart_.log_y && chart_.form != Chart::Form::kStacked && chart_.form != Chart::Form::kHistogram;
  up_.from = bottom_, up_.to = top_;
  const double top = largest();
  if (up_.logarithmic) {
    double low = top;
    for (const Series& series : chart_.series) {
      for (const double value : series.values) low = up_.holds(value) ? std::min(low, value) : low;
    }
    if (!(top > 0)) low = 0.5;
    const std::vector<double> ticks = axis_ticks(low, std::max(top, low * 1.001), true);
    up_.low = ticks.front(), up_.high = ticks.back();
    if (chart_.form == Chart::Form::kBars && up_.low >= low) up_.low /= 2;  // the smallest bar has a height too
  } else if (chart_.form == Chart::Form::kScatter || !chart_.from_zero) {
    const double low = smallest(), room = std::max(0.05 * (top - low), 1e-3 * std::abs(top));
    up_.low = low - room, up_.high = top + room > up_.low ? top + room : up_.low + 1;
  } else {
    up_.high = top > 0 ? top * 1.08 : 1;  // room above the highest bar for its number
  }
  for (const double tick : axis_ticks(up_.low, up_.high, up_.logarithmic)) {
    if (tick < up_.low || tick > up_.high * 1.0001) continue;
    const double y = up_.place(tick);
    out_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"currentColor\" "
        "stroke-opacity=\"0.15\"/>\n",
        x_ + kLeft, y, x_ + kWidth - kRight, y);
    text(x_ + kLeft - 6, y + 4, "end", short_number(tick));
  }
  const double middle = (top_ + bottom_) / 2;
  text(x_ + 14, middle, "middle", chart_.y_label,
       fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", x_ + 14, middle));
}

void Drawing::axes() {
  bottom_ = y_ + kHeight - kBottom - (chart_.note.empty() ? 0 : 14);
  vertical_axis();
  out_ += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"currentColor\"/>\n",
                      x_ + kLeft, bottom_, x_ + kWidth - kRight);
  const double middle = x_ + (kLeft + kWidth - kRight) / 2;
  text(middle, bottom_ + 34, "middle", chart_.x_label);
  if (!chart_.note.empty())
    text(middle, bottom_ + 50, "middle", chart_.note, " font-size=\"10\" fill-opacity=\"0.75\"");
  across_.from = x_ + kLeft, across_.to = x_ + kWidth - kRight;
  if (chart_.form == Chart::Form::kBars || chart_.form == Chart::Form::kStacked) {
    across_.high = static_cast<double>(std::max<size_t>(1, chart_.categories.size()));
    for (size_t i = 0; i < chart_.categories.size(); ++i)
      text(across_.place(static_cast<double>(i) + 0.5), bottom_ + 16, "middle", chart_.categories[i]);
    return;
  }
  if (chart_.form == Chart::Form::kScatter) {
    bool any = false;
    for (const Series& series : chart_.series) {
      for (const double x : series.x) {
        if (!std::isfinite(x)) continue;
        across_.low = any ? std::min(across_.low, x) : x, across_.high = any ? std::max(across_.high, x) : x;
        any = true;
      }
    }
    const double room = std::max(0.05 * (across_.high - across_.low), 1e-3 * std::abs(across_.high));
    across_.low -= room, across_.high += room;
  }
  across_.logarithmic = chart_.log_x;
  if (!chart_.x.empty()) across_.low = chart_.x.front(), across_.high = chart_.x.back();
  if (!(across_.high > across_.low)) across_.high = across_.low + (across_.low > 0 ? across_.low : 1);
  if (chart_.form == Chart::Form::kLines) across_.from += 14, across_.to -= 14;
  // A few points are their own ticks.
  const bool own = chart_.form == Chart::Form::kLines && chart_.x.size() <= 8;
  if (!chart_.categories.empty()) {
    for (size_t i = 0; i < chart_.x.size(); ++i)
      text(across_.place(chart_.x[i]), bottom_ + 16, "middle", chart_.categories[i]);
    return;
  }
  for (const double tick : own ? chart_.x : axis_ticks(across_.low, across_.high, across_.logarithmic)) {
    if (tick < across_.low || tick > across_.high * 1.0001) continue;
    out_ += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"currentColor\"/>\n",
                        across_.place(tick), bottom_, bottom_ + 4);
    text(across_.place(tick), bottom_ + 16, "middle", short_number(tick));
  }
}

// A bar from height y0 to y1 with a tooltip.
void Drawing::box(double x, double y0, double y1, double width, size_t series, const std::string& what) {
  out_ +=
      fmt::format("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{:.1f}\" height=\"{:.2f}\" {}><title>{}</title></rect>\n", x,
                  y1, width, std::max(0.0, y0 - y1), paint(series), svg_escaped(what));
}

void Drawing::bars() {
  const double slot = across_.place(1) - across_.place(0);
  const double width = 0.8 * slot / static_cast<double>(std::max<size_t>(1, chart_.series.size()));
  const bool numbers = width >= 18;
  for (size_t i = 0; i < chart_.categories.size(); ++i) {
    for (size_t k = 0; k < chart_.series.size(); ++k) {
      const double value = chart_.series[k].values[i];
      if (!up_.holds(value) || value < 0) continue;
      const double x = across_.place(static_cast<double>(i)) + 0.1 * slot + static_cast<double>(k) * width,
                   y = up_.place(value);
      box(x + 0.5, bottom_, y, width - 1, k,
          fmt::format("{}, {}: {}", chart_.categories[i], chart_.series[k].name, short_number(value)));
      if (numbers) text(x + width / 2, y - 3, "middle", short_number(value), " font-size=\"9.5\"");
    }
  }
}

void Drawing::stacked() {
  const double slot = across_.place(1) - across_.place(0);
  for (size_t i = 0; i < chart_.categories.size(); ++i) {
    double sum = 0;
    for (size_t k = 0; k < chart_.series.size(); ++k) {
      const double value = chart_.series[k].values[i];
      if (!std::isfinite(value) || value <= 0) continue;
      box(across_.place(static_cast<double>(i)) + 0.18 * slot, up_.place(sum), up_.place(sum + value), 0.64 * slot, k,
          fmt::format("{}, {}: {}", chart_.categories[i], chart_.series[k].name, short_number(value)));
      sum += value;
    }
    if (sum > 0)
      text(across_.place(static_cast<double>(i) + 0.5), up_.place(sum) - 3, "middle", short_number(sum),
           " font-size=\"9.5\"");
  }
}

void Drawing::lines() {
  for (size_t k = 0; k < chart_.series.size(); ++k) {
    std::string path;
    bool joined = false;
    for (size_t i = 0; i < chart_.x.size(); ++i) {
      const double value = chart_.series[k].values[i];
      if (!up_.holds(value) || !across_.holds(chart_.x[i])) {
        joined = false;
        continue;
      }
      const double x = across_.place(chart_.x[i]), y = up_.place(value);
      path += fmt::format("{}{:.1f} {:.1f} ", joined ? 'L' : 'M', x, y);
      joined = true;
      out_ += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"><title>{}</title></circle>\n", x, y, color(k),
          svg_escaped(fmt::format("{}, {}: {}", chart_.series[k].name,
                                  chart_.categories.empty() ? short_number(chart_.x[i]) : chart_.categories[i],
                                  short_number(value))));
    }
    if (path.empty()) continue;
    out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", path, color(k),
                        chart_.series[k].outlined ? " stroke-dasharray=\"5 4\"" : "");
  }
}

void Drawing::points() {
  for (size_t k = 0; k < chart_.series.size(); ++k) {
    const Series& series = chart_.series[k];
    std::string path;
    double last_x = -1e9, last_y = -1e9;  // of the last label
    for (size_t i = 0; i < series.values.size(); ++i) {
      if (!up_.holds(series.values[i]) || !across_.holds(series.x[i])) continue;
      const double x = across_.place(series.x[i]), y = up_.place(series.values[i]);
      path += fmt::format("{}{:.1f} {:.1f} ", path.empty() ? 'M' : 'L', x, y);
      out_ +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" {}><title>{}</title></circle>\n", x, y, paint(k),
                      svg_escaped(fmt::format("{}, {}: {}, {}", series.name, series.labels[i],
                                              short_number(series.x[i]), short_number(series.values[i]))));
      if (!series.named || (std::abs(x - last_x) < 8 && std::abs(y - last_y) < 8)) continue;  // never over each other
      text(x - 5, y - 5, "end", series.labels[i], " font-size=\"10\"");
      last_x = x, last_y = y;
    }
    if (!series.outlined || path.empty()) continue;
    out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"/>\n",
                        path, color(k));
  }
}

void Drawing::histogram_bars() {
  for (size_t i = 0; i + 1 < chart_.x.size(); ++i) {
    const double value = chart_.series[0].values[i];
    if (!std::isfinite(value) || value <= 0) continue;
    const double x0 = across_.place(chart_.x[i]), x1 = across_.place(chart_.x[i + 1]);
    box(x0 + 0.5, bottom_, up_.place(value), x1 - x0 - 1, 0,
        fmt::format("{} to {}: {}", short_number(chart_.x[i]), short_number(chart_.x[i + 1]), short_number(value)));
  }
}

std::string Drawing::draw() {
  check();
  text(x_ + kWidth / 2, y_ + 20, "middle", chart_.title, " font-size=\"13\" font-weight=\"bold\"");
  legend();
  axes();
  switch (chart_.form) {
    case Chart::Form::kBars: bars(); break;
    case Chart::Form::kStacked: stacked(); break;
    case Chart::Form::kLines: lines(); break;
    case Chart::Form::kHistogram: histogram_bars(); break;
    case Chart::Form::kScatter: points(); break;
  }
  return out_;
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, bool logarithmic) {
  std::vector<double> ticks;
  if (logarithmic) {
    if (!(low > 0) || !(high >= low)) return {1, 10};
    const double first = std::floor(std::log10(low) + 1e-9), last = std::ceil(std::log10(high) - 1e-9);
    const bool steps = std::log10(high / low) < 2.5;  // more than 1 of each decade
    for (double decade = first; decade <= last; ++decade) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double tick = step * std::pow(10.0, decade);
        if (!steps && step != 1.0) continue;
        // The last one below `low` and the first one above `high` close the range.
        if (!ticks.empty() && ticks.back() < low * 0.9999 && tick <= low * 1.0001) ticks.pop_back();
        if (ticks.empty() || ticks.back() < high * 0.9999) ticks.push_back(tick);
      }
    }
    return ticks;
  }
  if (!(high > low)) high = low + 1;
  const double rough = (high - low) / 5, decade = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double factor : {5.0, 2.0, 1.0}) step = rough <= factor * decade * 1.0001 ? factor * decade : step;
  const double first = std::floor(low / step + 1e-9);
  for (double i = first; ticks.empty() || ticks.back() < high - 1e-9 * step; ++i) ticks.push_back(i * step);
  return ticks;
}

Chart histogram(const std::string& title, const std::string& x_label, const std::vector<double>& values, int bins,
                bool log_x) {
  Chart chart{.form = Chart::Form::kHistogram, .title = title, .x_label = x_label, .y_label = "count", .log_x = log_x};
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

std::string charts_svg(const std::vector<Chart>& charts, int columns) {
  const int count = static_cast<int>(charts.size()), wide = std::max(1, std::min(columns, count)),
            high = (count + wide - 1) / wide;
  std::string svg = svg_head(wide * kWidth, std::max(1, high) * kHeight);
  for (int i = 0; i < count; ++i) svg += Drawing(charts[i], kWidth * (i % wide), kHeight * (i / wide)).draw();
  return svg + "</svg>\n";
}

}  // namespace pipegs
