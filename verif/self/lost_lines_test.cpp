// SPDX-License-Identifier: Apache-2.0
// lost_lines_test: a machine that blends one line too few, too often or too early, or fetches one chunk too few, is
// caught, whatever its pixels are.
//
// Idea    What a machine would show is made from the golden window, line by line, with one fault in it. What it writes
//         back is consistent with what it blends, so only the order and number of lines can give it away.
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>

#include "cpp_model/dopu/dopu.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

struct Step {  // a line, or a quad of it
  const GoldenSplat* splat;
  int region, quad;
};

struct Run {
  const char* design_point;
  uint64_t walk_most;
};

class LostLines : public testing::TestWithParam<Run> {
 protected:
  void SetUp() override {
    SimulateOptions options;
    options.config = find_design_point(GetParam().design_point).config;
    options.walk_most = GetParam().walk_most;
    const int side = options.config.window;
    simulate_golden(random_scene(3, 300, 1), test_camera(side, side, 60), options, simulation_);
    window_ = golden_window(simulation_.input, 0, 0);
    steps_ = all_steps();
  }
  const Config& config() const { return simulation_.packed.config; }
  std::vector<RegionState> fresh() const {
    std::vector<RegionState> regions;
    for (int r = 0; r < config().regions(); ++r)
      regions.push_back(ru_fresh_region(config(), simulation_.input.frame, 0, 0, r));
    return regions;
  }
  std::array<uint16_t, kRegionPixels> codes_of(const Step& step) const {
    std::array<uint16_t, kRegionPixels> codes;
    golden_codes(config(), step.splat->job, region_bit(config(), step.region), codes.data());
    return codes;
  }
  void blend(const Step& step, RegionState& region) const {
    const std::array<uint16_t, kRegionPixels> codes = codes_of(step);
    const Splat& splat = step.splat->splat;
    const uint32_t color[3] = {static_cast<uint32_t>(splat.red), static_cast<uint32_t>(splat.green),
                               static_cast<uint32_t>(splat.blue)};
    const BlendConstants constants(config());
    if (config().quads) ru_blend_quad(constants, region, step.quad, codes.data(), color);
    else ru_blend_region(constants, region, codes.data(), color);
  }
  // What a machine without a fault blends.
  std::vector<Step> all_steps() const {
    std::vector<Step> steps;
    std::vector<RegionState> regions = fresh();
    for (const GoldenLayer& layer : window_.layers) {
      for (const GoldenSplat& splat : layer.splats) {
        for (uint64_t rest = splat.splat.mask; rest != 0; rest &= rest - 1) {
          const int number = static_cast<int>(splat.splat.part) * config().mask_w() + std::countr_zero(rest);
          RegionState& region = regions[static_cast<size_t>(number)];
          if (region.all_done()) continue;
          const Step line{&splat, number, 0};
          const uint32_t live =
              config().quads ? ru_live_quads(codes_of(line).data(), ru_stopped_quads(region)) : uint32_t{1};
          for (int quad = 0; quad < kQuads; ++quad) {
            if ((live >> quad & 1) == 0) continue;
            steps.push_back({&splat, number, quad});
            blend(steps.back(), region);
          }
        }
      }
    }
    return steps;
  }
  // Mismatches of a machine that blends these; `mask` changes that of the sorted splat of this number, and the chunk
  // that begins with `lost` does not come.
  uint64_t mismatches(const std::vector<Step>& steps, size_t changed = ~size_t{0}, uint64_t mask = 0,
                      uint64_t lost = ~uint64_t{0}) {
    StreamCheck check(simulation_.input);
    show_chunks(check, lost);
    std::vector<uint32_t> words(record_words<Sorted>(config()));
    const auto shown = [&](Splat splat) {
      std::fill(words.begin(), words.end(), 0);
      pack(config(), splat, words.data());
      return words.data();
    };
    const auto all_end = [&](uint64_t kind) {
      for (int unit = 0; unit < config().units; ++unit) check.on_splat(unit, shown({.kind = kind}));
    };
    size_t number = 0, walk = 0;
    for (size_t layer = 0; layer < std::max<size_t>(1, window_.layers.size()); ++layer) {
      const bool last = layer + 1 >= window_.layers.size();
      const Splat end{.kind = last ? kWindowEnd : kLayerEnd};
      for (size_t i = 0; !window_.layers.empty() && i < window_.layers[layer].splats.size(); ++i, ++number) {
        Splat splat = window_.layers[layer].splats[i].splat;
        for (; window_.in_parts() && !walk_has(config(), window_.walks[walk], splat.part); ++walk)
          all_end(kPartEnd);
        check.on_splat(0, shown(splat));
        if (number == changed) splat.mask ^= mask;
        check.on_sorted(shown(splat));
      }
      for (; walk + 1 < window_.walks.size(); ++walk) all_end(kPartEnd);
      all_end(end.kind);
      check.on_sorted(shown(end));
    }
    std::vector<RegionState> regions = fresh();
    for (const Step& step : steps) show(check, step, regions[static_cast<size_t>(step.region)]);
    check.finish();
    first_ = check.first() ? check.first()->what : "";
    return check.mismatches();
  }
  // What the DOPU sends for the window.
  void each_chunk(const std::function<void(int, const Chunk&, uint64_t)>& each) const {
    const GoldenInput& input = simulation_.input;
    if (!config().has_watermarks()) dopu_window(config(), input.frame, *input.packed, 0, 0, each);
    for (const uint64_t walk : window_.walks) dopu_nearest(config(), input.frame, *input.packed, 0, 0, walk, each);
  }
  void show_chunks(StreamCheck& check, uint64_t lost) const {
    std::vector<uint32_t> words(record_words<Chunk>(config()));
    each_chunk([&](int, const Chunk& chunk, uint64_t) {
      if (chunk.slot == lost) return;
      pack(config(), chunk, words.data());
      check.on_chunk(0, kData, words.data());
    });
    for (int unit = 0; unit < config().units; ++unit) check.on_chunk(unit, kWindowEnd, words.data());
  }
  void show(StreamCheck& check, const Step& step, RegionState& region) const {
    const int row = step.quad / 4, group = config().quads ? (step.quad % 4 + 4 - 2 * row % 4) % 4 : 0;
    const int parts = config().quads ? 1 : 4, pixels = ru_word_pixels(config());
    const std::array<uint16_t, kRegionPixels> codes = codes_of(step);
    std::vector<uint32_t> line(kRegionPixels), word(kRegionPixels * 4);
    for (int i = 0; i < parts * pixels; ++i) {
      const int pixel = config().quads ? ru_word_pixel(config(), group, row, i) : i;
      put_bits(line.data(), i * config().alpha_w, config().alpha_w, codes[static_cast<size_t>(pixel)]);
    }
    check.on_alphas(group, 0, 0, static_cast<uint32_t>(step.splat->splat.index), step.region, row, line.data());
    blend(step, region);
    for (int part = 0; part < parts; ++part) {
      const int quarter = config().quads ? row : part, colors = 3 * config().rgb_w;
      std::fill(word.begin(), word.end(), 0);
      for (int i = 0; i < pixels; ++i) {
        const PixelState pixel = region.pixel(ru_word_pixel(config(), group, quarter, i));
        for (int j = 0; j < 3; ++j)
          put_bits(word.data(), i * colors + j * config().rgb_w, config().rgb_w, pixel.rgb[j]);
        put_bits(word.data(), pixels * colors + i * config().t_w, config().t_w, pixel.t);
        put_bits(word.data(), pixels * (colors + config().t_w) + i, 1, pixel.done);
      }
      check.on_pixels(group, step.region, quarter, word.data());
    }
  }
  // Steps drawn at random, the same in each run.
  std::vector<size_t> drawn(size_t count) const {
    std::mt19937_64 rng(7);
    std::vector<size_t> places;
    for (size_t i = 0; i < count; ++i) places.push_back(rng() % steps_.size());
    return places;
  }

  Simulation simulation_;
  GoldenWindow window_;
  std::vector<Step> steps_;
  std::string first_;
};

TEST_P(LostLines, AMachineWithoutAFaultAgrees) {
  ASSERT_GT(steps_.size(), 200u);
  EXPECT_EQ(mismatches(steps_), 0u) << first_;
}

TEST_P(LostLines, ALostLineIsSeen) {
  for (const size_t place : drawn(6)) {
    std::vector<Step> steps = steps_;
    steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(place));
    EXPECT_GT(mismatches(steps), 0u) << "line " << place;
    EXPECT_NE(first_.find("missing"), std::string::npos) << first_;
  }
}

TEST_P(LostLines, ALineThatComesTwiceIsSeen) {
  for (const size_t place : drawn(6)) {
    std::vector<Step> steps = steps_;
    steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(place), steps[place]);
    EXPECT_GT(mismatches(steps), 0u) << "line " << place;
    EXPECT_NE(first_.find("expected once"), std::string::npos) << first_;
  }
}

TEST_P(LostLines, NeighboursInTheWrongOrderAreSeen) {
  for (const size_t place : drawn(6)) {
    std::vector<Step> steps = steps_;
    const auto next = std::find_if(
        steps.begin() + static_cast<std::ptrdiff_t>(place) + 1, steps.end(),
        [&](const Step& step) { return step.region == steps[place].region && step.quad == steps[place].quad; });
    if (next == steps.end()) continue;
    std::swap(steps[place].splat, next->splat);
    EXPECT_GT(mismatches(steps), 0u) << "line " << place;
  }
}

// A region that is there and not done, and one in which the splat is not.
TEST_P(LostLines, AChangedMaskOfASortedSplatIsSeen) {
  size_t number = 0;
  for (const GoldenLayer& layer : window_.layers) {
    for (const GoldenSplat& splat : layer.splats) {
      const uint64_t mask = splat.splat.mask;
      for (int bit = 0; bit < config().mask_w(); bit += 13) {
        const int region = static_cast<int>(splat.splat.part) * config().mask_w() + bit;
        if (window_.regions[static_cast<size_t>(region)].all_done()) continue;
        EXPECT_GT(mismatches(steps_, number, uint64_t{1} << bit), 0u) << "splat " << number << ", bit " << bit;
        EXPECT_NE(first_.find("merge -> RU"), std::string::npos) << first_ << mask;
      }
      if (++number == 3) return;
    }
  }
}

// Of Gaussians of which a line was blended.
TEST_P(LostLines, AChunkThatLacksIsSeen) {
  std::set<uint64_t> blended;
  for (const Step& step : steps_) blended.insert(step.splat->splat.index);
  std::set<uint64_t> slots;
  each_chunk([&](int, const Chunk& chunk, uint64_t) {
    for (uint64_t slot = chunk.slot; slot < chunk.slot + chunk.count; ++slot) {
      if (blended.contains(simulation_.packed.gaussians[slot].index)) slots.insert(chunk.slot);
    }
  });
  ASSERT_GT(slots.size(), 1u);
  for (const uint64_t slot : slots) {
    EXPECT_GT(mismatches(steps_, ~size_t{0}, 0, slot), 0u) << "chunk of slot " << slot;
    EXPECT_NE(first_.find("its chunk, found it missing"), std::string::npos) << first_;
  }
}

// By a window that goes whole, and by parts.
INSTANTIATE_TEST_SUITE_P(DesignPoints, LostLines,
                         testing::Values(Run{"dop", 0}, Run{"exact", 0}, Run{"fast", 0}, Run{"fast", 1}));

}  // namespace
}  // namespace pipegs
