// SPDX-License-Identifier: Apache-2.0
// path_model.cpp: see path_model.hpp.
#include "sim/silicon/area/path_model.hpp"

#include <algorithm>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "sim/silicon/area/least_squares.hpp"

namespace pipegs {
namespace {

constexpr const char* kPathsHeader = "configuration,unit,path_fo4";
constexpr double kPathRidge = 1e-3;  // beside a largest path of 1; a knob's whole range is 2
const std::set<std::string> kTimedUnits = {"dopu", "pu", "su", "ru", "top"};

double longest_of(const std::map<std::string, double>& fo4) {
  double most = 0;
  for (const auto& [unit, path] : fo4) most = std::max(most, path);
  return most;
}

}  // namespace

double PathPoint::longest() const { return longest_of(fo4); }

std::vector<PathPoint> read_path_points(const std::filesystem::path& csv) {
  std::vector<PathPoint> points;
  if (!std::filesystem::exists(csv)) return points;
  std::set<std::string> names;
  std::string name;
  read_csv(csv, kPathsHeader, [&](const CsvRow& row) {
    if (row.text("configuration") != name) {
      name = row.text("configuration");
      if (!names.insert(name).second)
        row.fail("configuration", "found " + quote(name) + " again, expected its rows once");
      points.push_back({config_of(name), {}});
    }
    const std::string& unit = row.text("unit");
    if (!kTimedUnits.contains(unit)) row.fail("unit", "found " + quote(unit) + ", expected dopu, pu, su, ru or top");
    if (!points.back().fo4.try_emplace(unit, row.real("path_fo4", kPositive)).second)
      row.fail("unit", "found a second row of " + quote(unit) + ", expected one");
  });
  for (const PathPoint& point : points) {
    if (point.fo4.size() != kTimedUnits.size())
      throw InputError(csv.string(), config_difference(point.config), "expected the rows dopu, pu, su, ru, top");
  }
  return points;
}

PathModel::PathModel(std::vector<PathPoint> points, UnitKnobs knobs)
    : points_(std::move(points)), knobs_(std::move(knobs)) {
  std::map<std::string, std::vector<std::vector<double>>> x;
  std::map<std::string, std::vector<double>> y;
  for (const PathPoint& point : points_) {
    for (const auto& [unit, path] : point.fo4) {
      x[unit].push_back(terms(unit, point.config));
      y[unit].push_back(path);
      Bounds& bounds = bounds_[kind_of(point.config)].try_emplace(unit, Bounds{path, path}).first->second;
      bounds = {std::min(bounds.least, path), std::max(bounds.largest, path)};
    }
  }
  for (auto& [unit, paths] : y) {
    const double largest = *std::max_element(paths.begin(), paths.end());
    for (double& path : paths) path /= largest;
    std::vector<double> ridges = kind_ridges();
    ridges.resize(x[unit].front().size(), kPathRidge);
    coefficients_[unit] = least_squares(x[unit], paths, ridges);
    for (double& coefficient : coefficients_[unit]) coefficient *= largest;
  }
}

std::vector<double> PathModel::terms(const std::string& unit, const Config& config) const {
  std::vector<double> x = kind_terms(config);
  const auto knobs = knobs_.find(unit);
  if (knobs == knobs_.end()) return x;
  for (const std::string& knob : knobs->second)
    x.push_back(scaled(config, knob) - scaled(points_.front().config, knob));
  return x;
}

std::map<std::string, double> PathModel::by_unit(const Config& config) const {
  std::map<std::string, double> paths;
  const auto kind = bounds_.find(kind_of(config));
  if (kind == bounds_.end()) return paths;
  for (const auto& [unit, bounds] : kind->second) {
    const std::vector<double>& coefficients = coefficients_.at(unit);
    const std::vector<double> x = terms(unit, config);
    double path = 0;
    for (size_t i = 0; i < x.size(); ++i) path += coefficients[i] * x[i];
    paths[unit] = std::clamp(path, bounds.least, bounds.largest);
  }
  return paths;
}

std::optional<double> PathModel::fo4(const Config& config) const {
  const std::map<std::string, double> paths = by_unit(config);
  if (paths.empty()) return std::nullopt;
  return longest_of(paths);
}

bool PathModel::inside(const Config& config) const {
  std::vector<Config> points;
  for (const PathPoint& point : points_) points.push_back(point.config);
  return within(config, points);
}

PathModel PathModel::without(size_t point) const {
  std::vector<PathPoint> rest = points_;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(point));
  return {rest, knobs_};
}

}  // namespace pipegs
