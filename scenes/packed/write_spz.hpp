// SPDX-License-Identifier: Apache-2.0
// write_spz: a scene as Niantic's .spz, version 3, for those who show it: a sixth to an eighth of its .ply.
//
// Layout  As scenes/formats/spz.cpp reads it: 8 bits for opacity, color, scale and SH, 3 x 10 for the rotation, 24 for
//         a coordinate with as many of them behind the point as the farthest Gaussian leaves. One gzip member.
// Rule    All Gaussians are finite (activate() says so). What a number loses by its bits is rounding; what lies beyond
//         the bits' range is cut to it, and counted.
#pragma once

#include <cstddef>
#include <string>

#include "scenes/scene.hpp"

namespace pipegs {

struct Spz {
  std::string bytes;
  int position_bits = 0;    // behind the point
  std::size_t cut = 0;      // numbers that were cut to their range
  std::size_t numbers = 0;  // all
};

Spz write_spz(const Scene& scene);

}  // namespace pipegs
