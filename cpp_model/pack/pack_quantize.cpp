// SPDX-License-Identifier: Apache-2.0
// pack_quantize: see pack_quantize.hpp.
#include "cpp_model/pack/pack_quantize.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/color/sh_code.hpp"
#include "cpp_model/pu/front/pu_decode.hpp"

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

// How far a Gaussian reaches, of what an opaque one does; `opacity` is the record's field.
double reach_of_opacity(const Config& config, uint64_t opacity) {
  const double log2_opacity = -std::ldexp(static_cast<double>(opacity), -config.opacity_f);
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
  return widest * reach_of_opacity(config, record.opacity);
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
  const double reach = std::sqrt(2 * std::log(config.alpha_cut)) * reach_of_opacity(config, record.opacity);
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

namespace {

int opacity_code(double opacity) { return static_cast<int>(std::lround(std::min(opacity, 1.0) * kMostOpacity)); }

uint64_t scale_code(const Config& config, double world, uint64_t scale_exp, PackCounts& counts) {
  if (!(world > 0)) return kNoScale;
  const double top = static_cast<double>(scale_exp) + kScaleHeadroom - kScaleBias,
               code = std::round(kScaleSteps * (top - std::log2(world)));
  counts.saturated_scale += code < 0 || code > kNoScale - 1;
  const auto field = static_cast<uint64_t>(std::clamp(code, 0.0, kNoScale - 1.0));
  counts.flushed_scale += decode_scale(config, field, scale_exp) == 0;
  return field;
}

}  // namespace

uint64_t chunk_scale_exp(const Config& config, std::span<const ActivatedGaussian> gaussians, int scene_exponent) {
  constexpr double kRounded = 1.03;  // half a step of a sixteenth of an octave, and the field's own rounding
  double widest = 0, reach = 0;      // of a Gaussian, and of what it does with its opacity
  for (const ActivatedGaussian& gaussian : gaussians) {
    const double scale = std::ldexp(std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z}), -scene_exponent);
    const uint64_t opacity = opacity_of_code(config, opacity_code(gaussian.opacity));
    widest = std::max(widest, scale);
    reach = std::max(reach, scale * reach_of_opacity(config, opacity));
  }
  const auto exponent = [&](double scale) { return encode_scale(config, scale * kRounded, true) >> config.scale_m_w; };
  return std::max(exponent(reach), exponent(widest * std::exp2(1 - kScaleHeadroom)));
}

GaussianCode encode(const Config& config, const Scene& scene, const ActivatedGaussian& gaussian, uint32_t index,
                    int scene_exponent, uint64_t scale_exp, PackCounts& counts) {
  GaussianCode code;
  glm::dvec4 rotation = gaussian.rotation;
  int axis = 0;
  for (int i = 1; i < 4; ++i) axis = std::abs(rotation[i]) > std::abs(rotation[axis]) ? i : axis;
  if (rotation[axis] < 0) rotation = -rotation;
  uint64_t clipped = 0;  // never: no other component is above sqrt(1/2)
  int64_t* const turns[3] = {&code.turn_0, &code.turn_1, &code.turn_2};
  for (int i = 0, next = 0; i < 4; ++i) {
    if (i == axis) continue;
    const double unit = std::ldexp(rotation[i] * std::sqrt(2.0), Config::turn_code_w() - 1);
    *turns[next++] = std::clamp<int64_t>(to_signed(unit, Config::turn_code_w(), clipped), -255, 255);
  }
  code.axis = static_cast<uint64_t>(axis);
  const auto scale = [&](int i) {
    return scale_code(config, std::ldexp(gaussian.scale[i], -scene_exponent), scale_exp, counts);
  };
  code.scale_0 = scale(0);
  code.scale_1 = scale(1);
  code.scale_2 = scale(2);
  code.opacity = static_cast<uint64_t>(opacity_code(gaussian.opacity));
  const auto base = [&](int channel) {
    const double color = kShBand0 * static_cast<double>(scene.gaussians[index].sh_dc[channel]);
    return to_signed(std::ldexp(color, Config::base_code_w() - 1), Config::base_code_w(), counts.saturated_base);
  };
  code.base_r = base(0);
  code.base_g = base(1);
  code.base_b = base(2);
  return code;
}

namespace {

float largest_of(const float* coefficients, int begin, int end) {
  float largest = 0;
  for (int i = begin; i < end; ++i) largest = std::max(largest, std::abs(coefficients[i]));
  return largest;
}

// The smallest exponent at which mantissas of `width` bits, the upper ones of ShMW, hold what is as large as that.
int sh_exponent(const Config& config, float largest, int width) {
  if (!(largest > 0)) return 0;
  const int highest = (1 << config.sh_e_w) - 1, limit = (1 << (width - 1)) - 1;
  int length;
  std::frexp(largest, &length);  // largest < 2^length: mantissa < 2^(width - 1) at e = length + 27
  const int exponent = std::clamp(length + 27, 0, highest);
  const double mantissa = std::ldexp(static_cast<double>(largest), 26 + width - exponent);
  return exponent + (std::round(mantissa) > limit && exponent < highest);
}

// The codes of SH coefficients (sh_code.hpp): as for the whole mantissas, but each band has bits of its own.
void encode_colors(const Config& config, const float* coefficients, int sh_degree, uint32_t* line, int at,
                   PackCounts& counts) {
  int exponent = 0, own[kMaxShDegree + 1] = {};
  for (int band = 1; band <= sh_degree; ++band) {
    const float largest = largest_of(coefficients, sh_first(band), sh_first(band + 1));
    own[band] = sh_exponent(config, largest, sh_code_w(band));
    exponent = std::max(exponent, own[band]);
  }
  put_bits(line, at, config.sh_e_w, static_cast<uint64_t>(exponent));
  for (int band = 1; band <= sh_degree; ++band) {
    const int width = sh_code_w(band),
              drop = sh_degree == 1 ? 0 : std::min(exponent - own[band], sh_most_drop(config, band));
    if (sh_degree > 1) put_bits(line, at + sh_drop_at(config, band), Config::sh_drop_w(), static_cast<uint64_t>(drop));
    for (int i = sh_first(band); i < sh_first(band + 1); ++i) {
      const double mantissa = std::ldexp(static_cast<double>(coefficients[i]), 26 + width + drop - exponent);
      const int64_t field = to_signed(mantissa, width, counts.saturated_sh);
      put_bits(line, at + sh_code_at(config, sh_degree, i), width, static_cast<uint64_t>(field));
    }
  }
}

}  // namespace

void quantize_colors(const Config& config, const Scene& scene, int sh_degree, uint32_t index, uint32_t* line, int at,
                     PackCounts& counts) {
  const float* coefficients = sh_rest_of(scene, index);
  if (config.coded()) return encode_colors(config, coefficients, sh_degree, line, at, counts);
  const int values = 3 * sh_rest_count(sh_degree), mantissa_w = config.sh_m_w;
  const int exponent = sh_exponent(config, largest_of(coefficients, 0, values), mantissa_w);
  put_bits(line, at, config.sh_e_w, static_cast<uint64_t>(exponent));
  for (int i = 0; i < values; ++i) {
    const double mantissa = std::ldexp(static_cast<double>(coefficients[i]), 26 + mantissa_w - exponent);
    const int64_t field = to_signed(mantissa, mantissa_w, counts.saturated_sh);
    put_bits(line, at + config.sh_e_w + i * mantissa_w, mantissa_w, static_cast<uint64_t>(field));
  }
}

}  // namespace pipegs
