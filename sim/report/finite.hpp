// SPDX-License-Identifier: Apache-2.0
// finite.hpp: a number as JSON, which has neither infinity (the PSNR of equal pictures) nor NaN: null stands for them.
#pragma once

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scenes/text/json.hpp"

namespace pipegs {

inline nlohmann::ordered_json finite_json(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

// The PSNR that was written so.
inline double psnr_from(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json_real(json);
}

}  // namespace pipegs
