// SPDX-License-Identifier: Apache-2.0
// pu_touch: does the oriented box of a Gaussian touch a square of pixel centres?
//
// Paper   GSCore's test of a tile and of its four subtiles, from which the paper's baseline is reproduced (Sec. 5.2).
// Idea    Box and square are apart iff they are along x, along y, or along an axis of the box. The first two are the
//         columns and rows of its extents. For the others, with (dx, dy) from its middle to the mean:
//           |dx + tilt dy| <= side_u + h (1 + |tilt|),  |dy - tilt dx| <= side_v + h (1 + |tilt|),  h = (side - 1) / 2
// Numbers dx + tilt dy is cut to 13 fraction bits and then exact from square to square.
// RTL     rtl/pu/box/pu_touch.sv
#pragma once

#include <cstdlib>

#include "cpp_model/fixed.hpp"
#include "cpp_model/pu/box/pu_axes.hpp"
#include "cpp_model/pu/box/pu_box.hpp"

namespace pipegs {

inline constexpr int kTouchF = 13;  // fraction of dx + tilt dy

// Record has mean_x, mean_y (MeanF fraction bits), tilt, side_u and side_v. Of the square whose first pixel is (x, y);
// `from` is the square at which the hardware began to step, a multiple of `side` away.
template <class Record>
bool pu_touch(const Config& config, const Record& in, int64_t from_x, int64_t from_y, int64_t x, int64_t y,
              int64_t side) {
  // Twice the middle, so that half a pixel is whole.
  const int64_t dx = 2 * in.mean_x - ((2 * from_x + side - 1) << config.mean_f),
                dy = 2 * in.mean_y - ((2 * from_y + side - 1) << config.mean_f);
  const int cut = config.mean_f + 1 + kTiltF - kTouchF;
  const int64_t right = x - from_x, down = y - from_y;
  static_assert(kTiltF - kTouchF == 3);  // eight pixels times tilt are whole
  const int64_t u = shift_floor((dx << kTiltF) + in.tilt * dy, cut) - (right << kTouchF) - down / 8 * in.tilt,
                v = shift_floor((dy << kTiltF) - in.tilt * dx, cut) - (down << kTouchF) + right / 8 * in.tilt;
  const int64_t size = in.tilt < 0 ? -in.tilt : in.tilt;
  const int64_t half = ((side - 1) << (kTouchF - 1)) + (((side - 1) * size) >> (kTiltF + 1 - kTouchF));
  const int64_t limit_u = (static_cast<int64_t>(in.side_u) << (kTouchF - kSideF)) + half,
                limit_v = (static_cast<int64_t>(in.side_v) << (kTouchF - kSideF)) + half;
  return std::abs(u) <= limit_u && std::abs(v) <= limit_v;
}

}  // namespace pipegs
