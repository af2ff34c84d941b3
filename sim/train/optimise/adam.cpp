// SPDX-License-Identifier: Apache-2.0
// adam: see adam.hpp.
#include "sim/train/optimise/adam.hpp"

#include <algorithm>
#include <cmath>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

constexpr double kFirst = 0.9, kSecond = 0.999;
constexpr float kEpsilon = 1e-15f, kLargest = 1e15f;
constexpr std::size_t kBlock = 1 << 15;

struct Factors {
  float rate, root;  // rate / (1 - b1^t), 1 / sqrt(1 - b2^t)
};

void update(float* value, float* first, float* second, const float* gradient, std::size_t count, Factors factors) {
  constexpr float kOld1 = kFirst, kNew1 = 1 - kFirst, kOld2 = kSecond, kNew2 = 1 - kSecond;
  for (std::size_t i = 0; i < count; ++i) {
    const float raw = gradient[i];
    const float g = raw > kLargest ? kLargest : raw < -kLargest ? -kLargest : raw == raw ? raw : 0;
    first[i] = kOld1 * first[i] + kNew1 * g;
    second[i] = kOld2 * second[i] + kNew2 * g * g;
    value[i] -= factors.rate * first[i] / (std::sqrt(second[i]) * factors.root + kEpsilon);
  }
}

template <class Value>
float* floats(std::vector<Value>& values) {
  return reinterpret_cast<float*>(values.data());
}

}  // namespace

void adam_step(Parameters& parameters, Moments& moments, const Gradient& gradient, const Rates& rates, int step,
               unsigned threads) {
  const double bias1 = 1 - std::pow(kFirst, step), bias2 = 1 - std::pow(kSecond, step);
  const auto field = [&](auto member, double rate) {
    auto& values = parameters.*member;
    const std::size_t count = values.size() * sizeof(values[0]) / sizeof(float);
    const Factors factors{static_cast<float>(rate / bias1), static_cast<float>(1 / std::sqrt(bias2))};
    float *value = floats(values), *first = floats(moments.first.*member), *second = floats(moments.second.*member);
    const auto* slope = reinterpret_cast<const float*>((gradient.*member).data());
    parallel_for((count + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
      const std::size_t begin = block * kBlock, some = std::min(kBlock, count - begin);
      update(value + begin, first + begin, second + begin, slope + begin, some, factors);
    });
  };
  field(&Parameters::mean, rates.mean);
  field(&Parameters::sh_dc, rates.sh_dc);
  field(&Parameters::sh_rest, rates.sh_rest);
  field(&Parameters::opacity_logit, rates.opacity);
  field(&Parameters::log_scale, rates.scale);
  field(&Parameters::rotation, rates.rotation);
}

}  // namespace pipegs
