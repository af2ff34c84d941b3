// SPDX-License-Identifier: Apache-2.0
// pu_cull_test: rtl/pu/pu_cull.sv against its bit-accurate model, and the model against the pixels of the
// window in double precision.
#include "cpp_model/pu/pu_cull.hpp"

#include "Vpu_cull.h"
#include "cpp_model/pu/pass.hpp"
#include "verif/pu/pu_chain.hpp"
#include "verif/pu/pu_stage.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

PIPEGS_STAGE(pu_cull, Fetched, fetched, Visible, visible);

// Pixels that a Gaussian is tested against along one axis: of its window; with lists, of all windows of the frame.
double side_pixels(const Config& config, uint64_t window, uint64_t last) {
  return static_cast<double>((config.has_lists() ? last - window + 1 : 1) * static_cast<uint64_t>(config.window));
}

// A Gaussian near the edge of its window: the mean lies about its own reach beyond a side, and the chunk anywhere.
Fetched make(PuRandom& random, const Frame& frame) {
  const Config& config = random.config;
  const Visible v = random.visible(frame);
  Fetched in;
  in.window_x = config.has_lists() ? frame.raster.windows.first_x : v.window_x;
  in.window_y = config.has_lists() ? frame.raster.windows.first_y : v.window_y;
  in.view_exp = v.view_exp;
  const int lead = config.view_w - config.pos_w - 3;  // view_exp >= offset_exp - lead
  const int64_t highest = std::min<int64_t>(63, static_cast<int64_t>(v.view_exp) + lead);
  in.offset_exp = static_cast<uint64_t>(
      std::max<int64_t>(0, random.chance(2) ? highest : random.integer(0, std::max<int64_t>(0, highest))));
  in.view_exp = std::max<uint64_t>(in.view_exp, in.offset_exp < static_cast<uint64_t>(std::max(lead, 0))
                                                    ? 0
                                                    : in.offset_exp - static_cast<uint64_t>(std::max(lead, 0)));
  if (lead < 0) in.view_exp = std::max<uint64_t>(in.view_exp, in.offset_exp + static_cast<uint64_t>(-lead));
  const int64_t most = int64_t{1} << (config.pos_w - 1);
  in.offset_x = random.integer(-most, most - 1);
  in.offset_y = random.integer(-most, most - 1);
  in.offset_z = random.integer(-most, most - 1);
  pass_scales(v, in);
  pass_quaternion(v, in);
  in.opacity = v.opacity, in.base_r = v.base_r, in.base_g = v.base_g, in.base_b = v.base_b;
  in.index = v.index, in.slot = v.slot;
  // The origin that puts the mean where it hurts: aim at a pixel about the reach away from the window.
  const auto real = [](auto m, int down) { return std::ldexp(static_cast<double>(m), -down); };
  const double z = static_cast<double>(v.view_z),
               size = random.scale_value(std::max({in.scale_0, in.scale_1, in.scale_2}));
  const double s = std::ldexp(size, -static_cast<int>(in.view_exp));
  const auto aim = [&](uint64_t focal, uint64_t reach, int64_t center, uint64_t window, uint64_t last) {
    const double pixels = side_pixels(config, window, last), reach_px = real(reach, config.focal_f()) * s / z + 2,
                 pixel = real(center, config.center_f());
    const double side =
        random.chance(2) ? -reach_px * random.uniform(0, 1.2) : pixels + reach_px * random.uniform(0, 1.2);
    const double at = random.chance(2) ? random.uniform(0, pixels) : side;
    return (static_cast<double>(window) * config.window + at - pixel) / real(focal, config.focal_f()) * z;
  };
  const double x =
      aim(frame.lens.focal_x, frame.lens.reach_x, frame.lens.center_x, in.window_x, frame.raster.windows.last_x);
  const double y =
      aim(frame.lens.focal_y, frame.lens.reach_y, frame.lens.center_y, in.window_y, frame.raster.windows.last_y);
  const double unit = std::ldexp(1.0, static_cast<int>(in.offset_exp) - static_cast<int>(in.view_exp) - config.rot_f());
  const auto row = [&](int64_t a, int64_t b, int64_t c) {
    return unit * (static_cast<double>(a) * static_cast<double>(in.offset_x) +
                   static_cast<double>(b) * static_cast<double>(in.offset_y) +
                   static_cast<double>(c) * static_cast<double>(in.offset_z));
  };
  const auto origin = [&](double value) {
    const double high = std::ldexp(0.74, config.view_w - 1);  // the offset fills a quarter at most
    return static_cast<int64_t>(std::llround(std::clamp(value, -high, high)));
  };
  in.origin_x = origin(x - row(frame.camera.rotation.w00, frame.camera.rotation.w01, frame.camera.rotation.w02));
  in.origin_y = origin(y - row(frame.camera.rotation.w10, frame.camera.rotation.w11, frame.camera.rotation.w12));
  in.origin_z = origin(z - row(frame.camera.rotation.w20, frame.camera.rotation.w21, frame.camera.rotation.w22));
  return in;
}

auto make_run() {
  return [](PuRandom& random, int count) {
    StageRun<Stage> run = stage_run<Stage>(make, [](auto&&...) { return Visible{}; })(random, count);
    run.expected.clear();
    for (const Fetched& in : run.inputs) {
      if (const std::optional<Visible> v = pu_cull(random.config, run.frame, in)) run.expected.push_back(*v);
    }
    return run;
  };
}

TEST(PuCull, EqualsItsModelAtEveryPace) { check_every_pace<Stage>(make_run()); }

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
      Fetched in = make(random, frame);
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
      const auto side = [&](int64_t x, uint64_t focal, int64_t center, uint64_t window, uint64_t last,
                            double variance) {
        const double most = side_pixels(config, window, last) - 1;
        const double m = real(focal, config.focal_f()) * static_cast<double>(x) / static_cast<double>(v.view_z) +
                         real(center, config.center_f()) - static_cast<double>(window) * config.window;
        const double off = m < 0 ? -m : m > most ? m - most : 0;
        return off * off / variance;
      };
      const double far = std::max(
          side(v.view_x, frame.lens.focal_x, frame.lens.center_x, in.window_x, frame.raster.windows.last_x, e.a),
          side(v.view_y, frame.lens.focal_y, frame.lens.center_y, in.window_y, frame.raster.windows.last_y, e.c));
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
