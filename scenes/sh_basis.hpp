// SPDX-License-Identifier: Apache-2.0
// sh_basis: the 16 real spherical harmonics of degrees 0 to 3, in the order and with the signs of f_dc and f_rest.
//
// Idea    They are orthonormal on the sphere, so the coefficients of a turned colour are integrals of their products.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace pipegs {

inline constexpr std::size_t kShBasis = 16;
inline constexpr double kShConstant = 0.28209479177387814, kShLinear = 0.4886025119029199;

inline std::array<double, kShBasis> sh_basis(const glm::dvec3& d) {
  const double x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
  return {kShConstant,
          -kShLinear * y,
          kShLinear * z,
          -kShLinear * x,
          1.0925484305920792 * x * y,
          -1.0925484305920792 * y * z,
          0.31539156525252005 * (2 * zz - xx - yy),
          -1.0925484305920792 * x * z,
          0.5462742152960396 * (xx - yy),
          -0.5900435899266435 * y * (3 * xx - yy),
          2.890611442640554 * x * y * z,
          -0.4570457994644658 * y * (4 * zz - xx - yy),
          0.3731763325901154 * z * (2 * zz - 3 * xx - 3 * yy),
          -0.4570457994644658 * x * (4 * zz - xx - yy),
          1.445305721320277 * z * (xx - yy),
          -0.5900435899266435 * x * (xx - 3 * yy)};
}

}  // namespace pipegs
