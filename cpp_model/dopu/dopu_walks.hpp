// SPDX-License-Identifier: Apache-2.0
// dopu_walks: the walks of a window, in their order.
//
// Paper   None: the paper's windows have one.        RTL  rtl/dopu/dopu_windows.sv
// Idea    The whole window, or, where dopu_load finds too much in it for both eyes, all of it for one eye and then for
//         the other, or, where it finds too much for one, each part with a pixel of the picture, row by row, eye by
//         eye. Each walk is nearest first by itself and ends by itself. Parts share no pixel, so what is blended in a
//         pixel is the same, in the same order.
#pragma once

#include <vector>

#include "cpp_model/dopu/dopu_load.hpp"
#include "cpp_model/eyes.hpp"

namespace pipegs {

inline std::vector<uint64_t> dopu_walks(const Config& config, const Frame& frame, const PackedScene& scene,
                                        int window_x, int window_y) {
  const Load load = dopu_load(config, frame, scene, window_x, window_y);
  if (load == Load::kWhole) return {kWholeWalk};
  std::vector<uint64_t> walks;
  for (const int eye : wanted_eyes(config, frame)) {
    if (load == Load::kByEye) {
      walks.push_back(walk_of_eye(config, eye));
      continue;
    }
    for (int square = 0; square < config.squares(); ++square) {
      const uint64_t walk = walk_of(config, static_cast<uint64_t>(eye * config.squares() + square));
      const WalkSquare at = walk_square(config, walk);
      if (int64_t{window_x} * config.window + at.x < static_cast<int64_t>(frame.raster.width) &&
          int64_t{window_y} * config.window + at.y < static_cast<int64_t>(frame.raster.height))
        walks.push_back(walk);
    }
  }
  return walks;
}

}  // namespace pipegs
