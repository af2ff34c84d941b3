// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/start: distances to the three nearest neighbours are those of a search through all
// points, and a scene begins with balls of that size.
#include "sim/studies/train/start/start.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "cpp_model/float/projection.hpp"
#include "scenes/input_error.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

std::vector<double> by_search(const std::vector<glm::dvec3>& points) {
  std::vector<double> means;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> squares;
    for (std::size_t j = 0; j < points.size(); ++j) {
      const glm::dvec3 d = points[j] - points[i];
      if (j != i) squares.push_back(glm::dot(d, d));
    }
    std::sort(squares.begin(), squares.end());
    const std::size_t some = std::min<std::size_t>(squares.size(), 3);
    double sum = 0;
    for (std::size_t k = 0; k < some; ++k) sum += squares[k];
    means.push_back(some == 0 ? 0 : sum / static_cast<double>(some));
  }
  return means;
}

TEST(Neighbours, FewerThanThree) {
  EXPECT_EQ(mean_squared_distances({{1, 2, 3}}, 1), std::vector<double>{0});
  EXPECT_EQ(mean_squared_distances({{0, 0, 0}, {0, 3, 0}}, 1), (std::vector<double>{9, 9}));
  EXPECT_TRUE(mean_squared_distances({}, 1).empty());
}

TEST(Neighbours, EqualASearchThroughAllPoints) {
  std::mt19937_64 random(5);
  for (const std::size_t count : {5u, 9u, 17u, 100u, 1500u}) {
    for (const char* shape : {"cloud", "line", "grid", "same"}) {
      SCOPED_TRACE(std::string(shape) + " of " + std::to_string(count));
      std::vector<glm::dvec3> points;
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 p = draw_normals(random);
        if (shape[0] == 'c') points.push_back(p * p * p);  // dense in the middle, thin outside
        if (shape[0] == 'l') points.emplace_back(0, p.y, 0);
        if (shape[0] == 'g') points.push_back(glm::floor(p * 2.0));  // many at equal distances, many on each other
        if (shape[0] == 's') points.emplace_back(1, 1, 1);
      }
      const std::vector<double> wanted = by_search(points);
      for (const unsigned threads : {1u, 4u}) EXPECT_EQ(mean_squared_distances(points, threads), wanted);
    }
  }
}

TEST(Start, OfPointsIsABallOnEach) {
  const std::vector<ScenePoint> points = {
      {{0, 0, 0}, {255, 0, 51}}, {{2, 0, 0}, {0, 0, 0}}, {{0, 2, 0}, {0, 0, 0}}, {{2, 2, 0}, {0, 0, 0}}};
  const Parameters start = start_of_points(points, 3, 100, 1);
  ASSERT_EQ(start.size(), 4u);
  EXPECT_EQ(start.sh_degree, 3);
  EXPECT_EQ(start.mean[1], glm::vec3(2, 0, 0));
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::exp(start.log_scale[0][axis]), std::sqrt(16.0 / 3), 1e-6);
  EXPECT_NEAR(1 / (1 + std::exp(-start.opacity_logit[0])), 0.1, 1e-7);
  EXPECT_NEAR(0.5 + kSh0 * start.sh_dc[0].x, 1, 1e-6);
  EXPECT_NEAR(0.5 + kSh0 * start.sh_dc[0].z, 0.2, 1e-6);
  EXPECT_EQ(start.sh_rest, std::vector<float>(4 * 45, 0.0f));
  // Points on each other have a size.
  const Parameters same = start_of_points(std::vector<ScenePoint>(5, points[0]), 0, 100, 1);
  EXPECT_NEAR(std::exp(same.log_scale[0].x), std::sqrt(1e-7), 1e-9);
  // No more than there is room for, from all of the file.
  const Parameters two = start_of_points(points, 0, 2, 1);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two.mean[1], glm::vec3(0, 2, 0));
}

TEST(Start, OfASceneLeavesOutWhatIsNeverDrawn) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity(), kNaN = std::numeric_limits<float>::quiet_NaN();
  Scene scene;
  const Gaussian good{{0, 0, 1}, {-1, -2, -kInfinity}, {1, 0, 0, 0}, kInfinity, {0, 0, 0}};
  Gaussian bad = good;
  bad.mean.x = kNaN;
  scene.gaussians = {bad, good};
  const Parameters start = start_of_scene("a.ply", scene, 10);
  ASSERT_EQ(start.size(), 1u);
  EXPECT_EQ(start.mean[0], glm::vec3(0, 0, 1));
  EXPECT_NEAR(std::exp(start.log_scale[0].z), 1e-6, 1e-9);
  EXPECT_NEAR(start.opacity_logit[0], 13.8f, 0);
  scene.gaussians = {bad};
  EXPECT_THROW(start_of_scene("a.ply", scene, 10), InputError);
  scene.gaussians = {good};
  scene.antialiased = true;
  EXPECT_THROW(start_of_scene("a.ply", scene, 10), InputError);
}

}  // namespace
}  // namespace pipegs
