// SPDX-License-Identifier: Apache-2.0
// back_project: see back_project.hpp.
#include "sim/studies/train/gradient/raster/back_project.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cpp_model/float/projection.hpp"
#include "sim/layers/rotation.hpp"

namespace pipegs {
namespace {

// d basis / d direction of sh_basis, its three coordinates taken as independent.
void sh_slopes(const glm::dvec3& d, glm::dvec3 slopes[15]) {
  const double x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
  constexpr double k1 = 0.4886025119029199, k2 = 1.0925484305920792, k20 = 0.31539156525252005,
                   k22 = 0.5462742152960396, k3 = 0.5900435899266435, k31 = 2.890611442640554, k32 = 0.4570457994644658,
                   k30 = 0.3731763325901154, k33 = 1.445305721320277;
  slopes[0] = {0, -k1, 0};
  slopes[1] = {0, 0, k1};
  slopes[2] = {-k1, 0, 0};
  slopes[3] = k2 * glm::dvec3(y, x, 0);
  slopes[4] = -k2 * glm::dvec3(0, z, y);
  slopes[5] = k20 * glm::dvec3(-2 * x, -2 * y, 4 * z);
  slopes[6] = -k2 * glm::dvec3(z, 0, x);
  slopes[7] = k22 * glm::dvec3(2 * x, -2 * y, 0);
  slopes[8] = -k3 * glm::dvec3(6 * x * y, 3 * (xx - yy), 0);
  slopes[9] = k31 * glm::dvec3(y * z, x * z, x * y);
  slopes[10] = -k32 * glm::dvec3(-2 * x * y, 4 * zz - xx - 3 * yy, 8 * y * z);
  slopes[11] = k30 * glm::dvec3(-6 * x * z, -6 * y * z, 6 * zz - 3 * (xx + yy));
  slopes[12] = -k32 * glm::dvec3(4 * zz - 3 * xx - yy, -2 * x * y, 8 * x * z);
  slopes[13] = k33 * glm::dvec3(2 * x * z, -2 * y * z, xx - yy);
  slopes[14] = -k3 * glm::dvec3(3 * (xx - yy), -6 * x * y, 0);
}

// Adds the gradient of the SH coefficients; returns that of the mean through the direction.
glm::dvec3 color_gradient(const Parameters& parameters, std::size_t i, const glm::dvec3& offset, const SplatView& view,
                          const glm::dvec3& d_color, Gradient& gradient) {
  gradient.sh_dc[i] += glm::vec3(kSh0 * d_color);
  const int used = sh_rest_count(std::min(parameters.sh_degree, view.sh_degree));
  if (used <= 0) return glm::dvec3(0);
  const double length = glm::length(offset);
  const glm::dvec3 direction = offset / length;
  const float* rest = sh_rest_of(parameters, i);
  float* d_rest = gradient.sh_rest.data() + (rest - parameters.sh_rest.data());
  double basis[15];
  glm::dvec3 slopes[15], d_direction(0);
  sh_basis(direction, basis);
  sh_slopes(direction, slopes);
  for (int k = 0; k < used; ++k) {
    double along = 0;
    for (int channel = 0; channel < 3; ++channel) {
      d_rest[k * 3 + channel] += static_cast<float>(basis[k] * d_color[channel]);
      along += rest[k * 3 + channel] * d_color[channel];
    }
    d_direction += along * slopes[k];
  }
  return (d_direction - direction * glm::dot(direction, d_direction)) / length;
}

// d loss / d of what blending knows: mean in pixels, rho, tau, c.
struct PlaneGradient {
  glm::dvec2 mean;
  double rho, tau, c;
};

PlaneGradient plane_gradient(const SplatSums& sums, double rho, double tau, double c) {
  // u of the sums is in units of 1 / steep, steep^2 = log2(e) / (2 tau).
  const double unit = 1 / std::sqrt(std::numbers::log2e / 2 / tau);
  const double u = sums.power[1] * unit / tau, y = sums.power[2] / c;
  return {{-u, rho * u - y},
          sums.power[4] * unit / tau,
          sums.power[3] * unit * unit / (2 * tau * tau),
          sums.power[5] / (2 * c * c)};
}

}  // namespace

SeenSplat back_project(const Parameters& parameters, std::size_t i, const Camera& camera, const SplatView& view,
                       const SplatSums& sums, Gradient& gradient) {
  ActivatedGaussian gaussian;
  activate(parameters, i, gaussian);
  const glm::dvec3 offset = gaussian.mean - camera.position, at = camera.world_to_camera * offset;
  const double fx = camera.fx / at.z, fy = camera.fy / at.z, x = at.x / at.z, y = at.y / at.z;
  const double band_x = kTruthGuardBand * camera.tan_x(), band_y = kTruthGuardBand * camera.tan_y();
  const double tx = std::clamp(x, -band_x, band_x), ty = std::clamp(y, -band_y, band_y);

  const glm::dmat3 turned = camera.world_to_camera * rotation_matrix(gaussian.rotation);
  glm::dvec3 u0, u1;
  for (int k = 0; k < 3; ++k) {
    u0[k] = fx * gaussian.scale[k] * (turned[k].x - tx * turned[k].z);
    u1[k] = fy * gaussian.scale[k] * (turned[k].y - ty * turned[k].z);
  }
  const glm::dvec3 cross = glm::cross(u0, u1);
  TruthProjection p;
  p.a = glm::dot(u0, u0) + kDilation;
  p.b = glm::dot(u0, u1);
  p.c = glm::dot(u1, u1) + kDilation;
  p.det = glm::dot(cross, cross) + kDilation * (p.a + p.c) - kDilation * kDilation;
  const double rho = p.b / p.c;
  const PlaneGradient g = plane_gradient(sums, rho, p.det / p.c, p.c);

  glm::dmat3 d_turned;
  glm::dvec3 d_at(0);
  double d_tx = 0, d_ty = 0, stretch = 0;
  for (int k = 0; k < 3; ++k) {
    const double w = u0[k] - rho * u1[k], d0 = 2 * g.tau * w + g.rho * u1[k] / p.c,
                 d1 = 2 * g.c * u1[k] + g.rho * (w - rho * u1[k]) / p.c - 2 * rho * g.tau * w;
    const double d_log_scale = 2 * (g.tau * w * w + g.rho * w * u1[k] / p.c + g.c * u1[k] * u1[k]);
    gradient.log_scale[i][k] += static_cast<float>(d_log_scale);
    stretch += d_log_scale;
    const double s = gaussian.scale[k];
    d_turned[k] = s * glm::dvec3(fx * d0, fy * d1, -fx * tx * d0 - fy * ty * d1);
    d_tx -= fx * s * turned[k].z * d0;
    d_ty -= fy * s * turned[k].z * d1;
  }
  const glm::dmat3 back = glm::transpose(camera.world_to_camera);
  const glm::dvec4 stored(parameters.rotation[i]);
  gradient.rotation[i] += glm::vec4(rotation_gradient(gaussian.rotation, glm::length(stored), back * d_turned));

  // All of U scales with 1/z: its part of d loss / d z is that of all log scales together.
  d_at.z -= stretch / at.z;
  const double d_x = fx * g.mean.x * at.z + (tx == x ? d_tx : 0), d_y = fy * g.mean.y * at.z + (ty == y ? d_ty : 0);
  d_at += glm::dvec3(d_x, d_y, -d_x * x - d_y * y) / at.z;

  const glm::dvec3 d_color = sums.color * glm::dvec3(view.lit);
  gradient.mean[i] += glm::vec3(back * d_at + color_gradient(parameters, i, offset, view, d_color, gradient));
  gradient.opacity_logit[i] += static_cast<float>(sums.power[0] * (1 - gaussian.opacity));
  return {glm::length(glm::dvec2(g.mean.x * camera.width / 2, g.mean.y * camera.height / 2)), inria_radius(p)};
}

}  // namespace pipegs
