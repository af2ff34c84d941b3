// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/optimise: two steps of Adam worked by hand, and INRIA's schedule at the steps where it
// changes.
#include <gtest/gtest.h>

#include <limits>

#include "sim/studies/train/optimise/adam.hpp"
#include "sim/studies/train/run/trainer.hpp"

namespace pipegs {
namespace {

Parameters one_gaussian() {
  Parameters p;
  p.mean = {glm::vec3(0)}, p.log_scale = {glm::vec3(0)}, p.sh_dc = {glm::vec3(0)};
  p.rotation = {glm::vec4(0)}, p.opacity_logit = {0};
  return p;
}

// m and v after the gradients 0.5 and -0.25, divided by 1 - b^t:
//   0.05 / 0.1 = 0.5, 0.00025 / 0.001 = 0.25, a step of 0.1 * 0.5 / 0.5
//   0.02 / 0.19 = 0.1052632, 0.00031225 / 0.001999 = 0.1562031, a step of 0.1 * 0.1052632 / 0.3952254
TEST(Adam, TwoStepsByHand) {
  Parameters p = one_gaussian();
  Moments moments{p, p};
  Gradient gradient = p;
  const Rates rates{.mean = 0, .sh_dc = 0, .sh_rest = 0, .opacity = 0.1, .scale = 0, .rotation = 0};
  gradient.opacity_logit[0] = 0.5f;
  adam_step(p, moments, gradient, rates, 1, 1);
  EXPECT_NEAR(p.opacity_logit[0], -0.1, 1e-7);
  EXPECT_NEAR(moments.first.opacity_logit[0], 0.05, 1e-8);
  EXPECT_NEAR(moments.second.opacity_logit[0], 0.00025, 1e-10);
  gradient.opacity_logit[0] = -0.25f;
  adam_step(p, moments, gradient, rates, 2, 1);
  EXPECT_NEAR(p.opacity_logit[0], -0.1 - 0.1 * 0.1052632 / 0.3952254, 1e-7);
}

TEST(Adam, EachFieldHasItsRateAndNoGradientNoStep) {
  Parameters p = one_gaussian();
  Moments moments{p, p};
  Gradient gradient = p;
  gradient.mean[0] = {1, -2, 0}, gradient.log_scale[0].y = 3, gradient.sh_dc[0].z = -1e-9f, gradient.rotation[0].w = 5;
  const Rates rates{.mean = 0.01, .sh_dc = 0.02, .sh_rest = 0.03, .opacity = 0.04, .scale = 0.05, .rotation = 0.06};
  adam_step(p, moments, gradient, rates, 1, 1);
  const auto expect_near = [](const auto& found, const auto& wanted) { EXPECT_LT(glm::length(found - wanted), 1e-6f); };
  expect_near(p.mean[0], glm::vec3(-0.01f, 0.01f, 0));  // the first step is the rate, whatever the gradient
  expect_near(p.log_scale[0], glm::vec3(0, -0.05f, 0));
  expect_near(p.sh_dc[0], glm::vec3(0, 0, 0.02f));
  expect_near(p.rotation[0], glm::vec4(0, 0, 0, -0.06f));
  EXPECT_EQ(p.opacity_logit[0], 0);
}

// Two numbers with the gradients 4 and 3e-3: the root of their mean square is 2.83 at the first step.
TEST(Adam, DampedWhatHasLessThanTheUsualGradientMovesByLess) {
  Parameters p = one_gaussian();
  p.opacity_logit = {0, 0};
  Moments moments{p, p};
  Gradient gradient = p;
  gradient.opacity_logit = {4, -3e-3f};
  adam_step(p, moments, gradient, {.opacity = 0.1, .damping = 1}, 1, 1);
  const double usual = std::sqrt((16 + 9e-6) / 2);
  EXPECT_NEAR(p.opacity_logit[0], -0.1 * 4 / (4 + usual), 1e-6);
  EXPECT_NEAR(p.opacity_logit[1], 0.1 * 3e-3 / (3e-3 + usual), 1e-8);
}

TEST(Adam, WhatIsNoNumberMovesNothingAndHugeOnesStayFinite) {
  for (const float gradient_value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                                     -std::numeric_limits<float>::max()}) {
    Parameters p = one_gaussian();
    Moments moments{p, p};
    Gradient gradient = p;
    gradient.opacity_logit[0] = gradient_value;
    adam_step(p, moments, gradient, {.opacity = 0.1}, 1, 1);
    EXPECT_TRUE(std::isfinite(moments.second.opacity_logit[0]));
    EXPECT_NEAR(std::abs(p.opacity_logit[0]), gradient_value == gradient_value ? 0.1 : 0, 1e-6);
  }
}

TEST(Adam, ThreadsChangeNoBit) {
  Parameters p;
  p.sh_degree = 3;
  const std::size_t count = 3000;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    p.mean.emplace_back(x, x, 1), p.log_scale.emplace_back(x), p.sh_dc.emplace_back(x), p.rotation.emplace_back(x);
    p.opacity_logit.push_back(x);
    for (int k = 0; k < 45; ++k) p.sh_rest.push_back(std::sin(x + static_cast<float>(k)));
  }
  Parameters one = p, four = p;
  Moments moments_one{zero_gradient(p), zero_gradient(p)}, moments_four = moments_one;
  const Rates rates = Schedule{}.rates(1, 2);
  adam_step(one, moments_one, p, rates, 1, 1);
  adam_step(four, moments_four, p, rates, 1, 4);
  EXPECT_EQ(one.sh_rest, four.sh_rest);
  EXPECT_EQ(one.mean, four.mean);
  EXPECT_NE(one.sh_rest, p.sh_rest);
}

TEST(Schedule, IsInriasAtItsNumberOfSteps) {
  const Schedule inria{30000};
  EXPECT_NEAR(inria.rates(30000, 2).mean, 3.2e-6, 1e-12);
  EXPECT_NEAR(inria.rates(15000, 1).mean, 1.6e-5, 1e-12);
  EXPECT_EQ(inria.rates(7, 1).sh_rest, 0.0025 / 20);
  EXPECT_EQ(inria.sh_degree(999, 3), 0);
  EXPECT_EQ(inria.sh_degree(1000, 3), 1);
  EXPECT_EQ(inria.sh_degree(3000, 3), 3);
  EXPECT_EQ(inria.sh_degree(30000, 2), 2);
  EXPECT_FALSE(inria.grows(500));
  EXPECT_TRUE(inria.grows(600));
  EXPECT_FALSE(inria.grows(650));
  EXPECT_TRUE(inria.grows(14900));
  EXPECT_FALSE(inria.grows(15000));
  EXPECT_TRUE(inria.resets_opacity(3000));
  EXPECT_FALSE(inria.resets_opacity(15000));
  EXPECT_FALSE(inria.prunes_large(3000));
  EXPECT_TRUE(inria.prunes_large(3100));
}

TEST(Schedule, SharesOfAShorterRun) {
  const Schedule tenth{3000};
  EXPECT_NEAR(tenth.rates(1500, 1).mean, 1.6e-5, 1e-12);
  EXPECT_EQ(tenth.sh_degree(100, 3), 1);
  EXPECT_TRUE(tenth.grows(100));
  EXPECT_TRUE(tenth.grows(1400));
  EXPECT_FALSE(tenth.grows(1500));
  EXPECT_FALSE(tenth.resets_opacity(3000));
  const Schedule fine{1000, true};
  EXPECT_FALSE(fine.grows(100));
  EXPECT_FALSE(fine.counts_gradients(100));
  EXPECT_EQ(fine.sh_degree(1, 3), 3);
  EXPECT_NEAR(fine.rates(1000, 1).mean, 1.6e-7, 1e-12);
  EXPECT_NEAR(fine.rates(1000, 1).opacity, 0.0005, 1e-9);
}

}  // namespace
}  // namespace pipegs
