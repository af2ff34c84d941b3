// SPDX-License-Identifier: Apache-2.0
// pu_walk.hpp: every Gaussian of a packed scene through the models of the PU, stage by stage, each record
// shown to a visitor.
#pragma once

#include <optional>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/conic/pu_coeff.hpp"
#include "cpp_model/pu/color/pu_color.hpp"
#include "cpp_model/pu/conic/pu_conic.hpp"
#include "cpp_model/pu/project/pu_covariance.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/project/pu_factors.hpp"
#include "cpp_model/pu/conic/pu_intersect.hpp"
#include "cpp_model/pu/project/pu_jacobian.hpp"
#include "cpp_model/pu/project/pu_orient.hpp"
#include "cpp_model/pu/project/pu_project.hpp"
#include "cpp_model/pu/rows/pu_region.hpp"
#include "cpp_model/pu/rows/pu_row_init.hpp"
#include "cpp_model/pu/rows/pu_row_unit.hpp"
#include "cpp_model/pu/project/pu_squares.hpp"

namespace pipegs {

// Calls see(record) for each record from the chunk to the region's start, and rows(config, power, slope) for each
// pixel.
template <class See, class Rows>
void pu_walk(const Config& config, const Frame& frame, const Chunk& chunk, const GaussianRecord& gaussian,
             uint64_t slot, See&& see, Rows&& rows) {
  see(chunk), see(gaussian);
  const Fetched fetched = golden_fetched(chunk, gaussian, slot);
  see(fetched);
  const std::optional<Visible> visible = pu_cull(config, frame, fetched);
  if (!visible) return;
  see(*visible);
  const auto [projected, center, payload] = pu_project(config, frame, *visible);
  see(projected), see(center), see(payload);
  const Oriented oriented = pu_orient(config, frame, projected);
  see(oriented);
  const Jacobian jacobian = pu_jacobian(config, frame, oriented);
  see(jacobian);
  const Factors factors = pu_factors(config, frame, jacobian);
  see(factors);
  const Squares squares = pu_squares(config, frame, factors);
  see(squares);
  const Covariance covariance = pu_covariance(config, frame, squares, center);
  see(covariance);
  const Conic conic = pu_conic(config, frame, covariance);
  see(conic);
  const Coeff coeff = pu_coeff(config, frame, conic);
  see(coeff);
  const Tiles tiles = pu_intersect(config, frame, coeff);
  see(tiles);
  RowJob job;
  job.a = tiles.a, job.b = tiles.b, job.c = tiles.c, job.d = tiles.d, job.e = tiles.e, job.f = tiles.f,
  job.mask = tiles.mask;
  for (uint64_t rest = tiles.mask; rest != 0; rest &= rest - 1) {
    const Region region = pu_region(config, job, std::countr_zero(rest));
    see(region);
    for (int dy = 0; dy < 8; ++dy) {
      Row row = pu_row_init(region, dy);
      for (int dx = 0; dx < 8; ++dx) {
        rows(row.power, row.slope);
        row = pu_row_unit(row, region.curve_x);
      }
    }
  }
}

// All Gaussians of a packed scene in all windows of the frame.
template <class See, class Rows>
void pu_walk(const PackedScene& packed, const Frame& frame, See&& see, Rows&& rows) {
  see(frame);
  for (uint64_t y = frame.raster.windows.first_y; y <= frame.raster.windows.last_y; ++y) {
    for (uint64_t x = frame.raster.windows.first_x; x <= frame.raster.windows.last_x; ++x) {
      for (const Node& node : packed.chunks) {
        see(node);
        const Chunk chunk = dopu_origin(packed.config, frame, node, static_cast<int>(x), static_cast<int>(y));
        for (uint64_t slot = node.first; slot < node.first + node.count; ++slot) {
          pu_walk(packed.config, frame, chunk, packed.gaussians[slot], slot, see, rows);
        }
      }
    }
  }
}

}  // namespace pipegs
