// SPDX-License-Identifier: Apache-2.0
// pack_error: see pack_error.hpp.
#include "cpp_model/pack/pack_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

constexpr double kShBand0 = 0.28209479177387814;
constexpr double kReach = 3.33;    // standard deviations at which an opaque Gaussian's alpha is 1/255
constexpr int kFinest = 128;       // pixels along the widest extent
constexpr int kCoarsest = 8;       // widest extents in a pixel
constexpr double kPoint = 1e-100;  // scene units; what is no wider is one
constexpr int kSteps = 2;          // halvings of an octave, to find where the loss passes the limit

// A Gaussian seen along an axis; without low-pass filter.
struct Flat {
  double depth, x, y, xx, xy, yy, opacity;
  std::array<float, 3> color;
};

using View = std::vector<Flat>;  // the nearest first

struct Box {
  double low_x = HUGE_VAL, low_y = HUGE_VAL, high_x = -HUGE_VAL, high_y = -HUGE_VAL;
  void add(const Flat& one) {
    const double x = kReach * std::sqrt(one.xx), y = kReach * std::sqrt(one.yy);
    low_x = std::min(low_x, one.x - x), high_x = std::max(high_x, one.x + x);
    low_y = std::min(low_y, one.y - y), high_y = std::max(high_y, one.y + y);
  }
  double widest() const { return std::max(high_x - low_x, high_y - low_y); }
};

View view_along(int axis, std::span<const ActivatedGaussian> gaussians, std::span<const glm::vec3> dc) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  View view;
  view.reserve(gaussians.size());
  for (size_t i = 0; i < gaussians.size(); ++i) {
    const ActivatedGaussian& one = gaussians[i];
    const glm::dmat3 axes = rotation_matrix(one.rotation);
    Flat flat{one.mean[axis], one.mean[u], one.mean[v], 0, 0, 0, std::min(one.opacity, kMaxAlpha), {}};
    for (int k = 0; k < 3; ++k) {
      const double x = axes[k][u] * one.scale[k], y = axes[k][v] * one.scale[k];
      flat.xx += x * x, flat.xy += x * y, flat.yy += y * y;
    }
    for (int c = 0; c < 3; ++c)
      flat.color[static_cast<size_t>(c)] = static_cast<float>(std::max(0.0, kShBand0 * dc[i][c] + 0.5));
    view.push_back(flat);
  }
  std::stable_sort(view.begin(), view.end(), [](const Flat& a, const Flat& b) { return a.depth < b.depth; });
  return view;
}

struct Canvas {
  int width, height;
  std::vector<std::array<float, 4>> pixels;  // three colours, transmittance
};

// With pixels of this side, the first one's corner at the box's.
Canvas draw(const View& view, const Box& box, double pixel) {
  const double margin = kReach * std::sqrt(kDilation);
  const auto pixels = [&](double extent) { return static_cast<int>(std::ceil(extent / pixel + 2 * margin)) + 1; };
  Canvas canvas{pixels(box.high_x - box.low_x), pixels(box.high_y - box.low_y), {}};
  canvas.pixels.assign(static_cast<size_t>(canvas.width) * static_cast<size_t>(canvas.height), {0, 0, 0, 1});
  const double scale = 1 / (pixel * pixel);
  for (const Flat& one : view) {
    const double xx = one.xx * scale + kDilation, xy = one.xy * scale, yy = one.yy * scale + kDilation,
                 det = xx * yy - xy * xy, power = std::log(one.opacity * 255);
    if (!(power > 0) || !(det > 0)) continue;
    const double x = (one.x - box.low_x) / pixel + margin, y = (one.y - box.low_y) / pixel + margin,
                 reach_x = std::sqrt(2 * power * xx), reach_y = std::sqrt(2 * power * yy);
    const auto a = static_cast<float>(yy / det), b = static_cast<float>(-xy / det), c = static_cast<float>(xx / det);
    const int first_x = std::max(0, static_cast<int>(std::ceil(x - reach_x))),
              last_x = std::min(canvas.width - 1, static_cast<int>(std::floor(x + reach_x))),
              first_y = std::max(0, static_cast<int>(std::ceil(y - reach_y))),
              last_y = std::min(canvas.height - 1, static_cast<int>(std::floor(y + reach_y)));
    for (int row = first_y; row <= last_y; ++row) {
      for (int column = first_x; column <= last_x; ++column) {
        std::array<float, 4>& at = canvas.pixels[static_cast<size_t>(row * canvas.width + column)];
        const auto dx = static_cast<float>(column - x), dy = static_cast<float>(row - y);
        const float falls = 0.5f * (a * dx * dx + c * dy * dy) + b * dx * dy;
        if (falls >= static_cast<float>(power)) continue;
        const float alpha = static_cast<float>(one.opacity) * std::exp(-falls);
        for (size_t channel = 0; channel < 3; ++channel) at[channel] += alpha * at[3] * one.color[channel];
        at[3] *= 1 - alpha;
      }
    }
  }
  return canvas;
}

}  // namespace

double alike_pixel(std::span<const ActivatedGaussian> one, std::span<const glm::vec3> one_dc,
                   std::span<const ActivatedGaussian> other, std::span<const glm::vec3> other_dc, double most) {
  std::array<View, 3> ones, others;
  std::array<Box, 3> boxes;
  double widest = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    ones[axis] = view_along(static_cast<int>(axis), one, one_dc);
    others[axis] = view_along(static_cast<int>(axis), other, other_dc);
    for (const View* view : {&ones[axis], &others[axis]}) {
      for (const Flat& flat : *view) boxes[axis].add(flat);
    }
    widest = std::max(widest, boxes[axis].widest());
  }
  const auto alike = [&](double pixel) {
    double sum = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const Canvas a = draw(ones[axis], boxes[axis], pixel), b = draw(others[axis], boxes[axis], pixel);
      for (size_t i = 0; i < a.pixels.size(); ++i) {
        for (size_t channel = 0; channel < 4; ++channel) {
          const double apart = a.pixels[i][channel] - b.pixels[i][channel];
          sum += apart * apart;
        }
      }
      if (!(sum / 12 <= most)) return false;
    }
    return true;
  };
  if (!(widest > kPoint)) return alike(1) ? 1e-30 : kNeverAlike;  // a point: of any size
  double pixel = kCoarsest * widest;
  if (!alike(pixel)) return kNeverAlike;
  while (pixel > 2 * widest / kFinest && alike(pixel / 2)) pixel /= 2;
  double step = 0.5;
  for (int i = 0; i < kSteps; ++i, step /= 2) {
    const double finer = pixel * std::exp2(-step);
    if (alike(finer)) pixel = finer;
  }
  return pixel;
}

}  // namespace pipegs
