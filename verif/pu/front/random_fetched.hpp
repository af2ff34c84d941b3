// SPDX-License-Identifier: Apache-2.0
// random_fetched: random Gaussians about their own reach beyond a window, for the tests of the cull.
#pragma once

#include <algorithm>
#include <cmath>

#include "cpp_model/pu/pass.hpp"
#include "verif/pu/pu_random.hpp"

namespace pipegs {

// Pixels that a Gaussian is tested against along one axis: of its walk; with lists, of all windows of the frame.
inline double side_pixels(const Config& config, uint64_t walk, uint64_t window, uint64_t last) {
  if (!config.has_lists()) return static_cast<double>(walk_square(config, walk).side);
  return static_cast<double>((last - window + 1) * static_cast<uint64_t>(config.window));
}

// A Gaussian near the edge of its window: the mean lies about its own reach beyond a side, and the chunk anywhere.
inline Fetched random_fetched(PuRandom& random, const Frame& frame) {
  const Config& config = random.config;
  const Visible v = random.visible(frame);
  Fetched in;
  in.window_x = config.has_lists() ? frame.raster.windows.first_x : v.window_x;
  in.window_y = config.has_lists() ? frame.raster.windows.first_y : v.window_y;
  in.walk = v.walk;
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
               size = scale_value(config, std::max({in.scale_0, in.scale_1, in.scale_2}));
  const double s = std::ldexp(size, -static_cast<int>(in.view_exp));
  const auto aim = [&](uint64_t focal, uint64_t reach, int64_t center, uint64_t window, int64_t beside, uint64_t last) {
    const double pixels = side_pixels(config, in.walk, window, last),
                 reach_px = real(reach, config.focal_f()) * s / z + 2, pixel = real(center, config.center_f());
    const double side =
        random.chance(2) ? -reach_px * random.uniform(0, 1.2) : pixels + reach_px * random.uniform(0, 1.2);
    const double at = random.chance(2) ? random.uniform(0, pixels) : side;
    return (static_cast<double>(window) * config.window + static_cast<double>(beside) + at - pixel) /
           real(focal, config.focal_f()) * z;
  };
  const WalkSquare square = walk_square(config, in.walk);
  const double x = aim(frame.lens.focal_x, frame.lens.reach_x, frame.lens.center_x, in.window_x, square.x,
                       frame.raster.windows.last_x);
  const double y = aim(frame.lens.focal_y, frame.lens.reach_y, frame.lens.center_y, in.window_y, square.y,
                       frame.raster.windows.last_y);
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

}  // namespace pipegs
