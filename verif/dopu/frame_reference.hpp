// SPDX-License-Identifier: Apache-2.0
// frame_reference.hpp: the parameters of a frame in doubles, by other means than the driver, which has integers alone.
//
// Idea    Each field is what its definition says, computed in double and rounded: bounds upwards, all else to nearest.
//         A double has 53 bits where the driver has 60: the two part only where a value lies within some 2^-20 of the
//         place at which rounding turns, and no camera of a test or a scene has such a one.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "cpp_model/frame_setup.hpp"
#include "sim/design/design_point.hpp"
#include "verif/support/config.hpp"

namespace pipegs {

// 2 ln AlphaCut * fx^2 * (1 + 2^-8), rounded up, exponent u5, then mantissa u0.8.
inline uint64_t reference_spread(const Config& c, uint64_t focal) {
  if (!c.tight_cull) return 0;
  const double pixels = std::ldexp(static_cast<double>(focal), -c.focal_f());
  const double spread = std::max(1.0, 2 * std::log(c.alpha_cut) * pixels * pixels * (1 + std::ldexp(1.0, -8)));
  const int e = std::ilogb(spread);
  return (static_cast<uint64_t>(e) << 8) + static_cast<uint64_t>(std::ceil(std::ldexp(spread, 8 - e))) - 256;
}

// Turns values into fields; notes when one does not fit.
struct ReferenceFields {
  const Camera& camera;
  bool fits = true;

  int64_t signed_field(double value, int fraction, int width) {
    const double field = std::round(std::ldexp(value, fraction)), high = std::ldexp(1.0, width - 1);
    fits = fits && field >= -high && field < high;
    return fits ? static_cast<int64_t>(field) : 0;
  }
  uint64_t unsigned_field(double value, int fraction, int width, bool round_up = false) {
    const double scaled = std::ldexp(value, fraction), field = round_up ? std::ceil(scaled) : std::round(scaled);
    fits = fits && field >= 0 && field < std::ldexp(1.0, width);
    return fits ? static_cast<uint64_t>(field) : 0;
  }
};

inline void set_rotation(const Config& config, ReferenceFields& set, Frame& frame) {
  const glm::dmat3& w = set.camera.world_to_camera;  // w[column][row]
  int64_t* const fields[9] = {&frame.camera.rotation.w00, &frame.camera.rotation.w01, &frame.camera.rotation.w02,
                              &frame.camera.rotation.w10, &frame.camera.rotation.w11, &frame.camera.rotation.w12,
                              &frame.camera.rotation.w20, &frame.camera.rotation.w21, &frame.camera.rotation.w22};
  for (int i = 0; i < 9; ++i) *fields[i] = set.signed_field(w[i % 3][i / 3], config.rot_f(), config.rot_w());

  // Quaternion by the largest of its four components, so that no small number is divided by.
  const auto m = [&](int row, int column) { return w[column][row]; };
  const double trace = m(0, 0) + m(1, 1) + m(2, 2);
  double q[4];
  if (trace > 0) {
    const double s = 2 * std::sqrt(1 + trace);
    q[0] = s / 4;
    q[1] = (m(2, 1) - m(1, 2)) / s;
    q[2] = (m(0, 2) - m(2, 0)) / s;
    q[3] = (m(1, 0) - m(0, 1)) / s;
  } else {
    const int i = m(0, 0) >= m(1, 1) && m(0, 0) >= m(2, 2) ? 0
                  : m(1, 1) >= m(2, 2)                     ? 1
                                                           : 2,
              j = (i + 1) % 3, k = (i + 2) % 3;
    const double s = 2 * std::sqrt(1 + m(i, i) - m(j, j) - m(k, k));
    q[0] = (m(k, j) - m(j, k)) / s;
    q[1 + i] = s / 4;
    q[1 + j] = (m(j, i) + m(i, j)) / s;
    q[1 + k] = (m(k, i) + m(i, k)) / s;
  }
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  int64_t* const quaternion[4] = {&frame.camera.quaternion.w, &frame.camera.quaternion.x, &frame.camera.quaternion.y,
                                  &frame.camera.quaternion.z};
  for (int i = 0; i < 4; ++i)
    *quaternion[i] = set.signed_field(q[i] / norm, config.cam_quat_w() - 2, config.cam_quat_w());
}

// Focal length, principal point, guard band and reach of one image axis.
inline void set_lens(const Config& config, ReferenceFields& set, bool x, uint64_t& focal, int64_t& center,
                     uint64_t& limit, uint64_t& reach) {
  const double f = x ? set.camera.fx : set.camera.fy, tangent = x ? set.camera.tan_x() : set.camera.tan_y();
  focal = set.unsigned_field(f, config.focal_f(), config.focal_w());
  set.fits = set.fits && focal != 0;
  center = set.signed_field(x ? set.camera.cx : set.camera.cy, config.center_f(), config.center_w());
  limit = set.unsigned_field(kGuardBand * tangent, config.tan_f, 4 + config.tan_f);
  // From the rounded fields and one unit up: a bound on what the machine computes.
  const double slope = std::ldexp(static_cast<double>(limit + 1), -config.tan_f);
  const double pixels = std::ldexp(static_cast<double>(focal), -config.focal_f());
  reach = set.unsigned_field(std::sqrt(2 * std::log(config.alpha_cut)) * pixels * std::hypot(1, slope),
                             config.focal_f(), config.reach_w(), true) +
          1;
}

inline void set_windows(const Config& config, ReferenceFields& set, const std::optional<WindowRange>& windows,
                        Frame& frame) {
  const Camera& camera = set.camera;
  const int columns = (camera.width + config.window - 1) / config.window,
            rows = (camera.height + config.window - 1) / config.window;
  const WindowRange range = windows.value_or(WindowRange{0, 0, columns - 1, rows - 1});
  const auto inside = [](int first, int last, int all) { return first >= 0 && first <= last && last < all; };
  const int count = (range.last_x - range.first_x + 1) * (range.last_y - range.first_y + 1);
  set.fits = set.fits && inside(1, camera.width, kMaxImageSide + 1) && inside(1, camera.height, kMaxImageSide + 1) &&
             std::max(columns, rows) <= 1 << config.window_w() && inside(range.first_x, range.last_x, columns) &&
             inside(range.first_y, range.last_y, rows) && !(config.has_lists() && count > 1 << config.list_window_w());
  frame.raster.width = static_cast<uint64_t>(camera.width);
  frame.raster.height = static_cast<uint64_t>(camera.height);
  frame.raster.windows.first_x = static_cast<uint64_t>(range.first_x);
  frame.raster.windows.first_y = static_cast<uint64_t>(range.first_y);
  frame.raster.windows.last_x = static_cast<uint64_t>(range.last_x);
  frame.raster.windows.last_y = static_cast<uint64_t>(range.last_y);
  frame.walk_most = config.has_walks() ? 32000 : 0;
  // Pixels of all windows, whole ones, whatever their order; then the overflow areas.
  const uint64_t pixels = static_cast<uint64_t>(columns) * static_cast<uint64_t>(rows) *
                          static_cast<uint64_t>(config.window * config.window);
  const uint64_t lines = pixels / static_cast<uint64_t>(config.memory_w() / config.pixel_w);
  frame.tables.overflow = (frame.tables.pixels + lines + 4096 - 1) / 4096 * 4096;
}

// Nothing when a field does not fit, or the windows do not lie in the picture.
inline std::optional<Frame> reference_frame(const Config& config, const PackedScene& scene, const Camera& camera,
                                            const std::optional<WindowRange>& windows = {},
                                            double near_plane = kNearPlane) {
  ReferenceFields set{camera};
  Frame frame;
  // One bit below WorldW, so that centre - camera keeps WorldW + 1 bits in every unit.
  const auto world = [&](double value) { return set.signed_field(value, -scene.scene_exponent, config.world_w - 1); };
  frame.camera.position.x = world(camera.position.x);
  frame.camera.position.y = world(camera.position.y);
  frame.camera.position.z = world(camera.position.z);
  set_rotation(config, set, frame);
  set_lens(config, set, true, frame.lens.focal_x, frame.lens.center_x, frame.lens.limit_x, frame.lens.reach_x);
  set_lens(config, set, false, frame.lens.focal_y, frame.lens.center_y, frame.lens.limit_y, frame.lens.reach_y);
  frame.lens.spread_x = reference_spread(config, frame.lens.focal_x);
  frame.lens.spread_y = reference_spread(config, frame.lens.focal_y);
  frame.lens.near_plane = set.unsigned_field(near_plane, -scene.scene_exponent, config.world_w - 1);
  frame.tables.sh_degree = static_cast<uint64_t>(scene.sh_degree);
  frame.tables.antialias = scene.antialiased;
  frame.grid.low.x = scene.grid.low[0];
  frame.grid.low.y = scene.grid.low[1];
  frame.grid.low.z = scene.grid.low[2];
  frame.grid.scale_x = scene.grid.scale[0];
  frame.grid.scale_y = scene.grid.scale[1];
  frame.grid.scale_z = scene.grid.scale[2];
  frame.tables.cells = scene.layout.cells;
  frame.tables.groups = scene.layout.groups;
  frame.tables.chunks = scene.layout.chunks;
  frame.tables.gaussians = scene.layout.gaussians;
  frame.tables.colors = scene.layout.colors;
  frame.tables.pixels = scene.layout.pixels;
  set_windows(config, set, windows, frame);
  if (!set.fits) return std::nullopt;
  return frame;
}

// Lines of the overflow area, in numbers that never wrap: of all units together 1 GiB of records and keys and 1 GiB of
// alphas at most, and 2 GiB of lists.
inline uint64_t reference_overflow(const Config& c, uint64_t slots, uint64_t windows) {
  using Lines = unsigned __int128;
  const Lines gibibyte = Lines{1} << 24, units = static_cast<Lines>(c.units);
  const Lines splats = static_cast<Lines>(c.parts()) * slots;
  const Lines frames_windows = std::min<uint64_t>(windows, uint64_t{1} << c.list_window_w());
  Lines sorting = 0, share = 0;
  if (c.overflow) sorting = share = 2 * std::clamp<Lines>(splats, 64, gibibyte / 2 / units);
  if (!c.late && (c.overflow || c.order == 1)) {
    const Lines of_gaussian = static_cast<Lines>(c.window / 8 * (c.window / 8)) * (c.alpha_w > 8 ? 2 : 1);
    // A frame's alphas with lists, else those of a layer, twice.
    const Lines alphas = c.order == 1 ? std::clamp<Lines>(slots * of_gaussian * frames_windows, 64, gibibyte / units)
                                      : 2 * std::clamp<Lines>(slots * of_gaussian, 64, gibibyte / 2 / units);
    share = 2 * std::max(sorting, alphas);
  }
  while (share % 16 != 0) ++share;
  if (c.order != 1) return static_cast<uint64_t>(units * share);
  Lines list = 1;
  while (list < 64 || (list <= slots && list < Lines{1} << c.list_entry_w())) list *= 2;
  while (frames_windows * list > 2 * gibibyte) list /= 2;
  list += static_cast<Lines>(Config::list_gap());
  return static_cast<uint64_t>(2 * std::max(units * share, frames_windows * list));
}

// --- what is tried ---

inline uint64_t frame_seed() {
  const char* text = std::getenv("PIPEGS_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

// A scene of which a frame sees no more than unit, grid and places.
inline PackedScene bare_scene(const Config& config, int exponent, std::mt19937_64& rng) {
  PackedScene scene;
  scene.config = config;
  scene.scene_exponent = exponent;
  scene.sh_degree = static_cast<int>(rng() % 4);
  scene.antialiased = config.antialias != 0 && rng() % 2 != 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    scene.grid.low[axis] = static_cast<int64_t>(rng()) >> (65 - config.world_w);
    scene.grid.scale[axis] = rng() >> (64 - config.focal_w());
  }
  uint64_t at = 0;
  for (uint64_t* place : {&scene.layout.cells, &scene.layout.groups, &scene.layout.chunks, &scene.layout.gaussians,
                          &scene.layout.colors, &scene.layout.pixels}) {
    *place = at;
    at += 1 + rng() % 1000000;
  }
  return scene;
}

inline std::vector<Config> machines() {
  std::vector<Config> configs;
  for (const DesignPoint& point : design_points()) configs.push_back(point.config);
  for (const char* settings :
       {"tan_f=16", "tan_f=24", "alpha_cut=32", "alpha_cut=1023", "alpha_cut=512 antialias=1", "world_w=32",
        "world_w=44", "window=16 pixel_w=32", "order=2 late=1 tight_cull=1", "tight_cull=1 alpha_cut=33 tan_f=17"})
    configs.push_back(config_with(settings));
  return configs;
}

}  // namespace pipegs
