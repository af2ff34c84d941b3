// SPDX-License-Identifier: Apache-2.0
// stability.hpp: one hard scene through golden model, RTL and bounds: what every test of this folder asks.
//
//   expect_stable("T05", scene, camera)   golden = RTL on every beat and pixel, with assertions on, on `dop`, `exact`
//                                         and `fast`; alpha, T and colour differ from the truth by at most the bounds
//                                         of sim/bounds/budget.hpp
// The figures (worst error and worst bound) are printed and stand in the test's XML; docs/numerics/stability.md quotes
// them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/bounds/frame.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {

inline SimulateOptions stable_machine(const std::vector<std::string>& settings = {}) {
  SimulateOptions options;
  for (const std::string& setting : settings) config_set(options.config, setting);
  options.memory.jitter = 20;
  return options;
}

// The paper's machine, the one without layers, and the default one: all exist in every `make test`.
inline const std::vector<std::string> kExact = {"late=1", "order=2", "records=2048", "bucket_bits=5"};
inline std::vector<SimulateOptions> stable_machines() {
  std::vector<SimulateOptions> machines = {stable_machine(), stable_machine(kExact), stable_machine()};
  machines.back().config = find_design_point(kDefaultDesignPoint).config;
  return machines;
}

struct Stable {
  bool vacuous_allowed = false;  // pairs for which no bound can be given (a splat whose record is clipped)
  bool rtl = true;
  double near_plane = 0.2;
};

// Golden against the bounds.
inline void expect_bounded(const std::string& name, const Scene& scene, const Camera& camera,
                           const SimulateOptions& options, const Simulation& simulation, const Stable& stable = {}) {
  const BudgetReport report = budget_frame(scene, camera, options, simulation);
  EXPECT_TRUE(report.holds()) << name << ", " << config_difference(options.config) << ": " << *report.first;
  if (!stable.vacuous_allowed) { EXPECT_EQ(report.vacuous, 0u) << name; }
  std::printf("%s %s: alpha %.5f of %.5f, T %.5f of %.5f, colour %.5f of %.5f, power %.3g, %zu pairs\n", name.c_str(),
              config_difference(options.config).c_str(), report.alpha.error, report.alpha.bound, report.t.error,
              report.t.bound, report.color.error, report.color.bound, report.power_bound, report.pairs);
}

inline void expect_rtl_equal(const std::string& name, const SimulateOptions& options, Simulation& simulation) {
  simulate_rtl(options, simulation);
  EXPECT_EQ(simulation.mismatches, 0u) << name << ", " << config_difference(options.config) << ": window "
                                       << simulation.first_mismatch->window_x << ","
                                       << simulation.first_mismatch->window_y << ": "
                                       << simulation.first_mismatch->what;
}

// `result`: the simulation of `dop`.
inline void expect_stable(const std::string& name, const Scene& scene, const Camera& camera, Simulation& result,
                          const Stable& stable = {}) {
  std::vector<SimulateOptions> machines = stable_machines();
  for (size_t i = 0; i < machines.size(); ++i) {
    SCOPED_TRACE(name);
    machines[i].near_plane = stable.near_plane;
    Simulation other;
    Simulation& simulation = i == 0 ? result : other;
    simulate_golden(scene, camera, machines[i], simulation);
    expect_bounded(name, scene, camera, machines[i], simulation, stable);
    if (stable.rtl) expect_rtl_equal(name, machines[i], simulation);
  }
}

inline void expect_stable(const std::string& name, const Scene& scene, const Camera& camera,
                          const Stable& stable = {}) {
  Simulation result;
  expect_stable(name, scene, camera, result, stable);
}

}  // namespace pipegs
