// SPDX-License-Identifier: Apache-2.0
// dopu_nearest: which chunks of a walk go to the PUs, each with its bucket of depth, when the nearest goes first.
//
// Paper   None: instead of the layers of Sec. 3.2.        RTL  rtl/dopu/nearest/dopu_nearest.sv
// Idea    The walk is that of dopu_window, but a node is tested with what its parent's bucket says (dopu_hull): beyond
//         the image's edges other chunks pass, of which no pixel shows anything. A node's bucket is its own
//         (dopu_depth), but never smaller than its parent's, whose bound holds for it too: so what is opened last never
//         lies before what is known already, and the watermark (the smallest bucket among all that waits or is being
//         opened) only rises.
// Rule    Any order of chunks gives the same image; every watermark is at most the edge of every later chunk's bucket.
//         Which of the legal orders the machine takes depends on its memory, and is no part of this bit-accurate model.
#pragma once

#include <algorithm>

#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/dopu/nearest/dopu_lod.hpp"
#include "cpp_model/dopu/dopu_origin.hpp"
#include "cpp_model/dopu/dopu_planes.hpp"
#include "cpp_model/dopu/dopu_test.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

// Calls chunk(bucket, chunk record, number of the chunk) for each chunk of a walk, in the order of the tables.
template <class Callback>
void dopu_nearest(const Config& config, const Frame& frame, const PackedScene& scene, int window_x, int window_y,
                  uint64_t walk, Callback&& chunk) {
  const Planes planes = dopu_planes(config, frame, window_x, window_y, walk);
  const auto passes = [&](const Node& node, int parent) {
    return dopu_test(config, frame, planes, node, dopu_depth_edge(config, frame, parent));
  };
  for (const Node& cell : scene.cells) {
    if (cell.count == 0 || !passes(cell, 0)) continue;
    const int cell_bucket = dopu_depth(config, frame, planes, cell, 0);
    for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
      const Node& group = scene.groups[g];
      if (!passes(group, cell_bucket)) continue;
      const int group_bucket = dopu_depth(config, frame, planes, group, cell_bucket);
      const Node opened = dopu_lod(config, frame, group, group_bucket);
      for (uint64_t i = opened.first; i < opened.first + opened.count; ++i) {
        const Node& node = scene.chunks[i];
        if (!passes(node, group_bucket)) continue;
        Chunk sent = dopu_origin(config, frame, node, window_x, window_y);
        sent.walk = walk;
        chunk(dopu_depth(config, frame, planes, node, group_bucket), sent, i);
      }
    }
  }
}

}  // namespace pipegs
