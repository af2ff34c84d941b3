// SPDX-License-Identifier: Apache-2.0
// pipelines.hpp: the pipelines of several machines beneath each other on one axis of time, as the paper's Fig. 1 has
// them, from frames and not from a drawing.
//
// Idea    A machine has a row for each kind of unit. A row has bars: from when to when, and how high: the share of its
//         units that work. So a stage that waits for another one is an empty row, and a stage beside another one
//         is two filled rows.
// Units   Microseconds.
#pragma once

#include <string>
#include <vector>

#include "sim/compare/frame_watch.hpp"

namespace pipegs {

struct PipelineBar {
  double begin = 0, end = 0;
  double share = 0;  // of the row's units that work, 0 to 1
  std::string what = {};
};

struct PipelineRow {
  std::string unit;
  std::vector<PipelineBar> bars;
};

struct MachinePipeline {
  std::string machine, note;  // note: what is drawn, beside the name
  double end = 0;             // of the frame
  std::vector<PipelineRow> rows;
};

// A whole SVG file, in the colours of chart.hpp. Bars that are too thin to be seen are drawn at their least width.
std::string pipelines_svg(const std::string& title, const std::vector<MachinePipeline>& machines);

// How much of each kind of unit of the RTL works, in pieces of equal length.
class BusyPieces final : public FrameWatch {
 public:
  static constexpr uint64_t kCycles = 256;  // of a piece
  explicit BusyPieces(const Config& config) : FrameWatch(config), units_(config.units) {}
  // At most `bars` bars for the kinds DOPU, PU, SU and RU, each of the mean of its pieces.
  std::vector<PipelineRow> rows(uint64_t bars, double ghz) const;

 private:
  using Piece = std::array<uint64_t, 4>;  // busy cycles, summed over the units of a kind
  void cycle(uint64_t cycle, const uint8_t* states) override;

  int units_;
  uint64_t cycles_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace pipegs
