// SPDX-License-Identifier: Apache-2.0
// brute.cpp: see brute.hpp.
#include "sim/studies/rivals/test/brute.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "cpp_model/float/projection.hpp"

namespace pipegs {
namespace {

using Polygon = std::vector<glm::dvec2>;
using Tile = std::pair<int, int>;

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

bool touches(Polygon polygon, double x0, double y0, double side) {
  polygon = clip(polygon, 0, x0, 1);
  polygon = clip(polygon, 0, x0 + side - 1, -1);
  polygon = clip(polygon, 1, y0, 1);
  return !clip(polygon, 1, y0 + side - 1, -1).empty();
}

class Brute {
 public:
  Brute(const Scene& scene, const Camera& camera, const CountOptions& options)
      : scene_(scene), camera_(camera), options_(options) {}

  FrameCounts run() {
    out_.width = camera_.width, out_.height = camera_.height;
    shapes();
    lists();
    walk();
    for (const double edge : options_.voxels) out_.voxels.push_back(voxels(edge));
    return out_;
  }

 private:
  int columns(int side) const { return (camera_.width + side - 1) / side; }
  int rows(int side) const { return (camera_.height + side - 1) / side; }
  double alpha(const Shape& s, int x, int y) const {
    return s.alpha[static_cast<size_t>(y) * static_cast<size_t>(camera_.width) + static_cast<size_t>(x)];
  }

  void shapes() {
    for (size_t i = 0; i < scene_.gaussians.size(); ++i) {
      ++out_.scene;
      ActivatedGaussian gaussian;
      if (activate(scene_, i, gaussian) != Cull::kNone) continue;
      Shape s{project_truth(gaussian, scene_.gaussians[i].sh_dc, nullptr, 0, camera_,
                            {Semantics::kExact, options_.near_plane, scene_.antialiased, 0}),
              {},
              {},
              i};
      if (!s.p.visible) continue;
      for (int y = 0; y < camera_.height; ++y) {
        for (int x = 0; x < camera_.width; ++x) {
          const double power = std::min(0.0, power_at(s.p.conic, s.p.mean.x - x, s.p.mean.y - y));
          const double a = std::min(0.99, s.p.opacity * std::exp(power));
          s.alpha.push_back(a >= 1.0 / 255 ? a : 0);
        }
      }
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
    const double ex = 3 * std::sqrt(s.p.a), ey = 3 * std::sqrt(s.p.c);
    const Polygon axis_box = {s.p.mean + glm::dvec2(ex, ey), s.p.mean + glm::dvec2(-ex, ey),
                              s.p.mean - glm::dvec2(ex, ey), s.p.mean + glm::dvec2(ex, -ey)};
    switch (cover) {
      case Cover::kSquare: return in_square(s, side, x, y);
      case Cover::kAxis: return in_square(s, side, x, y) && touches(axis_box, x * side, y * side, side);
      case Cover::kOriented: return in_square(s, side, x, y) && touches(s.box, x * side, y * side, side);
      case Cover::kExact: break;
    }
    for (int py = y * side; py < std::min(camera_.height, (y + 1) * side); ++py) {
      for (int px = x * side; px < std::min(camera_.width, (x + 1) * side); ++px) {
        if (alpha(s, px, py) > 0) return true;
      }
    }
    return false;
  }

  std::set<Tile> tiles(const Shape& s, Cover cover, int side) const {
    std::set<Tile> found;
    for (int y = 0; y < rows(side); ++y) {
      for (int x = 0; x < columns(side); ++x) {
        if (covers(s, cover, side, x, y)) found.insert({x, y});
      }
    }
    return found;
  }

  void lists() {
    std::set<Tile> before;
    for (size_t side = 0; side < kListSides.size(); ++side) {
      ListCounts& lists = out_.lists[side];
      lists.side = kListSides[side], lists.columns = columns(lists.side), lists.rows = rows(lists.side);
      for (const Cover cover : kAllCovers)
        lists.lengths[cover].resize(static_cast<size_t>(lists.columns) * static_cast<size_t>(lists.rows));
    }
    for (const Shape& s : shapes_) {
      for (ListCounts& lists : out_.lists) {
        for (const Cover cover : kAllCovers) {
          for (const auto& [x, y] : tiles(s, cover, lists.side))
            ++lists.lengths[cover][static_cast<size_t>(y * lists.columns + x)];
        }
      }
      for (const Cover cover : kAllCovers) out_.listed[cover] += !tiles(s, cover, 16).empty();
      const std::set<Tile> oriented = tiles(s, Cover::kOriented, 16);
      if (oriented.empty()) continue;
      if (!before.empty()) {
        out_.neighbours.tiles += oriented.size();
        for (const Tile& tile : oriented) out_.neighbours.shared += before.count(tile);
      }
      before = oriented;
    }
  }

  struct TileState {
    int x0, y0, x1, y1;            // pixels of the image
    std::map<Tile, double> alive;  // transmittance of those that have not stopped
  };

  // Parts of so many pixels that have one alive and are touched by the box, or hold a pixel that counts.
  uint64_t parts(const Shape& s, const TileState& t, int side, bool boxed) const {
    uint64_t count = 0;
    for (int y0 = t.y0; y0 < t.y0 + 16; y0 += side) {
      for (int x0 = t.x0; x0 < t.x0 + 16; x0 += side) {
        bool alive = false, reached = false;
        for (int y = y0; y < std::min(y0 + side, t.y1); ++y) {
          for (int x = x0; x < std::min(x0 + side, t.x1); ++x) {
            alive = alive || t.alive.count({x, y}) != 0;
            reached = reached || alpha(s, x, y) > 0;
          }
        }
        count += alive && (boxed ? touches(s.box, x0, y0, side) : reached);
      }
    }
    return count;
  }

  void blend(const Shape& s, TileState& t) const {
    for (auto pixel = t.alive.begin(); pixel != t.alive.end();) {
      const double a = alpha(s, pixel->first.first, pixel->first.second), next = pixel->second * (1 - a);
      if (a > 0 && next < 1e-4) {
        pixel = t.alive.erase(pixel);
      } else {
        pixel->second = next;
        ++pixel;
      }
    }
  }

  TileState tile_state(int x, int y) const {
    TileState t{16 * x, 16 * y, std::min(16 * x + 16, camera_.width), std::min(16 * y + 16, camera_.height), {}};
    for (int py = t.y0; py < t.y1; ++py) {
      for (int px = t.x0; px < t.x1; ++px) t.alive[{px, py}] = 1;
    }
    return t;
  }

  void walk() {
    for (int y = 0; y < rows(16); ++y) {
      for (int x = 0; x < columns(16); ++x) {
        TileState t = tile_state(x, y);
        TileCounts& counts = out_.tiles.emplace_back();
        double& stop = stop_depth_[{x, y}] = std::numeric_limits<double>::infinity();
        for (const Shape& s : shapes_) {
          if (t.alive.empty()) break;
          for (const Cover cover : kAllCovers) counts.open[cover] += covers(s, cover, 16, x, y);
          if (covers(s, Cover::kOriented, 16, x, y)) counts.oriented_8x8 += parts(s, t, 8, true);
          counts.exact_8x8 += parts(s, t, 8, false);
          counts.exact_4x4 += parts(s, t, 4, false);
          blend(s, t);
          if (t.alive.empty()) stop = s.p.depth;
        }
      }
    }
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
  bool coarse(const ActivatedGaussian& gaussian, int x, int y) const {
    const double scale = std::max({gaussian.scale.x, gaussian.scale.y, gaussian.scale.z});
    const glm::dvec3 view = camera_.world_to_camera * (gaussian.mean - camera_.position);
    if (!(view.z > options_.near_plane)) return false;
    const double wide = 1.3 * camera_.width / (2 * camera_.fx), high = 1.3 * camera_.height / (2 * camera_.fy);
    const double tx = std::clamp(view.x / view.z, -wide, wide), ty = std::clamp(view.y / view.z, -high, high);
    const double sx = scale * camera_.fx / view.z, sy = scale * camera_.fy / view.z;
    const double a = sx * sx * (1 + tx * tx) + 0.3, b = sx * sy * tx * ty, c = sy * sy * (1 + ty * ty) + 0.3;
    const double radius = 3 * std::sqrt((a + c) / 2 + std::sqrt((a - c) * (a - c) / 4 + b * b));
    const glm::dvec2 mean(camera_.fx * view.x / view.z + camera_.cx, camera_.fy * view.y / view.z + camera_.cy);
    const glm::dvec2 low(x * kGroupSide, y * kGroupSide), high_corner = low + (kGroupSide - 1.0);
    return glm::length(glm::clamp(mean, low, high_corner) - mean) <= radius;
  }

  VoxelCounts voxels(double edge) const {
    std::map<std::tuple<int, int, int>, std::vector<size_t>> members;
    for (size_t i = 0; i < scene_.gaussians.size(); ++i) {
      ActivatedGaussian gaussian;
      if (activate(scene_, i, gaussian) != Cull::kNone) continue;
      const auto number = [&](int axis) { return static_cast<int>(std::floor(gaussian.mean[axis] / edge)); };
      members[{number(0), number(1), number(2)}].push_back(i);
    }
    VoxelCounts counts;
    for (int y = 0; y < rows(kGroupSide); ++y) {
      for (int x = 0; x < columns(kGroupSide); ++x) {
        FilterCounts& group = counts.groups.emplace_back();
        for (const auto& [key, inside] : members) {
          const glm::dvec3 low = edge * glm::dvec3(std::get<0>(key), std::get<1>(key), std::get<2>(key));
          if (nearest(low, edge) > group_stop(x, y) || !group_meets(low, edge, x, y)) continue;
          ++group.voxels;
          for (const size_t i : inside) pass(i, x, y, group);
        }
      }
    }
    return counts;
  }

  double nearest(const glm::dvec3& low, double edge) const {
    double least = std::numeric_limits<double>::infinity();
    for (const double x : {0.0, edge})
      for (const double y : {0.0, edge})
        for (const double z : {0.0, edge}) {
          const glm::dvec3 corner = low + glm::dvec3(x, y, z) - camera_.position;
          least = std::min(least, (camera_.world_to_camera * corner).z);
        }
    return least;
  }

  bool group_meets(const glm::dvec3& low, double edge, int x, int y) const {
    for (int py = y * kGroupSide; py < std::min(camera_.height, (y + 1) * kGroupSide); ++py) {
      for (int px = x * kGroupSide; px < std::min(camera_.width, (x + 1) * kGroupSide); ++px) {
        if (ray_meets(low, edge, px, py)) return true;
      }
    }
    return false;
  }

  double group_stop(int x, int y) const {
    double stop = 0;
    for (const auto& [tile, depth] : stop_depth_) {
      if (16 * tile.first / kGroupSide == x && 16 * tile.second / kGroupSide == y) stop = std::max(stop, depth);
    }
    return stop;
  }

  void pass(size_t i, int x, int y, FilterCounts& group) const {
    ++group.fetched;
    ActivatedGaussian gaussian;
    activate(scene_, i, gaussian);
    if (!coarse(gaussian, x, y)) return;
    ++group.coarse;
    const auto shape = std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& s) { return s.index == i; });
    group.fine += shape != shapes_.end() && covers(*shape, Cover::kExact, kGroupSide, x, y);
  }

  const Scene& scene_;
  const Camera& camera_;
  const CountOptions& options_;
  std::vector<Shape> shapes_;  // in front, in depth order
  std::map<Tile, double> stop_depth_;
  FrameCounts out_;
};

}  // namespace

FrameCounts brute_counts(const Scene& scene, const Camera& camera, const CountOptions& options) {
  return Brute(scene, camera, options).run();
}

}  // namespace pipegs
