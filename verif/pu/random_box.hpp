// SPDX-License-Identifier: Apache-2.0
// random_box.hpp: conics whose boxes lie in every way in some squares side by side, for the tests of pu_expand and
// pu_parts.
#pragma once

#include <algorithm>
#include <cmath>

#include "cpp_model/fixed.hpp"
#include "verif/pu/pu_random.hpp"

namespace pipegs {

// Boxes of all sizes: within a square, at its sides, of many squares, endless; means that saturate in some squares
// only.
inline Conic random_box(PuRandom& random, uint64_t columns, uint64_t rows, int side) {
  const Config& config = random.config;
  Conic c = random_record<Conic>(config, random.rng);
  c.kind = kData;
  const auto axis = [&](uint64_t squares, int64_t& mean, uint64_t& extent) {
    const double size = static_cast<double>(squares) * side;
    const int64_t most = (int64_t{1} << config.extent_w()) - 1;
    const double pixels = random.chance(12) ? std::ldexp(1.0, 18) + random.uniform(-200, 100)
                                            : std::exp(random.uniform(-3, random.chance(4) ? 12 : 5));
    extent = static_cast<uint64_t>(std::clamp<int64_t>(std::llround(pixels * 16), 0, most));
    double at = random.chance(2)   ? random.uniform(0, size)
                : random.chance(2) ? -pixels + random.uniform(-2, 2)
                                   : size + pixels + random.uniform(-2, 2);
    if (random.chance(3)) at = std::round(at / side) * side + random.uniform(-1, 1) * random.integer(0, 1);
    if (random.chance(10))
      at = std::ldexp(random.chance(2) ? 1.0 : -1.0, static_cast<int>(random.integer(17, 18))) +
           random.uniform(-2000, 2000);
    mean = saturate<int64_t>(std::llround(std::ldexp(at, config.mean_f)), config.mean_w());
  };
  axis(columns, c.mean_x, c.extent_x);
  axis(rows, c.mean_y, c.extent_y);
  if (config.oriented()) {  // of any shape within the box around it
    c.tilt = random.integer(-(1 << 16), 1 << 16);
    c.side_u = static_cast<uint64_t>(random.uniform(0, 1) * 16 * static_cast<double>(c.extent_x));
    c.side_v = static_cast<uint64_t>(random.uniform(0, 1) * 16 * static_cast<double>(c.extent_y));
  }
  return c;
}

}  // namespace pipegs
