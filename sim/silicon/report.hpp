// SPDX-License-Identifier: Apache-2.0
// report.hpp: what `pipegs silicon` prints: area, clock and energy of configurations beside what others published.
//
// Rule    Frames per second are those of the clock that a design point reaches: 1 GHz, or less where its longest path
//         asks for it. Power at 60 frames per second is that of a machine that stands still, with its power on, for the
//         rest of each sixtieth; the published powers are those of full speed, of the chip without DRAM.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/silicon/energy/energy.hpp"

namespace pipegs {

nlohmann::ordered_json to_json(const Range& range);

struct SiliconPoint {
  std::string name;
  Synth synth;
  std::vector<SiliconRow> rows;
  uint64_t cycles = 0;                 // of the view
  std::vector<EnergyRow> energy = {};  // empty when it was not asked for
  std::vector<ModuleClocks> clocks = {};

  double ghz() const { return std::min(1.0, 1e3 / rows.back().path_ps.mid); }
  double us() const { return static_cast<double>(cycles) / (1e3 * ghz()); }  // of a frame
  double fps() const { return 1e6 / us(); }
  double mm2() const { return rows.back().area_mm2.mid; }
  double fps_per_mm2() const { return fps() / mm2(); }
  const EnergyRow& chip() const { return energy[energy.size() - 2]; }
  double frames_per_joule() const { return fps() / chip().watts(fps()).mid; }  // of the chip
  double frames_per_joule_with_dram() const {
    return fps() / (chip().watts(fps()).mid + energy.back().watts(fps()).mid);
  }
};

nlohmann::ordered_json to_json(const std::vector<SiliconPoint>& design_points);
std::vector<Table> silicon_tables(const std::vector<SiliconPoint>& design_points);
std::vector<Chart> silicon_charts(const std::vector<SiliconPoint>& design_points);

}  // namespace pipegs
