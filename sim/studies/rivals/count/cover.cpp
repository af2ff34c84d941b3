// SPDX-License-Identifier: Apache-2.0
// cover.cpp: see cover.hpp.
//
// Idea    Ends of a row's span are estimated from the ellipse and settled by alpha itself, pixel by pixel: so spans are
//         the pixels that blending sees, and take a few exponentials instead of one a pixel.
#include "sim/studies/rivals/count/cover.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pipegs {
namespace {

constexpr double kMargin = 1e-6;  // of the estimate, for rounding

// Truncates toward 0, as INRIA's (int) does.
int tile_number(double edge, int side, int count) {
  return static_cast<int>(std::clamp(edge / side, 0.0, static_cast<double>(count)));
}

bool axis_box_touches(const SeenGaussian& s, const glm::dvec2& middle, double half) {
  return std::abs(s.mean.x - middle.x) <= half + 3 * std::sqrt(s.variance_x) &&
         std::abs(s.mean.y - middle.y) <= half + 3 * std::sqrt(s.variance_y);
}

}  // namespace

void TileSet::clear(const PixelRect& tiles) {
  tiles_ = tiles.empty() ? PixelRect{} : tiles;
  in_.assign(static_cast<size_t>(tiles_.x1 - tiles_.x0) * static_cast<size_t>(tiles_.y1 - tiles_.y0), 0);
}

uint64_t TileSet::count() const { return std::accumulate(in_.begin(), in_.end(), uint64_t{0}); }

double alpha_at(const SeenGaussian& s, int x, int y) {
  const double power = power_at(s.conic, s.mean.x - x, s.mean.y - y);
  if (!(power >= s.least_power)) return 0;
  const double alpha = std::min(kMaxAlpha, s.opacity * std::exp(std::min(power, 0.0)));
  return alpha < kMinAlpha ? 0 : alpha;
}

PixelSpan reached_span(const SeenGaussian& s, int y, const PixelSpan& limits) {
  const double dy = s.mean.y - y;
  const double left = -2 * s.least_power + kMargin - dy * dy / s.variance_y;
  if (!(left >= 0)) return {};
  const double middle = s.mean.x + s.conic.y * dy / s.conic.x;
  const double half = std::sqrt(left / s.conic.x) * (1 + kMargin) + kMargin;
  const auto pixel = [&](double x) {
    return static_cast<int>(std::clamp(x, static_cast<double>(limits.x0), static_cast<double>(limits.x1)));
  };
  const auto reached = [&](int x) { return alpha_at(s, x, y) > 0; };
  PixelSpan span{pixel(std::ceil(middle - half)), pixel(std::floor(middle + half) + 1)};
  while (!span.empty() && !reached(span.x0)) ++span.x0;
  while (!span.empty() && !reached(span.x1 - 1)) --span.x1;
  if (span.empty()) return {};
  while (span.x0 > limits.x0 && reached(span.x0 - 1)) --span.x0;
  while (span.x1 < limits.x1 && reached(span.x1)) ++span.x1;
  return span;
}

void reached_spans(const SeenGaussian& s, std::vector<PixelSpan>& spans) {
  spans.clear();
  for (int y = s.reach.y0; y < s.reach.y1; ++y) spans.push_back(reached_span(s, y, {s.reach.x0, s.reach.x1}));
}

PixelRect square_tiles(const SeenGaussian& s, const TileGrid& grid) {
  const int side = grid.side;
  return {tile_number(s.mean.x - s.radius, side, grid.columns), tile_number(s.mean.y - s.radius, side, grid.rows),
          tile_number(s.mean.x + s.radius + side - 1, side, grid.columns),
          tile_number(s.mean.y + s.radius + side - 1, side, grid.rows)};
}

// Two rectangles are apart iff they are along an axis of one of them.
bool box_touches(const SeenGaussian& s, const glm::dvec2& middle, double half) {
  const glm::dvec2 d = s.mean - middle, u = s.axis, v = {-u.y, u.x};
  const double l = s.half_long, h = s.half_short;
  const double tile = half * (std::abs(u.x) + std::abs(u.y));
  return std::abs(d.x) <= half + l * std::abs(u.x) + h * std::abs(v.x) &&
         std::abs(d.y) <= half + l * std::abs(u.y) + h * std::abs(v.y) && std::abs(glm::dot(d, u)) <= l + tile &&
         std::abs(glm::dot(d, v)) <= h + tile;
}

void covered(const SeenGaussian& s, const std::vector<PixelSpan>& spans, const TileGrid& grid, Cover cover,
             TileSet& set) {
  const int side = grid.side;
  if (cover == Cover::kExact) {
    const PixelRect& r = s.reach;
    set.clear({r.x0 / side, r.y0 / side, (r.x1 + side - 1) / side, (r.y1 + side - 1) / side});
    for (size_t row = 0; row < spans.size(); ++row) {
      if (spans[row].empty()) continue;
      const int y = (r.y0 + static_cast<int>(row)) / side;
      for (int x = spans[row].x0 / side; x <= (spans[row].x1 - 1) / side; ++x) set.add(x, y);
    }
    return;
  }
  set.clear(square_tiles(s, grid));
  const PixelRect tiles = set.tiles();
  const double half = half_of(side);
  for (int y = tiles.y0; y < tiles.y1; ++y) {
    for (int x = tiles.x0; x < tiles.x1; ++x) {
      const glm::dvec2 middle = middle_of(side, x, y);
      if (cover == Cover::kSquare || (cover == Cover::kAxis && axis_box_touches(s, middle, half)) ||
          (cover == Cover::kOriented && box_touches(s, middle, half)))
        set.add(x, y);
    }
  }
}

}  // namespace pipegs
