// SPDX-License-Identifier: Apache-2.0
// budget_test: cpp_model/driver/pipegs_budget.c on scenes that are numbers: what a frame takes at a level of detail.
#include "cpp_model/driver/pipegs_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/config.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/dopu/nearest/dopu_lod.hpp"

namespace pipegs {
namespace {

constexpr double kFocal = 1000;
constexpr uint64_t kCycles = 4000000;

Config machine_with_proxies() {
  Config config;
  for (const char* setting : {"late=1", "order=2", "bucket_bits=7", "lod=1"}) config_set(config, setting);
  return config;
}

// Without proxies a frame takes `whole` cycles; those of half a pixel save nothing yet, and with each octave more all
// but `least` of them become 2^slope times fewer.
struct Plant {
  double whole, least, slope;
  uint64_t cycles(uint64_t lod) const {
    const double pixels = dopu_lod_pixels(machine_with_proxies(), kFocal, lod),
                 octaves = pixels > 0.5 ? std::log2(pixels / 0.5) : 0;
    return static_cast<uint64_t>(least + (whole - least) * std::exp2(-slope * octaves));
  }
};

pipegs_budget budget_of(uint64_t cycles) {
  const pipegs_configuration config = driver_configuration(machine_with_proxies());
  const Camera camera =
      look_at("budget", 0, 1000, 1000, glm::dvec3(0, 0, -5), glm::dvec3(0), 2 * 180 / M_PI * std::atan(500 / kFocal));
  const pipegs_camera seen = driver_camera(camera, 0.2);
  pipegs_budget budget;
  EXPECT_TRUE(pipegs_budget_begin(&config, &seen, cycles, &budget));
  return budget;
}

TEST(Budget, TheFirstFrameIsCoarse) {
  const pipegs_budget budget = budget_of(kCycles);
  EXPECT_NEAR(dopu_lod_pixels(machine_with_proxies(), kFocal, pipegs_budget_lod(&budget)), PIPEGS_BUDGET_FIRST, 0.3);
}

TEST(Budget, AMachineWithoutProxiesHasNone) {
  pipegs_configuration config = driver_configuration(Config{});
  pipegs_camera camera = driver_camera(look_at("none", 0, 64, 64, glm::dvec3(0, 0, -5), glm::dvec3(0), 60), 0.2);
  pipegs_budget budget;
  EXPECT_FALSE(pipegs_budget_begin(&config, &camera, kCycles, &budget));
  config = driver_configuration(machine_with_proxies());
  EXPECT_FALSE(pipegs_budget_begin(&config, &camera, 0, &budget)) << "no cycles";
}

// A walk of 120 frames whose scene becomes four times as heavy and light again, by a few percent a frame.
TEST(Budget, AWalkHoldsItsCycles) {
  for (const double slope : {0.3, 0.6, 1.0, 1.5}) {
    pipegs_budget budget = budget_of(kCycles);
    int over = 0;
    for (int frame = 0; frame < 120; ++frame) {
      const double heavy = std::exp2(1 - std::cos(2 * M_PI * frame / 120));
      const Plant plant{heavy * 5e6, heavy * 1e5, slope};
      const uint64_t cycles = plant.cycles(pipegs_budget_lod(&budget));
      over += cycles > kCycles * 11 / 10;
      if (frame > 20 && plant.whole > 1.2 * kCycles) { EXPECT_GT(cycles, kCycles * 6 / 10) << slope << " " << frame; }
      pipegs_budget_took(&budget, cycles);
    }
    EXPECT_LE(over, 1) << slope;
  }
}

// What fits keeps all of its Gaussians; a picture that stands still keeps its level.
TEST(Budget, WhatFitsIsWholeAndWhatStandsStillStays) {
  pipegs_budget budget = budget_of(kCycles);
  for (int frame = 0; frame < 20; ++frame)
    pipegs_budget_took(&budget, Plant{3e6, 1e5, 0.5}.cycles(pipegs_budget_lod(&budget)));
  EXPECT_EQ(pipegs_budget_lod(&budget), 0u);
  uint64_t level = 0;
  int changes = 0;
  for (int frame = 0; frame < 100; ++frame) {
    pipegs_budget_took(&budget, Plant{9e6, 1e5, 0.5}.cycles(pipegs_budget_lod(&budget)));
    if (frame > 50) changes += pipegs_budget_lod(&budget) != level;
    level = pipegs_budget_lod(&budget);
  }
  EXPECT_LE(changes, 1);
}

// Cycles beyond all reason move the level to its end and back, and nothing else.
TEST(Budget, AnyCyclesGiveALevel) {
  for (const uint64_t wanted : {uint64_t{1}, kCycles, ~uint64_t{0}}) {
    pipegs_budget budget = budget_of(wanted);
    for (const uint64_t cycles : {uint64_t{0}, uint64_t{1}, kCycles, ~uint64_t{0}, ~uint64_t{0}, ~uint64_t{0}}) {
      for (int i = 0; i < 20; ++i) pipegs_budget_took(&budget, cycles);
      EXPECT_LT(pipegs_budget_lod(&budget), uint64_t{1} << machine_with_proxies().lod_w()) << cycles;
      if (cycles > wanted) { EXPECT_GT(pipegs_budget_lod(&budget), 0u) << cycles << " of " << wanted; }
    }
  }
}

}  // namespace
}  // namespace pipegs
