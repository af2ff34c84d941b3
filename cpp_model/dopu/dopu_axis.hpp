// SPDX-License-Identifier: Apache-2.0
// dopu_axis: the principal axis of the view, along which the layers are stacked.
//
// Paper   Sec. 3.2, Sec. 4.1 (DOPU).        RTL  rtl/dopu/dopu_axis.sv
// Idea    The axis along which the camera's forward vector is longest; ties go to the lowest axis.
#pragma once

#include <cstdlib>

#include "cpp_model/records.hpp"

namespace pipegs {

inline int dopu_axis(const Frame& frame) {
  const int64_t x = std::abs(frame.camera.rotation.w20), y = std::abs(frame.camera.rotation.w21),
                z = std::abs(frame.camera.rotation.w22);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

}  // namespace pipegs
