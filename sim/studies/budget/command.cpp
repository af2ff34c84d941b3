// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study budget`: errors of power and alpha of random Gaussians, below their bounds, beside float
// and half.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/percentile.hpp"
#include "sim/bounds/budget.hpp"
#include "sim/studies/budget/sample.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

struct BudgetArguments {
  MachineArguments machine;
  StudyOutput output;
  uint64_t seed = 1;
  size_t count = 1000000;
};

using Field = double BudgetSample::*;

struct Line {
  const char* name;
  Field field;
  double at;  // percentile, 1 is the largest
  bool dashed;
};

// Percentiles of fields by decades of `by`.
Chart chart_of(const std::vector<BudgetSample>& samples, const char* name, const char* title, const char* x_label,
               const char* y_label, Field by, int first, int last, const std::vector<Line>& lines) {
  Chart chart{.name = name, .form = Chart::Form::kLines, .title = title, .x_label = x_label, .y_label = y_label};
  chart.log_x = chart.log_y = true;
  std::vector<std::vector<const BudgetSample*>> bins(static_cast<size_t>(last - first));
  for (const BudgetSample& sample : samples) {
    const int decade = static_cast<int>(std::floor(std::log10(std::max(sample.*by, 1e-30))));
    bins[static_cast<size_t>(std::clamp(decade - first, 0, last - first - 1))].push_back(&sample);
  }
  for (int decade = first; decade < last; ++decade) chart.x.push_back(std::pow(10.0, decade + 0.5));
  for (const Line& line : lines) {
    Series series{.name = line.name, .values = {}, .outlined = line.dashed};
    for (const auto& bin : bins) {
      std::vector<double> values;
      for (const BudgetSample* sample : bin) values.push_back(sample->*line.field);
      series.values.push_back(percentile(values, line.at));
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::vector<Chart> charts(const std::vector<BudgetSample>& samples) {
  const std::vector<Line> power = {
      {"ours, median", &BudgetSample::power, 0.5, false},   {"ours, worst", &BudgetSample::power, 1, false},
      {"bound, median", &BudgetSample::bound, 0.5, true},   {"bound, worst", &BudgetSample::bound, 1, true},
      {"FP32, median", &BudgetSample::power32, 0.5, false}, {"FP32, worst", &BudgetSample::power32, 1, false},
      {"FP16, median", &BudgetSample::power16, 0.5, false}};
  const std::vector<Line> alpha = {
      {"ours, 99 %", &BudgetSample::alpha, 0.99, false},       {"ours, worst", &BudgetSample::alpha, 1, false},
      {"bound, 99 %", &BudgetSample::alpha_bound, 0.99, true}, {"FP32, worst", &BudgetSample::alpha32, 1, false},
      {"FP16, 99 %", &BudgetSample::alpha16, 0.99, false},     {"FP16, worst", &BudgetSample::alpha16, 1, false}};
  return {chart_of(samples, "power_by_ratio", "Error of the power by needle ratio", "longest / shortest axis",
                   "log2 units", &BudgetSample::ratio, 0, 8, power),
          chart_of(samples, "power_by_size", "Error of the power by size", "standard deviation, pixels", "log2 units",
                   &BudgetSample::sigma, -1, 4, power),
          chart_of(samples, "alpha_by_ratio", "Error of alpha by needle ratio", "longest / shortest axis", "alpha",
                   &BudgetSample::ratio, 0, 8, alpha),
          chart_of(samples, "alpha_by_size", "Error of alpha by size", "standard deviation, pixels", "alpha",
                   &BudgetSample::sigma, -1, 4, alpha)};
}

int budget(const BudgetArguments& arguments) {
  const Config config = arguments.machine.machine();
  arguments.output.check();
  Progress progress("budget");
  const std::vector<BudgetSample> samples = budget_samples(config, arguments.seed, arguments.count, [&](double share) {
    if (interrupted()) throw std::runtime_error("interrupted");
    progress.update(share);
  });
  struct Row {
    const char* what;
    Field field;
  };
  constexpr Row kRows[] = {{"power, ours", &BudgetSample::power},
                           {"power, bound", &BudgetSample::bound},
                           {"power, FP32", &BudgetSample::power32},
                           {"power, FP16", &BudgetSample::power16},
                           {"record, moves the power", &BudgetSample::record},
                           {"record, bound", &BudgetSample::record_bound},
                           {"alpha, ours", &BudgetSample::alpha},
                           {"alpha, bound", &BudgetSample::alpha_bound},
                           {"alpha, FP32", &BudgetSample::alpha32},
                           {"alpha, FP16", &BudgetSample::alpha16}};
  constexpr double kAt[] = {0.5, 0.9, 0.99, 0.999, 1};
  nlohmann::ordered_json out = {{"samples", samples.size()}, {"configuration", config_difference(config)}};
  const std::string head =
      fmt::format("{} Gaussians, configuration {}; powers in log2 units", samples.size(), config_difference(config));
  Table table{.columns = {{.key = "error", .word = true}}};
  for (const double at : kAt)
    table.columns.push_back({.key = fmt::format("{:g}", 100 * at),
                             .heading = at < 1 ? fmt::format("{:g} %", 100 * at) : std::string("worst")});
  std::vector<double> values(samples.size());
  for (const Row& row : kRows) {
    std::vector<TableCell>& cells = table.rows.emplace_back();
    cells.push_back(text_cell(row.what));
    for (const double at : kAt) {
      std::transform(samples.begin(), samples.end(), values.begin(),
                     [&](const BudgetSample& s) { return s.*row.field; });
      const double value = percentile(values, at);
      cells.push_back({.text = fmt::format("{:.3g}", value), .value = value});
      out[row.what][fmt::format("{:g}", 100 * at)] = finite_json(value);
    }
  }
  const auto beyond = [&](const std::function<bool(const BudgetSample&)>& test) {
    return std::count_if(samples.begin(), samples.end(), test);
  };
  const auto violations = beyond(
      [](const BudgetSample& s) { return s.power_excess > 0 || s.alpha_excess > 1e-9 || s.record > s.record_bound; });
  out["beyond_bound"] = violations;
  out["no_number"] = {{"fp32", beyond([](const BudgetSample& s) { return !std::isfinite(s.power32); })},
                      {"fp16", beyond([](const BudgetSample& s) { return !std::isfinite(s.power16); })}};
  table.notes.push_back(fmt::format("beyond the bound: {}; no number: FP32 {}, FP16 {}", violations,
                                    out["no_number"]["fp32"].get<long>(), out["no_number"]["fp16"].get<long>()));
  const std::vector<Chart> drawn = charts(samples);
  arguments.output.write({.title = "Errors of power and alpha",
                          .head = head,
                          .charts = drawn,
                          .tables = {table},
                          .machines = {{machine_name(config), config}}},
                         out);
  return violations == 0 ? kExitOk : kExitDiffers;
}

}  // namespace

void add_budget(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "budget", "errors of power and alpha of random Gaussians: ours, its bound, FP32, FP16",
                  footer("pipegs study budget --count 1000000 --out budget --page", "every error lies within its bound",
                         "one lies beyond it"));
  static BudgetArguments arguments;
  add_integer(command, "--count", arguments.count, "Gaussians", size_t{1}, size_t{100000000}).shows_default();
  add_integer(command, "--seed", arguments.seed, "of the Gaussians").shows_default();
  arguments.machine.add(command);
  arguments.output.add(command);
  when_chosen(command, run, [] { return budget(arguments); });
}

}  // namespace pipegs
