// SPDX-License-Identifier: Apache-2.0
// dopu_load: whether a window holds so much that its parts are walked one after the other.
//
// Paper   None: the paper's windows are walked whole.        RTL  rtl/dopu/dopu_load.sv
// Idea    The walk of a whole window opens no group before all of them have come, and the Gaussians of those that pass
//         are counted, as many to a chunk as it has room for. More than walk_most, which the host sets, or more groups
//         than half of the places in which nodes wait: the walk is given up, and the window goes by parts. Any answer
//         gives the same pixels; a wrong one costs nodes that are read again, or a set that spills.
// Rule    A function of scene, camera and walk_most alone, so the streams are, too.
#pragma once

#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

inline bool dopu_load(const Config& config, const Frame& frame, const PackedScene& scene, int window_x, int window_y) {
  if (frame.walk_most == 0) return false;
  const Planes planes = dopu_planes(config, frame, window_x, window_y);
  uint64_t chunks = 0, groups = 0;
  for (const Node& cell : scene.cells) {
    if (cell.count == 0 || !dopu_test(config, frame, planes, cell, dopu_depth_edge(config, frame, 0))) continue;
    const int edge = dopu_depth_edge(config, frame, dopu_depth(config, frame, planes, cell, 0));
    for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
      if (dopu_test(config, frame, planes, scene.groups[g], edge)) chunks += scene.groups[g].count, ++groups;
    }
  }
  return chunks * static_cast<uint64_t>(config.chunk) > frame.walk_most ||
         groups > static_cast<uint64_t>(config.nearest_nodes / 2);
}

}  // namespace pipegs
