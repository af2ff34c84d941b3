// SPDX-License-Identifier: Apache-2.0
// frame_figures.cpp: see frame_figures.hpp.
#include "sim/ladder/frame_figures.hpp"

#include <cmath>
#include <limits>

#include "sim/report/report.hpp"

namespace pipegs {

uint64_t FrameFigures::bytes() const {
  uint64_t sum = 0;
  for (const MemoryTraffic& stream : traffic) sum += stream.bytes_read + stream.bytes_written;
  return sum;
}

FrameFigures frame_figures(const Simulation& simulation, const SimulateOptions& options, uint64_t cycles) {
  const Bounds bounds = work_bounds(simulation, options);
  return {cycles, simulation.traffic, ratio(static_cast<double>(cycles), bounds.largest), bounds.largest_name};
}

double ratio(double a, double b) { return b > 0 ? a / b : std::numeric_limits<double>::quiet_NaN(); }

TableCell figure_cell(double value) { return std::isfinite(value) ? number_cell(value) : text_cell("-"); }

TableCell decibel_cell(double value) { return std::isinf(value) ? text_cell("equal") : figure_cell(value); }

}  // namespace pipegs
