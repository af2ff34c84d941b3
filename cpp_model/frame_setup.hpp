// SPDX-License-Identifier: Apache-2.0
// frame_setup: a camera in fixed point: what the host writes into the machine before it starts a frame.
//
// Paper   Sec. 2.1 (projection constants).        RTL  frame_t of rtl/pipegs_pkg.sv, constant while a frame runs
// Idea    The driver computes it (cpp_model/driver/pipegs_frame.c, C99, integers alone), as a user's program does;
// here its
//         arguments are made of C++ ones, a double as the two parts that it has, and its refusals become one line. What
//         does not fit its field is an error, never a clamp.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "scenes/camera.hpp"
#include "cpp_model/pack/pack.hpp"
#include "cpp_model/driver/pipegs_frame.h"

namespace pipegs {

// One line: which camera, which quantity, its value, its limit.
struct FrameError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct WindowRange {
  int first_x, first_y, last_x, last_y;
};

inline constexpr double kNearPlane = 0.2;  // scene units, as in INRIA's renderer
inline constexpr double kGuardBand = 1.3;  // of tan(fov / 2), where the Jacobian is held

// `windows` defaults to all windows of the image.
Frame frame_setup(const Config& config, const PackedScene& scene, const Camera& camera,
                  const std::optional<WindowRange>& windows = {}, double near_plane = kNearPlane);

// Lets a frame of a machine with two eyes make the pictures of both, which stand on both sides of its camera; half the
// way between them in scene units, along its right and its down axis.
void frame_eyes(const Config& config, const PackedScene& scene, const std::array<double, 2>& half, Frame& frame);

// The same with the sizes of the areas, as the driver queues it: the image at address 0, behind it the pixels, then the
// overflow areas, as large as a frame of all windows can need.
pipegs_job frame_job(const Config& config, const PackedScene& scene, const Camera& camera,
                     const std::optional<WindowRange>& windows = {}, double near_plane = kNearPlane);

// What the driver takes.
pipegs_configuration driver_configuration(const Config& config);  // as the machine's registers say it
pipegs_scene driver_scene(const PackedScene& scene);
pipegs_camera driver_camera(const Camera& camera, double near_plane);
std::array<pipegs_number, 2> driver_half(const std::array<double, 2>& half);  // as frame_eyes takes it

// lens.spread_x or _y for a focal length; 0 without TightCull.
inline uint64_t lens_spread(const Config& config, uint64_t focal) {
  return config.tight_cull ? pipegs_spread(static_cast<uint32_t>(config.alpha_cut), focal) : 0;
}

}  // namespace pipegs
