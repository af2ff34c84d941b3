// SPDX-License-Identifier: Apache-2.0
// frame_figures.hpp: what one machine took for a view, whoever counted its cycles: the RTL or the timing model.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/report/table.hpp"

namespace pipegs {

struct FrameFigures {
  uint64_t cycles = 0;
  std::vector<MemoryTraffic> traffic;
  double over_bound = 0;  // cycles over the largest bound: the roofline ratio; NaN without work
  std::string bound;      // which one that is

  uint64_t bytes() const;
  double megabytes() const { return static_cast<double>(bytes()) / 1e6; }
};

// Needs simulate_golden, and in the simulation the traffic that goes with these cycles.
FrameFigures frame_figures(const Simulation& simulation, const SimulateOptions& options, uint64_t cycles);

// a / b; NaN where b is not positive.
double ratio(double a, double b);

// "-" when there is no figure.
TableCell figure_cell(double value);
// A PSNR: "equal" of equal pictures.
TableCell decibel_cell(double value);

}  // namespace pipegs
