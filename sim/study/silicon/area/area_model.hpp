// SPDX-License-Identifier: Apache-2.0
// area_model.hpp: gates of any configuration, interpolated between synthesised ones.
//
// Idea    A block is a module with what it holds of rtl/lib. Its NAND2 equivalents are a sum over the knobs that its
//         text depends on (synth/data/depends.csv): a line for a width, and a square, since a multiplier grows with the
//         product of two widths. Design points (late, order, quadratic) are offsets. Each block is fitted by least
//         squares to synth/data/points.csv; units are sums of blocks. Ridges hold back what few points do not tell,
//         squares most.
// Rule    A block stands in the unit where it stands in the points of the same design point; of another design point
//         nothing is known, nor beyond the knobs' ranges: such a configuration is extrapolated.
// Check   without(): the same model from all points but one, for the leave-one-out error of that one.
//         docs/numerics/accuracy.md shows the errors.
// Units   NAND2 equivalents, all instances; units are those of SynthUnit, top is what is left. Gates only: SRAMs are
//         silicon.hpp's.
// Errors  InputError: a table is missing or broken, or a block of the points has no row of knobs.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct AreaPoint {
  Config config;
  std::map<std::string, std::map<std::string, double>> nand2;  // by block, then by unit

  std::map<std::string, double> by_unit() const;
};
std::vector<AreaPoint> read_area_points(const std::filesystem::path& csv);

using Dependences = std::map<std::string, std::vector<std::string>>;  // knobs of each block
Dependences read_dependences(const std::filesystem::path& csv);

class AreaModel {
 public:
  AreaModel(std::vector<AreaPoint> points, Dependences depends);

  bool knows(const Config& config) const;  // whether machines of its kind are among the points: none with quads is
  std::map<std::string, double> nand2(const Config& config) const;  // by unit; throws ConfigError when not known
  bool inside(const Config& config) const;  // of the points' design points and ranges; alike where no point moves

  const std::vector<AreaPoint>& points() const { return points_; }
  AreaModel without(size_t point) const;

 private:
  struct Block {
    std::vector<std::string> knobs;
    std::vector<double> coefficients;
  };
  using DesignPoint = std::array<int, 3>;  // late, order, quadratic
  static DesignPoint design_point_of(const Config& config);
  void fit(const std::string& name, Block& block) const;
  std::vector<double> terms(const Block& block, const Config& config) const;

  std::vector<AreaPoint> points_;
  Dependences depends_;
  std::map<std::string, Block> blocks_;
  std::map<DesignPoint, std::map<std::string, std::map<std::string, double>>>
      places_;  // of each block: how much of it stands in which unit
};

double sum(const std::map<std::string, double>& by_unit);

}  // namespace pipegs
