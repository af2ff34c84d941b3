// SPDX-License-Identifier: Apache-2.0
// projection: one Gaussian onto one camera in float64.
//
// Paper   Eq. 1: cov2d = J W R S S^T R^T W^T J^T + 0.3 I.
// Idea    With U = J W R S (two rows u0, u1 of three), cov2d = U U^T and
//           det = |u0 x u1|^2 + 0.3 (|u0|^2 + |u1|^2) + 0.09      every term >= 0
//         so a needle of ratio 1e6 loses nothing to cancellation, unlike a*c - b*b.
// Use     The float64 reference in the unit tests of the fixed-point bit-accurate models.
#pragma once

#include <glm/glm.hpp>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"

namespace pipegs {

enum class Semantics { kExact, kInria, kGsplat };

inline constexpr double kDilation = 0.3;        // px^2, added to both variances
inline constexpr double kTruthGuardBand = 1.3;  // times tan(fov/2), for x/z inside J
inline constexpr double kMaxAlpha = 0.99;
inline constexpr double kMinAlpha = 1.0 / 255;
inline constexpr double kMinTransmittance = 1e-4;
inline constexpr double kMinCompensation = 2.5e-5;  // of det / dilated det, antialiased scenes

struct TruthProjection {
  double depth = 0;            // view z
  glm::dvec2 mean{0};          // pixels; kGsplat: pixel i has its centre at i + 0.5
  double a = 0, b = 0, c = 0;  // cov2d (xx, xy, yy), dilated
  double det = 0;
  glm::dvec3 conic{0};   // inverse of cov2d (xx, xy, yy)
  double opacity = 0;    // compensated, if the scene is antialiased
  glm::dvec3 rgb{0};     // >= 0, without upper clamp
  bool visible = false;  // in front of the near plane, not degenerate; says nothing of the image
};

struct ProjectionOptions {
  Semantics semantics = Semantics::kExact;
  double near_plane = 0.2;
  bool antialiased = false;
  int sh_degree = kMaxShDegree;  // cap
};

// sh_rest: coefficient-major as in Scene, null for degree 0.
TruthProjection project_truth(const ActivatedGaussian& gaussian, const glm::vec3& sh_dc, const float* sh_rest,
                              int sh_degree, const Camera& camera, const ProjectionOptions& options);

// The rotation of a unit quaternion w, x, y, z.
glm::dmat3 rotation_matrix(const glm::dvec4& unit);

// Colour seen along `direction` (unit, from the camera to the Gaussian): +0.5, negative to 0.
glm::dvec3 sh_color(const glm::vec3& sh_dc, const float* sh_rest, int sh_degree, const glm::dvec3& direction);

// The fifteen basis functions beyond the constant, in the order of f_rest.
void sh_basis(const glm::dvec3& direction, double basis[15]);
inline constexpr double kSh0 = 0.28209479177387814;

// Pixels [x0, x1) x [y0, y1) of the image that the semantics evaluates; empty if x0 >= x1 or y0 >= y1.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};
PixelRect footprint(const TruthProjection& projected, const Camera& camera, Semantics semantics);

// INRIA's radius of the square around a mean, pixels: 3 sigma of the longer axis, rounded up.
double inria_radius(const TruthProjection& projected);

// log(alpha) without opacity at offset (dx, dy) = mean - pixel centre.
inline double power_at(const glm::dvec3& conic, double dx, double dy) {
  return -0.5 * (conic.x * dx * dx + conic.z * dy * dy) - conic.y * dx * dy;
}

}  // namespace pipegs
