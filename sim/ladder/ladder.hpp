// SPDX-License-Identifier: Apache-2.0
// ladder.hpp: one view on several design points, and what each of them did: the figures of the paper's Fig. 8 and 9.
//
// Idea    Every design point runs the same scene on the same memory through golden model and RTL, compared as `sim`
//         does. All figures come from those runs: cycles of the performance counters, what the taps show, bytes of the
//         memory.
// Docs    docs/commands.md names each figure.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/report/chart.hpp"
#include "sim/report/table.hpp"
#include "sim/compare/frame_watch.hpp"
#include "sim/design/design_point.hpp"
#include "sim/design/static_cost.hpp"
#include "sim/ladder/frame_figures.hpp"

namespace pipegs {

// Busy cycles of the units of a kind while they were in one window, summed over the units.
struct WindowCycles {
  uint64_t sort = 0, raster = 0;
};

// What the figures need beside the performance counters.
class FigureWatch final : public FrameWatch {
 public:
  using FrameWatch::FrameWatch;
  const std::vector<WindowCycles>& windows() const { return windows_; }

 private:
  void cycle(uint64_t cycle, const uint8_t* states) override;
  WindowCycles& at(uint64_t window);
  std::vector<WindowCycles> windows_;
};

// Busy cycles summed over units.
uint64_t busy_cycles(const std::vector<UnitCycles>& units);
// Raster over sort of the windows that sorted something.
std::vector<double> window_ratios(const std::vector<WindowCycles>& windows);
double mean(const std::vector<double>& values);  // NaN without values

// One design point's row of the ladder. Figures that could not be had are NaN.
struct LadderRow {
  const DesignPoint* design_point = nullptr;
  SimulateOptions options;
  std::string failure;  // one line when the design point did not run; then nothing below holds
  FrameFigures frame;
  uint64_t mismatches = 0;
  double raster_over_sort = 0, raster_over_sort_window = 0;  // of all busy cycles; mean over the windows
  double bubbles = 0;                                        // share of the RUs' cycles in which they were not busy
  double exposed = 0;                                        // cycles before the first line is blended
  bool has_alpha_stores = false;
  uint64_t peak_alpha_lines = 0, peak_records = 0;
  double psnr_order = 0, psnr_numeric = 0;
  bool with_truth = false;
  std::string same_pixels;        // the first design point above that has the same picture, bit for bit
  uint64_t different_pixels = 0;  // from the first design point above that must draw the same picture
  std::vector<UnitCycles> ru;
  StaticCost cost;
};

// Fills the row from a simulation that was watched by `watch`.
void ladder_figures(LadderRow& row, const Simulation& simulation, const FigureWatch& watch);

nlohmann::ordered_json ladder_json(const std::vector<LadderRow>& rows);
std::vector<Table> ladder_tables(const std::vector<LadderRow>& rows);
std::vector<Chart> ladder_charts(const std::vector<LadderRow>& rows);

}  // namespace pipegs
