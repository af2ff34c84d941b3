// SPDX-License-Identifier: Apache-2.0
// chart.hpp: what was found, as a chart: bars side by side or stacked, lines, histograms, clouds of points.
//
// Idea    A Chart is data and labels; sim/report/page draws it: charts.mjs in a page, svg.sh as a file.
// Rule    Nothing is drawn that is not in the data: a value that is not finite leaves a gap. On a logarithmic axis the
//         same holds for values that are not positive.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pipegs {

struct Series {
  std::string name;
  std::vector<double> values;            // one for each category, x or bin
  bool outlined = false;                 // drawn as a dashed outline: what others reported; of points: joined by a line
  std::vector<double> x = {};            // of points: where each lies
  std::vector<std::string> labels = {};  // of points: what each is
  bool named = false;                    // of points: the labels stand beside them, but for one that covers another
  std::vector<std::string> copies = {};  // of points: what a click in a page copies, such as a configuration
  std::vector<double> low = {}, high = {};  // of bars on a logarithmic axis: the ends of each value's range
};

struct Chart {
  enum class Form {
    kBars,       // series side by side, by category; on a logarithmic axis, where no height is a length, dots
    kStacked,    // series on top of each other, by category
    kLines,      // markers at x, joined
    kHistogram,  // one series; bin i lies between x[i] and x[i + 1]
    kScatter,    // points anywhere, of each series its own; axes begin near the lowest
  };
  std::string name;  // among the charts of a command
  Form form = Form::kBars;
  std::string title, x_label, y_label;
  std::vector<std::string> categories;  // of bars; of lines: what stands at x, if not its number
  std::vector<double> x;                // of lines and histograms, ascending
  std::vector<Series> series;
  bool log_x = false, log_y = false;  // log_x: lines and histograms only; log_y: bars and lines
  bool from_zero = true;              // of lines: the linear vertical axis begins at 0, else near the lowest value
  std::string note;                   // one line beneath
};

// The values in `bins` bins of equal width (equal ratio when log_x, for positive values).
Chart histogram(const std::string& name, const std::string& title, const std::string& x_label,
                const std::vector<double>& values, int bins, bool log_x = false);

// As charts.mjs reads them. Throws std::invalid_argument when a chart's counts do not fit each other.
nlohmann::ordered_json charts_json(const std::vector<Chart>& charts);

}  // namespace pipegs
