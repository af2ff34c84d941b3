// SPDX-License-Identifier: Apache-2.0
// facts.cpp: what the detectors look at: the packed coefficients, and the timing model's peaks. See effects.hpp.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>

#include "cpp_model/float/parallel.hpp"
#include "cpp_model/pu/color/pu_color_fetch.hpp"
#include "cpp_model/pu/color/pu_color_sum.hpp"
#include "cpp_model/pack/pack_quantize.hpp"
#include "sim/effects/effects.hpp"

namespace pipegs {
namespace {

// A coefficient is mantissa * 2^(exponent - kShExponentBias - ShMW), so |mantissa| << exponent compares all of them.
std::array<double, 4> largest_coefficients(const PackedScene& packed) {
  const Config& config = packed.config;
  std::array<uint64_t, 4> largest{};
  if (packed.sh_degree > 0) {
    const size_t per_line = static_cast<size_t>(color_slots_per_line(packed.sh_degree)),
                 slots = packed.slot_to_index.size();
    constexpr size_t kBlock = 16384;
    std::mutex mutex;
    parallel_for((slots + kBlock - 1) / kBlock, 0, [&](size_t block) {
      std::array<uint64_t, 4> mine{};
      for (size_t slot = block * kBlock; slot < std::min(slots, (block + 1) * kBlock); ++slot) {
        const uint32_t* words = packed.colors[slot / per_line].data();
        int at = static_cast<int>(slot % per_line) * 128;
        const uint64_t exponent = get_bits(words, at, config.sh_e_w);
        at += config.sh_e_w;
        for (int band = 1; band <= packed.sh_degree; ++band) {
          uint64_t magnitude = 0;
          for (int i = 0; i < 3 * (2 * band + 1); ++i, at += config.sh_m_w) {
            const uint64_t field = get_bits(words, at, config.sh_m_w), full = uint64_t{1} << config.sh_m_w;
            magnitude = std::max(magnitude, field < full / 2 ? field : full - field);
          }
          mine[static_cast<size_t>(band)] = std::max(mine[static_cast<size_t>(band)], magnitude << exponent);
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

}  // namespace pipegs
