// SPDX-License-Identifier: Apache-2.0
// dopu_walks: the walks of a window, in their order.
//
// Paper   None: the paper's windows have one.        RTL  rtl/dopu/dopu_windows.sv
// Idea    The whole window, or, where dopu_load finds too much in it, each part with a pixel of the picture, row by
//         row. Each walk is nearest first by itself and ends by itself. Parts share no pixel, so what is blended in a
//         pixel is the same, in the same order.
#pragma once

#include <vector>

#include "cpp_model/dopu/dopu_load.hpp"

namespace pipegs {

inline std::vector<uint64_t> dopu_walks(const Config& config, const Frame& frame, const PackedScene& scene,
                                        int window_x, int window_y) {
  if (!dopu_load(config, frame, scene, window_x, window_y)) return {kWholeWalk};
  std::vector<uint64_t> walks;
  for (uint64_t part = 0; part < static_cast<uint64_t>(config.squares()); ++part) {
    const WalkSquare square = walk_square(config, walk_of(config, part));
    if (int64_t{window_x} * config.window + square.x < static_cast<int64_t>(frame.raster.width) &&
        int64_t{window_y} * config.window + square.y < static_cast<int64_t>(frame.raster.height))
      walks.push_back(walk_of(config, part));
  }
  return walks;
}

}  // namespace pipegs
