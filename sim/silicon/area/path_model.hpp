// SPDX-License-Identifier: Apache-2.0
// path_model.hpp: the longest path of any configuration, interpolated between synthesised ones: its clock.
//
// Idea    The longest path between registers of each unit, and of the whole machine (top), in FO4 delays of the
//         library that timed it: those cross to 28 nm. Each is fitted by least squares over the knobs of the unit's
//         blocks, a line for each, with the offsets of kinds (machine_kind.hpp); ridges keep weak terms small.
// Rule    The longest path is a property of a few gates, not a sum over blocks. So the result is clamped to the range
//         that was measured of the kind; of a kind without a point there is none. The machine's path is the longest of
//         all units'.
// Check   without(): the same model from all points but one.
// Errors  InputError: the table is broken. One that is missing, or holds its header only, has no points.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/silicon/area/machine_kind.hpp"

namespace pipegs {

struct PathPoint {
  Config config;
  std::map<std::string, double> fo4;  // by unit: dopu, pu, su, ru, top

  double longest() const;
};
std::vector<PathPoint> read_path_points(const std::filesystem::path& csv);

using UnitKnobs = std::map<std::string, std::vector<std::string>>;  // on which each unit depends

class PathModel {
 public:
  PathModel() = default;  // knows nothing
  PathModel(std::vector<PathPoint> points, UnitKnobs knobs);

  std::map<std::string, double> by_unit(const Config& config) const;  // empty of a kind without a point
  std::optional<double> fo4(const Config& config) const;              // of the machine
  bool inside(const Config& config) const;                            // of the points' kinds and ranges

  const std::vector<PathPoint>& points() const { return points_; }
  PathModel without(size_t point) const;

 private:
  struct Bounds {
    double least, largest;
  };
  std::vector<double> terms(const std::string& unit, const Config& config) const;

  std::vector<PathPoint> points_;
  UnitKnobs knobs_;
  std::map<std::string, std::vector<double>> coefficients_;  // by unit
  std::map<MachineKind, std::map<std::string, Bounds>> bounds_;
};

}  // namespace pipegs
