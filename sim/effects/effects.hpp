// SPDX-License-Identifier: Apache-2.0
// effects.hpp: parts of the machine and of its simulation that a scene and a camera may not call for, and doing
// without.
//
// Idea    One table. Each effect has a detector, which says with evidence whether the view calls for it, and a way to
//         leave it out: an entry of the configuration (the hardware is compiled out), a build variant, or host work.
// Rule    Leaving out what is not called for changes no pixel. A detector may be wrong all the same, so whoever leaves
//         something out compares every pixel with the golden frame of the full configuration (simulate_effects). What
//         went wrong is then looked for with all effects.
// Rule    `auto` also keeps what moves cycles alone: the external memory's timing is called for by whoever asks for
//         cycles.
// Docs    docs/cycles/timing_model.md
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {

// What the detectors look at. The golden model has run.
struct EffectFacts {
  const Scene& scene;
  const SimulateOptions& options;  // with everything simulated
  const Simulation& simulation;
  std::array<double, 4> sh_largest{};  // magnitude of the largest packed coefficient of each band, 1 to 3
  std::optional<TimingResult> timing;  // when the timing model was asked,
  uint64_t fixed_latency_cycles = 0;   // also with a memory that only has a latency
  const Called& called() const { return simulation.golden.called; }
};

// Gathers them; the golden model must have run. Asking the timing model costs a second pass over the scene.
EffectFacts effect_facts(const Scene& scene, const SimulateOptions& options, const Simulation& simulation,
                         bool ask_timing);

struct Effect {
  struct Verdict {
    bool called_for = true;
    std::string evidence;
  };
  std::string_view name, what;
  std::string_view without;  // what leaving it out is: a configuration entry, a build variant, host work
  Verdict (*detect)(const EffectFacts&);
  void (*leave_out)(SimulateOptions&);
};

const std::vector<Effect>& effects();

// What it costs: memory of the machine that falls away without it, or "".
std::string effect_cost(const Effect& effect, const SimulateOptions& options);

struct EffectFinding {
  const Effect* effect;
  Effect::Verdict verdict;
};
std::vector<EffectFinding> find_effects(const EffectFacts& facts);

// What a run simulates. `options` are those of the machine without the effects left out.
struct EffectPlan {
  SimulateOptions options;
  std::vector<std::string> simulated, left_out;
};
// Leaves out what is not called for.
EffectPlan plan_effects(const SimulateOptions& full, const std::vector<EffectFinding>& findings);
// Leaves out all but those named. Throws ConfigError, one line that names the known ones.
EffectPlan plan_effects(const SimulateOptions& full, const std::vector<std::string>& names);

// Runs the RTL of `plan`; simulate_golden() with `full` must have run. Returns "", or one line when something that was
// left out is called for: then the RTL has run once more, with everything, and `simulation` holds what that gave.
std::string simulate_effects(const Scene& scene, const Camera& camera, const SimulateOptions& full,
                             const EffectPlan& plan, Simulation& simulation);

}  // namespace pipegs
