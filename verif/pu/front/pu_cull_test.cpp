// SPDX-License-Identifier: Apache-2.0
// pu_cull_test: rtl/pu/front/pu_cull.sv against its bit-accurate model, and the model against the pixels of the
// window in double precision.
#include "cpp_model/pu/front/pu_cull.hpp"

#include "Vpu_cull.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/front/random_fetched.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/random_open.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_cull, Fetched, fetched, Visible, visible);

auto make_run() {
  return [](PuRandom& random, int count) {
    StageRun<Stage> run = stage_run<Stage>(random_fetched, [](auto&&...) { return Visible{}; })(random, count);
    run.expected.clear();
    for (const Fetched& in : run.inputs) {
      if (const std::optional<Visible> v = pu_cull(random.config, run.frame, in)) run.expected.push_back(*v);
    }
    return run;
  };
}

TEST(PuCull, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(make_run()); }

// What goes to pu_reach.
TEST(PuCull, TheGapGoesBesideTheSurvivor) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  size_t beyond = 0;
  for (const Pace pace : kPaces) {
    for (int i = 0; i < 10; ++i) {
      const StageRun<Stage> run = make_run()(random, 400);
      std::vector<Gap> expected;
      for (const Fetched& in : run.inputs) {
        Gap gap;
        if (!pu_cull(config, run.frame, in, nullptr, &gap)) continue;
        expected.push_back(config.tight_cull ? gap : Gap{});
        beyond += gap.gap_x > 0 || gap.gap_y > 0;
      }
      Bench<Vpu_cull> bench;
      write_frame(config, bench.dut, run.frame);
      auto source = Stage::source(bench, config, Pace::kAlways);
      auto sink = Stage::sink(bench, config, pace);
      std::vector<Gap> found;
      const Beside beside(bench, [&] {
        if (bench.dut.visible_valid_o && bench.dut.visible_ready_i)
          found.push_back(read_record<Gap>(config, bench.dut.gap_o));
      });
      bench.reset();
      for (const Fetched& in : run.inputs) source.push(in);
      bench.run_until([&] { return found.size() >= expected.size() && source.empty(); });
      ASSERT_EQ(found.size(), expected.size());
      for (size_t k = 0; k < expected.size(); ++k)
        ASSERT_EQ(first_difference(config, expected[k], found[k]), "") << "beat " << k << ", seed " << bench.seed;
    }
  }
  EXPECT_GT(beyond, 500u);
}

// With Occlusion: shows each Gaussian, five cycles after it went in, what is open then, and before and after that
// something else.
struct Opens : Endpoint {
  Bench<Vpu_cull>& bench;
  const Config& config;
  std::deque<std::optional<Open>> coming{5};
  std::vector<Open> opens;  // of each input
  size_t taken = 0;
  Opens(Bench<Vpu_cull>& b, const Config& c) : bench(b), config(c) { b.add(*this); }
  void drive() override {
    const std::optional<Open> now = coming.front();
    coming.pop_front();
    write_record(config, bench.dut.open_i,
                 now ? *now : random_open(config, bench.rng() % 4, bench.rng() % 4, bench.rng));
  }
  void observe() override {
    const bool takes = bench.dut.fetched_valid_i && bench.dut.fetched_ready_o;
    coming.push_back(takes ? std::optional<Open>(opens.at(taken++)) : std::nullopt);
  }
};

std::vector<Open> random_opens(const Config& config, const std::vector<Fetched>& inputs, std::mt19937_64& rng) {
  const uint64_t windows = uint64_t{1} << config.window_w();
  std::vector<Open> opens;
  for (const Fetched& in : inputs) {
    Open open = random_open(config, (in.window_x + (rng() % 8 == 0)) % windows,
                            (in.window_y + (rng() % 8 == 0)) % windows, rng);
    open.known = rng() % 8 != 0;
    opens.push_back(open);
  }
  return opens;
}

Closed closed_at(const Config& config, const Open& open, const Fetched& in) {
  return closed_at(config, open, in.window_x, in.window_y, in.walk);
}

TEST(PuCull, DropsWhatTouchesNothingOpen) {
  const Config config = test_config();
  if (!config.occlusion) GTEST_SKIP() << "without Occlusion nothing is known to be closed";
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  size_t beside = 0, kept = 0;
  for (int i = 0; i < 10; ++i) {
    const StageRun<Stage> run = make_run()(random, 600);
    Bench<Vpu_cull> bench;
    write_frame(config, bench.dut, run.frame);
    auto source = Stage::source(bench, config, Pace::kAlways);
    auto sink = Stage::sink(bench, config, Pace::kAlways);
    Opens opens(bench, config);
    bench.reset();
    opens.opens = random_opens(config, run.inputs, rng);
    opens.coming.assign(5, std::nullopt);
    std::vector<Visible> expected;
    for (size_t k = 0; k < run.inputs.size(); ++k) {
      const Fetched& in = run.inputs[k];
      const std::optional<Visible> v =
          pu_cull(config, run.frame, in, nullptr, nullptr, closed_at(config, opens.opens[k], in));
      beside += !v && pu_cull(config, run.frame, in);
      kept += v.has_value();
      if (v) expected.push_back(*v);
      source.push(in);
    }
    bench.run_until([&] { return source.empty(); });
    for (int k = 0; k < 20; ++k) bench.step();
    ASSERT_EQ(sink.size(), expected.size());
    for (size_t k = 0; k < expected.size(); ++k)
      ASSERT_EQ(first_difference(config, expected[k], sink.at(k)), "") << "beat " << k << ", seed " << bench.seed;
  }
  EXPECT_GT(beside, 200u);
  EXPECT_GT(kept, 200u);
}

// What stays closed while the pipeline stands counts as before.
TEST(PuCull, DropsTheSameAtEveryPace) {
  const Config config = test_config();
  if (!config.occlusion) GTEST_SKIP();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  size_t beside = 0;
  for (int i = 0; i < 8 * static_cast<int>(std::size(kPaces)); ++i) {
    const Pace pace = kPaces[static_cast<size_t>(i) % std::size(kPaces)];
    const StageRun<Stage> run = make_run()(random, 600);
    const Open open = random_open(config, run.inputs[0].window_x, run.inputs[0].window_y, rng);
    Bench<Vpu_cull> bench;
    write_frame(config, bench.dut, run.frame);
    write_record(config, bench.dut.open_i, open);
    auto source = Stage::source(bench, config, pace);
    auto sink = Stage::sink(bench, config, pace == Pace::kAlways ? Pace::kQuarter : pace);
    bench.reset();
    std::vector<Visible> expected;
    for (const Fetched& in : run.inputs) {
      const std::optional<Visible> v = pu_cull(config, run.frame, in, nullptr, nullptr, closed_at(config, open, in));
      beside += !v && pu_cull(config, run.frame, in);
      if (v) expected.push_back(*v);
      source.push(in);
    }
    bench.run_until([&] { return source.empty() && sink.size() >= expected.size(); }, 100000);
    for (int k = 0; k < 20; ++k) bench.step();
    ASSERT_EQ(sink.size(), expected.size());
    for (size_t k = 0; k < expected.size(); ++k)
      ASSERT_EQ(first_difference(config, expected[k], sink.at(k)), "") << "beat " << k << ", seed " << bench.seed;
  }
  EXPECT_GT(beside, 5u);
}

// Never more with more closed; and `most` says of each side how much it is.
TEST(PuCull, ModelKeepsLessTheMoreIsClosed) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int kept = 0, dropped = 0;
  for (int i = 0; i < 300; ++i) {
    const Frame frame = random.frame();
    for (int k = 0; k < 20; ++k) {
      const Fetched in = random_fetched(random, frame);
      Closed most;
      const bool whole = pu_cull(config, frame, in, nullptr, nullptr, {}, &most).has_value();
      const Closed closed = random_closed(config, in.walk, rng);
      const bool keeps = pu_cull(config, frame, in, nullptr, nullptr, closed).has_value();
      if (!whole) {
        ASSERT_FALSE(keeps);
        continue;
      }
      ASSERT_EQ(keeps, closed.left <= most.left && closed.right <= most.right && closed.top <= most.top &&
                           closed.bottom <= most.bottom);
      kept += keeps, dropped += !keeps;
    }
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(dropped, 100);
}

// With two eyes: shows each Gaussian to the one that it is meant for.
struct Looks : Endpoint {
  Bench<Vpu_cull>& bench;
  std::vector<int> eyes;  // of each input
  size_t taken = 0;
  explicit Looks(Bench<Vpu_cull>& b) : bench(b) { b.add(*this); }
  void drive() override { bench.dut.eye_i = static_cast<CData>(taken < eyes.size() ? eyes[taken] : bench.rng() % 2); }
  void observe() override { taken += bench.dut.fetched_valid_i && bench.dut.fetched_ready_o; }
};

TEST(PuCull, SeesWhatTheEyeSees) {
  const Config config = test_config();
  if (config.eyes == 1) GTEST_SKIP() << "one eye";
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  size_t one = 0, both = 0;
  for (const Pace pace : kPaces) {
    for (int i = 0; i < 12; ++i) {
      StageRun<Stage> run = make_run()(random, 500);
      uint64_t least = 63;  // view_exp: its unit leaves room for half the distance
      for (const Fetched& in : run.inputs) least = in.kind == kData ? std::min(least, in.view_exp) : least;
      const auto half = [&] {
        const int64_t most = int64_t{1} << (rng() % (static_cast<uint64_t>(config.view_w - 2) + least));
        return std::clamp(random.integer(-most, most), -(int64_t{1} << (config.half_eye_w() - 1)) + 1,
                          (int64_t{1} << (config.half_eye_w() - 1)) - 1);
      };
      run.frame.eyes.half_x = half(), run.frame.eyes.half_y = half();
      Bench<Vpu_cull> bench;
      write_frame(config, bench.dut, run.frame);
      auto source = Stage::source(bench, config, pace);
      auto sink = Stage::sink(bench, config, pace);
      Looks looks(bench);
      bench.reset();
      std::vector<Visible> expected;
      for (const Fetched& in : run.inputs) {
        looks.eyes.push_back(in.kind == kData ? static_cast<int>(rng() % 2) : 0);
        source.push(in);
        std::optional<Visible> seen[2];
        for (const int eye : {0, 1}) seen[eye] = pu_cull(config, run.frame, in, nullptr, nullptr, {}, nullptr, eye);
        one += seen[0].has_value() != seen[1].has_value();
        both += in.kind == kData && seen[0] && seen[1] && seen[0]->view_x != seen[1]->view_x;
        if (seen[looks.eyes.back()]) expected.push_back(*seen[looks.eyes.back()]);
      }
      bench.run_until([&] { return source.empty() && sink.size() >= expected.size(); }, 100000);
      for (int k = 0; k < 20; ++k) bench.step();
      ASSERT_EQ(sink.size(), expected.size());
      for (size_t k = 0; k < expected.size(); ++k)
        ASSERT_EQ(first_difference(config, expected[k], sink.at(k)), "") << "beat " << k << ", seed " << bench.seed;
    }
  }
  EXPECT_GT(one, 500u) << "one eye sees it";
  EXPECT_GT(both, 1000u);
}

TEST(PuCull, TakesAGaussianEveryCycle) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  const StageRun<Stage> run = make_run()(random, 500);
  Bench<Vpu_cull> bench;
  write_frame(config, bench.dut, run.frame);
  auto source = Stage::source(bench, config, Pace::kAlways);
  auto sink = Stage::sink(bench, config, Pace::kAlways);
  bench.reset();
  const uint64_t start = bench.cycle;
  for (const Fetched& in : run.inputs) source.push(in);
  bench.run_until([&] { return source.empty(); });
  EXPECT_EQ(bench.cycle - start, run.inputs.size());
}

// The largest alpha of the window's pixels, of those that are open, must be below 1/AlphaCut for all that is dropped in
// front of the near plane.
TEST(PuCull, ModelDropsNothingThatReachesAPixelOfTheWindow) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  PuRandom random{config, rng};
  int dropped = 0, kept = 0, useless = 0;
  for (int i = 0; i < 4000; ++i) {
    const Frame frame = random.frame();
    for (int k = 0; k < 10; ++k) {
      Fetched in = random_fetched(random, frame);
      // A pixel where the exponent is above -power_max can be seen: power_max = ln(AlphaCut opacity).
      if (random.chance(3)) in.opacity = 0;
      const double power_max =
          std::log(config.alpha_cut) - std::log(2.0) * std::ldexp(static_cast<double>(in.opacity), -config.opacity_f);
      if (power_max < 0) continue;
      Fetched near = in;  // the same, made visible by a window that is all of the plane: a huge scale
      near.scale_0 = (uint64_t{1} << config.scale_w()) - 1;
      const std::optional<Visible> seen = pu_cull(config, frame, near);
      if (!seen) continue;  // behind the near plane
      Visible v = *seen;
      v.scale_0 = in.scale_0;
      const Oriented o = pu_orient(config, frame, pu_project(config, frame, v).projected);
      const ExactCovariance e = exact_covariance(random, frame, o);
      // Conservative in favour of "reaches": the largest power over the window seen along each axis alone.
      const auto real = [](auto value, int down) { return std::ldexp(static_cast<double>(value), -down); };
      const WalkSquare square = walk_square(config, in.walk);
      const Closed closed = config.has_lists() || random.chance(2) ? Closed{} : random_closed(config, in.walk, rng);
      const auto side = [&](int64_t x, uint64_t focal, int64_t center, uint64_t window, int64_t walk_beside,
                            uint64_t low_closed, uint64_t high_closed, uint64_t last, double variance) {
        const auto beside = walk_beside + 8 * static_cast<int64_t>(low_closed);
        const double most =
            side_pixels(config, in.walk, window, last) - 1 - 8 * static_cast<double>(low_closed + high_closed);
        const double m = real(focal, config.focal_f()) * static_cast<double>(x) / static_cast<double>(v.view_z) +
                         real(center, config.center_f()) - static_cast<double>(window) * config.window -
                         static_cast<double>(beside);
        const double off = m < 0 ? -m : m > most ? m - most : 0;
        return off * off / variance;
      };
      const double far = std::max(side(v.view_x, frame.lens.focal_x, frame.lens.center_x, in.window_x, square.x,
                                       closed.left, closed.right, frame.raster.windows.last_x, e.a),
                                  side(v.view_y, frame.lens.focal_y, frame.lens.center_y, in.window_y, square.y,
                                       closed.top, closed.bottom, frame.raster.windows.last_y, e.c));
      const bool reaches = far <= 2 * power_max;
      const bool keeps = pu_cull(config, frame, in, nullptr, nullptr, closed).has_value();
      if (reaches) { ASSERT_TRUE(keeps) << to_text(config, in) << "\n" << to_text(config, frame); }
      dropped += !keeps;
      kept += keeps;
      useless += keeps && !reaches;
    }
  }
  std::printf("pu_cull: %d dropped, %d kept, of which %d cannot reach the window's box\n", dropped, kept, useless);
  EXPECT_GT(dropped, 1000);
  EXPECT_GT(kept, 1000);
}

TEST(PuCull, TheNearPlaneIsExact) {
  const Config config = test_config();
  Frame frame;
  frame.camera.rotation.w00 = frame.camera.rotation.w11 = frame.camera.rotation.w22 = int64_t{1} << config.rot_f();
  frame.lens.focal_x = frame.lens.focal_y = uint64_t{100} << config.focal_f();
  frame.lens.reach_x = frame.lens.reach_y = uint64_t{400} << config.focal_f();
  for (const uint64_t view_exp : {0, 3}) {
    for (int64_t below = -9; below <= 9; ++below) {
      Fetched in;
      in.view_exp = view_exp;
      in.origin_z = 1000;
      frame.lens.near_plane = static_cast<uint64_t>((int64_t{1000} << view_exp) + below);
      uint64_t behind = 0;
      EXPECT_EQ(pu_cull(config, frame, in, &behind).has_value(), !config.near_test || below < 0)
          << "z 2^view_exp > near, near is " << below << " above z";
      EXPECT_EQ(behind, below >= 0);
    }
  }
}

}  // namespace
}  // namespace pipegs
