// SPDX-License-Identifier: Apache-2.0
// regions: where the regions of a window lie, and sets of them.
//
// Idea    A window of 128 pixels has four parts of 64, so that masks stay 64 bits wide and coefficients keep the range
//         of 64 pixels; a smaller one is one part. Parts are numbered row by row, and so are the regions of a part: a
//         region's number is its part above its bit in the part's mask.
// RTL     rtl/ru/place/ru_place.sv (where a region lies); elsewhere bits of the number
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "cpp_model/config.hpp"

namespace pipegs {

inline constexpr int kParts = 4;      // most parts of a window
inline constexpr int kRegions = 256;  // most regions

inline int region_part(const Config& c, int region) { return region / c.mask_w(); }
inline int region_bit(const Config& c, int region) { return region % c.mask_w(); }
inline int region_number(const Config& c, uint64_t part, int bit) { return static_cast<int>(part) * c.mask_w() + bit; }

// Column and row of a region in its window, in regions.
inline int region_x(const Config& c, int region) {
  return region_part(c, region) % c.parts_x() * c.part_regions_x() + region_bit(c, region) % c.part_regions_x();
}
inline int region_y(const Config& c, int region) {
  return region_part(c, region) / c.parts_x() * c.part_regions_x() + region_bit(c, region) / c.part_regions_x();
}

// The region that lies there.
inline int region_at(const Config& c, int x, int y) {
  const int side = c.part_regions_x();
  return region_number(c, static_cast<uint64_t>(y / side * c.parts_x() + x / side), y % side * side + x % side);
}

// Some regions of a window: the mask of each part.
struct RegionSet {
  std::array<uint64_t, kParts> mask = {};

  bool has(const Config& c, int region) const {
    return (mask[static_cast<size_t>(region_part(c, region))] >> region_bit(c, region) & 1) != 0;
  }
  void add(const Config& c, int region, bool wanted = true) {
    mask[static_cast<size_t>(region_part(c, region))] |= uint64_t{wanted} << region_bit(c, region);
  }
  int count() const {
    int sum = 0;
    for (const uint64_t part : mask) sum += std::popcount(part);
    return sum;
  }
  RegionSet& operator|=(const RegionSet& other) {
    for (size_t i = 0; i < mask.size(); ++i) mask[i] |= other.mask[i];
    return *this;
  }
  RegionSet operator&(const RegionSet& other) const {
    RegionSet both;
    for (size_t i = 0; i < mask.size(); ++i) both.mask[i] = mask[i] & other.mask[i];
    return both;
  }
  RegionSet operator~() const {
    RegionSet others;
    for (size_t i = 0; i < mask.size(); ++i) others.mask[i] = ~mask[i];
    return others;
  }
  bool operator==(const RegionSet&) const = default;
};

}  // namespace pipegs
