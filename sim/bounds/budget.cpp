// SPDX-License-Identifier: Apache-2.0
// budget.cpp: see budget.hpp. The numbers of the steps are those of docs/numerics/error_budget.md.
#include "sim/bounds/budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cpp_model/lib/math/sqrt.hpp"
#include "cpp_model/pu/color/sh_code.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"

namespace pipegs {
namespace {

constexpr double kLog2E = 1.4426950408889634;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double unit(int fraction) { return std::ldexp(1.0, -fraction); }

// The covariance as the machine keeps it: narrow axis eliminated, so that no quadratic form cancels.
struct Metric {
  explicit Metric(const TruthProjection& t)
      : swap(t.a > t.c), wide(1 / std::max(t.a, t.c)), narrow(std::max(t.a, t.c) / t.det), slope(t.b * wide) {}
  // |S^-1/2 (x, y)|
  double length(double x, double y) const {
    const double p = swap ? y : x, q = swap ? x : y, w = p - slope * q;
    return std::sqrt(narrow * w * w + wide * q * q);
  }
  // The largest of it over both signs of y.
  double longest(double x, double y) const { return std::max(length(x, y), length(x, -y)); }

  bool swap;
  double wide, narrow, slope;
};

// The power that a shift of the mean costs, m = |S^-1/2 shift|.
double of_shift(double m, double budget) { return std::sqrt(2 * kLog2E * budget) * m + kLog2E / 2 * m * m; }

// The power that a change of U costs, n = |S^-1/2 dU|.
double of_change(double n, double budget) {
  const double x = 2 * n + n * n;
  return x < 1 ? budget * x / (1 - x) : kInfinity;
}

glm::dmat3 rotation(const glm::dvec4& q) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

// One Gaussian before one camera, in double.
struct Geometry {
  Geometry(const Camera& c, const ActivatedGaussian& g, const TruthProjection& truth)
      : camera(c),
        metric(truth),
        offset(g.mean - c.position),
        view(c.world_to_camera * offset),
        axes(c.world_to_camera * rotation(g.rotation)),
        scale(g.scale) {
    const double z = view.z;
    gx = c.fx / z, gy = c.fy / z;
    const double lx = kTruthGuardBand * c.tan_x(), ly = kTruthGuardBand * c.tan_y();
    tx = std::clamp(view.x / z, -lx, lx), ty = std::clamp(view.y / z, -ly, ly);
    largest = std::max({scale.x, scale.y, scale.z});
    const double a = metric.length(gx, 0), b = metric.length(0, gy), d = metric.length(gx * tx, gy * ty);
    jacobian = std::sqrt(a * a + b * b + d * d);
    toward = glm::length(glm::dvec3(axes[0].z * scale.x, axes[1].z * scale.y, axes[2].z * scale.z));
  }
  // |S^-1/2 dU| of a view position that is off by `error` in each component.
  double moved(double error) const {
    const double share = error / view.z;
    if (!(share < 0.5)) return kInfinity;
    return 2 * share * std::sqrt(2.0) + tangent(2 * share * (1 + std::abs(tx)), 2 * share * (1 + std::abs(ty)));
  }
  // Of tangents that are off by dx, dy.
  double tangent(double dx, double dy) const { return metric.longest(gx * dx, gy * dy) * toward; }
  // Of a rotation whose matrix is off by `error`.
  double turned(double error) const { return jacobian * error * largest; }
  // Mean of a view position that is off, as |S^-1/2 shift|.
  double shifted(double error) const {
    const double share = error / view.z;
    if (!(share < 0.5)) return kInfinity;
    return metric.longest(2 * gx * error * (1 + std::abs(view.x / view.z)),
                          2 * gy * error * (1 + std::abs(view.y / view.z)));
  }
  // Relative error of the determinant of a matrix R' that is off by `error` (n is taken for the cross product of the
  // rows).
  double determinant(double error, double det) const {
    const double pairs = std::max({scale.x * scale.y, scale.y * scale.z, scale.z * scale.x}) * gx * gy;
    const double dt = 2 * error * std::sqrt(3 * (1 + tx * tx + ty * ty)) * pairs;
    const double sharp = std::sqrt(std::max(0.0, det));
    return (2 * sharp * dt + dt * dt) / det;
  }

  const Camera& camera;
  Metric metric;
  glm::dvec3 offset, view;
  glm::dmat3 axes;
  glm::dvec3 scale;
  double gx, gy, tx, ty, largest, jacobian, toward;
};

// Rotation matrix of a quaternion of `fraction` bits rounded to nearest: |dq| <= 2^-fraction, of which the part along q
// counts twice as much as the turn.
double of_quaternion(int fraction) { return std::sqrt(20.0) * unit(fraction); }
// Of the record's, as its codes leave it; and of what is not its direction but its length.
double of_record_quaternion(const Config& config) {
  return of_quaternion(config.quat_w - 1) + (config.coded() ? std::sqrt(20.0) * kTurnCodeError : 0);
}
double of_record_length(const Config& config) {
  return of_quaternion(config.quat_w - 1) + (config.coded() ? std::sqrt(20.0) * kSqrtError : 0);
}

// Components of the view position: packed mean and camera, their rotation, and two roundings in view space.
double position_error(const Config& config, const Geometry& g, const BudgetUnits& u) {
  const double packed = std::sqrt(3.0) / 2 * (2 * u.world + (u.offset > u.world ? u.offset : 0));
  return packed + 3 * unit(config.rot_f() + 1) * glm::length(g.offset);
}

double view_rounding(const BudgetUnits& u) { return u.view; }  // half for the origin, half for the offset

// Half a unit of a scale's mantissa, what is flushed below its smallest, what is clipped beyond its largest; of a code
// half a step of the logarithm, too, and what is raised to the chunk's smallest.
double scale_error(const Config& config, double scale, const BudgetUnits& u) {
  const double smallest = 2 * unit(8) * u.world, top = std::ldexp(2.0, 55) * u.world;
  const double step = config.coded() ? std::exp2(0.5 / kScaleSteps) - 1 : 0;
  return scale * (step + (1 + step) * unit(config.scale_m_w + 1)) + (scale < smallest ? smallest / 2 : 0) +
         (scale < u.scale ? u.scale : 0) + (scale > top ? scale - top * (1 - unit(config.scale_m_w + 1)) : 0);
}

// Of -log2(opacity): half a unit of the field, and of a code half a step of the opacity itself.
double opacity_error(const Config& config, double opacity) {
  const double field = unit(config.opacity_f + 1), step = 0.5 / kMostOpacity;
  if (!config.coded()) return field;
  return opacity > step ? field + std::log2(opacity / (opacity - step)) : kInfinity;
}

// |S^-1/2 dU| of what the record rounds.
double record_change(const Config& config, const Geometry& g, const BudgetUnits& u) {
  double scales = 0;
  for (int j = 0; j < 3; ++j) {
    const glm::dvec3& axis = g.axes[j];
    const double column = g.metric.length(g.gx * (axis.x - g.tx * axis.z), g.gy * (axis.y - g.ty * axis.z)) *
                          scale_error(config, g.scale[j], u);
    scales += column * column;
  }
  const double focal = unit(config.focal_f() + 1),
               lens = std::max(focal / g.camera.fx, focal / g.camera.fy) * std::sqrt(2.0);
  return g.turned(of_record_quaternion(config)) + std::sqrt(scales) + g.moved(position_error(config, g, u)) + lens;
}

double record_power(const Config& config, const Geometry& g, const BudgetUnits& u, double opacity, double budget) {
  const double focal = unit(config.focal_f() + 1), center = unit(config.center_f() + 1);
  const double lens =
      g.metric.longest(focal * std::abs(g.view.x / g.view.z) + center, focal * std::abs(g.view.y / g.view.z) + center);
  return of_change(record_change(config, g, u), budget) +
         of_shift(g.shifted(position_error(config, g, u)) + lens, budget) + opacity_error(config, opacity);
}

// 1/z: z rounded to MantissaW bits, recip, x / z rounded to ViewW bits: below four units together.
double ratio_error(const Config& config) { return unit(std::min(config.mantissa_w, config.view_w) - 3); }

// How far the matrix R' may be from W R: the camera's quaternion, q', and R' itself.
double turn_error(const Config& config) {
  return 2 * of_quaternion(config.cam_quat_w() - 2) + 3 * unit(config.rotation_w() - 1);
}

// |S^-1/2 dU| of what projection and rotation round.
double projection_change(const Config& config, const Geometry& g, const BudgetUnits& u) {
  const double ratio = ratio_error(config), tan = unit(config.tan_f);
  return g.turned(turn_error(config)) + g.tangent(tan + ratio * std::abs(g.tx), tan + ratio * std::abs(g.ty)) +
         g.moved(view_rounding(u));
}

double projection_power(const Config& config, const Geometry& g, const BudgetUnits& u, double budget) {
  const double ratio = ratio_error(config), mean = unit(config.mean_f);
  const double shift =
      g.shifted(view_rounding(u)) + g.metric.longest(mean + ratio * g.camera.fx * std::abs(g.view.x / g.view.z),
                                                     mean + ratio * g.camera.fy * std::abs(g.view.y / g.view.z));
  return of_change(projection_change(config, g, u), budget) + of_shift(shift, budget);
}

// Error of -log2 of the compensated opacity: `share`, the determinant before dilation over that after it, may be off.
double compensation_power(const Config& config, const Geometry& g, const BudgetUnits& u, const TruthProjection& t,
                          double share) {
  const double x = 2 * (record_change(config, g, u) + projection_change(config, g, u));
  const double moved = 2 * (position_error(config, g, u) + view_rounding(u)) / g.view.z;
  double scales = 0;
  for (int j = 0; j < 3; ++j) scales = std::max(scales, scale_error(config, g.scale[j], u) / g.largest);
  const double tangents =
      unit(config.tan_f) + ratio_error(config) + moved * (1 + std::max(std::abs(g.tx), std::abs(g.ty)));
  // Scales and tangents count beside the largest one: a product of two small ones may change by more than itself.
  const double wide =
      g.gx * g.gy * g.largest * g.largest * 2 * (scales + tangents) * std::sqrt(3 * (1 + g.tx * g.tx + g.ty * g.ty));
  const double turned = g.determinant(turn_error(config) + of_record_quaternion(config), t.det);
  const double error = turned + (2 * std::sqrt(share * t.det) * wide + wide * wide) / t.det +
                       share * (2 * x + x * x + 8 * moved + 64 * unit(config.mantissa_w - 1));
  const double low = std::max(kMinCompensation, share - error), high = std::max(kMinCompensation, share + error);
  return std::max(std::log2(high / share), std::log2(share / low)) / 2 + 6e-5 + unit(config.opacity_f + 1);
}

double conic_power(const Config& config, const Geometry& g, const TruthProjection& t, double budget) {
  const double u = unit(config.mantissa_w - 1);
  const double variance = 16 * u, mixed = 16 * u, det = 23 * u, product = 4 * u;
  const double turn = turn_error(config) + of_record_length(config);  // counts, also of an exact record
  const double relative = 2 * variance + det + 2 * product + g.determinant(turn, t.det);
  const double slope = mixed * std::sqrt(std::min(t.a, t.c) / std::max(t.a, t.c)) +
                       (variance + product) * std::abs(g.metric.slope) + unit(config.slope_w() - 2);
  const double lever = slope * std::sqrt(g.metric.narrow / g.metric.wide);
  return budget * (relative + lever + lever * lever);
}

double coefficient_power(const Config& config, double budget) {
  const double side = config.part_side() - 1;
  // A and E round two products, C too; D and F one.
  const double rounding =
      (1 + side / 2 + side + side * side / 2 + side * side + side * side / 2) * unit(config.coeff_f);
  // Factors cut to 34 bits; w cut to MantissaW + 2 bits, which moves the vertex.
  const double reach = std::sqrt(budget) + 2 * side * std::sqrt(kLog2E / 2 / kDilation);
  return rounding + unit(15) + 2 * std::sqrt(budget) * reach * unit(config.mantissa_w + 1);
}

double accumulator_power(const Config& config) { return 81 * unit(config.power_f); }

// Largest coefficient of the bands from `first` to `last`.
double largest_of(const float* rest, int first, int last) {
  double largest = 0;
  for (int k = sh_first(first); k < sh_first(last + 1); ++k)
    largest = std::max(largest, static_cast<double>(std::abs(rest[k])));
  return largest;
}

// Colour: base and coefficients of the record, direction and basis, and three roundings. Bands of codes have fewer bits
// of their own.
double color_error(const Config& config, const Geometry& g, const float* rest, int degree, const BudgetUnits& u,
                   bool exact_record) {
  const int work = std::max(config.base_w - 3, config.color_w - 2) + 2;
  double error = unit(config.color_w - 1) + unit(work + 1) + (exact_record ? 0 : unit(config.base_w - 2));
  if (config.coded() && !exact_record) error += unit(Config::base_code_w());
  double sum = 0;
  for (int k = 0; k < 3 * sh_rest_count(degree); ++k) sum += std::abs(rest[k]);
  if (sum == 0) return error;
  const double largest = largest_of(rest, 1, degree);
  if (!exact_record)
    error += 0.75 * sh_rest_count(degree) * (largest * unit(config.sh_m_w - 2) + std::max(0.0, largest - 15.9));
  for (int band = 1; band <= degree && config.coded() && !exact_record; ++band)
    error += 0.75 * (2 * band + 1) * largest_of(rest, band, band) * unit(sh_code_w(band) - 2);
  const double position = (exact_record ? 0 : position_error(config, g, u)) + 2 * view_rounding(u);
  return error + sum * (unit(12) + 3 * position / glm::length(g.offset));
}

// The colour without the clamp at 0, as the record holds its constant band.
glm::dvec3 open_color(const Config& config, const glm::vec3& dc, const float* rest, int degree,
                      const glm::dvec3& offset) {
  const double low = config.coded() ? -0.5 : -4,
               top = config.coded() ? 1.5 - unit(Config::base_code_w() - 1) : 4 - unit(config.base_w - 3),
               length = glm::length(offset);
  double basis[15];
  sh_basis(length > 0 ? offset / length : glm::dvec3(0, 0, 1), basis);
  glm::dvec3 color(0);
  for (int i = 0; i < 3; ++i) {
    color[i] = std::clamp(kSh0 * static_cast<double>(dc[i]) + 0.5, low, top);
    for (int k = 0; k < sh_rest_count(degree); ++k) color[i] += basis[k] * rest[3 * k + i];
  }
  return color;
}

}  // namespace

GaussianBudget gaussian_budget(const Config& config, const Camera& camera, const ProjectionOptions& options,
                               const ActivatedGaussian& gaussian, const glm::vec3& sh_dc, const float* sh_rest,
                               int sh_degree, const BudgetUnits& units, bool exact_record) {
  GaussianBudget out;
  ProjectionOptions behind = options;  // the near plane is decided here
  behind.near_plane = 0;
  out.truth = project_truth(gaussian, sh_dc, sh_rest, sh_degree, camera, behind);
  if (!out.truth.visible) return out;
  const Geometry g(camera, gaussian, out.truth);
  const double depth_error =
      (exact_record ? 0 : position_error(config, g, units)) + 2 * view_rounding(units) + units.world;
  out.depth = depth_error;
  if (out.truth.depth <= options.near_plane - depth_error) {
    out.truth.visible = false;
    return out;
  }
  out.certain = out.truth.depth > options.near_plane + depth_error;
  const double budget = std::log2(255.0) + 1;  // the farthest pixel that may count, roundings included
  out.power.record = exact_record ? 0 : record_power(config, g, units, gaussian.opacity, budget);
  out.power.projection = projection_power(config, g, units, budget);
  out.power.conic = conic_power(config, g, out.truth, budget);
  out.power.coefficients = coefficient_power(config, budget);
  out.power.accumulators = accumulator_power(config);
  if (options.antialiased) {
    const double lowered = out.truth.opacity / gaussian.opacity;
    out.power.compensation = compensation_power(config, g, units, out.truth, lowered * lowered);
  }
  const int degree = std::min(sh_degree, config.sh_degree);
  out.rgb = open_color(config, sh_dc, sh_rest, degree, g.offset);
  out.color = color_error(config, g, sh_rest, degree, units, exact_record);
  return out;
}

double budget_power(const TruthProjection& t, double x, double y) {
  const double length = Metric(t).length(t.mean.x - x, t.mean.y - y);
  return std::log2(t.opacity) - kLog2E / 2 * length * length;
}

Interval alpha_interval(const Config& config, double power, double error) {
  const double cut = -std::ldexp(static_cast<double>(config.power_cut()), -config.power_f);
  const double low = power - error, high = std::min(power + error, 0.0);
  if (!(high >= cut)) return {0, 0};
  const double one = std::ldexp(1.0, config.alpha_w), rounding = alpha_rounding(config) * one;
  const auto code = [&](double alpha, double by) {
    return std::clamp(alpha * one + by, 1.0, static_cast<double>(config.alpha_max()));
  };
  return {low >= cut ? code(std::exp2(low), -rounding) / one : 0, code(std::exp2(high), rounding) / one};
}

Interval color_interval(const Config& config, double color, double error) {
  const double top = 4 - unit(config.color_w - 2);
  return {std::clamp(color - error, 0.0, top), std::clamp(color + error, 0.0, top)};
}

double alpha_rounding(const Config& config) {
  constexpr double kLn2 = 0.6931471805599453;
  // What a chord lies above the curve, or half the way from one entry of the table to the next.
  const double table =
      config.exp_linear ? kLn2 * kLn2 / 8 * unit(2 * config.exp_index_w) : kLn2 / 2 * unit(config.exp_index_w);
  const double inside = table + unit(config.alpha_w + 7) + unit(config.alpha_w + 7) + unit(config.exp_f()) * kLn2;
  return unit(config.alpha_w + 1) + inside;
}

double weight_rounding(const Config& config) { return unit(config.t_w); }

double blend_rounding(const Config& config) { return unit(config.rgb_w - 1); }

double stop_level(const Config& config) { return std::ldexp(static_cast<double>(config.t_stop()), 1 - config.t_w); }

}  // namespace pipegs
