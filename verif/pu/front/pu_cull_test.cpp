// SPDX-License-Identifier: Apache-2.0
// pu_cull_test: rtl/pu/front/pu_cull.sv against its bit-accurate model, and the model against the pixels of the
// window in double precision.
#include "cpp_model/pu/front/pu_cull.hpp"

#include "Vpu_cull.h"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/pu/front/random_fetched.hpp"
#include "verif/support/frame_ports.hpp"

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

// The largest alpha of the window's pixels must be below 1/AlphaCut for all that is dropped in front of the near plane.
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
      const auto side = [&](int64_t x, uint64_t focal, int64_t center, uint64_t window, int64_t beside, uint64_t last,
                            double variance) {
        const double most = side_pixels(config, in.walk, window, last) - 1;
        const double m = real(focal, config.focal_f()) * static_cast<double>(x) / static_cast<double>(v.view_z) +
                         real(center, config.center_f()) - static_cast<double>(window) * config.window -
                         static_cast<double>(beside);
        const double off = m < 0 ? -m : m > most ? m - most : 0;
        return off * off / variance;
      };
      const double far = std::max(side(v.view_x, frame.lens.focal_x, frame.lens.center_x, in.window_x, square.x,
                                       frame.raster.windows.last_x, e.a),
                                  side(v.view_y, frame.lens.focal_y, frame.lens.center_y, in.window_y, square.y,
                                       frame.raster.windows.last_y, e.c));
      const bool reaches = far <= 2 * power_max;
      const bool keeps = pu_cull(config, frame, in).has_value();
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
