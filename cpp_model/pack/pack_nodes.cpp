// SPDX-License-Identifier: Apache-2.0
// pack_nodes: see pack_nodes.hpp.
#include "cpp_model/pack/pack_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pack/pack_quantize.hpp"

namespace pipegs {

// The finest grid (in 2^-WorldW steps of its scale) whose N cells cover the box along each axis.
GridBox make_grid(const Config& config, const SceneBox& box, int scene_exponent) {
  GridBox grid;
  const int64_t largest = (int64_t{1} << config.focal_w()) - 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double low = std::ldexp(box.low[axis], -scene_exponent), high = std::ldexp(box.high[axis], -scene_exponent);
    const double size = std::max(1.0, (high - low) * 1.001);
    const double scale = std::floor(std::ldexp(config.grid, config.world_w) / size);
    grid.scale[axis] = static_cast<uint64_t>(std::clamp(scale, 0.0, static_cast<double>(largest)));
    const double covered =
        grid.scale[axis] == 0 ? size : std::ldexp(config.grid, config.world_w) / static_cast<double>(grid.scale[axis]);
    const int64_t limit = int64_t{1} << (config.world_w - 2);
    grid.low[axis] = std::clamp(static_cast<int64_t>(std::floor((low + high - covered) / 2)), -limit, limit);
  }
  return grid;
}

int cell_coordinate(const Config& config, const GridBox& grid, int axis, int64_t world) {
  const size_t a = static_cast<size_t>(axis);
  const Int128 product = Int128{world - grid.low[a]} * static_cast<Int128>(grid.scale[a]);
  return static_cast<int>(std::clamp<Int128>(shift_floor(product, config.world_w), 0, config.grid - 1));
}

using Extents = std::array<int64_t, 3>;

// Extents into the fields of a node, rounded up, in the finest unit in which all fit. What is wider than any scene is
// cut: a hull so wide counts for no window.
void set_extents(const Config& config, const Extents& half, Extents down, Extents up, Node& node) {
  int64_t widest = *std::max_element(half.begin(), half.end());
  for (Extents* hull : {&down, &up}) {
    for (int64_t& extent : *hull) {
      extent = std::min(extent, int64_t{1} << (config.world_w - 1));
      widest = std::max(widest, extent);
    }
  }
  while (shift_ceil(widest, static_cast<int>(node.half_exp)) >> config.half_w() != 0) ++node.half_exp;
  while (config.tight_boxes && shift_ceil(widest, static_cast<int>(node.half_exp) + 1) >> config.hull_w() != 0)
    ++node.half_exp;
  const auto field = [&](int64_t extent, int more) {
    return static_cast<uint64_t>(shift_ceil(extent, static_cast<int>(node.half_exp) + more));
  };
  node.half_x = field(half[0], 0);
  node.half_y = field(half[1], 0);
  node.half_z = field(half[2], 0);
  if (!config.tight_boxes) return;
  node.down_x = field(down[0], 1);
  node.down_y = field(down[1], 1);
  node.down_z = field(down[2], 1);
  node.up_x = field(up[0], 1);
  node.up_y = field(up[1], 1);
  node.up_z = field(up[2], 1);
}

// Centre, offset exponent, offsets of the records and half extents of one chunk, all from the rounded means.
Node make_chunk(const Config& config, std::span<const WorldPoint> means, std::span<GaussianRecord> records,
                uint64_t scale_exp) {
  Node node;
  int64_t* const center[3] = {&node.center_x, &node.center_y, &node.center_z};
  int64_t GaussianRecord::*const offset[3] = {&GaussianRecord::offset_x, &GaussianRecord::offset_y,
                                              &GaussianRecord::offset_z};
  const int below = config.coded() ? config.pos_w - Config::offset_code_w() : 0;  // bits of an offset that are zero
  const int64_t most = (int64_t{1} << (config.pos_w - 1 - below)) - 1;
  int64_t widest = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    int64_t low = means[0][axis], high = low;
    for (const WorldPoint& mean : means) {
      low = std::min(low, mean[axis]);
      high = std::max(high, mean[axis]);
    }
    *center[axis] = shift_floor(low + high, 1);
    widest = std::max(widest, high - *center[axis]);  // high is at least as far as low
  }
  while (shift_round(widest, static_cast<int>(node.offset_exp) + below) > most) ++node.offset_exp;
  Extents half = {0, 0, 0}, down = {0, 0, 0}, up = {0, 0, 0};
  for (size_t i = 0; i < means.size(); ++i) {
    const std::array<double, 3> extent =
        config.tight_boxes ? ellipsoid_extents(config, records[i]) : std::array<double, 3>{};
    for (size_t axis = 0; axis < 3; ++axis) {
      const int64_t rounded = shift_round(means[i][axis] - *center[axis], static_cast<int>(node.offset_exp) + below) *
                              (int64_t{1} << below);
      records[i].*offset[axis] = rounded;
      const int64_t away = std::abs(rounded) << node.offset_exp;
      const double farthest = std::min(std::ceil(extent[axis]), std::ldexp(1.0, config.world_w));
      half[axis] = std::max(half[axis], away);
      const int64_t from = rounded * (int64_t{1} << node.offset_exp), reach = static_cast<int64_t>(farthest);
      down[axis] = std::max({down[axis], half[axis], reach - from});
      up[axis] = std::max({up[axis], half[axis], reach + from});
    }
  }
  set_extents(config, half, down, up, node);
  double scale = 0;
  for (const GaussianRecord& record : records) scale = std::max(scale, effective_scale(config, record));
  node.scale_max = std::max(encode_scale(config, scale * (1 + 1e-9), true), scale_exp << config.scale_m_w);
  node.count = means.size();
  return node;
}

Node make_parent(const Config& config, std::span<const Node> children) {
  Node node;
  int64_t* const center[3] = {&node.center_x, &node.center_y, &node.center_z};
  int64_t Node::*const centers[3] = {&Node::center_x, &Node::center_y, &Node::center_z};
  uint64_t Node::*const halves[3] = {&Node::half_x, &Node::half_y, &Node::half_z};
  uint64_t Node::*const downs[3] = {&Node::down_x, &Node::down_y, &Node::down_z};
  uint64_t Node::*const ups[3] = {&Node::up_x, &Node::up_y, &Node::up_z};
  Extents half = {0, 0, 0}, down = {0, 0, 0}, up = {0, 0, 0};
  for (size_t axis = 0; axis < 3; ++axis) {
    int64_t low = std::numeric_limits<int64_t>::max(), high = std::numeric_limits<int64_t>::min();
    for (const Node& child : children) {
      const int64_t reach = static_cast<int64_t>(child.*halves[axis]) << child.half_exp;
      low = std::min(low, child.*centers[axis] - reach);
      high = std::max(high, child.*centers[axis] + reach);
    }
    *center[axis] = shift_floor(low + high, 1);
    half[axis] = high - *center[axis];
    for (const Node& child : children) {
      const int64_t from = child.*centers[axis] - *center[axis];
      down[axis] =
          std::max({down[axis], half[axis], (static_cast<int64_t>(child.*downs[axis]) << 1 << child.half_exp) - from});
      up[axis] =
          std::max({up[axis], half[axis], (static_cast<int64_t>(child.*ups[axis]) << 1 << child.half_exp) + from});
    }
  }
  set_extents(config, half, down, up, node);
  for (const Node& child : children) node.scale_max = std::max(node.scale_max, child.scale_max);
  return node;
}

double hull_area(const Config& config, const Node& node, double around) {
  const double unit = std::ldexp(2.0, static_cast<int>(node.half_exp));
  // Without hulls the box is that of the means, and its Gaussians reach as far as the largest scale does.
  const double reach =
      config.tight_boxes ? 0 : std::sqrt(2 * std::log(config.alpha_cut)) * scale_value(config, node.scale_max);
  const auto side = [&](uint64_t half, uint64_t down, uint64_t up) {
    return around + 2 * reach + unit * static_cast<double>(config.tight_boxes ? down + up : half);
  };
  const double x = side(node.half_x, node.down_x, node.up_x), y = side(node.half_y, node.down_y, node.up_y),
               z = side(node.half_z, node.down_z, node.up_z);
  return x * y + y * z + z * x;
}

}  // namespace pipegs
