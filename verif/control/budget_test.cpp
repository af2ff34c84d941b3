// SPDX-License-Identifier: Apache-2.0
// budget_test: cpp_model/driver/pipegs_budget.c on scenes that are numbers: what a frame takes at a level of detail.
#include "cpp_model/driver/pipegs_budget.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "cpp_model/config.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/dopu/nearest/dopu_lod.hpp"

namespace pipegs {
namespace {

constexpr double kFocal = 1000;
constexpr uint64_t kCycles = 4000000;

// A machine whose frames have both fields, or one of them.
Config machine(bool rest, bool proxies) {
  Config config;
  config_set(config, rest ? "early_stop=1" : "early_stop=0");
  if (proxies) {
    for (const char* setting : {"late=1", "order=2", "bucket_bits=7", "lod=1"}) config_set(config, setting);
  }
  return config;
}

const Config kMachines[] = {machine(true, true), machine(false, true), machine(true, false)};

struct Level {
  double rest, pixels;  // transmittance; size of proxies on the screen
};

// What the next frame is queued with.
Level next_level(const Config& config, pipegs_budget& budget) {
  pipegs_frame frame = {};
  pipegs_budget_set(&budget, &frame);
  return {std::ldexp(static_cast<double>(frame.raster_rest), -config.rest_w()),
          dopu_lod_pixels(config, kFocal, frame.lod)};
}

// The whole picture takes `whole` cycles. A rest saves up to `stops` of them; proxies of half a pixel save nothing yet,
// and with each octave more all but `least` become 2^slope times fewer.
struct Plant {
  double whole, least, slope, stops = 0.3;
  uint64_t cycles(Level level) const {
    const double octaves = level.pixels > 0.5 ? std::log2(level.pixels / 0.5) : 0,
                 rests = level.rest > 0 ? std::clamp(10 + std::log2(level.rest), 0.0, 8.0) / 8 : 0;
    return static_cast<uint64_t>((least + (whole - least) * std::exp2(-slope * octaves)) * (1 - stops * rests));
  }
};

pipegs_budget budget_of(const Config& machine, uint64_t cycles) {
  const pipegs_configuration config = driver_configuration(machine);
  const Camera camera =
      look_at("budget", 0, 1000, 1000, glm::dvec3(0, 0, -5), glm::dvec3(0), 2 * 180 / M_PI * std::atan(500 / kFocal));
  const pipegs_camera seen = driver_camera(camera, 0.2);
  pipegs_budget budget;
  EXPECT_TRUE(pipegs_budget_begin(&config, &seen, cycles, &budget));
  return budget;
}

TEST(Budget, TheFirstFrameIsCoarse) {
  for (const Config& config : kMachines) {
    pipegs_budget budget = budget_of(config, kCycles);
    const Level level = next_level(config, budget);
    if (config.lod) { EXPECT_NEAR(level.pixels, PIPEGS_BUDGET_FIRST, 0.3); }
    if (config.early_stop) { EXPECT_GE(level.rest, 1.0 / 16); }
  }
}

TEST(Budget, AMachineThatCanGiveUpNothingHasNone) {
  pipegs_configuration config = driver_configuration(machine(false, false));
  pipegs_camera camera = driver_camera(look_at("none", 0, 64, 64, glm::dvec3(0, 0, -5), glm::dvec3(0), 60), 0.2);
  pipegs_budget budget;
  EXPECT_FALSE(pipegs_budget_begin(&config, &camera, kCycles, &budget));
  config = driver_configuration(machine(true, true));
  EXPECT_FALSE(pipegs_budget_begin(&config, &camera, 0, &budget)) << "no cycles";
}

// Each level gives up as much as the one before or more, first rest and then proxies, and the fields hold what it says.
TEST(Budget, ALevelGivesUpMoreThanTheOneBefore) {
  for (const Config& config : kMachines) {
    pipegs_budget budget = budget_of(config, kCycles);
    Level before = {0, 0};
    int rises = 0;
    for (budget.level = 0; budget.level <= budget.most; ++budget.level) {
      const Level level = next_level(config, budget);
      EXPECT_GE(level.rest, before.rest);
      EXPECT_GE(level.pixels, before.pixels);
      EXPECT_LE(level.rest, config.early_stop ? 0.25 : 0);
      if (config.early_stop && level.pixels > 0) { EXPECT_GE(level.rest, 1.0 / 17); }
      if (!config.lod) { EXPECT_EQ(level.pixels, 0); }
      EXPECT_EQ(budget.level == 0, level.rest == 0 && level.pixels == 0);
      rises += level.rest > before.rest || level.pixels > before.pixels;
      before = level;
    }
    EXPECT_GT(rises, budget.most / 3);
    if (config.lod) { EXPECT_GT(before.pixels, kFocal / 2); }
  }
}

// A walk of 120 frames whose scene becomes four times as heavy and light again, by a few percent a frame; each frame
// queued when the one before is done, or while it runs.
TEST(Budget, AWalkHoldsItsCycles) {
  for (const Config& config : kMachines) {
    for (const double slope : {0.3, 0.6, 1.0, 1.5}) {
      for (const size_t ahead : {0, 1}) {
        pipegs_budget budget = budget_of(config, kCycles);
        std::deque<uint64_t> flying;
        int over = 0;
        for (int frame = 0; frame < 120; ++frame) {
          const double heavy = std::exp2(1 - std::cos(2 * M_PI * frame / 120));
          const Plant plant = config.lod ? Plant{heavy * 5e6, heavy * 1e5, slope}
                                         : Plant{heavy * 2e6, 0, 0, 0.55};  // rest alone does not save more
          const uint64_t cycles = plant.cycles(next_level(config, budget));
          over += cycles > kCycles * 11 / 10;
          if (frame > 20 && plant.whole > 1.2 * kCycles)
            EXPECT_GT(cycles, kCycles * 6 / 10) << slope << " " << ahead << " " << frame;
          flying.push_back(cycles);
          if (flying.size() > ahead) pipegs_budget_took(&budget, flying.front()), flying.pop_front();
        }
        EXPECT_LE(over, 1) << config_difference(config) << " " << slope << " " << ahead;
      }
    }
  }
}

// What fits is drawn whole; a picture that stands still keeps its level.
TEST(Budget, WhatFitsIsWholeAndWhatStandsStillStays) {
  for (const Config& config : kMachines) {
    pipegs_budget budget = budget_of(config, kCycles);
    for (int frame = 0; frame < 20; ++frame)
      pipegs_budget_took(&budget, Plant{3e6, 1e5, 0.5}.cycles(next_level(config, budget)));
    EXPECT_EQ(budget.level, 0);
    int changes = 0;
    for (int frame = 0; frame < 100; ++frame) {
      const int32_t level = budget.level;
      pipegs_budget_took(&budget, Plant{5e6, 1e5, 0.5}.cycles(next_level(config, budget)));
      if (frame > 50) changes += budget.level != level;
    }
    EXPECT_LE(changes, 1);
  }
}

// Lenses beyond all reason give levels that the fields hold.
TEST(Budget, AnyLensGivesALevel) {
  std::mt19937_64 rng(1);
  for (const Config& config : kMachines) {
    const pipegs_configuration machine = driver_configuration(config);
    for (int run = 0; run < 2000; ++run) {
      pipegs_camera camera = {};
      camera.focal[0] = {static_cast<int64_t>(rng() >> rng() % 64), static_cast<int32_t>(rng() >> (32 + rng() % 32))};
      if (run % 3 == 0) camera.focal[0].exponent = -camera.focal[0].exponent;
      if (run % 7 == 0) camera.focal[0].exponent = static_cast<int32_t>(rng());
      pipegs_budget budget;
      if (!pipegs_budget_begin(&machine, &camera, kCycles, &budget)) {
        EXPECT_FALSE(config.early_stop) << "without proxies there is a rest";
        continue;
      }
      for (int i = 0; i < 8; ++i) {
        pipegs_frame frame = {};
        pipegs_budget_set(&budget, &frame);
        EXPECT_LT(frame.lod, uint64_t{1} << config.lod_w());
        EXPECT_LT(frame.raster_rest, uint64_t{1} << config.rest_w());
        pipegs_budget_took(&budget, i < 4 ? kCycles * 9 : 1);
      }
    }
  }
}

// Cycles beyond all reason move the level to its end and back, and nothing else.
TEST(Budget, AnyCyclesGiveALevel) {
  for (const Config& config : kMachines) {
    for (const uint64_t wanted : {uint64_t{1}, kCycles, ~uint64_t{0}}) {
      pipegs_budget budget = budget_of(config, wanted);
      for (const uint64_t cycles : {uint64_t{0}, uint64_t{1}, kCycles, ~uint64_t{0}, ~uint64_t{0}, ~uint64_t{0}}) {
        for (int i = 0; i < 20; ++i) pipegs_budget_took(&budget, cycles);
        pipegs_frame frame = {};
        pipegs_budget_set(&budget, &frame);
        EXPECT_LT(frame.lod, uint64_t{1} << config.lod_w()) << cycles;
        EXPECT_LT(frame.raster_rest, uint64_t{1} << config.rest_w()) << cycles;
        if (cycles > wanted) { EXPECT_GT(frame.lod + frame.raster_rest, 0u) << cycles << " of " << wanted; }
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
