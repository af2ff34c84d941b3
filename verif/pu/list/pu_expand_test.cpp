// SPDX-License-Identifier: Apache-2.0
// pu_expand_test: rtl/pu/list/pu_expand.sv against its bit-accurate model; the model against the projection in
// each window.
#include "cpp_model/pu/list/pu_expand.hpp"

#include "Vpu_expand.h"
#include "cpp_model/pu/project/pu_project.hpp"
#include "verif/pu/pu_random.hpp"
#include "verif/pu/random_box.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

// A frame of some windows that begins anywhere.
Frame small_frame(PuRandom& random) {
  Frame frame = random.frame();
  frame.raster.windows.first_x = static_cast<uint64_t>(random.integer(0, 900));
  frame.raster.windows.first_y = static_cast<uint64_t>(random.integer(0, 900));
  frame.raster.windows.last_x = frame.raster.windows.first_x + static_cast<uint64_t>(random.integer(0, 12));
  frame.raster.windows.last_y = frame.raster.windows.first_y + static_cast<uint64_t>(random.integer(0, 9));
  return frame;
}

Conic random_conic(PuRandom& random, const Frame& frame) {
  const Windows& windows = frame.raster.windows;
  return random_box(random, windows.last_x - windows.first_x + 1, windows.last_y - windows.first_y + 1,
                    random.config.window);
}

// Any colour for a job: a function of the Gaussian, so that the expectation can be made beforehand.
Colored any_color(const Config& config, const ColorJob& job) {
  Colored c;
  c.kind = job.kind, c.depth = job.depth, c.index = job.index;
  const uint64_t most = (uint64_t{1} << config.color_w) - 1;
  if (job.kind == kData)
    c.red = job.index & most, c.green = (job.index * 77 + 5) & most, c.blue = (job.index >> 3) & most;
  return c;
}

struct Expected {
  std::vector<ColorJob> jobs;
  std::vector<Conic> placed;
  std::vector<Listed> listed;
  size_t passed = 0;  // windows without a beat
  void add(const Config& config, const Frame& frame, const Conic& conic, const Payload& payload) {
    if (conic.kind == kLayerEnd) return;
    const std::optional<PuExpandBox> box = conic.kind == kData ? pu_expand_box(config, frame, conic) : std::nullopt;
    if (conic.kind == kData && !box) return;
    jobs.push_back(conic.kind == kData ? pu_expand_job(payload) : ColorJob{.kind = conic.kind});
    if (conic.kind != kData) {
      placed.push_back({});
      placed.back().kind = conic.kind;
      return;
    }
    for (int64_t y = box->first_y; y <= box->last_y; ++y) {
      for (int64_t x = box->first_x; x <= box->last_x; ++x) {
        if (!pu_expand_keeps(config, conic, *box, x, y)) {
          ++passed;
          continue;
        }
        placed.push_back(pu_expand(config, conic, x, y));
        listed.push_back(pu_expand_listed(frame, any_color(config, jobs.back()), x, y));
      }
    }
  }
};

struct ExpandRun {
  ExpandRun(const Config& config, Pace source, Pace color, Pace sink)
      : in(bench, config, bench.dut.conic_valid_i, bench.dut.conic_ready_o, bench.dut.conic_i, source),
        payloads(bench, config, payload_valid, bench.dut.payload_take_o, bench.dut.payload_i),
        jobs(bench, config, bench.dut.color_job_valid_o, bench.dut.color_job_ready_i, bench.dut.color_job_o, color),
        colors(bench, config, bench.dut.colored_valid_i, bench.dut.colored_ready_o, bench.dut.colored_i, color),
        out(bench, config, bench.dut.placed_valid_o, bench.dut.placed_ready_i, bench.dut.placed_o, sink),
        listed(bench, config, bench.dut.listed_valid_o, listed_ready, bench.dut.listed_o),
        beside(bench, [this, config] {
          while (colored < jobs.size()) colors.push(any_color(config, jobs.at(colored++)));
          passes += bench.dut.passes_o;
          passed_beside += bench.dut.passes_o && bench.dut.placed_valid_o && !bench.dut.placed_ready_i;
        }) {
    bench.reset();
  }
  void push(const Conic& conic, const Payload& payload) {
    in.push(conic);
    if (conic.kind == kData) payloads.push(payload);
  }
  Bench<Vpu_expand> bench;
  RecordSource<Conic, std::remove_reference_t<decltype(Vpu_expand::conic_i)>> in;
  CData payload_valid = 0, listed_ready = 0;  // a payload is there in time, and what is listed is not refused
  RecordSource<Payload, std::remove_reference_t<decltype(Vpu_expand::payload_i)>> payloads;
  RecordSink<ColorJob, std::remove_reference_t<decltype(Vpu_expand::color_job_o)>> jobs;
  RecordSource<Colored, std::remove_reference_t<decltype(Vpu_expand::colored_i)>> colors;
  RecordSink<Conic, std::remove_reference_t<decltype(Vpu_expand::placed_o)>> out;
  RecordSink<Listed, std::remove_reference_t<decltype(Vpu_expand::listed_o)>> listed;
  // Cycles in which the module says that it passes over a window, so that the PU does not fall asleep; and such beside
  // a beat that waits for its taker.
  size_t passes = 0, passed_beside = 0, colored = 0;
  Beside beside;
};

TEST(PuExpand, EqualsItsModelAtEveryPace) {
  const Config config = test_config();
  size_t dropped = 0, several = 0, saturated = 0, passed = 0, beside = 0, runs = 0;
  for (const Pace source : kPaces) {
    for (const Pace color : kPaces) {
      for (const Pace sink : kPaces) {
        ExpandRun run(config, source, color, sink);
        run.bench.rng.discard(++runs);  // a frame of its own: of some the means in no window saturate
        PuRandom random{config, run.bench.rng};
        const Frame frame = small_frame(random);
        write_frame(config, run.bench.dut, frame);
        Expected expected;
        for (int i = 0; i < 300; ++i) {
          Conic conic = random_conic(random, frame);
          if (random.chance(30)) conic.kind = random.chance(2) ? kLayerEnd : kWindowEnd;
          const size_t before = expected.placed.size();
          const auto payload = random_record<Payload>(config, random.rng);
          run.push(conic, payload);
          expected.add(config, frame, conic, payload);
          if (conic.kind != kData) continue;
          dropped += expected.placed.size() == before;
          several += expected.placed.size() > before + 1;
          const int64_t most = (int64_t{1} << (config.window_mean_w() - 1)) - 1;
          for (size_t k = before; k < expected.placed.size(); ++k) saturated += expected.placed[k].mean_x == most;
        }
        ASSERT_TRUE(
            run.bench.run_until([&] { return run.out.size() >= expected.placed.size() && run.in.empty(); }, 400000));
        for (size_t i = 0; i < 20 + expected.passed; ++i) run.bench.step();  // windows without a beat may be the last
        ASSERT_EQ(run.out.size(), expected.placed.size());
        ASSERT_EQ(run.jobs.size(), expected.jobs.size());
        EXPECT_EQ(run.bench.dut.busy_o, 0);
        for (size_t i = 0; i < expected.jobs.size(); ++i) {
          ASSERT_EQ(first_difference(config, expected.jobs[i], run.jobs.at(i)), "")
              << "job " << i << ", seed " << run.bench.seed;
        }
        for (size_t i = 0; i < expected.placed.size(); ++i) {
          ASSERT_EQ(first_difference(config, expected.placed[i], run.out.at(i)), "")
              << "beat " << i << ", seed " << run.bench.seed << "\nexpected " << to_text(config, expected.placed[i])
              << "\n"
              << to_text(config, frame);
        }
        passed += expected.passed, beside += run.passed_beside;
        ASSERT_EQ(run.passes, expected.passed);
        ASSERT_EQ(run.listed.size(), expected.listed.size());
        for (size_t i = 0, beat = 0; i < expected.listed.size(); ++i, ++beat) {
          ASSERT_EQ(first_difference(config, expected.listed[i], run.listed.at(i)), "")
              << "listed " << i << ", seed " << run.bench.seed;
          while (expected.placed[beat].kind != kData) ++beat;
          EXPECT_LT(run.listed.cycles[i], run.out.cycles[beat]) << "listed behind its beat";
        }
      }
    }
  }
  EXPECT_GT(dropped, 500u);
  EXPECT_GT(several, 500u);
  if (!config.oriented()) { EXPECT_GT(saturated, 50u); }  // the box does not touch windows so far away
  if (config.oriented()) {
    EXPECT_GT(passed, 5000u);
    EXPECT_GT(beside, 1000u) << "a window that is passed over waits for nobody";
  }
}

TEST(PuExpand, GivesAWindowEveryCycleAndAGaussianEveryTwo) {
  const Config config = test_config();
  for (const uint64_t windows : {1, 10}) {
    ExpandRun run(config, Pace::kAlways, Pace::kAlways, Pace::kAlways);
    PuRandom random{config, run.bench.rng};
    Frame frame = small_frame(random);
    frame.raster.windows.last_x = frame.raster.windows.first_x + windows - 1;
    frame.raster.windows.last_y = frame.raster.windows.first_y;
    write_frame(config, run.bench.dut, frame);
    constexpr uint64_t kGaussians = 300;
    for (uint64_t i = 0; i < kGaussians; ++i) {
      Conic conic = random_record<Conic>(config, run.bench.rng);
      conic.kind = kData;
      conic.mean_x = conic.mean_y = int64_t{5} << config.mean_f;
      conic.extent_x = conic.extent_y = uint64_t{11} * static_cast<uint64_t>(config.window) * 16;
      conic.side_u = conic.side_v = (uint64_t{1} << config.side_w()) - 1;
      run.push(conic, {});
    }
    ASSERT_TRUE(run.bench.run_until([&] { return run.out.size() == kGaussians * windows; }));
    EXPECT_LE(run.out.cycles.back() - run.out.cycles.front(), kGaussians * (windows + 1)) << windows << " windows";
  }
}

// Bit for bit what the projection gives in the window itself, and no window that the exact test keeps is left out.
TEST(PuExpandModel, PlacesAMeanAsTheProjectionInItsWindow) {
  const Config config = test_config();
  Config windowed = config;  // the same machine without lists
  windowed.order = 0;
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int saturated = 0, compared = 0;
  for (int i = 0; i < 300; ++i) {
    const Frame frame = random.frame();
    for (int k = 0; k < 100; ++k) {
      Visible v = random.visible(frame);
      if (random.chance(3))
        v.view_z = std::max<int64_t>(1, v.view_z >> random.integer(0, 12));  // means far beyond the frame
      Visible first = v;
      first.window_x = frame.raster.windows.first_x, first.window_y = frame.raster.windows.first_y;
      Conic conic;
      const Center whole = pu_project(config, frame, first).center;
      conic.mean_x = whole.mean_x, conic.mean_y = whole.mean_y;
      const Conic placed = pu_expand(config, conic, static_cast<int64_t>(v.window_x), static_cast<int64_t>(v.window_y));
      ProjectCounts counts;
      const Center alone = pu_project(windowed, frame, v, &counts).center;
      ASSERT_EQ(placed.mean_x, alone.mean_x) << to_text(windowed, v);
      ASSERT_EQ(placed.mean_y, alone.mean_y) << to_text(windowed, v);
      saturated += counts.saturated;
      ++compared;
    }
  }
  EXPECT_GT(saturated, 300) << "of " << compared;
}

TEST(PuExpandModel, LeavesOutNoWindowInWhichTheBoxHoldsAPixel) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int inside = 0, beside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Frame frame = small_frame(random);
    const Conic conic = random_conic(random, frame);
    const std::optional<PuExpandBox> box = pu_expand_box(config, frame, conic);
    for (uint64_t y = 0; y <= frame.raster.windows.last_y - frame.raster.windows.first_y; ++y) {
      for (uint64_t x = 0; x <= frame.raster.windows.last_x - frame.raster.windows.first_x; ++x) {
        const Conic placed = pu_expand(config, conic, static_cast<int64_t>(x), static_cast<int64_t>(y));
        // As pu_intersect makes its box.
        const auto holds = [&](int64_t mean, uint64_t extent) {
          const int64_t half = static_cast<int64_t>(extent) << (config.mean_f - 4), unit = int64_t{1} << config.mean_f;
          return std::max<int64_t>((mean - half + unit - 1) >> config.mean_f, 0) <=
                 std::min<int64_t>((mean + half) >> config.mean_f, config.window - 1);
        };
        const bool seen = holds(placed.mean_x, placed.extent_x) && holds(placed.mean_y, placed.extent_y);
        const bool in_box = box && static_cast<int64_t>(x) >= box->first_x && static_cast<int64_t>(x) <= box->last_x &&
                            static_cast<int64_t>(y) >= box->first_y && static_cast<int64_t>(y) <= box->last_y;
        if (seen) { ASSERT_TRUE(in_box) << x << "," << y << " " << to_text(config, conic); }
        inside += seen;
        beside += in_box && !seen;
        const auto endless = [&](uint64_t extent) {
          return extent >> kNearlyEndless == (uint64_t{1} << (config.extent_w() - kNearlyEndless)) - 1;
        };
        if (in_box && !endless(conic.extent_x) && !endless(conic.extent_y)) {
          ASSERT_TRUE(seen) << "a window too many: " << to_text(config, conic);
        }
      }
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(beside, 100) << "of endless boxes";
}

}  // namespace
}  // namespace pipegs
