// SPDX-License-Identifier: Apache-2.0
// adam: see adam.hpp.
#include "sim/studies/train/optimise/adam.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "cpp_model/float/parallel.hpp"

namespace pipegs {
namespace {

constexpr double kFirst = 0.9, kSecond = 0.999;
constexpr float kEpsilon = 1e-15f, kLargest = 1e15f;
constexpr std::size_t kBlock = 1 << 15, kOne = 1;

struct Factors {
  float rate, root, epsilon;  // rate / (1 - b1^t), 1 / sqrt(1 - b2^t)
};

// The moments with this gradient; returns the sum of the second ones.
double follow(float* first, float* second, const float* gradient, std::size_t count) {
  constexpr float kOld1 = kFirst, kNew1 = 1 - kFirst, kOld2 = kSecond, kNew2 = 1 - kSecond;
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float raw = gradient[i];
    const float g = raw > kLargest ? kLargest : raw < -kLargest ? -kLargest : raw == raw ? raw : 0;
    first[i] = kOld1 * first[i] + kNew1 * g;
    second[i] = kOld2 * second[i] + kNew2 * g * g;
    sum += second[i];
  }
  return sum;
}

void move(float* value, const float* first, const float* second, std::size_t count, Factors factors) {
  for (std::size_t i = 0; i < count; ++i)
    value[i] -= factors.rate * first[i] / (std::sqrt(second[i]) * factors.root + factors.epsilon);
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
    float *value = floats(values), *first = floats(moments.first.*member), *second = floats(moments.second.*member);
    const auto* slope = reinterpret_cast<const float*>((gradient.*member).data());
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    const auto some = [&](std::size_t block) { return std::min(kBlock, count - block * kBlock); };
    std::vector<double> sums(blocks);
    parallel_for(blocks, threads, [&](std::size_t block) {
      const std::size_t at = block * kBlock;
      sums[block] = follow(first + at, second + at, slope + at, some(block));
    });
    const double mean = std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(std::max(count, kOne)),
                 usual = std::sqrt(mean / bias2);
    const Factors factors{static_cast<float>(rate / bias1), static_cast<float>(1 / std::sqrt(bias2)),
                          static_cast<float>(rates.damping * usual) + kEpsilon};
    parallel_for(blocks, threads, [&](std::size_t block) {
      const std::size_t at = block * kBlock;
      move(value + at, first + at, second + at, some(block), factors);
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
