// SPDX-License-Identifier: Apache-2.0
// layer_grid: see layer_grid.hpp.
#include "sim/layers/layer_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cpp_model/dopu/dopu_layer.hpp"

namespace pipegs {
namespace {

Config config_of(int cells) {
  Config config;
  config_set(config, "grid=" + std::to_string(cells));
  config_set(config, "sh_degree=0");  // colours have no part in it
  config_check(config);
  return config;
}

}  // namespace

int LayerGrid::slab(int axis, double coordinate) const {
  const double cell = std::floor((coordinate - low[axis]) / cell_size[axis]);
  return static_cast<int>(std::clamp(cell, 0.0, cells - 1.0));
}

LayerGrid::Distance LayerGrid::distance(int axis, double coordinate) const {
  if (cells < 2) return {std::numeric_limits<double>::infinity(), 0};
  const double place = std::round((coordinate - low[axis]) / cell_size[axis]);
  const double away = coordinate - boundary(axis, static_cast<int>(std::clamp(place, 1.0, cells - 1.0)));
  return {std::abs(away), away < 0 ? -1.0 : 1.0};
}

LayerGrid layer_grid(const Parameters& parameters, int cells) { return layer_grid(scene_of(parameters, ""), cells); }

LayerGrid layer_grid(const Scene& scene, int cells) { return layer_grid(pack_scene(config_of(cells), scene, 0)); }

LayerGrid layer_grid(const PackedScene& packed) {
  LayerGrid grid;
  grid.cells = packed.config.grid;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    grid.low[axis] = std::ldexp(static_cast<double>(packed.grid.low[a]), packed.scene_exponent);
    grid.cell_size[axis] =
        std::ldexp(1 / static_cast<double>(packed.grid.scale[a]), packed.config.world_w + packed.scene_exponent);
  }
  return grid;
}

int principal_axis(const Camera& camera) {
  const glm::dmat3& m = camera.world_to_camera;
  const double x = std::abs(m[0][2]), y = std::abs(m[1][2]), z = std::abs(m[2][2]);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

std::vector<int> layers_of_slabs(const LayerGrid& grid, const Camera& camera) {
  const int axis = principal_axis(camera), own = grid.slab(axis, camera.position[axis]);
  const Config config = config_of(grid.cells);
  std::vector<int> layers(static_cast<std::size_t>(grid.cells));
  int layer = 0;
  for (int step = 0; step < 2 * grid.cells; ++step) {
    const int slab = dopu_layer_step(config, own, step);
    if (slab >= 0) layers[static_cast<std::size_t>(slab)] = layer++;
  }
  return layers;
}

}  // namespace pipegs
