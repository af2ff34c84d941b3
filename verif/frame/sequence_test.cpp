// SPDX-License-Identifier: Apache-2.0
// sequence_test: frames one after the other in one machine without a reset, every stream and pixel of each compared.
//
// What the machine keeps of a frame must not show in the next one: frames of other sizes, cameras and scenes follow on
// each machine, queued behind the running one and one at a time.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "sim/compare/sequence_check.hpp"
#include "sim/rtl/rtl_fault.hpp"
#include "verif/frame/machines.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/frame/sequence.hpp"

namespace pipegs {
namespace {

// Sizes up and down, a scene of another degree, an empty one, and the first again.
TEST(Sequence, FramesOfOtherSizesCamerasAndScenesFollowWithoutAReset) {
  const Scene first = random_scene(61, 900, 1), second = random_scene(62, 400, 2);
  Camera turned = test_camera(96, 70);
  turned.position = {0.4, -0.2, 0.6};
  turned.world_to_camera = glm::dmat3(0.96, 0, 0.28, 0, 1, 0, -0.28, 0, 0.96);
  for (const size_t i : todays()) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    sequence.add(first, test_camera(130, 70));
    sequence.add(test_camera(17, 33));
    sequence.add(turned);
    sequence.add(second, test_camera(200, 64, 150));
    sequence.add(scene_of({}), test_camera(64, 64));
    sequence.add(first, test_camera(130, 70));
    sequence.expect_equal();
    if (HasFatalFailure()) return;
    const Config config = machine(i).config;
    // Where the bus is what all wait for, frames that overlap win nothing.
    if (!config.has_lists() && !config.has_stores() && config.bus_w != 128) {
      EXPECT_LT(sequence.queued_cycles, sequence.single_cycles);
      if (config.taps) { EXPECT_LT(sequence.queued_gaps, sequence.single_gaps); }
    }
  }
}

// The picture of a frame is taken with it, while the frame before is still being written in the other format. Nothing
// is written but half lines with a pixel of the picture.
TEST(Sequence, PicturesInRasterOrderFollowThoseByWindows) {
  const Scene scene = random_scene(65, 500, 1);
  for (const size_t i : todays()) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence mixed(machine(i)), raster(machine(i));
    mixed.add(scene, test_camera(130, 71));
    mixed.in_raster_order(0);
    mixed.add(test_camera(90, 70));
    mixed.add(test_camera(17, 33));
    mixed.in_raster_order(5);
    mixed.add(test_camera(1, 1));
    mixed.expect_equal();
    raster.add(scene, test_camera(130, 71));
    raster.in_raster_order(2);
    raster.add(test_camera(129, 65));
    raster.in_raster_order(0);
    raster.expect_equal();
    EXPECT_EQ(raster.pixel_bytes, 32u * 17 * (71 + 65));
    if (HasFailure()) return;
  }
}

// Opaque windows: what is done in one frame must not stop the next one, which begins while the RUs finish.
TEST(Sequence, WhatIsOpaqueInOneFrameIsOpenInTheNext) {
  Scene open = random_scene(63, 600, 0), hidden = open;
  for (int i = 0; i < 60; ++i) hidden.gaussians.push_back(gaussian_at({0, 0, 0.3f + 0.001f * i}, 6.0f, 0.999));
  for (const size_t i : todays()) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    for (int round = 0; round < 2; ++round) {
      sequence.add(hidden, test_camera(64, 64));
      sequence.add(open, test_camera(64, 64));
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// A frame's own limit goes with it: no pixel of one stops by the rule of the next, which begins while the RUs finish.
TEST(Sequence, EachFrameHasItsOwnRest) {
  Scene scene = random_scene(66, 900, 1);
  for (Gaussian& gaussian : scene.gaussians) gaussian.log_scale += 0.7f;  // most pixels become opaque
  for (const size_t i : todays()) {
    if (!machine(i).config.early_stop) continue;
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    sequence.add(scene, test_camera(130, 70));
    for (const double rest : {0.3, 0.0, 0.02, 0.999}) {
      sequence.rest(rest);
      sequence.add(test_camera(130, 70));
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// Proxies and none in turn, of a scene that stays where it is: what is open of one frame knows nothing of the level of
// the next one.
TEST(Sequence, EachFrameHasItsOwnLevelOfDetail) {
  Scene scene = random_scene(67, 6000, 1);
  for (Gaussian& gaussian : scene.gaussians) {  // alike, so that few stand for many
    gaussian.sh_dc = glm::vec3(0.5f);
    gaussian.log_scale = glm::vec3(-1.2f);  // larger than their distance, so that merged ones are as wide
  }
  std::fill(scene.sh_rest.begin(), scene.sh_rest.end(), 0.0f);
  for (const size_t i : todays({kHidden, kCrowded})) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    sequence.add(scene, test_camera(130, 70));
    for (const double pixels : {1000.0, 0.01, 0.0, 500.0, 0.02}) {
      sequence.lod_pixels(pixels);
      sequence.add(test_camera(130, 70));
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
    for (const size_t coarse : {1, 4}) EXPECT_LT(sequence.gaussians(coarse), sequence.gaussians(0) * 3 / 4) << coarse;
    for (const size_t whole : {2, 3, 5}) EXPECT_EQ(sequence.gaussians(whole), sequence.gaussians(0)) << whole;
  }
}

// One eye, the other, both, nearer and farther apart: each frame knows its own.
TEST(Sequence, EachFrameHasItsOwnEyes) {
  const Scene scene = random_scene(65, 1500, 1);
  for (const size_t i : todays({kCrowded})) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    sequence.eyes(3, 0.05);
    sequence.add(scene, test_camera(130, 70));
    for (const auto& [wanted, x, y] : {std::tuple{1, 0.05, 0.0}, {2, 0.5, 0.1}, {3, 2.0, -0.3}, {3, 0.0, 0.0}}) {
      sequence.eyes(static_cast<uint64_t>(wanted), x, y);
      sequence.add(test_camera(130, 70));
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// Other AOVs in each frame, by windows and in raster order: what a frame writes is its own.
TEST(Sequence, EachFrameHasItsOwnAovs) {
  const Scene scene = random_scene(68, 1200, 1);
  for (const size_t i : todays({kFine, kHidden})) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    sequence.aovs(15);
    sequence.add(scene, test_camera(130, 70));
    for (const uint64_t wanted : {0, 2, 13, 8, 15}) {
      sequence.aovs(wanted);
      sequence.add(test_camera(130, 70));
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// In raster order each lies behind the picture as its colours do; the frames of a machine have one format.
TEST(Sequence, AovsLieInRasterOrder) {
  const Scene scene = random_scene(69, 1200, 1);
  for (const size_t i : todays({kFine, kHidden})) {
    SCOPED_TRACE(config_difference(machine(i).config));
    Sequence sequence(machine(i));
    for (const uint64_t wanted : {15, 5, 10}) {
      sequence.aovs(wanted);
      sequence.add(scene, test_camera(141, 75));
      sequence.in_raster_order(wanted % 4);
    }
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// Frames that sort otherwise (another near plane) wait until the SUs are empty.
TEST(Sequence, TheMemoryAndTheNearPlaneMayChange) {
  const Scene scene = random_scene(64, 1500, 1);
  for (const size_t number : todays({kDop, kTiny, kGscore, kExact, kFine})) {
    SCOPED_TRACE(config_difference(machine(number).config));
    for (const auto& [latency, bandwidth, jitter, queue] : {std::tuple{1, 64.0, 0, 256}, {400, 6.4, 400, 4}}) {
      SimulateOptions options = machine(number);
      options.memory = {.latency = latency, .bytes_per_cycle = bandwidth, .jitter = jitter, .queue = queue, .seed = 3};
      Sequence sequence(options);
      sequence.add(scene, test_camera(128, 128));
      sequence.add(test_camera(100, 150, 130));
      sequence.add(test_camera(128, 128), 0.7);
      sequence.add(test_camera(128, 128));
      sequence.expect_equal();
      if (HasFatalFailure()) return;
    }
  }
}

// Everything that AXI4 allows: writes applied hundreds of cycles late, answers that overtake each other, readies that
// fall. The picture depends on nothing of it.
TEST(Sequence, AHarshMemoryChangesNoBit) {
  const Scene first = random_scene(65, 900, 1), second = random_scene(66, 500, 3);
  for (const size_t i : todays()) {
    SimulateOptions options = machine(i);
    if (options.config.bus_w == 0) continue;
    SCOPED_TRACE(config_difference(options.config));
    options.memory.harsh = true;
    options.memory.seed = 7 + i;
    Sequence sequence(options);
    sequence.add(first, test_camera(130, 70));
    sequence.add(test_camera(40, 90));
    sequence.add(second, test_camera(96, 64));
    sequence.expect_equal();
    if (HasFatalFailure()) return;
  }
}

// Frames are given up in the middle, with reads and writes out: by an abort, by a read and by a write that fails. Each
// begins anew behind the reset of the core, and no late answer of the old one may count.
TEST(Sequence, WhatIsGivenUpInTheMiddleLeavesNothingBehind) {
  using Kind = RtlDisturbance::Kind;
  const Scene first = random_scene(67, 900, 1), second = random_scene(68, 500, 2);
  for (const size_t i : todays()) {
    for (const bool harsh : {false, true}) {
      SimulateOptions options = machine(i);
      if (options.config.bus_w == 0 && harsh) continue;
      SCOPED_TRACE(config_difference(options.config));
      options.memory.harsh = harsh;
      options.memory.latency = 200;
      std::mt19937_64 rng(i);
      for (uint64_t frame = 0; frame < 9; ++frame) {
        const Kind kind = options.config.bus_w == 0 ? Kind::kAbort : static_cast<Kind>(rng() % 3);
        options.rtl.disturbances.push_back({frame, rng() % 3000, kind});
      }
      Sequence sequence(options);
      sequence.add(first, test_camera(130, 70));
      sequence.add(test_camera(100, 90));
      sequence.add(second, test_camera(96, 64));
      sequence.expect_equal();
      if (HasFatalFailure()) return;
    }
  }
}

// Memory stops to do one thing after the other that a bus must do, for longer than the machine allows: the machine says
// so, is done with, and when memory has come back the frame is rendered as if nothing had been.
TEST(Sequence, AMemoryThatFallsSilentIsGotOver) {
  SimulateOptions options = machine(kFast);
  Simulation simulation;
  simulate_golden(random_scene(70, 600, 1), test_camera(130, 70), options, simulation);
  const Areas areas = frame_areas(options.config, simulation.packed, simulation.input.frame);
  const pipegs_job job = frame_job(options.config, simulation.input.frame, areas);
  const uint32_t read = PIPEGS_ERROR_READ_TIMEOUT, write = PIPEGS_ERROR_WRITE_TIMEOUT;
  const std::unique_ptr<RtlModel> model = load_rtl(options.config);
  for (const bool harsh : {false, true}) {
    for (const auto& [what, silence, told] : {std::tuple{"AR", AxiSilence{.ar = true}, read},
                                              {"R", {.r = true}, read},
                                              {"AW", {.aw = true}, write},
                                              {"W", {.w = true}, write},
                                              {"B", {.b = true}, write}}) {
      SCOPED_TRACE(fmt::format("{}, {}", what, harsh ? "harsh" : "timed"));
      options.memory.harsh = harsh;
      options.rtl.bus_timeout = 1500;
      options.rtl.disturbances = {{0, 900, RtlDisturbance::Kind::kSilence, silence, 20000}};
      ExternalMemory memory(options.memory, options.config.bus_w);
      memory.load(memory_image(simulation.packed).lines);
      SequenceCheck check({{&simulation.input, &simulation.golden, areas}}, memory, nullptr);
      const RtlResult result = model->run({job}, memory, options.rtl, &check, {});
      EXPECT_EQ(result.errors, told);
      EXPECT_EQ(check.complete(), 1u);
      ASSERT_EQ(check.frame(0).mismatches(), 0u) << check.frame(0).first()->what;
    }
  }
}

// An error that nobody foresaw ends the run in words.
TEST(Sequence, AnErrorOfTheMemoryIsTold) {
  SimulateOptions options = machine(kFast);
  Simulation simulation;
  simulate_golden(random_scene(69, 300, 1), test_camera(64, 64), options, simulation);
  const std::unique_ptr<RtlModel> model = load_rtl(options.config);
  ExternalMemory memory(options.memory, options.config.bus_w);
  memory.bus()->failing.insert(simulation.input.frame.tables.cells);
  try {
    const Frame& frame = simulation.input.frame;
    const Areas areas = frame_areas(options.config, simulation.packed, frame);
    model->run({frame_job(options.config, frame, areas)}, memory, {}, nullptr, {});
    FAIL() << "no error";
  } catch (const RtlFault& fault) { EXPECT_THAT(fault.what(), testing::HasSubstr("SLVERR")); }
}

}  // namespace
}  // namespace pipegs
