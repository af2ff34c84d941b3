// SPDX-License-Identifier: Apache-2.0
// narrow: a double of a file as the float of a scene.
//
// Rule    A double beyond float's range becomes an infinity (and the Gaussian is culled later); the conversion itself
//         would be undefined behaviour.
#pragma once

#include <cmath>
#include <limits>

namespace pipegs {

inline float narrow(double value) {
  if (std::abs(value) > std::numeric_limits<float>::max() && std::isfinite(value)) {
    return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(std::copysign(1.0, value)));
  }
  return static_cast<float>(value);
}

}  // namespace pipegs
