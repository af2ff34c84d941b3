// SPDX-License-Identifier: Apache-2.0
// Nothing wraps: every field of every record that the models of the PU pass on fits its declared width, on random,
// hostile and our own scenes; every value in the Row Units fits the width that the RTL gives it.
//
// stability_sanitized (sanitized.cpp) asks the compiler the same of the arithmetic inside; the RTL's assertions are on
// in all runs.
#include <gtest/gtest.h>

#include <cstdio>

#include "scenes/generate/generate.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/bounds/hostile_scene.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/stability/support/pu_walk.hpp"
#include "verif/support/records_fit.hpp"

namespace pipegs {
namespace {

bool holds(int64_t value, int bits) { return value >= -(int64_t{1} << (bits - 1)) && value < int64_t{1} << (bits - 1); }

// The records seen.
uint64_t expect_all_fit(const PackedScene& packed, const Frame& frame, const char* what, uint64_t seed) {
  const Config& config = packed.config;
  std::string first;
  uint64_t records = 0;
  pu_walk(
      packed, frame,
      [&](const auto& record) {
        ++records;
        if (first.empty()) first = misfit(config, record);
      },
      [&](int64_t power, int64_t slope) {
        if (first.empty() && !holds(power, config.power_w())) first = "a Row Unit's power " + std::to_string(power);
        if (first.empty() && !holds(slope, config.gradient_w() + 1))
          first = "a Row Unit's slope " + std::to_string(slope);
      });
  EXPECT_EQ(first, "") << what << ", seed " << seed;
  return records;
}

uint64_t walk(const Scene& scene, const Camera& camera, double near_plane, const char* what, uint64_t seed,
              const std::vector<std::string>& settings = {}) {
  SimulateOptions options;
  for (const std::string& setting : settings) config_set(options.config, setting);
  options.near_plane = near_plane;
  Simulation simulation;
  simulate_pack(scene, camera, options, simulation);
  return expect_all_fit(simulation.packed, simulation.input.frame, what, seed);
}

TEST(StabilityWrap, RandomAndOurOwnScene) {
  uint64_t records = walk(random_scene(1, 2000, 3), test_camera(130, 70), 0.2, "random", 1);
  Camera camera = generated_cameras()[0];
  camera.width = camera.height = 64;
  records += walk(generate_scene(1, 20000), camera, 0.2, "our own", 1);
  std::printf("records that fit: %llu\n", static_cast<unsigned long long>(records));
}

TEST(StabilityWrap, HostileScenesInSeveralFormats) {
  uint64_t records = 0;
  const std::vector<std::vector<std::string>> formats = {{},
                                                         {"order=1"},
                                                         {"mantissa_w=18", "coeff_f=20", "power_f=12"},
                                                         {"mantissa_w=28", "coeff_f=30", "power_f=24", "view_w=30"},
                                                         {"pos_w=12", "quat_w=10", "scale_m_w=6"}};
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const StressView view = stress_view(seed);
    records += walk(view.scene, view.camera, view.near_plane, "hostile", seed, formats[seed % formats.size()]);
  }
  std::printf("records that fit: %llu\n", static_cast<unsigned long long>(records));
}

// The check itself finds a value one beyond each end.
TEST(StabilityWrap, TheCheckFindsWhatDoesNotFit) {
  const Config config;
  Coeff coeff;
  coeff.b = (int64_t{1} << (config.bc_w() - 1)) - 1;
  EXPECT_EQ(misfit(config, coeff), "");
  ++coeff.b;
  EXPECT_NE(misfit(config, coeff).find("coeff.b"), std::string::npos);
  coeff.b = -(int64_t{1} << (config.bc_w() - 1)) - 1;
  EXPECT_NE(misfit(config, coeff), "");
  Conic conic;
  conic.extent_x = uint64_t{1} << config.extent_w();
  EXPECT_NE(misfit(config, conic).find("conic.extent_x"), std::string::npos);
}

}  // namespace
}  // namespace pipegs
