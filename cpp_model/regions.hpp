// SPDX-License-Identifier: Apache-2.0
// regions: where the regions of a window lie, and sets of them.
//
// Idea    A window of 128 pixels has four squares of 64, so that masks stay 64 bits wide and coefficients keep the
//         range of 64 pixels; a smaller one is one square. Squares are numbered row by row, and so are the regions of
//         one. A part is a square in an eye's picture: all of the first eye, then all of the second. A region's number
//         is its part above its bit in the part's mask.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "cpp_model/config.hpp"

namespace pipegs {

inline constexpr int kParts = 8;      // most parts of a window
inline constexpr int kRegions = 512;  // most regions

inline int region_part(const Config& c, int region) { return region / c.mask_w(); }
inline int region_bit(const Config& c, int region) { return region % c.mask_w(); }
inline int region_number(const Config& c, uint64_t part, int bit) { return static_cast<int>(part) * c.mask_w() + bit; }

inline uint64_t part_square(const Config& c, uint64_t part) { return part % static_cast<uint64_t>(c.squares()); }
inline int part_eye(const Config& c, int part) { return part / c.squares(); }
inline int region_eye(const Config& c, int region) { return part_eye(c, region_part(c, region)); }

// Column and row of a region in its window, in regions.
inline int region_x(const Config& c, int region) {
  return region_part(c, region) % c.parts_x() * c.part_regions_x() + region_bit(c, region) % c.part_regions_x();
}
inline int region_y(const Config& c, int region) {
  return region_part(c, region) % c.squares() / c.parts_x() * c.part_regions_x() +
         region_bit(c, region) / c.part_regions_x();
}

// The region that lies there in an eye's picture.
inline int region_at(const Config& c, int x, int y, int eye = 0) {
  const int side = c.part_regions_x(), square = y / side * c.parts_x() + x / side;
  return region_number(c, static_cast<uint64_t>(eye * c.squares() + square), y % side * side + x % side);
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
