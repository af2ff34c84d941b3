// SPDX-License-Identifier: Apache-2.0
// area_model.hpp: gates of any configuration, interpolated between synthesised ones.
//
// Idea    A block is a module with what it holds of rtl/lib. Its NAND2 equivalents are a sum over the knobs that its
//         text depends on (synth/data/depends.csv): a line for a width, and a square, since a multiplier grows with the
//         product of two widths. Kinds of machines (machine_kind.hpp) are offsets; with living quads a block's lines
//         have another slope, too, because other lanes stand in it. Each block is fitted by least squares to
//         synth/data/points.csv; units are sums of blocks. Ridges hold back what few points do not tell, squares most.
// Copies  What stands in each unit, or in each PU that fetches, is fitted for one of them and multiplied: a block is so
//         when its instances are a multiple of `units`, or of pu_fronts, in every point, and of these what leaves the
//         fewest different ratios in a kind.
// Rule    A block stands in the unit where it stands in the points of the same kind. A kind without a point is not
//         known; beyond the knobs' ranges a configuration is extrapolated.
// Check   without(): the same model from all points but one, for the leave-one-out error of that one.
//         docs/numerics/accuracy.md shows the errors.
// Units   NAND2 equivalents, all instances; units are those of SynthUnit, top is what is left. Gates only: SRAMs are
//         silicon.hpp's.
// Errors  InputError: a table is missing or broken, or a block of the points has no row of knobs.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/silicon/area/machine_kind.hpp"
#include "sim/silicon/area/path_model.hpp"

namespace pipegs {

struct AreaPoint {
  Config config;
  std::map<std::string, std::map<std::string, double>> nand2 = {};  // by block, then by unit
  std::map<std::string, int> instances = {};                        // of each block, in all units; none: one

  std::map<std::string, double> by_unit() const;
};
std::vector<AreaPoint> read_area_points(const std::filesystem::path& csv);

using Dependences = std::map<std::string, std::vector<std::string>>;  // knobs of each block
Dependences read_dependences(const std::filesystem::path& csv);

class AreaModel {
 public:
  AreaModel(std::vector<AreaPoint> points, Dependences depends);

  bool knows(const Config& config) const;                           // whether a machine of its kind is among the points
  std::map<std::string, double> nand2(const Config& config) const;  // by unit; where not known, as the first point's
  bool inside(const Config& config) const;  // of the points' kinds and ranges; alike where no point moves
  UnitKnobs unit_knobs() const;             // those of the blocks in each unit; the top's are all

  const std::vector<AreaPoint>& points() const { return points_; }
  AreaModel without(size_t point) const;

 private:
  enum class Copies { kOne, kFronts, kUnits };
  struct Block {
    std::vector<std::string> knobs;
    Copies copies = Copies::kOne;
    std::vector<double> coefficients;
  };
  static int count(Copies copies, const Config& config);
  Copies copies_of(const std::string& name) const;
  void fit(const std::string& name, Block& block) const;
  std::vector<double> terms(const Block& block, const Config& config) const;

  std::vector<AreaPoint> points_;
  Dependences depends_;
  std::map<std::string, Block> blocks_;
  std::map<MachineKind, std::map<std::string, std::map<std::string, double>>>
      places_;  // of each block: how much of it stands in which unit
};

double sum(const std::map<std::string, double>& by_unit);

}  // namespace pipegs
