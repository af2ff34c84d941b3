// SPDX-License-Identifier: Apache-2.0
// ours.cpp: see ours.hpp.
#include "sim/studies/rivals/compare/ours.hpp"

#include <algorithm>

namespace pipegs {

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

}  // namespace pipegs
