// SPDX-License-Identifier: Apache-2.0
// frame_model.hpp: area and clock of any configuration, time and energy of any frame, interpolated, without synthesis
// and without RTL.
//
// Idea    Area: gates from the area model, SRAMs from their law, which is exact. Clock: what the longest path of the
//         path model allows, above 1 GHz too; a frame takes cycles / clock. Energy of a frame: a unit's gates take
//         so many joules for each NAND2 and cycle of the frame, an SRAM access so many for what an access costs there:
//         rates of frames that `pipegs silicon` has measured (synth/data/energy.csv; `make figures` writes it), mean
//         over those of the same design point. Leakage follows area and cycles, DRAM follows bytes.
// Rule    A design point of which no frame was measured takes the mean over all design points; that is extrapolated,
//         like areas beyond the points. Where no path of the kind is known, time counts at 1 GHz.
// Trust   Rates differ from scene to scene and design point to design point: docs/numerics/accuracy.md has
//         the leave-one-out errors.
// Units   mm2, us, J of a frame at full speed; ranges of process.hpp.
// Errors  InputError: a table is missing or broken.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/silicon/area/area_model.hpp"
#include "sim/silicon/area/path_model.hpp"
#include "sim/silicon/energy/energy.hpp"

namespace pipegs {

struct MeasuredFrame {
  std::string scene;
  Config config;
  uint64_t cycles = 0;
  std::map<std::string, double> kilo_nand2;  // by row of energy.hpp
  std::map<std::string, double> joules;      // by row, mid, without leakage
};
std::vector<MeasuredFrame> read_frames(const std::filesystem::path& csv);

struct FrameCost {
  Range mm2;                                      // gates and SRAMs
  Range chip, dram;                               // J, leakage in the chip's
  std::optional<double> path_fo4 = std::nullopt;  // the longest; none where no path of such a machine is known
  double us = 0;                                  // cycles / clock, at 1 GHz where that is not known
  bool extrapolated_area = false, extrapolated_energy = false, extrapolated_path = false;

  std::optional<double> ghz() const { return path_fo4 ? std::optional(1e3 / (*path_fo4 * kFo4Ps.mid)) : std::nullopt; }
  double joules() const { return chip.mid + dram.mid; }
};

// "3.12", or "~3.12" beyond what was synthesised or measured.
std::string interpolated_text(double value, bool extrapolated, int digits);

class FrameModel {
 public:
  FrameModel(AreaModel area, PathModel paths, SramLaw law, std::vector<MeasuredFrame> frames);

  // None of a machine whose area the model does not know.
  std::optional<FrameCost> cost(const Config& config, uint64_t cycles, uint64_t bytes) const;
  Range dynamic(const Config& config, const std::map<std::string, double>& kilo_nand2,
                uint64_t cycles) const;  // of the chip, without leakage

  const AreaModel& area() const { return area_; }
  const PathModel& paths() const { return paths_; }
  const std::vector<MeasuredFrame>& frames() const { return frames_; }
  FrameModel without(size_t frame) const;

 private:
  bool measured(const Config& config) const;
  double rate(const std::string& row,
              const Config& config) const;  // of a design point: J for each cycle and unit of size

  AreaModel area_;
  PathModel paths_;
  SramLaw law_;
  std::vector<MeasuredFrame> frames_;
};

// Of the tables in synth/.
FrameModel read_frame_model();

}  // namespace pipegs
