// SPDX-License-Identifier: Apache-2.0
// report.hpp: what `pipegs silicon` prints: area, clock and energy of configurations beside what others published.
//
// Rule    Frames per second are those of 1 GHz. Power at 60 frames per second is that of a machine that stands still,
//         with its power on, for the rest of each sixtieth; the published powers are those of full speed, of the chip
//         without DRAM.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/study/silicon/energy/energy.hpp"

namespace pipegs {

struct SiliconPoint {
  std::string name;
  Synth synth;
  std::vector<SiliconRow> rows;
  uint64_t cycles = 0;                 // of the view
  std::vector<EnergyRow> energy = {};  // empty when it was not asked for
  std::vector<ModuleClocks> clocks = {};

  double fps() const { return 1e9 / static_cast<double>(cycles); }
  double mm2() const { return rows.back().area_mm2.mid; }
  double fps_per_mm2() const { return fps() / mm2(); }
  const EnergyRow& chip() const { return energy[energy.size() - 2]; }
  double frames_per_joule() const { return fps() / chip().watts(fps()).mid; }  // of the chip
  double frames_per_joule_with_dram() const {
    return fps() / (chip().watts(fps()).mid + energy.back().watts(fps()).mid);
  }
};

nlohmann::ordered_json to_json(const std::vector<SiliconPoint>& design_points);
std::string to_text(const std::vector<SiliconPoint>& design_points);
std::vector<Chart> silicon_charts(const std::vector<SiliconPoint>& design_points);

}  // namespace pipegs
