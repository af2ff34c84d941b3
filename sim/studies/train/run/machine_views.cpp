// SPDX-License-Identifier: Apache-2.0
// machine_views: see machine_views.hpp.
#include "sim/studies/train/run/machine_views.hpp"

#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {

MachineViews machine_views(const std::string& name, const Config& config, const Scene& scene,
                           const std::vector<TrainingView>& views, const Advance& advance) {
  SimulateOptions options;
  options.config = config;
  options.memory.dram = kDefaultDram;
  std::vector<Camera> cameras;
  for (const TrainingView& view : views) cameras.push_back(view.camera);
  const PackedScene packed = pack_views(scene, cameras, options);
  MachineViews seen{name, {}, {}};
  for (std::size_t i = 0; i < views.size(); ++i) {
    advance(static_cast<double>(i) / static_cast<double>(views.size()));
    Simulation simulation;
    simulate_frame(packed, views[i].camera, options, simulation);
    simulate_golden(simulation);
    seen.likeness.push_back(likeness(simulation.golden.image, views[i].image()));
    seen.cycles.push_back(timing_run(timing_trace(simulation.input), config, options.memory).cycles);
  }
  return seen;
}

std::vector<MachineViews> both_machines(const Scene& scene, const std::vector<TrainingView>& views, int layers,
                                        const Advance& advance) {
  Config paper = find_design_point("dop").config;
  paper.grid = layers;
  const auto half = [&](double from) { return [&advance, from](double share) { advance(from + share / 2); }; };
  return {machine_views("dop", paper, scene, views, half(0)),
          machine_views(std::string(kDefaultDesignPoint), find_design_point(kDefaultDesignPoint).config, scene, views,
                        half(0.5))};
}

}  // namespace pipegs
