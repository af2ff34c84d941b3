// pu_cull: moves a Gaussian into view space and drops it when it is behind the near plane or cannot reach the window.
//
// Paper   Sec. 4.2, frustum culling of the preprocessing.
// Idea    view = origin + W offset. A splat reaches at most reach * s / z pixels from its mean, s its largest scale,
//         plus 3.33 sqrt(0.3) for the dilation. Times z, each of the four sides is a plane, no division:
//           keep iff  fx x - a z + reach s >= 0,   a = Window window_x - center_x - 2        (and the other three)
//         x, z, s are cut to 17 bits with a common exponent, always to the side that keeps: it never drops a Gaussian
//         with alpha >= 1/255 in a pixel of the window.
// Numbers view s(ViewW-1).0 in units of 2^view_exp, rounded to nearest, saturated (DOPU's view_exp leaves room).
//         near plane exact: keep iff z 2^view_exp > near_plane.
// RTL     rtl/pu/pu_cull.sv
#pragma once

#include <optional>

#include "cpp_model/records.hpp"

namespace pipegs {

inline constexpr int kCullMargin = 2;  // pixels beyond the window: 3.33 sqrt(0.3) = 1.83 and slack for the rounded mean

// Nothing for a Gaussian that is dropped; other beats pass with all other fields zero.
std::optional<Visible> pu_cull(const Config& config, const Frame& frame, const Fetched& fetched);

}  // namespace pipegs
