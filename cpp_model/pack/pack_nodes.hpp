// SPDX-License-Identifier: Apache-2.0
// pack_nodes: the grid, and the nodes (bounding boxes) of chunks and cells.
//
// Idea    Means are rounded first and boxes drawn around the rounded ones, outwards, so that a box that misses a window
//         proves that none of its Gaussians touches it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

using WorldPoint = std::array<int64_t, 3>;  // world units

// A box in scene units.
struct SceneBox {
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
};

// The finest scale (FocalW bits, rounded down) at which the cells still cover the box along each axis.
GridBox make_grid(const Config& config, const SceneBox& box, int scene_exponent);

// The node of one chunk; writes the offsets of its records. If coded these are multiples of the codes' unit, and
// scale_max has the exponent `scale_exp`.
Node make_chunk(const Config& config, std::span<const WorldPoint> means, std::span<GaussianRecord> records,
                uint64_t scale_exp = 0);

// Half the surface of a box as wide as what a node may draw and `around` more along each axis, world units squared.
double hull_area(const Config& config, const Node& node, double around);

// The box around the chunks of a group or the groups of a cell.
Node make_parent(const Config& config, std::span<const Node> children);

}  // namespace pipegs
