// SPDX-License-Identifier: Apache-2.0
// eyes: the two cameras of a frame that share one walk (eyes = 2).
//
// Paper   None: it renders for headsets, but one picture at a time.
// Idea    Both eyes have one rotation and one lens and stand on both sides of the frame's position, so a Gaussian has
//         one depth, one key and one place in the order for both. In view space the first eye sees everything half the
//         distance further to the right, the second one to the left. A node is sent where either of them may see it
//         (dopu_test).
// Round   Half the distance to nearest in the unit of a chunk's view space, once for both.
#pragma once

#include <vector>

#include "cpp_model/dopu/walk.hpp"
#include "cpp_model/fixed.hpp"
#include "cpp_model/records.hpp"

namespace pipegs {

inline bool wants_eye(const Config& c, const Frame& frame, int eye) {
  return c.eyes == 1 ? eye == 0 : (frame.raster.eyes >> eye & 1) != 0;
}

inline std::vector<int> wanted_eyes(const Config& c, const Frame& frame) {
  std::vector<int> wanted;
  for (int eye = 0; eye < c.eyes; ++eye) {
    if (wants_eye(c, frame, eye)) wanted.push_back(eye);
  }
  return wanted;
}

// Of those, whom a walk is for.
inline std::vector<int> walk_eyes(const Config& c, const Frame& frame, uint64_t walk) {
  std::vector<int> eyes;
  for (const int eye : wanted_eyes(c, frame)) {
    if (walk_sees(c, walk, eye)) eyes.push_back(eye);
  }
  return eyes;
}

// What is added to a view coordinate, in units of 2^view_exp.
inline int64_t eye_shift(int64_t half, uint64_t view_exp, int eye) {
  const int64_t shift = shift_round(half, static_cast<int>(view_exp));
  return eye == 0 ? shift : -shift;
}

}  // namespace pipegs
