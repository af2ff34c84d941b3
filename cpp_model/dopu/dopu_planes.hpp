// SPDX-License-Identifier: Apache-2.0
// dopu_planes: the five planes that a Gaussian must not be behind to touch a window.
//
// Paper   Sec. 4.1 (DOPU feeds the PUs by layer; the window is ours).        RTL  rtl/dopu/dopu_planes.sv
// Idea    With t = (x, y, z) the mean in view space and s the scale, pixels x0 .. x1 can be reached only if
//           left    fx x - (x0 - cx - m) z + reach_x s >= 0       right  -fx x + (x1 - cx + m) z + reach_x s >= 0
//           top, bottom the same in y; near  z - near >= 0
//         reach s / z bounds sqrt(2 ln AlphaCut) = 3.33 standard deviations of the projection, m = ReachMargin pixels
//         those of the 0.3 px^2 dilation (1.83) and all roundings. Each is a plane n . (mean - camera) with a
//         world-space normal n = f w0 - a w2.
// Format  Exact in 2^-38, then floored to TestW bits with one unit for n and reach: slack in dopu_test pays for it.
#pragma once

#include <algorithm>
#include <array>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/eyes.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

enum PlaneSide { kNear, kLeft, kRight, kTop, kBottom, kPlanes };
struct Planes : std::array<Plane, kPlanes> {
  int eye = kAllEyes;  // the one that is to see what passes
};

// One side plane: `sign` is +1 for left and top, -1 for right and bottom.
inline Plane dopu_planes_side(const Config& config, const int64_t (&side)[3], const int64_t (&forward)[3],
                              uint64_t focal, int64_t center, uint64_t reach, int64_t pixel, int sign) {
  const int center_f = config.center_f(), align = config.focal_f() - center_f;
  const int64_t edge = (pixel << center_f) - center - sign * (int64_t{config.reach_margin()} << center_f);  // s17.12
  int64_t n[3];
  uint64_t magnitudes = reach << config.rot_f();  // u18.38
  for (int i = 0; i < 3; ++i) {
    const int64_t exact = static_cast<int64_t>(focal) * side[i] - ((edge * forward[i]) << align);  // s18.38
    n[i] = sign > 0 ? exact : -exact;
    magnitudes |= static_cast<uint64_t>(n[i] < 0 ? ~n[i] : n[i]);
  }
  const int shift = std::max(0, bit_length(magnitudes) - (config.test_w() - 1));
  Plane plane;
  plane.nx = shift_floor(n[0], shift);
  plane.ny = shift_floor(n[1], shift);
  plane.nz = shift_floor(n[2], shift);
  plane.reach = shift_floor(static_cast<int64_t>(reach << config.rot_f()), shift);
  return plane;
}

// Of a window's walk without what is closed of it (Occlusion); with lists (order 1) the planes of the rectangle from
// this window to the frame's last one.
inline Planes dopu_planes(const Config& config, const Frame& frame, int window_x, int window_y,
                          uint64_t walk = kWholeWalk, const Closed& closed = {}) {
  const int64_t right[3] = {frame.camera.rotation.w00, frame.camera.rotation.w01, frame.camera.rotation.w02},
                down[3] = {frame.camera.rotation.w10, frame.camera.rotation.w11, frame.camera.rotation.w12};
  const int64_t forward[3] = {frame.camera.rotation.w20, frame.camera.rotation.w21, frame.camera.rotation.w22};
  const WalkSquare square = walk_square(config, walk);
  const auto pixels = [](uint64_t regions) { return static_cast<int64_t>(regions) * 8; };
  const int64_t walk_x = int64_t{window_x} * config.window + square.x,
                walk_y = int64_t{window_y} * config.window + square.y;
  const auto end = [&](int64_t first, uint64_t last_window) {
    return config.has_lists() ? static_cast<int64_t>(last_window + 1) * config.window : first + square.side;
  };
  const auto last = [&](int64_t end, uint64_t beside, uint64_t size) {
    return std::min(end - pixels(beside), static_cast<int64_t>(size)) - 1;
  };
  const int64_t x0 = walk_x + pixels(closed.left), y0 = walk_y + pixels(closed.top);
  const int64_t x1 = last(end(walk_x, frame.raster.windows.last_x), closed.right, frame.raster.width);
  const int64_t y1 = last(end(walk_y, frame.raster.windows.last_y), closed.bottom, frame.raster.height);
  const int drop = config.rot_w() - config.test_w();
  Planes planes;
  if (const std::vector<int> eyes = walk_eyes(config, frame, walk); config.eyes > 1 && eyes.size() == 1)
    planes.eye = eyes[0];
  planes[kNear] = {shift_floor(frame.camera.rotation.w20, drop), shift_floor(frame.camera.rotation.w21, drop),
                   shift_floor(frame.camera.rotation.w22, drop), -(int64_t{1} << (config.rot_f() - drop))};
  planes[kLeft] =
      dopu_planes_side(config, right, forward, frame.lens.focal_x, frame.lens.center_x, frame.lens.reach_x, x0, +1);
  planes[kRight] =
      dopu_planes_side(config, right, forward, frame.lens.focal_x, frame.lens.center_x, frame.lens.reach_x, x1, -1);
  planes[kTop] =
      dopu_planes_side(config, down, forward, frame.lens.focal_y, frame.lens.center_y, frame.lens.reach_y, y0, +1);
  planes[kBottom] =
      dopu_planes_side(config, down, forward, frame.lens.focal_y, frame.lens.center_y, frame.lens.reach_y, y1, -1);
  return planes;
}

}  // namespace pipegs
