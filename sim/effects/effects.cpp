// SPDX-License-Identifier: Apache-2.0
// effects.cpp: what the detectors look at, the table of effects, and a run without some of them; see effects.hpp.
#include "sim/effects/effects.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/pu_color_sum.hpp"
#include "sim/design/static_cost.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

// A coefficient is mantissa * 2^(exponent - kShExponentBias - ShMW), so |mantissa| << exponent compares all of them.
std::array<double, 4> largest_coefficients(const PackedScene& packed) {
  const Config& config = packed.config;
  std::array<uint64_t, 4> largest{};
  if (packed.sh_degree > 0) {
    const size_t per_line = static_cast<size_t>(color_slots_per_line(config, packed.sh_degree)),
                 slots = packed.slot_to_index.size();
    constexpr size_t kBlock = 16384;
    std::mutex mutex;
    parallel_for((slots + kBlock - 1) / kBlock, 0, [&](size_t block) {
      std::array<uint64_t, 4> mine{};
      for (size_t slot = block * kBlock; slot < std::min(slots, (block + 1) * kBlock); ++slot) {
        const ShMantissas found = sh_mantissas(config, packed.sh_degree, packed.colors[slot / per_line].data(),
                                               color_place(config, packed.sh_degree, slot));
        for (int band = 1; band <= packed.sh_degree; ++band) {
          uint64_t magnitude = 0;
          for (int i = sh_first(band); i < sh_first(band + 1); ++i)
            magnitude = std::max(magnitude, static_cast<uint64_t>(std::abs(found.of[static_cast<size_t>(i)])));
          uint64_t& most = mine[static_cast<size_t>(band)];
          most = std::max(most, magnitude << found.exponent);
        }
      }
      const std::lock_guard lock(mutex);
      for (size_t band = 1; band < 4; ++band) largest[band] = std::max(largest[band], mine[band]);
    });
  }
  std::array<double, 4> result{};
  for (size_t band = 1; band < 4; ++band)
    result[band] = std::ldexp(static_cast<double>(largest[band]), -kShExponentBias - config.sh_m_w);
  return result;
}

}  // namespace

EffectFacts effect_facts(const Scene& scene, const SimulateOptions& options, const Simulation& simulation,
                         bool ask_timing) {
  EffectFacts facts{.scene = scene,
                    .options = options,
                    .simulation = simulation,
                    .sh_largest = largest_coefficients(simulation.packed),
                    .timing = {}};
  if (ask_timing) {
    const TimingTrace trace = timing_trace(simulation.input);
    facts.timing = timing_run(trace, options.config, options.memory);
    ExternalMemoryOptions fixed = options.memory;
    fixed.dram = "ideal", fixed.jitter = 0;
    facts.fixed_latency_cycles = timing_run(trace, options.config, fixed).cycles;
  }
  return facts;
}

namespace {

using Verdict = Effect::Verdict;

// Band `band` of the SH colours; the hardware of a band needs those below it.
template <int band>
Verdict detect_sh(const EffectFacts& facts) {
  const int scene = facts.scene.sh_degree, config = facts.options.config.sh_degree;
  if (config < band) return {false, fmt::format("the configuration evaluates degree {}", config)};
  if (scene < band) return {false, fmt::format("the scene has degree {}", scene)};
  const bool higher = std::any_of(facts.sh_largest.begin() + band + 1, facts.sh_largest.end(),
                                  [](double largest) { return largest > 0; });
  const double largest = facts.sh_largest[band];
  return {largest > 0 || higher, fmt::format("largest coefficient {:.3g}{}", largest,
                                             largest == 0 && higher ? ", but a higher band needs it" : "")};
}

template <int band>
void leave_out_sh(SimulateOptions& options) {
  options.config.sh_degree = std::min(options.config.sh_degree, band - 1);
}

// An entry of the configuration that is 1 with the effect and 0 without.
template <int Config::*entry>
void without(SimulateOptions& options) {
  options.config.*entry = 0;
}

Verdict counted(uint64_t count, const char* what) { return {count > 0, fmt::format("{} {}", count, what)}; }

Verdict detect_antialias(const EffectFacts& facts) {
  return {facts.scene.antialiased,
          facts.scene.antialiased ? "the scene was trained with it" : "the scene was trained without"};
}

Verdict detect_saturation(const EffectFacts& facts) {
  const Saturations& s = facts.simulation.golden.saturations;
  return {s.color + s.accumulated > 0,
          fmt::format("{} colours, {} accumulated colours at the top", s.color, s.accumulated)};
}

Verdict detect_layers(const EffectFacts& facts) {
  if (!facts.options.config.has_layers()) return {false, "depth order without layers"};
  const uint64_t most = facts.called().layers;
  return {most > 1, fmt::format("at most {} layers of a window hold something", most)};
}

// Stores whose peak comes this near to their capacity may overflow where the timing model says that they do not.
constexpr double kFull = 0.9;

Verdict detect_overflow(const EffectFacts& facts) {
  const Config& config = facts.options.config;
  const Work& work = facts.simulation.golden.work;
  const bool lines_fit = !config.caches_alphas() || work.regions <= static_cast<uint64_t>(config.alpha_lines);
  if (lines_fit && work.records <= static_cast<uint64_t>(config.records)) {
    return {false, fmt::format("the whole frame has {} records, {} lines of alphas", work.records,
                               config.caches_alphas() ? work.regions : 0)};
  }
  if (!facts.timing) return {true, "may be: only the timing model knows how full the stores get"};
  const double lines = static_cast<double>(facts.timing->peak_lines) / config.alpha_lines,
               records = static_cast<double>(facts.timing->peak_records) / config.records;
  const std::string stores =
      fmt::format("{}record store {:.0f} % of capacity",
                  config.caches_alphas() ? fmt::format("peak alpha store {:.0f} %, ", 100 * lines) : "", 100 * records);
  return {facts.timing->overflow_lines > 0 || std::max(lines, records) > kFull,
          fmt::format("timing model: {}, {} lines overflow", stores, facts.timing->overflow_lines)};
}

// A chain of the SU is a bucket of depth, or a run of a set in memory.
Verdict detect_large_groups(const EffectFacts& facts) {
  const uint64_t most = facts.called().bucket;
  if (most > 16) return {true, fmt::format("a bucket of depth holds {} keys", most)};
  if (detect_overflow(facts).called_for) return {true, "records may overflow"};
  return {false, fmt::format("no bucket of depth holds more than {} keys", most)};
}

Verdict detect_dram(const EffectFacts& facts) {
  const ExternalMemoryOptions& memory = facts.options.memory;
  if (memory.dram == "ideal" && memory.jitter == 0) return {false, "the memory asked for has a fixed latency"};
  if (!facts.timing) return {true, "cycles are asked for"};
  const uint64_t cycles = facts.timing->cycles, fixed = facts.fixed_latency_cycles;
  return {cycles != fixed,
          fmt::format("timing model: {} cycles, {} with a fixed latency; pixels never depend on it", cycles, fixed)};
}

Verdict detect_waves(const EffectFacts& facts) {
  const bool asked = !facts.options.rtl.waves.empty();
  return {asked, asked ? "--waves" : "no --waves"};
}

Verdict detect_taps(const EffectFacts& facts) {
  if (facts.options.taps != nullptr || facts.options.watch) return {true, "someone watches the streams"};
  if (!facts.options.rtl.waves.empty()) return {true, "waves are read beside the streams"};
  return {false, "every pixel is compared; a mismatch is located by a second run with all"};
}

Verdict detect_asserts(const EffectFacts& facts) {
  if (detect_taps(facts).called_for) return {true, "someone looks for a fault"};
  return {false, "a broken rule shows as a pixel or as a machine that hangs"};
}

}  // namespace

// One line for each: name, what it is, what leaving it out is, detector, and how to leave it out.
const std::vector<Effect>& effects() {
  using Options = SimulateOptions;
  static const std::vector<Effect> table = {
      {"sh1", "SH band 1: colours that change with the direction", "sh_degree=0", detect_sh<1>, leave_out_sh<1>},
      {"sh2", "SH band 2", "sh_degree=1", detect_sh<2>, leave_out_sh<2>},
      {"sh3", "SH band 3", "sh_degree=2", detect_sh<3>, leave_out_sh<3>},
      {"antialias", "opacity lowered by what the dilation adds to the area", "antialias=0", detect_antialias,
       without<&Config::antialias>},
      {"near", "the near plane", "near_test=0",
       [](const EffectFacts& f) {
         return counted(f.called().near, "pairs of Gaussian and window before the near plane");
       },
       without<&Config::near_test>},
      {"guard_band", "clamp of the Jacobian's x/z and y/z", "guard_band=0",
       [](const EffectFacts& f) {
         return counted(f.called().guard, "visible pairs of Gaussian and window beyond the guard band");
       },
       without<&Config::guard_band>},
      {"saturation", "colours that clip at the top", "saturation=0", detect_saturation, without<&Config::saturation>},
      {"early_stop", "pixels and regions that close when they are opaque", "early_stop=0",
       [](const EffectFacts& f) { return counted(f.called().stopped, "pixels stopped"); },
       without<&Config::early_stop>},
      {"layers", "carry of T and RGB from layer to layer", "layered=0", detect_layers,
       [](Options& o) {
         if (o.config.has_layers()) o.config.layered = 0;
       }},
      {"ties", "order of equal depths by index", "index_ties=0",
       [](const EffectFacts& f) { return counted(f.called().ties, "neighbours of equal depth in the sorted order"); },
       without<&Config::index_ties>},
      {"overflow", "alphas, records and keys that go to external memory", "overflow=0", detect_overflow,
       without<&Config::overflow>},
      {"large_groups", "sort groups of more than 16 keys", "large_groups=0", detect_large_groups,
       without<&Config::large_groups>},
      {"dram", "external memory's timing beyond a fixed latency", "--memory ideal --jitter 0", detect_dram,
       [](Options& o) { o.memory.dram = "ideal", o.memory.jitter = 0; }},
      {"waves", "code that writes waves", "no variant +waves", detect_waves,
       [](Options& o) { o.variant.waves = false; }},
      {"taps", "streams at the top level, each beat compared", "taps=0", detect_taps,
       [](Options& o) { o.config.taps = 0; }},
      {"asserts", "assertions of the RTL", "variant +noasserts", detect_asserts,
       [](Options& o) { o.variant.asserts = false; }},
  };
  return table;
}

std::string effect_cost(const Effect& effect, const SimulateOptions& options) {
  SimulateOptions without = options;
  effect.leave_out(without);
  const double kb = static_cost(options.config).buffer_kb() - static_cost(without.config).buffer_kb();
  return kb > 0 ? fmt::format("{:.1f} KB", kb) : "";
}

std::vector<EffectFinding> find_effects(const EffectFacts& facts) {
  std::vector<EffectFinding> findings;
  for (const Effect& effect : effects()) findings.push_back({&effect, effect.detect(facts)});
  return findings;
}

namespace {

EffectPlan plan(const SimulateOptions& full, const std::vector<bool>& simulated) {
  EffectPlan result{full, {}, {}};
  for (size_t i = 0; i < effects().size(); ++i) {
    const Effect& effect = effects()[i];
    if (simulated[i]) {
      result.simulated.emplace_back(effect.name);
      continue;
    }
    effect.leave_out(result.options);
    result.left_out.emplace_back(effect.name);
  }
  config_check(result.options.config);
  return result;
}

}  // namespace

EffectPlan plan_effects(const SimulateOptions& full, const std::vector<EffectFinding>& findings) {
  std::vector<bool> simulated;
  for (const EffectFinding& finding : findings) simulated.push_back(finding.verdict.called_for);
  return plan(full, simulated);
}

EffectPlan plan_effects(const SimulateOptions& full, const std::vector<std::string>& names) {
  std::vector<bool> simulated(effects().size(), false);
  std::vector<std::string_view> known;
  for (const Effect& effect : effects()) known.push_back(effect.name);
  const auto at = [&](std::string_view name) {
    return static_cast<size_t>(std::find(known.begin(), known.end(), name) - known.begin());
  };
  for (const std::string& name : names) {
    if (at(name) == known.size())
      throw ConfigError(fmt::format("--effects {}: expected auto, all, or some of {}", name, fmt::join(known, ", ")));
    simulated[at(name)] = true;
  }
  if (!full.rtl.waves.empty() && !(simulated[at("waves")] && simulated[at("taps")]))
    throw ConfigError("--waves: needs the effects waves and taps");
  // A band of SH needs those below it.
  if (simulated[at("sh3")]) simulated[at("sh2")] = true;
  if (simulated[at("sh2")]) simulated[at("sh1")] = true;
  return plan(full, simulated);
}

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
