// SPDX-License-Identifier: Apache-2.0
// sequence.hpp: frames one after the other in one machine without a reset, every stream and pixel of each compared.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/design/config_file.hpp"

namespace pipegs {

// Runs frames in turn, and is told which.
class Sequence {
 public:
  explicit Sequence(const SimulateOptions& options) : options_(options) {}

  void add(const Scene& scene, const Camera& camera) {
    simulations_.push_back(std::make_unique<Simulation>());
    simulate_golden(scene, camera, options_, *simulations_.back());
  }
  // The frame added last has its pixels in raster order, with so many lines to spare in each row.
  void in_raster_order(uint64_t spare) {
    GoldenInput& input = simulations_.back()->input;
    input.picture = raster_picture(input.frame.tables.pixels, input.frame.raster.width);
    input.picture.stride += spare;
  }
  // A frame of the scene before, which shares its place in memory, pixels included.
  void add(const Camera& camera, double near_plane = 0.2) {
    const PackedScene& packed = *simulations_.back()->input.packed;
    auto& next = *simulations_.emplace_back(std::make_unique<Simulation>());
    options_.near_plane = near_plane;
    simulate_frame(packed, camera, options_, next);
    simulate_golden(options_, next);
  }
  // Of the frames to come: transmittance below which a pixel's next Gaussian takes all, 0: INRIA's rule.
  void rest(double transmittance) { options_.rest = transmittance; }
  // Of the frames to come: proxies of groups that differ by less than so many pixels.
  void lod_pixels(double pixels) { options_.lod_pixels = pixels; }
  // That a frame fetches, by the golden model.
  uint64_t gaussians(size_t frame) const { return simulations_.at(frame)->golden.work.fetched; }
  void expect_equal() {
    expect_equal(true);
    if (!testing::Test::HasFatalFailure()) expect_equal(false);
  }
  // Each queued behind the one before, or each when the machine is empty.
  void expect_equal(bool queued) {
    std::vector<Simulation*> frames;
    for (const auto& one : simulations_) frames.push_back(one.get());
    options_.rtl.queued = queued;
    const SequenceRun run = simulate_sequence(options_, frames);
    pixel_bytes = run.traffic.at(2).bytes_written;
    ASSERT_EQ(run.rtl.frame_ends.size(), frames.size());
    for (size_t i = 0; i < frames.size(); ++i) {
      ASSERT_EQ(frames[i]->mismatches, 0u)
          << config_difference(options_.config) << (queued ? ", queued" : ", one at a time") << ", seed "
          << options_.rtl.seed << ": frame " << i << ", window " << frames[i]->first_mismatch->window_x << ","
          << frames[i]->first_mismatch->window_y << ": " << frames[i]->first_mismatch->what;
      if (options_.config.taps) { ASSERT_GT(frames[i]->beats, 0u); }
    }
    if (options_.config.taps) { ASSERT_EQ(run.rtl.frame_gaps.size(), frames.size() - 1); }
    (queued ? queued_cycles : single_cycles) = run.rtl.frame_ends.back();
    (queued ? queued_gaps : single_gaps) =
        std::accumulate(run.rtl.frame_gaps.begin(), run.rtl.frame_gaps.end(), uint64_t{0});
  }

  uint64_t queued_cycles = 0, single_cycles = 0, queued_gaps = 0, single_gaps = 0, pixel_bytes = 0;

 private:
  SimulateOptions options_;
  std::vector<std::unique_ptr<Simulation>> simulations_;
};

}  // namespace pipegs
