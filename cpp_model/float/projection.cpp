// SPDX-License-Identifier: Apache-2.0
// projection: see projection.hpp.
//
// Idea    The three semantics differ in the mean's convention, the near comparison and the
//         footprint; J, U, covariance and colour are shared.
// Rule    What overflows double (a splat of 1e38 units at the near plane stays below) is invisible
//         rather than NaN: the last test of project_truth asks for a finite determinant.
#include "cpp_model/float/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/sh_basis.hpp"

namespace pipegs {
namespace {

constexpr double kInriaW = 1e-7;  // INRIA divides by w + 1e-7
constexpr double kGsplatFar = 1e10;
constexpr double kGsplatExtent = 3.33;  // sigmas
constexpr int kTile = 16;

struct Limits {
  double lowest, highest;
};

// The range of x/z (or y/z) inside J.
Limits guard_band(Semantics semantics, double tangent, int size, double focal, double center) {
  if (semantics != Semantics::kGsplat) return {-kTruthGuardBand * tangent, kTruthGuardBand * tangent};
  const double gsplat_center = center + 0.5;
  const double extra = (kTruthGuardBand - 1) * tangent;
  return {-(gsplat_center / focal + extra), (size - gsplat_center) / focal + extra};
}

// Saturating conversion; the images are far smaller than the limits.
int to_pixel(double value) { return static_cast<int>(std::clamp(value, -1e9, 1e9)); }

PixelRect clipped(const PixelRect& r, const Camera& camera) {
  return {std::max(r.x0, 0), std::max(r.y0, 0), std::min(r.x1, camera.width), std::min(r.y1, camera.height)};
}

PixelRect inria_footprint(const TruthProjection& p, const Camera& camera) {
  const double radius = inria_radius(p);
  const auto tile = [](double edge, int size) {
    const int grid = (size + kTile - 1) / kTile;
    return std::clamp(to_pixel(edge / kTile), 0, grid) * kTile;  // to_pixel truncates toward 0 as (int) does
  };
  return clipped(
      {tile(p.mean.x - radius, camera.width), tile(p.mean.y - radius, camera.height),
       tile(p.mean.x + radius + kTile - 1, camera.width), tile(p.mean.y + radius + kTile - 1, camera.height)},
      camera);
}

PixelRect gsplat_footprint(const TruthProjection& p, const Camera& camera) {
  const double extent = std::min(kGsplatExtent, std::sqrt(2 * std::log(p.opacity * 255)));
  const double rx = std::ceil(extent * std::sqrt(p.a)), ry = std::ceil(extent * std::sqrt(p.c));
  return clipped({to_pixel(std::floor(p.mean.x - rx)), to_pixel(std::floor(p.mean.y - ry)),
                  to_pixel(std::ceil(p.mean.x + rx)), to_pixel(std::ceil(p.mean.y + ry))},
                 camera);
}

// alpha >= 1/255 iff d^T conic d <= 2 ln(255 opacity); the ellipse's box is sqrt of that * variance.
// The margin covers rounding only; the pixel's own test decides.
PixelRect exact_footprint(const TruthProjection& p, const Camera& camera) {
  constexpr double kMargin = 1e-6;
  const double level = 2 * std::max(0.0, std::log(p.opacity * 255)) + kMargin;
  const double ex = std::sqrt(level * p.a) * (1 + kMargin), ey = std::sqrt(level * p.c) * (1 + kMargin);
  return clipped({to_pixel(std::ceil(p.mean.x - ex - kMargin)), to_pixel(std::ceil(p.mean.y - ey - kMargin)),
                  to_pixel(std::floor(p.mean.x + ex + kMargin) + 1), to_pixel(std::floor(p.mean.y + ey + kMargin) + 1)},
                 camera);
}

}  // namespace

glm::dmat3 rotation_matrix(const glm::dvec4& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

void sh_basis(const glm::dvec3& d, double basis[15]) {
  const std::array<double, kShBasis> all = sh_basis(d);
  std::copy(all.begin() + 1, all.end(), basis);
}

glm::dvec3 sh_color(const glm::vec3& sh_dc, const float* sh_rest, int sh_degree, const glm::dvec3& direction) {
  glm::dvec3 color = kSh0 * glm::dvec3(sh_dc) + 0.5;
  double basis[15];
  sh_basis(direction, basis);
  for (int k = 0; k < sh_rest_count(sh_degree); ++k) {
    for (int channel = 0; channel < 3; ++channel) color[channel] += basis[k] * sh_rest[k * 3 + channel];
  }
  return glm::max(color, 0.0);
}

TruthProjection project_truth(const ActivatedGaussian& gaussian, const glm::vec3& sh_dc, const float* sh_rest,
                              int sh_degree, const Camera& camera, const ProjectionOptions& options) {
  TruthProjection out;
  const Semantics semantics = options.semantics;
  const glm::dvec3 offset = gaussian.mean - camera.position;
  const glm::dvec3 view = camera.world_to_camera * offset;
  out.depth = view.z;
  const bool gsplat = semantics == Semantics::kGsplat;
  if (!(gsplat ? view.z >= options.near_plane && view.z <= kGsplatFar : view.z > options.near_plane)) return out;

  const double z = view.z;
  const Limits lx = guard_band(semantics, camera.tan_x(), camera.width, camera.fx, camera.cx);
  const Limits ly = guard_band(semantics, camera.tan_y(), camera.height, camera.fy, camera.cy);
  const double tx = std::clamp(view.x / z, lx.lowest, lx.highest);
  const double ty = std::clamp(view.y / z, ly.lowest, ly.highest);
  const glm::dmat3 m = camera.world_to_camera * rotation_matrix(gaussian.rotation);
  glm::dvec3 u0, u1;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 column = m[axis] * gaussian.scale[axis];
    u0[axis] = camera.fx / z * (column.x - tx * column.z);
    u1[axis] = camera.fy / z * (column.y - ty * column.z);
  }
  const glm::dvec3 cross = glm::cross(u0, u1);
  const double aa = glm::dot(u0, u0), cc = glm::dot(u1, u1), det_sharp = glm::dot(cross, cross);
  out.a = aa + kDilation;
  out.b = glm::dot(u0, u1);
  out.c = cc + kDilation;
  out.det = det_sharp + kDilation * (aa + cc) + kDilation * kDilation;
  if (!std::isfinite(out.det) || !(out.det > 0)) return out;
  out.conic = glm::dvec3(out.c, -out.b, out.a) / out.det;

  const double w = semantics == Semantics::kInria ? z + kInriaW : z;
  const double half = gsplat ? 0.5 : 0;
  out.mean = {camera.fx * view.x / w + camera.cx + half, camera.fy * view.y / w + camera.cy + half};
  out.opacity = gaussian.opacity;
  if (options.antialiased) out.opacity *= std::sqrt(std::max(kMinCompensation, det_sharp / out.det));
  // z > near >= 0 keeps the length above 0; the test is for a caller's negative near plane.
  const double length = glm::length(offset);
  const glm::dvec3 direction = length > 0 ? offset / length : glm::dvec3(0, 0, 1);
  out.rgb = sh_color(sh_dc, sh_rest, std::min(sh_degree, options.sh_degree), direction);
  out.visible = true;
  return out;
}

double inria_radius(const TruthProjection& p) {
  const double mid = 0.5 * (p.a + p.c);
  return std::ceil(3 * std::sqrt(mid + std::sqrt(std::max(0.1, mid * mid - p.det))));
}

PixelRect footprint(const TruthProjection& projected, const Camera& camera, Semantics semantics) {
  if (!projected.visible) return {};
  switch (semantics) {
    case Semantics::kInria: return inria_footprint(projected, camera);
    case Semantics::kGsplat: return projected.opacity < kMinAlpha ? PixelRect{} : gsplat_footprint(projected, camera);
    case Semantics::kExact: break;
  }
  // A hair below 1/255 still goes to the pixel's own test, which compares alpha itself.
  return projected.opacity < kMinAlpha * (1 - 1e-12) ? PixelRect{} : exact_footprint(projected, camera);
}

}  // namespace pipegs
