// SPDX-License-Identifier: Apache-2.0
// pixel_map.hpp: what a page shows over the picture in false colors: a code for each place, and what a code means.
//
// Idea    A map is of pixels or of 8x8 regions. Codes are bytes (or two), so a map is small: linear codes are
//         the value itself times a step, logarithmic ones are `low` times 2^((code - 1) / steps), 0 for nothing.
// Errors  A logarithmic code is at most half a step off: a factor of 2^(1 / (2 steps)).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cpp_model/float/image.hpp"
#include "sim/report/html/document.hpp"

namespace pipegs {

struct PixelMap {
  std::string name, title, unit;
  std::string what;  // one sentence: what a place shows
  int cell = 1;      // pixels of a side
  int width = 0, height = 0;
  std::vector<double> values;
  bool logarithmic = false;
  double low = 0;    // logarithmic: the value of code 1; what is below counts as 0
  double steps = 8;  // logarithmic: codes of an octave
  double step = 1;   // linear: value of a code
};

// Codes, one for each value. Throws std::range_error for a value beyond the last one.
std::vector<uint16_t> codes_of(const PixelMap& map);

// Adds the plane `map:NAME` and an entry of data["maps"]. With `like`, a map of the same kind that is on the page and
// mostly equal, it holds the difference from its codes, modulo 256. Throws as codes_of.
void add_map(HtmlDocument& page, const PixelMap& map, const PixelMap* like = nullptr);

// The largest difference of a channel at each pixel, what a screen shows: clamped to 0 to 1.
std::vector<double> largest_errors(const Image& a, const Image& b);

}  // namespace pipegs
