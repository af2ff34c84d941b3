// SPDX-License-Identifier: Apache-2.0
// pu_project: the mean on the screen, 1/z, the clamped tangents of the Jacobian, the depth key and the view direction.
//
// Paper   Sec. 2.1, EWA projection of the mean; depth of the sort key.
// Idea    z, x, y are normalised by one shifter in turn; one reciprocal; then four products on one multiplier:
//           tx = x (1/z), ty = y (1/z), fx tx, fy ty.
// Numbers 1/z = inv_z_m 2^inv_z_e per world unit, relative error below 2^-25 (MantissaW = 26).
//         tan s4.TanF: rounded, clamped to +-limit (GuardBand 0: only saturated). mean s18.MeanF, from the unclamped
//         ratio: rounded, saturated.
//         depth = {floor(log2 z) in world units, the bits below the leading one}: truncated, monotonic in z.
//         dir: the view vector shifted so that its largest component fills DirectionW bits, truncated.
// RTL     rtl/pu/project/pu_project.sv
#pragma once

#include "cpp_model/records.hpp"

namespace pipegs {

struct ProjectCounts {
  uint64_t saturated = 0;  // records whose mean left s18.MeanF
  uint64_t clamped = 0;    // records with a tangent beyond the guard band
};

// What the mathematics looks at next, and what goes beside it: the centre to pu_covariance, the payload to the back.
struct ProjectedParts {
  Projected projected;
  Center center;
  Payload payload;
  bool operator==(const ProjectedParts&) const = default;
};

ProjectedParts pu_project(const Config& config, const Frame& frame, const Visible& visible,
                          ProjectCounts* counts = nullptr);

}  // namespace pipegs
