// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/optimise/densify: who is cloned, split and removed, worked by hand; and no count above
// the limit.
#include "sim/studies/train/optimise/densify.hpp"

#include <gtest/gtest.h>

#include <random>

#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

float logit(double opacity) { return static_cast<float>(std::log(opacity / (1 - opacity))); }

struct Population {
  Parameters parameters;
  Moments moments;
  Demand demand;

  void add(float x, double scale, double opacity, double mean_gradient, std::uint32_t seen) {
    Parameters& p = parameters;
    p.mean.emplace_back(x, 0, 0);
    p.log_scale.emplace_back(static_cast<float>(std::log(scale)));
    p.sh_dc.emplace_back(x);
    p.rotation.emplace_back(1, 0, 0, 0);
    p.opacity_logit.push_back(logit(opacity));
    moments = {p, p};  // any values that tell Gaussians apart
    demand.sum.push_back(static_cast<float>(mean_gradient) * static_cast<float>(seen));
    demand.seen.push_back(seen);
  }
};

// With an extent of 1 a Gaussian is small up to a scale of 0.01.
Population five() {
  Population all;
  all.add(0, 0.005, 0.5, 3e-4, 2);   // small: cloned
  all.add(1, 0.05, 0.5, 3e-4, 1);    // large: split
  all.add(2, 0.05, 0.5, 1e-4, 9);    // nothing is asked for
  all.add(3, 0.05, 0.001, 9e-4, 1);  // not to be seen: removed
  all.add(4, 0.2, 0.5, 9e-4, 0);     // no view saw it; larger than a tenth of the extent
  return all;
}

TEST(Densify, ClonesSplitsAndRemoves) {
  Population all = five();
  densify(all.parameters, all.moments, all.demand, {.extent = 1, .most = 100, .prune_large = false, .seed = 1});
  const Parameters& p = all.parameters;
  ASSERT_EQ(p.size(), 6u);
  const float order[] = {0, 2, 4, 0, 1, 1};  // stay; clone; halves
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(p.sh_dc[i].x, order[i]) << i;
    EXPECT_EQ(all.moments.first.sh_dc[i].x, i < 3 ? order[i] : 0) << i;
    EXPECT_EQ(all.moments.second.rotation[i][0], i < 3 ? 1 : 0) << i;
  }
  EXPECT_EQ(p.mean[3], p.mean[0]);
  EXPECT_EQ(p.log_scale[3], p.log_scale[0]);
  for (const std::size_t half : {4u, 5u}) {
    EXPECT_NEAR(std::exp(p.log_scale[half].x), 0.05 / 1.6, 1e-6);
    EXPECT_LT(glm::length(p.mean[half] - glm::vec3(1, 0, 0)), 5 * 0.05 * 1.8);
    EXPECT_EQ(p.opacity_logit[half], logit(0.5));
  }
  EXPECT_NE(p.mean[4], p.mean[5]);
  EXPECT_EQ(all.demand.sum, std::vector<float>(6, 0));
  EXPECT_EQ(all.demand.seen, std::vector<std::uint32_t>(6, 0));
}

TEST(Densify, LargeOnesGoOnceOpacitiesWereReset) {
  Population all = five();
  densify(all.parameters, all.moments, all.demand, {.extent = 1, .most = 100, .prune_large = true, .seed = 1});
  EXPECT_EQ(all.parameters.size(), 5u);
  for (const glm::vec3& color : all.parameters.sh_dc) EXPECT_NE(color.x, 4);
}

// Room for one more: the larger gradient gets it.
TEST(Densify, TheLargestGradientGetsTheRoom) {
  Population all = five();
  all.demand.sum[1] *= 2;
  densify(all.parameters, all.moments, all.demand, {.extent = 1, .most = 5, .prune_large = false, .seed = 1});
  const float order[] = {0, 2, 4, 1, 1};
  ASSERT_EQ(all.parameters.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(all.parameters.sh_dc[i].x, order[i]) << i;
  Population full = five();
  densify(full.parameters, full.moments, full.demand, {.extent = 1, .most = 2, .prune_large = false, .seed = 1});
  EXPECT_EQ(full.parameters.size(), 4u) << "nothing grows, and only what is not to be seen goes";
}

// Halves are drawn from the Gaussian: their mean and their spread along a turned long axis are those of it.
TEST(Densify, HalvesAreDrawnFromTheGaussian) {
  Population all;
  for (int i = 0; i < 4000; ++i) {
    all.add(0, 0.02, 0.5, 1, 1);
    all.parameters.log_scale.back().x = std::log(0.4f);
    all.parameters.rotation.back() = {2, 0, 0, 2};  // a quarter turn round z: the long axis lies along y
  }
  densify(all.parameters, all.moments, all.demand, {.extent = 1, .most = 100000, .prune_large = false, .seed = 9});
  ASSERT_EQ(all.parameters.size(), 8000u);
  glm::dvec3 sum(0), squares(0);
  for (const glm::vec3& mean : all.parameters.mean) {
    sum += mean;
    squares += glm::dvec3(mean) * glm::dvec3(mean);
  }
  const glm::dvec3 spread = glm::sqrt(squares / 8000.0);
  EXPECT_LT(glm::length(sum / 8000.0), 0.02);
  EXPECT_NEAR(spread.x, 0.02, 0.001);
  EXPECT_NEAR(spread.y, 0.4, 0.02);
}

TEST(Densify, NeverMoreThanAskedForAndTheSameEachTime) {
  std::mt19937_64 random(4);
  for (int round = 0; round < 30; ++round) {
    Population all;
    const std::size_t count = 1 + random() % 60, most = count + random() % 40;
    for (std::size_t i = 0; i < count; ++i) {
      const double size = 0.03 * draw_unit(random), opacity = 0.001 + 0.02 * draw_unit(random),
                   demand = 4e-4 * draw_unit(random);
      all.add(static_cast<float>(i), size, opacity, demand, random() % 3);
    }
    Population again = all;
    const DensifyOptions options{.extent = 1, .most = most, .prune_large = round % 2 == 0, .seed = random()};
    densify(all.parameters, all.moments, all.demand, options);
    densify(again.parameters, again.moments, again.demand, options);
    EXPECT_LE(all.parameters.size(), most);
    EXPECT_EQ(all.parameters.mean, again.parameters.mean);
    EXPECT_EQ(all.moments.first.size(), all.parameters.size());
    EXPECT_EQ(all.demand.sum.size(), all.parameters.size());
  }
}

TEST(Densify, DemandIsTheMeanOverTheViewsThatSaw) {
  Demand demand;
  demand.clear(2);
  demand.add({{0.5f, 9}, {3, 0}});
  demand.add({{0.25f, 9}, {3, 0}});
  EXPECT_EQ(demand.sum, (std::vector<float>{0.75f, 0}));
  EXPECT_EQ(demand.seen, (std::vector<std::uint32_t>{2, 0}));
}

TEST(Densify, ResetLeavesNoOpacityAboveAHundredth) {
  Population all = five();
  reset_opacity(all.parameters, all.moments);
  for (const float value : all.parameters.opacity_logit) EXPECT_LE(value, logit(0.01) + 1e-6f);
  EXPECT_EQ(all.parameters.opacity_logit[3], logit(0.001));
  EXPECT_EQ(all.moments.first.opacity_logit, std::vector<float>(5, 0));
  EXPECT_EQ(all.moments.second.opacity_logit, std::vector<float>(5, 0));
}

}  // namespace
}  // namespace pipegs
