// SPDX-License-Identifier: Apache-2.0
// metrics_test: PSNR, SSIM and percentiles of the error against values worked out by hand.
#include "cpp_model/float/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pipegs {
namespace {

Image flat(int width, int height, double value) {
  Image image(width, height);
  for (glm::dvec3& pixel : image.rgb) pixel = glm::dvec3(value);
  return image;
}

TEST(Metrics, SsimOfEqualImagesIsOne) {
  Image image(16, 12);
  for (int i = 0; i < 16 * 12; ++i) image.rgb[i] = glm::dvec3(std::sin(i) * 0.5 + 0.5, (i % 7) / 7.0, 0.2);
  EXPECT_NEAR(ssim(image, image), 1, 1e-12);
}

// Without variance only the means count: (2 ma mb + C1) / (ma^2 + mb^2 + C1).
TEST(Metrics, SsimOfFlatImagesComparesTheirMeans) {
  EXPECT_NEAR(ssim(flat(20, 11, 0.5), flat(20, 11, 0.25)), (2 * 0.5 * 0.25 + 1e-4) / (0.25 + 0.0625 + 1e-4), 1e-12);
}

// One window, black against a single dot in its centre: mean and variance follow from the centre's weight.
TEST(Metrics, SsimOfADotInOneWindow) {
  Image dot = flat(11, 11, 0);
  dot.rgb[dot.at(5, 5)] = glm::dvec3(1);
  double sum = 0;
  for (int i = -5; i <= 5; ++i) sum += std::exp(-i * i / 4.5);
  const double weight = 1 / (sum * sum), variance = weight - weight * weight;
  const double expected = 1e-4 * 9e-4 / ((weight * weight + 1e-4) * (variance + 9e-4));
  EXPECT_NEAR(ssim(flat(11, 11, 0), dot), expected, 1e-12);
}

TEST(Metrics, SsimSeesWhatAScreenShows) {
  EXPECT_NEAR(ssim(flat(11, 11, 1), flat(11, 11, 1.7)), 1, 1e-12);
  EXPECT_TRUE(std::isnan(ssim(flat(10, 40, 0), flat(10, 40, 0))));
  EXPECT_THROW(ssim(flat(11, 11, 0), flat(12, 11, 0)), std::invalid_argument);
}

// 300 values: errors 1 to 300.
TEST(Metrics, PercentileIsTheSmallestErrorThatTheShareDoesNotExceed) {
  const Image zero = flat(10, 10, 0);
  Image ramp = zero;
  for (int i = 0; i < 300; ++i) ramp.rgb[i / 3][i % 3] = (i % 2 == 0 ? 1.0 : -1.0) * (i + 1);
  EXPECT_EQ(percentile_abs_error(zero, ramp, 0.99), 297);
  EXPECT_EQ(percentile_abs_error(zero, ramp, 0.999), 300);
  EXPECT_EQ(percentile_abs_error(zero, ramp, 0.5), 150);
  EXPECT_EQ(percentile_abs_error(zero, ramp, 0), 1);
  EXPECT_EQ(percentile_abs_error(zero, ramp, 1), max_abs_error(zero, ramp));
  ramp.rgb[50][1] = std::nan("");
  EXPECT_TRUE(std::isnan(percentile_abs_error(zero, ramp, 0.5)));
}

}  // namespace
}  // namespace pipegs
