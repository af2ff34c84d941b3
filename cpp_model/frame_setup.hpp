// SPDX-License-Identifier: Apache-2.0
// frame_setup: a camera in fixed point: what the host writes into the machine before it starts a frame.
//
// Paper   Sec. 2.1 (projection constants).        RTL  frame_t of rtl/pipegs_pkg.sv, constant while a frame runs
// Idea    Everything that is the same for all Gaussians of a frame is computed here once, in double, and rounded:
//         bounds (reach) upwards, all else to nearest. What does not fit its field is an error, never a clamp.
#pragma once

#include <optional>
#include <stdexcept>

#include "cpp_model/config.hpp"
#include "cpp_model/records.hpp"
#include "scenes/camera.hpp"
#include "cpp_model/pack/pack.hpp"

namespace pipegs {

// One line: which camera, which quantity, its value, its limit.
struct FrameError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct WindowRange {
  int first_x, first_y, last_x, last_y;
};

inline constexpr double kNearPlane = 0.2;        // scene units, as in INRIA's renderer
inline constexpr double kGuardBand = 1.3;        // of tan(fov / 2), where the Jacobian is held
inline constexpr int kOverflowAlignment = 4096;  // lines

// `windows` defaults to all windows of the image.
Frame frame_setup(const Config& config, const PackedScene& scene, const Camera& camera,
                  const std::optional<WindowRange>& windows = {}, double near_plane = kNearPlane);

}  // namespace pipegs
