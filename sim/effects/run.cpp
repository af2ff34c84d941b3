// SPDX-License-Identifier: Apache-2.0
// run.cpp: see run.hpp.
#include "sim/effects/run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/rtl/rtl_fault.hpp"
namespace pipegs {
namespace {

// The packed scene and the frame as the machine of `options` wants them. Of what effects leave out only bands of SH
// change the packing; the golden frame stays.
void repack(const Scene& scene, const Camera& camera, const SimulateOptions& options, Simulation& simulation) {
  if (std::min(scene.sh_degree, options.config.sh_degree) != simulation.packed.sh_degree) {
    simulate_pack(scene, camera, options, simulation);
  } else {
    simulation.packed.config = options.config;
    simulate_frame(simulation.packed, camera, options, simulation);
  }
}

// What a run without the effects left out shows to be wrong, or "".
std::string fault(const SimulateOptions& options, Simulation& simulation) {
  try {
    simulate_rtl(options, simulation);
  } catch (const RtlFault& error) { return error.what(); }
  return simulation.mismatches == 0
             ? ""
             : fmt::format("{} mismatches, {}", simulation.mismatches, simulation.first_mismatch->what);
}

}  // namespace

std::string simulate_effects(const Scene& scene, const Camera& camera, const SimulateOptions& full,
                             const EffectPlan& plan, Simulation& simulation) {
  if (plan.left_out.empty()) {
    simulate_rtl(full, simulation);
    return "";
  }
  repack(scene, camera, plan.options, simulation);
  const std::string found = fault(plan.options, simulation);
  if (found.empty()) return "";
  repack(scene, camera, full, simulation);
  simulate_rtl(full, simulation);
  return fmt::format("without {}: {}; with all effects {} mismatches: {}", fmt::join(plan.left_out, ", "), found,
                     simulation.mismatches,
                     simulation.mismatches == 0 ? "something left out is called for" : "the machine is wrong");
}

}  // namespace pipegs
