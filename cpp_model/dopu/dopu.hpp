// SPDX-License-Identifier: Apache-2.0
// dopu: walks the scene for one window: which chunks go to the PUs, in which layer, in which order.
//
// Paper   Sec. 3.2, Sec. 4.1 (Dynamic Orthogonal Partitioning Unit).        RTL  rtl/dopu/pipegs_dopu.sv
// Idea    Slabs of the grid outward from the camera's own; in each slab every cell that passes the window test; in each
//         such cell every group, in each such group every chunk that passes it.
// Rule    This is the walk without the feedback "all regions are done", which only ever cuts its tail off.
#pragma once

#include "cpp_model/dopu/dopu_axis.hpp"
#include "cpp_model/dopu/dopu_layer.hpp"
#include "cpp_model/dopu/dopu_origin.hpp"
#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

struct DopuCounts {
  uint64_t cell_tests = 0, group_tests = 0, chunk_tests = 0, chunks = 0, gaussians = 0;
};

// Calls chunk(layer, chunk record, number of the chunk) for each chunk of the window; layers count 0, 1 ... Grid - 1
// from the nearest, whether or not they hold a chunk.
template <class Callback>
DopuCounts dopu_window(const Config& config, const Frame& frame, const PackedScene& scene, int window_x, int window_y,
                       Callback&& chunk) {
  DopuCounts counts;
  const int axis = dopu_axis(frame), camera = dopu_layer_camera(config, frame, axis);
  const Planes planes = dopu_planes(config, frame, window_x, window_y);
  int layer = 0;
  for (int step = 0; step < 2 * config.grid; ++step) {
    const int slab = dopu_layer_step(config, camera, step);
    if (slab < 0) continue;
    for (int n = 0; n < config.slab_cells(); ++n) {
      const Node& cell = scene.cells[static_cast<size_t>(dopu_layer_cell(config, axis, slab, n))];
      if (cell.count == 0) continue;
      ++counts.cell_tests;
      if (!dopu_test(config, frame, planes, cell, 0)) continue;
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = scene.groups[g];
        ++counts.group_tests;
        if (!dopu_test(config, frame, planes, group, 0)) continue;
        for (uint64_t i = group.first; i < group.first + group.count; ++i) {
          const Node& node = scene.chunks[i];
          ++counts.chunk_tests;
          if (!dopu_test(config, frame, planes, node, 0)) continue;
          ++counts.chunks;
          counts.gaussians += node.count;
          chunk(layer, dopu_origin(config, frame, node, window_x, window_y), i);
        }
      }
    }
    layer += config.layered;
  }
  return counts;
}

}  // namespace pipegs
