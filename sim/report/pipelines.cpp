// SPDX-License-Identifier: Apache-2.0
// pipelines.cpp: see pipelines.hpp. Lengths are SVG user units (pixels at normal size).
#include "sim/report/pipelines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/chart.hpp"
#include "sim/report/svg.hpp"

namespace pipegs {
namespace {

constexpr double kWidth = 960, kLeft = 132, kRight = 16;
constexpr double kTop = 40, kName = 20, kRow = 18, kGap = 12, kFoot = 44;
constexpr double kThinnest = 0.25;

double height_of(const MachinePipeline& machine) {
  return kName + kRow * static_cast<double>(machine.rows.size()) + kGap;
}

}  // namespace

std::string pipelines_svg(const std::string& title, const std::vector<MachinePipeline>& machines) {
  double longest = 0, height = kTop + kFoot;
  for (const MachinePipeline& machine : machines) {
    longest = std::max(longest, machine.end);
    height += height_of(machine);
  }
  if (!(longest > 0)) longest = 1;
  const auto place = [&](double us) { return kLeft + us / longest * (kWidth - kLeft - kRight); };
  std::string svg = svg_head(kWidth, height);
  svg += svg_text(kWidth / 2, 22, "middle", title, " font-size=\"13\" font-weight=\"bold\"");
  double y = kTop;
  for (const MachinePipeline& machine : machines) {
    svg += svg_text(8, y + 13, "start", machine.machine, " font-weight=\"bold\"");
    svg += svg_text(kLeft, y + 13, "start", machine.note, " fill-opacity=\"0.75\"");
    y += kName;
    for (size_t r = 0; r < machine.rows.size(); ++r, y += kRow) {
      const double floor = y + kRow - 3;
      svg += svg_text(kLeft - 8, floor - 2, "end", machine.rows[r].unit);
      svg += fmt::format(
          "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"currentColor\" "
          "stroke-opacity=\"0.2\"/>\n",
          place(0), floor, place(machine.end), floor);
      for (const PipelineBar& bar : machine.rows[r].bars) {
        const double x = place(bar.begin), high = (kRow - 4) * std::clamp(bar.share, 0.0, 1.0);
        if (high <= 0) continue;
        svg += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\">", x,
                           floor - high, std::max(kThinnest, place(bar.end) - x), high, svg_color(r));
        if (!bar.what.empty()) svg += "<title>" + svg_escaped(bar.what) + "</title>";
        svg += "</rect>\n";
      }
    }
    svg += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"currentColor\" "
        "stroke-dasharray=\"3 3\"/>\n",
        place(machine.end), y - kRow * static_cast<double>(machine.rows.size()), y);
    y += kGap;
  }
  svg += fmt::format("<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"currentColor\"/>\n",
                     kLeft, y, kWidth - kRight);
  for (const double tick : axis_ticks(0, longest, false)) {
    if (tick > longest * 1.0001) continue;
    svg += svg_text(place(tick), y + 16, "middle", fmt::format("{:g}", tick));
  }
  svg += svg_text((kLeft + kWidth - kRight) / 2, y + 34, "middle", "us");
  return svg + "</svg>\n";
}

void BusyPieces::cycle(uint64_t cycle, const uint8_t* states) {
  if (cycle / kCycles >= pieces_.size()) pieces_.resize(cycle / kCycles + 1);
  Piece& piece = pieces_[cycle / kCycles];
  cycles_ = std::max(cycles_, cycle + 1);
  piece[0] += states[0] == kBusy;
  for (int kind = 1, unit = 1; kind < 4; ++kind) {
    for (int k = 0; k < units_; ++k, ++unit) piece[static_cast<size_t>(kind)] += states[unit] == kBusy;
  }
}

std::vector<PipelineRow> BusyPieces::rows(uint64_t bars, double ghz) const {
  std::vector<PipelineRow> rows = {{"DOPU", {}}, {"PU", {}}, {"SU", {}}, {"RU", {}}};
  const uint64_t step = std::max<uint64_t>(1, (pieces_.size() + bars - 1) / std::max<uint64_t>(1, bars));
  for (uint64_t first = 0; first < pieces_.size(); first += step) {
    const uint64_t last = std::min<uint64_t>(first + step, pieces_.size());
    const double begin = static_cast<double>(first * kCycles),
                 end = static_cast<double>(std::min(last * kCycles, cycles_));
    for (size_t kind = 0; kind < rows.size(); ++kind) {
      uint64_t busy = 0;
      for (uint64_t i = first; i < last; ++i) busy += pieces_[i][kind];
      const double units = kind == 0 ? 1 : units_;
      rows[kind].bars.push_back(
          {begin / ghz / 1e3, end / ghz / 1e3, static_cast<double>(busy) / units / (end - begin), {}});
    }
  }
  return rows;
}

}  // namespace pipegs
