// SPDX-License-Identifier: Apache-2.0
// ranges.cpp: see ranges.hpp.
#include "sim/studies/rivals/compare/ranges.hpp"

#include <algorithm>
#include <array>

namespace pipegs {
namespace {

constexpr size_t kFps = 0, kFramesJ = 1, kFramesJDram = 2;
using Goals = std::array<double, 3>;

Goals goals_of(const MachineFrame& frame) {
  const double chip = frame.chip_joules;
  return {frame.fps(), chip > 0 ? 1 / chip : 0, frames_per_joule_with_dram(frame)};
}

Range spread(double mid, const std::vector<Goals>& found, size_t goal) {
  Range range{mid, mid, mid};
  for (const Goals& one : found)
    range.low = std::min(range.low, one[goal]), range.high = std::max(range.high, one[goal]);
  return range;
}

}  // namespace

double frames_per_joule_with_dram(const MachineFrame& frame) {
  const double all = frame.chip_joules + frame.dram_joules.mid;
  return all > 0 ? 1 / all : 0;
}

RivalResult rival_result(const Rival& rival, const FrameCounts& counts, PlayedMemory& memory) {
  const auto run = [&](const Values& changed) { return goals_of(frame_of(rival, counts, memory, changed)); };
  RivalResult result{.rival = &rival, .frame = frame_of(rival, counts, memory), .mm2 = rival.mm2_28()};
  std::array<Values, 3> help, hurt;
  std::vector<Goals> found;
  for (const Parameter& one : rival.parameters) {
    if (one.low == one.high) continue;
    const Goals low = run({{one.name, one.low}}), high = run({{one.name, one.high}});
    result.swings.push_back({&one, low[kFps], high[kFps], low[kFramesJDram], high[kFramesJDram]});
    for (size_t g = 0; g < help.size(); ++g) {
      help[g][one.name] = low[g] > high[g] ? one.low : one.high;
      hurt[g][one.name] = low[g] > high[g] ? one.high : one.low;
    }
    found.push_back(low), found.push_back(high);
  }
  for (size_t g = 0; g < help.size(); ++g) found.push_back(run(help[g])), found.push_back(run(hurt[g]));
  const Goals mid = goals_of(result.frame);
  Figures& figures = result.figures;
  figures.fps = spread(mid[kFps], found, kFps);
  figures.frames_j = spread(mid[kFramesJ], found, kFramesJ);
  figures.frames_j_dram = spread(mid[kFramesJDram], found, kFramesJDram);
  figures.fps_mm2 = ratio(figures.fps, result.mm2);
  return result;
}

OwnMachine own_machine(const std::string& name, const Config& config, const EngineResult& frame,
                       const FrameModel& model) {
  const std::optional<FrameCost> cost = model.cost(config, frame.cycles, frame.bytes);
  if (!cost) throw ConfigError(name + ": a machine whose area is not known cannot be compared");
  OwnMachine own{.name = name,
                 .ghz = std::min(1.0, cost->ghz().value_or(1.0)),
                 .cycles = static_cast<double>(frame.cycles),
                 .bytes = static_cast<double>(frame.bytes),
                 .mm2 = cost->mm2};
  const double fps = 1e9 * own.ghz / own.cycles;
  const auto frames_of = [](const Range& joules) { return Range{1 / joules.high, 1 / joules.mid, 1 / joules.low}; };
  const Range with_dram = cost->chip + Range{cost->dram.mid, cost->dram.mid, cost->dram.mid};
  own.figures = {{fps, fps, fps}, ratio({fps, fps, fps}, own.mm2), frames_of(cost->chip), frames_of(with_dram)};
  return own;
}

Range ratio(const Range& a, const Range& b) { return {a.low / b.high, a.mid / b.mid, a.high / b.low}; }

}  // namespace pipegs
