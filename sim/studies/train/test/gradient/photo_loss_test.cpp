// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient/photo_loss: small pictures by hand, SSIM pixel by pixel as INRIA defines it,
// differences.
#include "sim/studies/train/gradient/photo_loss.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace pipegs {
namespace {

using Picture = std::vector<glm::dvec3>;

Picture random_picture(unsigned seed, int width, int height) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Picture picture(static_cast<std::size_t>(width * height));
  for (glm::dvec3& pixel : picture) {
    for (int c = 0; c < 3; ++c) pixel[c] = uniform();
  }
  return picture;
}

// 1 - mean SSIM by the definition: a weighted window round each pixel, zeros beyond the edge.
double plain_dssim(const Picture& p, const Picture& q, int width, int height) {
  double weights[11], norm = 0, total = 0;
  for (int i = 0; i < 11; ++i) norm += weights[i] = std::exp(-(i - 5) * (i - 5) / 4.5);
  for (int c = 0; c < 3; ++c) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        double m = 0, n = 0, pp = 0, qq = 0, pq = 0;
        for (int dy = -5; dy <= 5; ++dy) {
          for (int dx = -5; dx <= 5; ++dx) {
            if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height) continue;
            const auto at = static_cast<std::size_t>((y + dy) * width + x + dx);
            const double weight = weights[dy + 5] * weights[dx + 5] / (norm * norm), a = p[at][c], b = q[at][c];
            m += weight * a, n += weight * b, pp += weight * a * a, qq += weight * b * b, pq += weight * a * b;
          }
        }
        total += (2 * m * n + 1e-4) * (2 * (pq - m * n) + 9e-4) /
                 ((m * m + n * n + 1e-4) * (pp - m * m + qq - n * n + 9e-4));
      }
    }
  }
  return 1 - total / (3.0 * width * height);
}

TEST(PhotoLoss, OfTwoPixelsByHand) {
  const Picture picture{{0.5, 0.25, 1}, {0, 0, 0}}, photo{{0.25, 0.5, 1}, {0, 0, 0.5}};
  Picture gradient;
  EXPECT_NEAR(photo_loss(picture, photo, 2, 1, 0, &gradient), (0.25 + 0.25 + 0.5) / 6, 1e-15);
  EXPECT_EQ(gradient, (Picture{{1.0 / 6, -1.0 / 6, 0}, {0, 0, -1.0 / 6}}));
}

TEST(PhotoLoss, EqualPicturesHaveNone) {
  const Picture picture = random_picture(1, 20, 13);
  Picture gradient;
  EXPECT_NEAR(photo_loss(picture, picture, 20, 13, 0.2, &gradient), 0, 1e-15);
  for (const glm::dvec3& pixel : gradient) EXPECT_NEAR(glm::length(pixel), 0, 1e-12);
}

TEST(PhotoLoss, IsInriasSsim) {
  for (const auto& [width, height] : {std::pair(23, 17), {4, 30}, {1, 1}, {3, 2}}) {
    const Picture p = random_picture(2, width, height), q = random_picture(3, width, height);
    double difference = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      difference += std::abs(p[i].x - q[i].x) + std::abs(p[i].y - q[i].y) + std::abs(p[i].z - q[i].z);
    const double wanted = 0.8 * difference / (3.0 * width * height) + 0.2 * plain_dssim(p, q, width, height);
    EXPECT_NEAR(photo_loss(p, q, width, height, 0.2, nullptr), wanted, 1e-12) << width << "x" << height;
  }
}

TEST(PhotoLoss, SlopesAreThoseOfDifferences) {
  // The pictures are random, so no value is near its photograph's, where L1 has a corner.
  const int width = 15, height = 14;
  Picture p = random_picture(4, width, height);
  const Picture q = random_picture(5, width, height);
  Picture gradient;
  photo_loss(p, q, width, height, 0.2, &gradient);
  const double step = 1e-5;
  for (std::size_t i = 0; i < p.size(); i += 4) {
    for (int c = 0; c < 3; ++c) {
      const double kept = p[i][c];
      if (std::abs(kept - q[i][c]) < 2 * step) continue;
      p[i][c] = kept + step;
      const double above = photo_loss(p, q, width, height, 0.2, nullptr);
      p[i][c] = kept - step;
      const double below = photo_loss(p, q, width, height, 0.2, nullptr);
      p[i][c] = kept;
      const double wanted = (above - below) / (2 * step);
      EXPECT_NEAR(gradient[i][c], wanted, 1e-4 * std::abs(wanted) + 1e-9) << i;
    }
  }
}

TEST(PhotoLoss, InFloatIsNearlyThatInDouble) {
  const int width = 97, height = 61;
  Picture p = random_picture(6, width, height), q = random_picture(7, width, height);
  for (std::size_t i = 0; i < p.size(); ++i) {  // half of it smooth: there variances are small differences
    if (i % width < 48) q[i] = p[i] = glm::dvec3(0.8, 0.5 + static_cast<double>(i) * 1e-5, 0.3);
    if (i % width < 24) p[i] += 0.02;
  }
  Picture wanted;
  std::vector<glm::vec3> found, photo(q.begin(), q.end());
  const double loss = photo_loss(p, q, width, height, 0.2, &wanted);
  EXPECT_NEAR(photo_loss({p.begin(), p.end()}, photo, width, height, 0.2, &found), loss, 1e-5 * loss);
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i % width >= 24 && i % width < 48) continue;  // L1's corner
    largest = std::max(largest, glm::length(wanted[i]));
    worst = std::max(worst, glm::length(wanted[i] - glm::dvec3(found[i])));
  }
  EXPECT_LT(worst, 1e-3 * largest);
}

TEST(PhotoLoss, RefusesPicturesOfAnotherSize) {
  const Picture six(6), four(4);
  EXPECT_THROW(photo_loss(six, four, 3, 2, 0.2, nullptr), std::invalid_argument);
  EXPECT_THROW(photo_loss(six, six, 2, 2, 0.2, nullptr), std::invalid_argument);
  EXPECT_THROW(photo_loss(Picture{}, Picture{}, 0, 0, 0.2, nullptr), std::invalid_argument);
}

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
