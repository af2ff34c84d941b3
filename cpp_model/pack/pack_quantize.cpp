// SPDX-License-Identifier: Apache-2.0
// pack_quantize: see pack_quantize.hpp.
#include "cpp_model/pack/pack_quantize.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "cpp_model/fixed.hpp"

namespace pipegs {
namespace {

constexpr double kShBand0 = 0.28209479177387814;
constexpr int kScaleBias = 8;  // exponent field of a scale of one world unit

// Rounds and clips to a signed field; adds to `clipped` when it did not fit.
int64_t to_signed(double value, int bits, uint64_t& clipped) {
  const double high = std::ldexp(1.0, bits - 1) - 1, rounded = std::round(value);
  if (rounded > high || rounded < -high - 1) ++clipped;
  return static_cast<int64_t>(std::clamp(rounded, -high - 1, high));
}

// How far a Gaussian reaches, of what an opaque one does.
double reach_of_opacity(const Config& config, const GaussianRecord& record) {
  const double log2_opacity = -std::ldexp(static_cast<double>(record.opacity), -config.opacity_f);
  return std::sqrt(std::max(0.0, 1 + log2_opacity / std::log2(config.alpha_cut)));
}

}  // namespace

uint64_t encode_scale(const Config& config, double world, bool round_up) {
  const int mantissa_w = config.scale_m_w;
  const int64_t one = int64_t{1} << mantissa_w, largest = (one << config.scale_e_w) - 1;
  if (!(world > 0)) return 0;
  int exponent;
  const double fraction = std::frexp(world, &exponent);  // world = fraction * 2^exponent, fraction in [0.5, 1)
  const double mantissa = std::ldexp(fraction, mantissa_w + 1);
  const int64_t rounded = static_cast<int64_t>(round_up ? std::ceil(mantissa) : std::round(mantissa));
  // A mantissa that rounds up to 2 carries into the exponent by itself.
  const int64_t field = int64_t{exponent - 1 + kScaleBias} * one + (rounded - one);
  if (field < one) return round_up || world * 2 >= std::ldexp(1.0, 1 - kScaleBias) ? static_cast<uint64_t>(one) : 0;
  return static_cast<uint64_t>(std::min(field, largest));
}

double scale_value(const Config& config, uint64_t scale) {
  const int exponent = static_cast<int>(scale >> config.scale_m_w);
  if (exponent == 0) return 0;
  const double mantissa = static_cast<double>(scale & ((uint64_t{1} << config.scale_m_w) - 1));
  return std::ldexp(1 + std::ldexp(mantissa, -config.scale_m_w), exponent - kScaleBias);
}

uint64_t encode_opacity(const Config& config, double opacity) {
  return static_cast<uint64_t>(std::max(0.0, std::round(std::ldexp(-std::log2(opacity), config.opacity_f))));
}

double effective_scale(const Config& config, const GaussianRecord& record) {
  const double widest = scale_value(config, std::max({record.scale_0, record.scale_1, record.scale_2}));
  return widest * reach_of_opacity(config, record);
}

std::array<double, 3> ellipsoid_extents(const Config& config, const GaussianRecord& record) {
  // Of the mantissas' width, and of a quaternion that its rounding leaves a little longer or shorter than one.
  const double slack = std::ldexp(1.0, -9) + std::ldexp(8.0, -config.quat_w);
  const glm::dquat rotation =
      glm::normalize(glm::dquat(static_cast<double>(record.qw), static_cast<double>(record.qx),
                                static_cast<double>(record.qy), static_cast<double>(record.qz)));
  const glm::dmat3 axes = glm::mat3_cast(rotation);  // columns
  const std::array<double, 3> scale = {scale_value(config, record.scale_0), scale_value(config, record.scale_1),
                                       scale_value(config, record.scale_2)};
  const double reach = std::sqrt(2 * std::log(config.alpha_cut)) * reach_of_opacity(config, record);
  const double widest = *std::max_element(scale.begin(), scale.end());
  std::array<double, 3> extents;
  for (int axis = 0; axis < 3; ++axis) {
    double variance = 0;
    for (int k = 0; k < 3; ++k) {
      const double part = axes[k][axis] * scale[static_cast<size_t>(k)];
      variance += part * part;
    }
    extents[static_cast<size_t>(axis)] = reach * (std::sqrt(variance) + slack * widest);
  }
  return extents;
}

GaussianRecord quantize_reach(const Config& config, const ActivatedGaussian& gaussian, int scene_exponent,
                              PackCounts& counts) {
  GaussianRecord record;
  const double largest = scale_value(config, (uint64_t{1} << config.scale_w()) - 1);
  const auto scale = [&](int axis) {
    const double world = std::ldexp(gaussian.scale[axis], -scene_exponent);
    const uint64_t field = encode_scale(config, world, false);
    if (world > largest) ++counts.saturated_scale;
    if (world > 0 && field == 0) ++counts.flushed_scale;
    return field;
  };
  record.scale_0 = scale(0);
  record.scale_1 = scale(1);
  record.scale_2 = scale(2);
  record.opacity = encode_opacity(config, gaussian.opacity);
  uint64_t rotation_clipped = 0;  // a component of exactly one loses one unit: within the rounding, not reported
  const auto component = [&](int i) {
    return to_signed(std::ldexp(gaussian.rotation[i], config.quat_w - 1), config.quat_w, rotation_clipped);
  };
  record.qw = component(0);
  record.qx = component(1);
  record.qy = component(2);
  record.qz = component(3);
  return record;
}

GaussianRecord quantize(const Config& config, const Scene& scene, const ActivatedGaussian& gaussian, uint32_t index,
                        int scene_exponent, PackCounts& counts) {
  GaussianRecord record = quantize_reach(config, gaussian, scene_exponent, counts);
  const auto base = [&](int channel) {
    const double color = kShBand0 * static_cast<double>(scene.gaussians[index].sh_dc[channel]) + 0.5;
    return to_signed(std::ldexp(color, config.base_w - 3), config.base_w, counts.saturated_base);
  };
  record.base_r = base(0);
  record.base_g = base(1);
  record.base_b = base(2);
  record.index = index;
  return record;
}

int color_slots_per_line(int sh_degree) { return sh_degree == 1 ? 4 : 1; }

void quantize_colors(const Config& config, const Scene& scene, int sh_degree, uint32_t index, uint32_t* line, int at,
                     PackCounts& counts) {
  const float* coefficients = sh_rest_of(scene, index);
  const int values = 3 * sh_rest_count(sh_degree), mantissa_w = config.sh_m_w;
  float largest = 0;
  for (int i = 0; i < values; ++i) largest = std::max(largest, std::abs(coefficients[i]));
  // The smallest exponent whose largest mantissa holds every coefficient.
  const int highest = (1 << config.sh_e_w) - 1, limit = (1 << (mantissa_w - 1)) - 1;
  int exponent = 0;
  if (largest > 0) {
    int length;
    std::frexp(largest, &length);  // largest < 2^length: mantissa < 2^(mantissa_w - 1) at e = length + 27
    exponent = std::clamp(length + 27, 0, highest);
    const double mantissa = std::ldexp(static_cast<double>(largest), 26 + mantissa_w - exponent);
    if (std::round(mantissa) > limit && exponent < highest) ++exponent;
  }
  put_bits(line, at, config.sh_e_w, static_cast<uint64_t>(exponent));
  for (int i = 0; i < values; ++i) {
    const double mantissa = std::ldexp(static_cast<double>(coefficients[i]), 26 + mantissa_w - exponent);
    const int64_t field = to_signed(mantissa, mantissa_w, counts.saturated_sh);
    put_bits(line, at + config.sh_e_w + i * mantissa_w, mantissa_w, static_cast<uint64_t>(field));
  }
}

}  // namespace pipegs
