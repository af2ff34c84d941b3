// SPDX-License-Identifier: Apache-2.0
// metrics: see metrics.hpp.
//
// Idea    Plain sums in double in pixel order: the result does not depend on threads.
//         A NaN on either side makes the result NaN rather than being lost in a comparison.
#include "cpp_model/float/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace pipegs {
namespace {

void check_same_size(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw std::invalid_argument("metrics: images of " + std::to_string(a.width) + "x" + std::to_string(a.height) +
                              " and " + std::to_string(b.width) + "x" + std::to_string(b.height) +
                              " cannot be compared");
}

constexpr int kSide = 11;  // of an SSIM window

std::array<double, kSide> ssim_weights() {
  std::array<double, kSide> weights;
  double sum = 0;
  for (int i = 0; i < kSide; ++i) sum += weights[i] = std::exp(-(i - 5) * (i - 5) / (2 * 1.5 * 1.5));
  for (double& weight : weights) weight /= sum;
  return weights;
}

std::vector<double> clamped_plane(const Image& image, int channel) {
  std::vector<double> plane;
  plane.reserve(image.rgb.size());
  for (const glm::dvec3& pixel : image.rgb) plane.push_back(glm::clamp(pixel[channel], 0.0, 1.0));
  return plane;
}

// The weighted sum down the columns of kSide rows from `top` on, of the product of two planes.
void fold(const std::vector<double>& a, const std::vector<double>& b, int width, int top,
          const std::array<double, kSide>& weights, std::vector<double>& columns) {
  std::fill(columns.begin(), columns.end(), 0.0);
  for (int i = 0; i < kSide; ++i) {
    const double* x = a.data() + static_cast<std::size_t>(top + i) * static_cast<std::size_t>(width);
    const double* y = b.data() + static_cast<std::size_t>(top + i) * static_cast<std::size_t>(width);
    for (int k = 0; k < width; ++k) columns[k] += weights[i] * x[k] * y[k];
  }
}

// Sum of the local SSIM over all windows of one channel.
double ssim_sum(const std::vector<double>& a, const std::vector<double>& b, int width, int height) {
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
  const std::array<double, kSide> weights = ssim_weights();
  const std::vector<double> ones(a.size(), 1.0);
  const std::pair<const std::vector<double>*, const std::vector<double>*> products[5] = {
      {&a, &ones}, {&b, &ones}, {&a, &a}, {&b, &b}, {&a, &b}};
  std::array<std::vector<double>, 5> columns;
  for (std::vector<double>& column : columns) column.resize(static_cast<std::size_t>(width));
  double sum = 0;
  for (int top = 0; top + kSide <= height; ++top) {
    for (int m = 0; m < 5; ++m) fold(*products[m].first, *products[m].second, width, top, weights, columns[m]);
    for (int left = 0; left + kSide <= width; ++left) {
      double mean[5] = {};
      for (int m = 0; m < 5; ++m) {
        for (int i = 0; i < kSide; ++i) mean[m] += weights[i] * columns[m][left + i];
      }
      const double ma = mean[0], mb = mean[1], saa = mean[2] - ma * ma, sbb = mean[3] - mb * mb,
                   sab = mean[4] - ma * mb;
      sum += (2 * ma * mb + kC1) * (2 * sab + kC2) / ((ma * ma + mb * mb + kC1) * (saa + sbb + kC2));
    }
  }
  return sum;
}

}  // namespace

double psnr(const Image& a, const Image& b) {
  check_same_size(a, b);
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const glm::dvec3 d = glm::clamp(a.rgb[i], 0.0, 1.0) - glm::clamp(b.rgb[i], 0.0, 1.0);
    sum += glm::dot(d, d);
  }
  if (sum == 0) return std::numeric_limits<double>::infinity();
  return -10 * std::log10(sum / (3 * static_cast<double>(a.rgb.size())));
}

double max_abs_error(const Image& a, const Image& b) {
  check_same_size(a, b);
  double worst = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(a.rgb[i][c] - b.rgb[i][c]);
      if (!(error <= worst)) worst = error;
      if (std::isnan(error)) return error;
    }
  }
  return worst;
}

double percentile_abs_error(const Image& a, const Image& b, double share) {
  check_same_size(a, b);
  std::vector<double> errors;
  errors.reserve(3 * a.rgb.size());
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      errors.push_back(std::abs(a.rgb[i][c] - b.rgb[i][c]));
      if (std::isnan(errors.back())) return errors.back();
    }
  }
  if (errors.empty()) return 0;
  const auto count = static_cast<double>(errors.size());
  const auto at = static_cast<std::ptrdiff_t>(std::clamp(std::ceil(share * count) - 1, 0.0, count - 1));
  std::nth_element(errors.begin(), errors.begin() + at, errors.end());
  return errors[static_cast<std::size_t>(at)];
}

double ssim(const Image& a, const Image& b) {
  check_same_size(a, b);
  if (a.width < kSide || a.height < kSide) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const std::vector<double> plane_a = clamped_plane(a, c), plane_b = clamped_plane(b, c);
    sum += ssim_sum(plane_a, plane_b, a.width, a.height);
  }
  return sum / (3.0 * (a.width - kSide + 1) * (a.height - kSide + 1));
}

}  // namespace pipegs
