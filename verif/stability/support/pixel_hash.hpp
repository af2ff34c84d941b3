// SPDX-License-Identifier: Apache-2.0
// pixel_hash.hpp: one number for all golden pixels of `count` hostile scenes, in layers and in exact order and with
// lists.
#pragma once

#include "cpp_model/frame_setup.hpp"
#include "cpp_model/golden.hpp"
#include "sim/bounds/hostile_scene.hpp"

namespace pipegs {

inline uint64_t hostile_hash(int count) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (int seed = 1; seed <= count; ++seed) {
    const StressView view = stress_view(static_cast<uint64_t>(seed), {.gaussians = 60, .width = 0, .height = 0});
    for (const int order : {0, 1, 2}) {
      Config config;
      config.order = order, config.late = order != 0;
      const glm::dvec3& at = view.camera.position;
      const PackedScene packed = pack_scene(
          config, view.scene, std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z), 2 * view.near_plane}));
      const GoldenInput input{.packed = &packed,
                              .frame = frame_setup(config, packed, view.camera, {}, view.near_plane)};
      for (const uint64_t pixel : golden_frame(input, {}).pixels) hash = (hash ^ pixel) * 0x100000001b3u;
    }
  }
  return hash;
}

}  // namespace pipegs
