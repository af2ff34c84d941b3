// SPDX-License-Identifier: Apache-2.0
// layer_grid: the planes between the layers of the machine, and the order in which a camera takes the layers.
//
// Paper   Sec. 3.2: an N x N x N grid; the layers are its slabs along the principal axis of the camera.
// Idea    The grid is the packer's own (cpp_model/pack), so a scene is trained for the layers in which it is drawn.
//         Between N slabs lie N - 1 boundaries: the outer cells extend to infinity, so the faces of the grid are none.
// Order   Outward from the camera's own slab, as dopu_layer_step walks: 0 is the nearest layer.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "cpp_model/pack/pack.hpp"
#include "scenes/camera.hpp"
#include "sim/layers/parameters.hpp"

namespace pipegs {

struct LayerGrid {
  int cells = 1;            // per axis
  glm::dvec3 low{0};        // where the first cell begins, scene units
  glm::dvec3 cell_size{1};  // of a cell

  double boundary(int axis, int number) const { return low[axis] + number * cell_size[axis]; }  // 1 .. cells - 1
  int slab(int axis, double coordinate) const;

  struct Distance {
    double length;  // to the nearest boundary; infinite if there is none
    double slope;   // d length / d coordinate: 1, -1, or 0 without a boundary
  };
  Distance distance(int axis, double coordinate) const;
};

// ConfigError for a number of cells that no machine has (1, 2, 4 or 8 are legal).
LayerGrid layer_grid(const Parameters& parameters, int cells);
LayerGrid layer_grid(const Scene& scene, int cells);
LayerGrid layer_grid(const PackedScene& packed);

// The axis along which the camera looks most; ties go to the lowest (dopu_axis).
int principal_axis(const Camera& camera);

// By slab along the principal axis: when the camera takes it, 0 first.
std::vector<int> layers_of_slabs(const LayerGrid& grid, const Camera& camera);

}  // namespace pipegs
