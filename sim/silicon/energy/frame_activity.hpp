// SPDX-License-Identifier: Apache-2.0
// frame_activity.hpp: what switches in a whole frame: samples of the RTL's run, spread over it.
//
// Idea    Waves of a whole frame would be a hundred gigabytes. kSamples times kSampleCycles cycles of waves, one sample
//         drawn from each stretch of the frame, stand for it; every second sample belongs to the second half, and how
//         far both halves lie apart tells what the sampling is worth. Cycles and bytes of the frame are exact.
// Rule    The run is held against the golden model bit for bit, as any other.
// Units   As in activity.hpp. Units are those of SynthUnit; SRAMs are named as in synth.json, [k] for any number, all
//         instances of a name summed.
#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "sim/silicon/energy/activity.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

inline constexpr uint64_t kSamples = 4096, kSampleCycles = 8;

struct FrameActivity {
  uint64_t cycles = 0, bytes = 0;  // of the frame; over the pins of the external memory
  std::array<Activity, 2> halves;  // clocks: by unit

  Activity sum() const;
};

nlohmann::ordered_json to_json(const FrameActivity& activity);
FrameActivity frame_activity_from_json(const nlohmann::ordered_json& json);  // NumberError, nlohmann::json::exception

// The unit that a scope or a clock gate stands in: dopu, pu, su, ru, list, buf; top for what is left.
std::string unit_of(const std::string& scope);
// Without the top's name, numbers as [k]; clocks by unit, alike SRAMs as one.
Activity by_unit(const Activity& activity);

// Runs the RTL, which it builds if need be. `cycles`: how many the frame will take. Waves pass through `folder`.
// Throws std::runtime_error when the RTL differs from the golden model.
FrameActivity measure_activity(const Scene& scene, const Camera& camera, SimulateOptions options,
                               const Enables& enables, uint64_t cycles, const std::filesystem::path& folder);

}  // namespace pipegs
