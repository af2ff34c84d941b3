// SPDX-License-Identifier: Apache-2.0
// pu_color_rotate: turns the view direction into world axes and measures its squared length.
//
// Idea    world = W^T view; a rotation keeps the length, so the length is taken from the shorter view components while
//         the rotation runs. W is cut to s1.18: at most 2^-17.2 of the length is lost.
// Stream  view_direction -> world_direction, s(DirectionW).1, saturated (only when W is no rotation), and length2,
//         exact.
// RTL     rtl/pu/color/pu_color_rotate.sv
#pragma once

#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kColorRotF = 18;  // fraction of the rotation as used here

inline WorldDirection pu_color_rotate(const Config& config, const Frame& frame, const ViewDirection& view) {
  const int cut = config.rot_f() - kColorRotF;
  const auto component = [&](int64_t wx, int64_t wy, int64_t wz) {
    const int64_t sum = shift_floor(wx, cut) * view.x + shift_floor(wy, cut) * view.y + shift_floor(wz, cut) * view.z;
    return saturate(shift_round(sum, kColorRotF - 1), config.world_direction_w());
  };
  return {.x = component(frame.camera.rotation.w00, frame.camera.rotation.w10, frame.camera.rotation.w20),
          .y = component(frame.camera.rotation.w01, frame.camera.rotation.w11, frame.camera.rotation.w21),
          .z = component(frame.camera.rotation.w02, frame.camera.rotation.w12, frame.camera.rotation.w22),
          .length2 = static_cast<uint64_t>(view.x * view.x + view.y * view.y + view.z * view.z)};
}

}  // namespace pipegs
