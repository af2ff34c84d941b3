// SPDX-License-Identifier: Apache-2.0
// brute.cpp: see brute.hpp.
#include "sim/studies/rivals/test/brute.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

using Polygon = std::vector<glm::dvec2>;
using Place = std::pair<int, int>;  // of a pixel or tile: its column and row

struct Shape {
  TruthProjection p;
  std::vector<double> alpha;  // of each pixel, 0 below 1/255
  Polygon box;
  size_t index;
};

// The part of a polygon where sign * (coordinate - limit) >= 0.
Polygon clip(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon rest;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - limit), db = sign * (b[axis] - limit);
    if (da >= 0) rest.push_back(a);
    if ((da < 0) != (db < 0)) rest.push_back(a + (b - a) * (da / (da - db)));
  }
  return rest;
}

// Whether a polygon touches the centres' square of tile (x, y) of this side.
bool touches(Polygon polygon, int side, int x, int y) {
  polygon = clip(polygon, 0, x * side, 1);
  polygon = clip(polygon, 0, x * side + side - 1, -1);
  polygon = clip(polygon, 1, y * side, 1);
  return !clip(polygon, 1, y * side + side - 1, -1).empty();
}

class Brute {
 public:
  Brute(const Scene& scene, const Camera& camera, const CountOptions& options)
      : scene_(scene), camera_(camera), options_(options) {}

  FrameCounts run() {
    out_.width = camera_.width, out_.height = camera_.height, out_.scene = scene_.gaussians.size();
    shapes();
    lists();
    neighbours();
    each_tile(16, [&](int x, int y) { walk(x, y); });
    for (const double edge : options_.voxels) out_.voxels.push_back(voxels(edge));
    return out_;
  }

 private:
  int columns(int side) const { return (camera_.width + side - 1) / side; }
  int rows(int side) const { return (camera_.height + side - 1) / side; }
  template <class Action>
  void each_tile(int side, const Action& action) const {
    for (int y = 0; y < rows(side); ++y) {
      for (int x = 0; x < columns(side); ++x) action(x, y);
    }
  }
  // Whether a pixel of the image in tile (x, y) of this side passes.
  template <class Test>
  bool any_pixel(int side, int x, int y, const Test& test) const {
    for (int py = y * side; py < std::min(camera_.height, (y + 1) * side); ++py) {
      for (int px = x * side; px < std::min(camera_.width, (x + 1) * side); ++px) {
        if (test(px, py)) return true;
      }
    }
    return false;
  }
  double alpha(const Shape& s, int x, int y) const { return s.alpha[static_cast<size_t>(y * camera_.width + x)]; }

  TruthProjection project(const ActivatedGaussian& gaussian, size_t i, bool antialiased) const {
    return project_truth(gaussian, scene_.gaussians[i].sh_dc, nullptr, 0, camera_,
                         {Semantics::kExact, options_.near_plane, antialiased, 0});
  }

  void shapes() {
    for (size_t i = 0; i < scene_.gaussians.size(); ++i) {
      ActivatedGaussian gaussian;
      if (activate(scene_, i, gaussian) != Cull::kNone) continue;
      Shape s{project(gaussian, i, scene_.antialiased), {}, {}, i};
      if (!s.p.visible) continue;
      each_tile(1, [&](int x, int y) {
        const double power = std::min(0.0, power_at(s.p.conic, s.p.mean.x - x, s.p.mean.y - y));
        const double a = std::min(0.99, s.p.opacity * std::exp(power));
        s.alpha.push_back(a >= 1.0 / 255 ? a : 0);
      });
      const double angle = 0.5 * std::atan2(2 * s.p.b, s.p.a - s.p.c);
      const glm::dvec2 u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
      const auto along = [&](const glm::dvec2& w) {
        return 3 * std::sqrt(w.x * w.x * s.p.a + 2 * w.x * w.y * s.p.b + w.y * w.y * s.p.c) * w;
      };
      s.box = {s.p.mean + along(u) + along(v), s.p.mean - along(u) + along(v), s.p.mean - along(u) - along(v),
               s.p.mean + along(u) - along(v)};
      shapes_.push_back(s);
    }
    std::stable_sort(shapes_.begin(), shapes_.end(),
                     [](const Shape& a, const Shape& b) { return a.p.depth < b.p.depth; });
  }

  // INRIA's getRect, by its own integers.
  bool in_square(const Shape& s, int side, int x, int y) const {
    const double middle = 0.5 * (s.p.a + s.p.c);
    const int radius =
        static_cast<int>(std::ceil(3 * std::sqrt(middle + std::sqrt(std::max(0.1, middle * middle - s.p.det)))));
    const auto in = [&](double mean, int number, int count) {
      const int low = std::min(count, std::max(0, static_cast<int>((mean - radius) / side)));
      const int high = std::min(count, std::max(0, static_cast<int>((mean + radius + side - 1) / side)));
      return number >= low && number < high;
    };
    return in(s.p.mean.x, x, columns(side)) && in(s.p.mean.y, y, rows(side));
  }

  bool covers(const Shape& s, Cover cover, int side, int x, int y) const {
    if (cover == Cover::kExact) return any_pixel(side, x, y, [&](int px, int py) { return alpha(s, px, py) > 0; });
    const double ex = 3 * std::sqrt(s.p.a), ey = 3 * std::sqrt(s.p.c);
    const Polygon axis_box = {s.p.mean + glm::dvec2(ex, ey), s.p.mean + glm::dvec2(-ex, ey),
                              s.p.mean - glm::dvec2(ex, ey), s.p.mean + glm::dvec2(ex, -ey)};
    return in_square(s, side, x, y) &&
           (cover == Cover::kSquare || touches(cover == Cover::kAxis ? axis_box : s.box, side, x, y));
  }

  void lists() {
    for (size_t i = 0; i < kListSides.size(); ++i) {
      ListCounts& lists = out_.lists[i];
      const int side = lists.side = kListSides[i];
      lists.columns = columns(side), lists.rows = rows(side);
      for (const Cover cover : kAllCovers) {
        each_tile(side, [&](int x, int y) {
          const auto in = [&](const Shape& s) { return covers(s, cover, side, x, y); };
          lists.lengths[cover].push_back(static_cast<uint32_t>(std::count_if(shapes_.begin(), shapes_.end(), in)));
        });
      }
    }
  }

  void neighbours() {
    std::set<Place> before;
    for (const Shape& s : shapes_) {
      ByCover<std::set<Place>> tiles;
      for (const Cover cover : kAllCovers) {
        each_tile(16, [&](int x, int y) {
          if (covers(s, cover, 16, x, y)) tiles[cover].insert({x, y});
        });
        out_.listed[cover] += !tiles[cover].empty();
      }
      if (tiles.oriented.empty()) continue;
      if (!before.empty()) out_.neighbours.tiles += tiles.oriented.size();
      for (const Place& tile : tiles.oriented) out_.neighbours.shared += before.count(tile);
      before = tiles.oriented;
    }
  }

  void walk(int x, int y) {
    std::map<Place, double> alive;  // transmittance of the pixels that have not stopped
    any_pixel(16, x, y, [&](int px, int py) { return alive[{px, py}] = 1, false; });
    // Parts of this side that have a pixel alive and are touched.
    const auto parts = [&](int side, const auto& touched) {
      const int per_tile = 16 / side;
      uint64_t count = 0;
      for (int i = 0; i < per_tile * per_tile; ++i) {
        const int px = x * per_tile + i % per_tile, py = y * per_tile + i / per_tile;
        count += any_pixel(side, px, py, [&](int a, int b) { return alive.contains({a, b}); }) && touched(px, py);
      }
      return count;
    };
    TileCounts& counts = out_.tiles.emplace_back();
    double stop = std::numeric_limits<double>::infinity();
    for (const Shape& s : shapes_) {
      if (alive.empty()) break;
      for (const Cover cover : kAllCovers) counts.open[cover] += covers(s, cover, 16, x, y);
      if (covers(s, Cover::kOriented, 16, x, y))
        counts.oriented_8x8 += parts(8, [&](int px, int py) { return touches(s.box, 8, px, py); });
      counts.exact_8x8 += parts(8, [&](int px, int py) { return covers(s, Cover::kExact, 8, px, py); });
      counts.exact_4x4 += parts(4, [&](int px, int py) { return covers(s, Cover::kExact, 4, px, py); });
      for (auto& [pixel, transmittance] : alive) {
        const double a = alpha(s, pixel.first, pixel.second), next = transmittance * (1 - a);
        transmittance = a > 0 && next < 1e-4 ? 0 : next;
      }
      std::erase_if(alive, [](const auto& pixel) { return pixel.second == 0; });
      if (alive.empty()) stop = s.p.depth;
    }
    double& group = group_stop_[{16 * x / kGroupSide, 16 * y / kGroupSide}];
    group = std::max(group, stop);
  }

  // A ray from the near plane on passes through a box iff it begins inside or comes through a face.
  bool ray_meets(const glm::dvec3& low, double edge, int x, int y) const {
    const glm::dvec3 ray = glm::transpose(camera_.world_to_camera) *
                           glm::dvec3((x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1);
    const auto inside = [&](double t, int but) {
      const glm::dvec3 at = camera_.position + t * ray;
      for (int axis = 0; axis < 3; ++axis) {
        if (axis != but && !(at[axis] >= low[axis] && at[axis] <= low[axis] + edge)) return false;
      }
      return true;
    };
    if (inside(options_.near_plane, -1)) return true;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double face : {low[axis], low[axis] + edge}) {
        const double t = (face - camera_.position[axis]) / ray[axis];
        if (std::isfinite(t) && t >= options_.near_plane && inside(t, axis)) return true;
      }
    }
    return false;
  }

  // Whether the circle of a ball of the largest scale touches a group.
  bool coarse(ActivatedGaussian gaussian, size_t i, int x, int y) const {
    gaussian.scale = glm::dvec3(std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z}));
    const TruthProjection ball = project(gaussian, i, false);
    const double longer = (ball.a + ball.c) / 2 + std::sqrt(std::pow((ball.a - ball.c) / 2, 2) + ball.b * ball.b);
    const glm::dvec2 low(x * kGroupSide, y * kGroupSide), high = low + (kGroupSide - 1.0);
    return ball.visible && glm::distance(glm::clamp(ball.mean, low, high), ball.mean) <= 3 * std::sqrt(longer);
  }

  VoxelCounts voxels(double edge) const {
    std::map<std::vector<int>, std::vector<size_t>> members;
    std::vector<ActivatedGaussian> gaussians(scene_.gaussians.size());
    for (size_t i = 0; i < gaussians.size(); ++i) {
      if (activate(scene_, i, gaussians[i]) != Cull::kNone) continue;
      const auto number = [&](int axis) { return static_cast<int>(std::floor(gaussians[i].mean[axis] / edge)); };
      members[{number(0), number(1), number(2)}].push_back(i);
    }
    VoxelCounts counts;
    each_tile(kGroupSide, [&](int x, int y) {
      FilterCounts& group = counts.groups.emplace_back();
      for (const auto& [key, inside] : members) {
        const glm::dvec3 low = edge * glm::dvec3(key[0], key[1], key[2]);
        const auto meets = [&](int px, int py) { return ray_meets(low, edge, px, py); };
        if (nearest(low, edge) > group_stop_.at({x, y}) || !any_pixel(kGroupSide, x, y, meets)) continue;
        ++group.voxels;
        group.fetched += inside.size();
        for (const size_t i : inside) {
          if (!coarse(gaussians[i], i, x, y)) continue;
          ++group.coarse;
          group.fine += std::ranges::any_of(
              shapes_, [&](const Shape& s) { return s.index == i && covers(s, Cover::kExact, kGroupSide, x, y); });
        }
      }
    });
    return counts;
  }

  double nearest(const glm::dvec3& low, double edge) const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 corner = low + edge * glm::dvec3(i % 2, i / 2 % 2, i / 4);
      least = std::min(least, (camera_.world_to_camera * (corner - camera_.position)).z);
    }
    return least;
  }

  const Scene& scene_;
  const Camera& camera_;
  const CountOptions& options_;
  std::vector<Shape> shapes_;           // in front, in depth order
  std::map<Place, double> group_stop_;  // the depth at which its last pixel stops
  FrameCounts out_;
};

}  // namespace

FrameCounts brute_counts(const Scene& scene, const Camera& camera, const CountOptions& options) {
  return Brute(scene, camera, options).run();
}

}  // namespace pipegs
