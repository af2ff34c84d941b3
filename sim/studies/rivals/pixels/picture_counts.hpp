// SPDX-License-Identifier: Apache-2.0
// picture_counts.hpp: what is counted while a picture is blended in an order of its own.
#pragma once

#include <cstdint>

namespace pipegs {

struct OrderCounts {
  uint64_t blends = 0;  // (Gaussian, pixel) that add to the pixel
  uint64_t late = 0;    // of those, nearer by view depth than one that had been added before
};

// Of STREAMINGGS: see streaming.hpp.
struct StreamCounts {
  uint64_t met = 0, taken = 0;  // (voxel, group) that meet; of those, fetched before the group's last pixel stops
  uint64_t pairs = 0;           // (Gaussian, group) with alpha >= 1/255 at a pixel of the group
  uint64_t lost_voxel = 0;      // of those, whose voxel the group does not meet
  uint64_t lost_coarse = 0;     // of the rest, whose circle does not touch the group
  uint64_t fetched = 0, coarse = 0, fine = 0;  // (Gaussian, group) in voxels taken, and what passes the filters
  double bytes(double index_bytes) const {
    return 16 * static_cast<double>(fetched) + index_bytes * static_cast<double>(coarse);
  }
};

}  // namespace pipegs
