// SPDX-License-Identifier: Apache-2.0
// pu_random: legal random cameras and Gaussians for the tests of the projection, with the extremes that hurt.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/float/projection.hpp"
#include "cpp_model/frame_setup.hpp"
#include "cpp_model/pack/pack.hpp"
#include "cpp_model/records.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {

struct PuRandom {
  const Config& config;
  std::mt19937_64& rng;

  double uniform(double low, double high) { return draw_uniform(rng, low, high); }
  int64_t integer(int64_t low, int64_t high) { return draw_integer(rng, low, high); }
  bool chance(int one_in) { return rng() % static_cast<uint64_t>(one_in) == 0; }

  void quaternion(double (&q)[4]) {
    double norm = 0;
    do {
      norm = 0;
      for (double& v : q) {
        v = chance(6) ? 0 : draw_normal(rng);
        norm += v * v;
      }
    } while (norm < 1e-6);
    for (double& v : q) v /= std::sqrt(norm);
  }

  // 12 to 32768 pixels wide, 20 to 120 degrees. The rotation and its quaternion agree.
  Frame frame() {
    Frame f;
    const double width = std::exp(uniform(std::log(64), std::log(16384))), height = width * uniform(0.4, 1);
    f.raster.width = static_cast<uint64_t>(width);
    f.raster.height = static_cast<uint64_t>(height);
    f.raster.windows.last_x = (f.raster.width - 1) / config.window;
    f.raster.windows.last_y = (f.raster.height - 1) / config.window;
    double q[4];
    quaternion(q);
    const glm::dmat3 r = rotation_matrix({q[0], q[1], q[2], q[3]});
    int64_t* const rows[9] = {&f.camera.rotation.w00, &f.camera.rotation.w01, &f.camera.rotation.w02,
                              &f.camera.rotation.w10, &f.camera.rotation.w11, &f.camera.rotation.w12,
                              &f.camera.rotation.w20, &f.camera.rotation.w21, &f.camera.rotation.w22};
    for (int i = 0; i < 9; ++i) *rows[i] = std::llround(std::ldexp(r[i % 3][i / 3], config.rot_f()));
    int64_t* const camera[4] = {&f.camera.quaternion.w, &f.camera.quaternion.x, &f.camera.quaternion.y,
                                &f.camera.quaternion.z};
    for (int i = 0; i < 4; ++i) *camera[i] = std::llround(std::ldexp(q[i], config.cam_quat_w() - 2));
    const double fov = uniform(20, 110) * 3.14159265358979 / 180,
                 focal = std::min(16383.0, width / 2 / std::tan(fov / 2));
    f.lens.focal_x = static_cast<uint64_t>(std::ldexp(focal, config.focal_f()));
    f.lens.focal_y = static_cast<uint64_t>(std::ldexp(std::min(16383.0, focal * uniform(0.9, 1.1)), config.focal_f()));
    f.lens.center_x = std::llround(std::ldexp(width * uniform(0.3, 0.7), config.center_f()));
    f.lens.center_y = std::llround(std::ldexp(height * uniform(0.3, 0.7), config.center_f()));
    set_reach(f.lens.focal_x, width, f.lens.limit_x, f.lens.reach_x);
    set_reach(f.lens.focal_y, height, f.lens.limit_y, f.lens.reach_y);
    f.lens.spread_x = lens_spread(config, f.lens.focal_x);
    f.lens.spread_y = lens_spread(config, f.lens.focal_y);
    f.lens.near_plane = static_cast<uint64_t>(integer(1, 1 << integer(1, 20)));
    return f;
  }
  void set_reach(uint64_t focal_field, double size, uint64_t& limit, uint64_t& reach) {
    const double focal = std::ldexp(static_cast<double>(focal_field), -config.focal_f());
    limit = std::min((uint64_t{1} << (config.tan_w() - 1)) - 1,
                     static_cast<uint64_t>(std::ldexp(1.3 * size / 2 / focal, config.tan_f)));
    const double slope = std::ldexp(static_cast<double>(limit + 1), -config.tan_f);
    reach = static_cast<uint64_t>(std::ldexp(std::sqrt(2 * std::log(config.alpha_cut)) * focal * std::hypot(1, slope),
                                             config.focal_f())) +
            2;
  }

  // Log-uniform in all of the field, sometimes zero.
  uint64_t scale() {
    if (chance(20)) return 0;
    return static_cast<uint64_t>(integer(1, (1 << config.scale_w()) - 1));
  }
  // `octaves` around 2^center world units.
  uint64_t scale_near(double center, double octaves) {
    const double e = std::clamp(center + uniform(-octaves, octaves) + 8, 1.0, 62.0);
    return (static_cast<uint64_t>(e) << config.scale_m_w) | (rng() & ((uint64_t{1} << config.scale_m_w) - 1));
  }
  // Quaternion, scales, opacity, colour and numbers of any record that has them.
  template <class R>
  void gaussian(R& r, double scale_center, double octaves) {
    double q[4];
    quaternion(q);
    int64_t* const fields[4] = {&r.qw, &r.qx, &r.qy, &r.qz};
    for (int i = 0; i < 4; ++i)
      *fields[i] = saturate<int64_t>(std::llround(std::ldexp(q[i], config.quat_w - 1)), config.quat_w);
    const bool wild = chance(4);
    r.scale_0 = wild ? scale() : scale_near(scale_center, octaves);
    r.scale_1 = wild ? scale() : scale_near(scale_center, octaves);
    r.scale_2 = wild ? scale() : scale_near(scale_center, octaves);
    rest(r);
  }
  template <class R>
  void rest(R& r) {
    r.opacity = rng() & ((uint64_t{1} << config.opacity_w()) - 1);
    r.base_r = integer(-(1 << (config.base_w - 1)), (1 << (config.base_w - 1)) - 1);
    r.base_g = integer(-(1 << (config.base_w - 1)), (1 << (config.base_w - 1)) - 1);
    r.base_b = integer(-(1 << (config.base_w - 1)), (1 << (config.base_w - 1)) - 1);
    r.index = rng() & ((uint64_t{1} << config.index_w) - 1);
    r.slot = rng() & ((uint64_t{1} << config.slot_w()) - 1);
  }

  // Any centre.
  Center center() {
    Center c = random_record<Center>(config, rng);
    c.mean_x >>= rng() % static_cast<uint64_t>(config.mean_w()),
        c.mean_y >>= rng() % static_cast<uint64_t>(config.mean_w());
    return c;
  }

  // Of a window, or of a part of it, or of an eye.
  uint64_t walk() {
    const std::vector<uint64_t> walks = all_walks(config);
    return chance(3) ? kWholeWalk : walks[rng() % walks.size()];
  }

  // A visible Gaussian of any depth, mostly near the image, from 1/1000 pixel to far larger than it.
  Visible visible(const Frame& f) {
    Visible v;
    const int bits = static_cast<int>(integer(1, config.view_w - 1));
    v.view_z = integer(int64_t{1} << (bits - 1), (int64_t{1} << bits) - 1);
    const double spread = chance(8) ? 40 : 1.5;
    const auto side = [&](double limit) {
      return saturate<int64_t>(std::llround(static_cast<double>(v.view_z) * uniform(-spread, spread) * limit),
                               config.view_w);
    };
    v.view_x = chance(30) ? integer(-1, 1) : side(std::ldexp(static_cast<double>(f.lens.limit_x), -config.tan_f));
    v.view_y = chance(30) ? integer(-1, 1) : side(std::ldexp(static_cast<double>(f.lens.limit_y), -config.tan_f));
    v.view_exp = static_cast<uint64_t>(integer(0, std::min(20, config.world_w - config.view_w)));
    v.window_x = static_cast<uint64_t>(integer(0, static_cast<int64_t>(f.raster.windows.last_x)));
    v.window_y = static_cast<uint64_t>(integer(0, static_cast<int64_t>(f.raster.windows.last_y)));
    v.walk = walk();
    const double pixel = std::log2(static_cast<double>(v.view_z)) + static_cast<double>(v.view_exp) -
                         std::log2(std::ldexp(static_cast<double>(f.lens.focal_x), -config.focal_f()));
    gaussian(v, pixel + uniform(-6, 12), chance(2) ? 10 : 2);
    return v;
  }
};

}  // namespace pipegs
