// SPDX-License-Identifier: Apache-2.0
// pixel_map.cpp: see pixel_map.hpp.
#include "sim/report/html/frame/pixel_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pipegs {
namespace {

uint16_t code_of(const PixelMap& map, double value) {
  double code = value / map.step;
  if (map.logarithmic) code = value < map.low ? 0 : 1 + map.steps * std::log2(value / map.low);
  if (!(code > -0.5 && code < 65535.5))
    throw std::range_error(fmt::format("map {}: {} is beyond its codes", map.name, value));
  return static_cast<uint16_t>(std::lround(code));
}

}  // namespace

std::vector<uint16_t> codes_of(const PixelMap& map) {
  std::vector<uint16_t> codes;
  codes.reserve(map.values.size());
  for (const double value : map.values) codes.push_back(code_of(map, value));
  return codes;
}

void add_map(HtmlDocument& page, const PixelMap& map, const PixelMap* like) {
  std::vector<uint16_t> codes = codes_of(map);
  const uint16_t most = codes.empty() ? uint16_t{0} : *std::max_element(codes.begin(), codes.end());
  if (like != nullptr) {
    const std::vector<uint16_t> base = codes_of(*like);
    for (size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<uint8_t>(codes[i] - base.at(i));
  }
  const std::string plane = "map:" + map.name;
  if (like != nullptr || most < 256) {
    page.add_plane(plane, map.width, map.height, 1, std::vector<uint8_t>(codes.begin(), codes.end()));
  } else {
    page.add_plane(plane, map.width, map.height, codes);
  }
  page.data["maps"].push_back({{"name", map.name},
                               {"title", map.title},
                               {"unit", map.unit},
                               {"what", map.what},
                               {"cell", map.cell},
                               {"logarithmic", map.logarithmic},
                               {"low", map.low},
                               {"steps", map.steps},
                               {"step", map.step},
                               {"most", most}});
  if (like != nullptr) page.data["maps"].back()["less"] = "map:" + like->name;
}

std::vector<double> largest_errors(const Image& a, const Image& b) {
  std::vector<double> errors;
  errors.reserve(a.rgb.size());
  for (size_t i = 0; i < a.rgb.size(); ++i) {
    const glm::dvec3 difference = glm::abs(glm::clamp(a.rgb[i], 0.0, 1.0) - glm::clamp(b.rgb.at(i), 0.0, 1.0));
    errors.push_back(std::max({difference.x, difference.y, difference.z}));
  }
  return errors;
}

}  // namespace pipegs
