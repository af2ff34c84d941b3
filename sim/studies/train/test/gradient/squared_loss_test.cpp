// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient/squared_loss: its value by hand, its derivative against differences.
#include "sim/studies/train/gradient/squared_loss.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pipegs {
namespace {

const std::vector<glm::vec3> kWanted = {{0.25f, 0.5f, 1}, {0, 0.125f, 0.75f}};

TEST(SquaredLoss, ByHand) {
  std::vector<glm::vec3> picture = kWanted, slope;
  EXPECT_EQ(squared_loss(picture, kWanted, &slope), 0);
  EXPECT_EQ(slope, std::vector<glm::vec3>(2, glm::vec3(0))) << "what is met does not move";
  picture[1].x = 0.5f, picture[0].z = 0.5f;
  EXPECT_DOUBLE_EQ(squared_loss(picture, kWanted, &slope), (0.25 + 0.25) / 6);
  EXPECT_FLOAT_EQ(slope[1].x, 1.0f / 6);
  EXPECT_FLOAT_EQ(slope[0].z, -1.0f / 6);
}

TEST(SquaredLoss, ItsDerivativeIsThatOfDifferences) {
  const std::vector<glm::vec3> picture = {{0.5f, 0.25f, 0.875f}, {0.0625f, 1, 0.5f}};
  std::vector<glm::vec3> slope, ignored;
  squared_loss(picture, kWanted, &slope);
  const float step = 0.0625f;  // the loss is of second order, so the central difference is exact
  for (std::size_t i = 0; i < picture.size(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      std::vector<glm::vec3> more = picture, less = picture;
      more[i][channel] += step, less[i][channel] -= step;
      const double difference = squared_loss(more, kWanted, &ignored) - squared_loss(less, kWanted, &ignored);
      EXPECT_NEAR(slope[i][channel], difference / (2 * step), 1e-7) << i << " " << channel;
    }
  }
}

TEST(SquaredLoss, PicturesOfOtherSizesAreRefused) {
  std::vector<glm::vec3> slope;
  EXPECT_THROW(squared_loss({kWanted[0]}, kWanted, &slope), std::invalid_argument);
}

}  // namespace
}  // namespace pipegs
