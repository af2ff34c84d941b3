// SPDX-License-Identifier: Apache-2.0
// area_model.cpp: see area_model.hpp.
#include "sim/silicon/area/area_model.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "scenes/input_error.hpp"
#include "scenes/text/csv.hpp"
#include "sim/silicon/area/least_squares.hpp"

namespace pipegs {
namespace {

constexpr const char* kPointsHeader = "configuration,unit,block,instances,nand2,flipflops";
constexpr const char* kDependsHeader = "block,knobs";
// Beside a block's mean area of 1: what a coefficient may cost. A knob's whole range is 2. Live: with living quads.
constexpr double kLineRidge = 1e-4, kSquareRidge = 1e-2, kLiveRidge = 1e-3;

}  // namespace

double sum(const std::map<std::string, double>& by_unit) {
  double all = 0;
  for (const auto& [unit, nand2] : by_unit) all += nand2;
  return all;
}

std::map<std::string, double> AreaPoint::by_unit() const {
  std::map<std::string, double> units;
  for (const auto& [block, places] : nand2) {
    for (const auto& [unit, area] : places) units[unit] += area;
  }
  return units;
}

std::vector<AreaPoint> read_area_points(const std::filesystem::path& csv) {
  std::vector<AreaPoint> points;
  std::set<std::string> names;
  std::string name;
  read_csv(csv, kPointsHeader, [&](const CsvRow& row) {
    if (row.text("configuration") != name) {
      name = row.text("configuration");
      if (!names.insert(name).second)
        row.fail("configuration", "found " + quote(name) + " again, expected its rows once");
      points.push_back({.config = config_of(name)});
    }
    const int instances = row.integer<int>("instances", 1);
    row.integer<int>("flipflops", 0);
    const std::string &block = row.text("block"), &unit = row.text("unit");
    if (!points.back().nand2[block].try_emplace(unit, row.real("nand2", kNotNegative)).second)
      row.fail("block", "found a second row of " + quote(block) + " in " + quote(unit) + ", expected one");
    points.back().instances[block] += instances;
  });
  if (points.empty()) throw InputError(csv.string(), "", "no points");
  return points;
}

Dependences read_dependences(const std::filesystem::path& csv) {
  Dependences depends;
  read_csv(csv, kDependsHeader, [&](const CsvRow& row) {
    const auto [place, is_new] = depends.try_emplace(row.text("block"));
    if (!is_new) row.fail("block", "found a second " + quote(row.text("block")) + ", expected one");
    std::stringstream text(row.text("knobs"));
    for (std::string knob; text >> knob;) {
      config_value(Config{}, knob);
      if (std::find(place->second.begin(), place->second.end(), knob) != place->second.end())
        row.fail("knobs", "found a second " + quote(knob) + ", expected one");
      place->second.push_back(knob);
    }
  });
  return depends;
}

AreaModel::AreaModel(std::vector<AreaPoint> points, Dependences depends)
    : points_(std::move(points)), depends_(std::move(depends)) {
  for (const AreaPoint& point : points_) {
    for (const auto& [name, places] : point.nand2) {
      const auto depends = depends_.find(name);
      if (depends == depends_.end())
        throw InputError("synth/data/depends.csv", "block " + name, "missing: synth/depends.py finds its knobs");
      blocks_[name].knobs = depends->second;
      if (sum(places) > 0) places_[kind_of(point.config)].try_emplace(name, places);
    }
  }
  for (auto& [name, block] : blocks_) {
    block.copies = copies_of(name);
    fit(name, block);
  }
}

int AreaModel::count(Copies copies, const Config& config) {
  if (copies == Copies::kUnits) return config.units;
  return copies == Copies::kFronts ? config.pu_fronts() : 1;
}

AreaModel::Copies AreaModel::copies_of(const std::string& name) const {
  Copies best = Copies::kOne;
  size_t fewest = std::numeric_limits<size_t>::max();
  for (const Copies copies : {Copies::kUnits, Copies::kFronts, Copies::kOne}) {
    std::set<std::pair<MachineKind, int>> ratios;
    bool whole = true;
    for (const AreaPoint& point : points_) {
      const auto instances = point.instances.find(name);
      if (!point.nand2.contains(name)) continue;
      const int all = instances == point.instances.end() ? 1 : instances->second, each = count(copies, point.config);
      whole = whole && all % each == 0;
      ratios.insert({kind_of(point.config), all / each});
    }
    if (whole && ratios.size() < fewest) best = copies, fewest = ratios.size();
  }
  return best;
}

void AreaModel::fit(const std::string& name, Block& block) const {
  std::vector<std::vector<double>> x;
  std::vector<double> y, ridge = kind_ridges();
  double mean = 0;
  for (const AreaPoint& point : points_) {
    if (!places_.at(kind_of(point.config)).contains(name)) continue;  // no part of such a machine
    const auto found = point.nand2.find(name);
    x.push_back(terms(block, point.config));
    y.push_back(found == point.nand2.end() ? 0 : sum(found->second) / count(block.copies, point.config));
    mean += y.back();
  }
  if (mean == 0) {
    block.coefficients.assign(ridge.size() + 3 * block.knobs.size(), 0);
    return;
  }
  mean /= static_cast<double>(y.size());
  for (size_t i = 0; i < block.knobs.size(); ++i) ridge.insert(ridge.end(), {kLineRidge, kSquareRidge, kLiveRidge});
  for (double& area : y) area /= mean;
  block.coefficients = least_squares(x, y, ridge);
  for (double& coefficient : block.coefficients) coefficient *= mean;
}

std::vector<double> AreaModel::terms(const Block& block, const Config& config) const {
  std::vector<double> x = kind_terms(config);
  for (const std::string& knob : block.knobs) {
    const double at = scaled(config, knob) - scaled(points_.front().config, knob);
    x.push_back(at);
    x.push_back(at * at);
    x.push_back(at * config.quads);
  }
  return x;
}

bool AreaModel::knows(const Config& config) const { return places_.contains(kind_of(config)); }

std::map<std::string, double> AreaModel::nand2(const Config& config) const {
  std::map<std::string, double> units;
  for (const auto& [name, places] : places_.at(kind_of(knows(config) ? config : points_.front().config))) {
    const Block& block = blocks_.at(name);
    const std::vector<double> x = terms(block, config);
    double area = 0;
    for (size_t i = 0; i < x.size(); ++i) area += block.coefficients[i] * x[i];
    area = std::max(0.0, area) * count(block.copies, config);
    for (const auto& [unit, part] : places) units[unit] += area * part / sum(places);
  }
  return units;
}

bool AreaModel::inside(const Config& config) const {
  std::vector<Config> points;
  for (const AreaPoint& point : points_) points.push_back(point.config);
  return within(config, points);
}

UnitKnobs AreaModel::unit_knobs() const {
  std::map<std::string, std::set<std::string>> found;
  for (const AreaPoint& point : points_) {
    for (const auto& [name, places] : point.nand2) {
      const std::vector<std::string>& knobs = blocks_.at(name).knobs;
      found["top"].insert(knobs.begin(), knobs.end());
      for (const auto& [unit, area] : places) found[unit].insert(knobs.begin(), knobs.end());
    }
  }
  UnitKnobs result;
  for (const auto& [unit, knobs] : found) result[unit].assign(knobs.begin(), knobs.end());
  return result;
}

AreaModel AreaModel::without(size_t point) const {
  std::vector<AreaPoint> rest = points_;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(point));
  return {rest, depends_};
}

}  // namespace pipegs
