// SPDX-License-Identifier: Apache-2.0
// view_check: see view_check.hpp.
#include "scenes/check/view_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "scenes/percentile.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kSample = 20000;
constexpr std::size_t kSearched = 16;  // views of which all is asked
constexpr double kManyNear = 0.25;     // of what is in the picture; a camera within a scene has few per cent there

struct Point {
  glm::dvec3 mean;
  double reach;  // how far it reaches about its mean
};
using Points = std::vector<Point>;
// Every so many of the points.
using PointsOf = std::function<Points(std::size_t)>;

struct Seen {
  std::size_t all = 0, behind = 0, near = 0, beside = 0, inside = 0;
  std::vector<double> near_depths;
};

Seen look(const Points& points, const Camera& camera, double near_plane) {
  Seen seen;
  const double half_x = camera.width / 2.0, half_y = camera.height / 2.0;
  for (const Point& point : points) {
    ++seen.all;
    const glm::dvec3 p = camera.world_to_camera * (point.mean - camera.position);
    if (!(p.z > 0)) {
      ++seen.behind;
      continue;
    }
    const auto beyond = [&](double at, double focal, double centre, double half) {
      return std::abs(focal * at / p.z + centre + 0.5 - half) > half + focal * point.reach / p.z;
    };
    if (beyond(p.x, camera.fx, camera.cx, half_x) || beyond(p.y, camera.fy, camera.cy, half_y)) {
      ++seen.beside;
    } else if (p.z < near_plane) {
      ++seen.near;
      seen.near_depths.push_back(p.z);
    } else {
      ++seen.inside;
    }
  }
  return seen;
}

std::string why(const Seen& seen, double near_plane, const char* things) {
  std::vector<std::string> parts;
  if (seen.near > 0)
    parts.push_back(
        fmt::format("{} lie before the near plane of {:g} (half of them nearer than {:.2g}: --near, or "
                    "another unit of scene and cameras)",
                    seen.near, near_plane, percentile(seen.near_depths, 0.5)));
  if (seen.behind > 0) parts.push_back(fmt::format("{} lie behind the camera", seen.behind));
  if (seen.beside > 0) parts.push_back(fmt::format("{} beside the picture", seen.beside));
  std::string text = fmt::format("of {} {} ", seen.all, things);
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : ", ") + parts[i];
  return text;
}

Findings check(std::size_t count, const PointsOf& points_of, const char* things, std::span<const Camera> cameras,
               double near_plane) {
  Findings findings;
  std::size_t empty = 0, near = 0, searched = 0;
  std::string first_empty, first_near;
  const Points sample = points_of(count / kSample + 1);
  Points all;
  for (const Camera& camera : cameras) {
    Seen seen = look(sample, camera, near_plane);
    if (seen.inside == 0 && count > kSample && searched++ < kSearched) {
      if (all.empty()) all = points_of(1);
      seen = look(all, camera, near_plane);
    }
    if (seen.all == 0) return findings;  // the scene itself has nothing to show
    if (seen.inside == 0) {
      if (empty++ == 0)
        first_empty = fmt::format("view '{}' shows nothing: {}", camera.name, why(seen, near_plane, things));
    } else if (static_cast<double>(seen.near) > kManyNear * static_cast<double>(seen.near + seen.inside)) {
      if (near++ == 0)
        first_near = fmt::format(
            "view '{}' leaves out {} of {} {} that lie in its picture before the near plane of {:g} "
            "(--near, or another unit of scene and cameras)",
            camera.name, seen.near, seen.near + seen.inside, things, near_plane);
    }
  }
  const auto add = [&](const char* key, const std::string& text, std::size_t views) {
    if (views == 0) return;
    findings.emplace_back(
        key, cameras.size() == 1 ? text : fmt::format("{} of {} views, the first: {}", views, cameras.size(), text));
  };
  add("empty_view", first_empty, empty);
  add("near_plane", first_near, near);
  return findings;
}

}  // namespace

Findings check_views(const Scene& scene, std::span<const Camera> cameras, double near_plane) {
  const auto points_of = [&](std::size_t step) {
    Points points;
    for (std::size_t i = 0; i < scene.gaussians.size(); i += step) {
      ActivatedGaussian g;
      if (activate(scene, i, g) == Cull::kNone)
        points.push_back({g.mean, 3 * std::max({g.scale.x, g.scale.y, g.scale.z})});
    }
    return points;
  };
  return check(scene.gaussians.size(), points_of, "Gaussians", cameras, near_plane);
}

Findings check_views(const std::vector<glm::dvec3>& points, std::span<const Camera> cameras, double near_plane) {
  const auto points_of = [&](std::size_t step) {
    Points chosen;
    for (std::size_t i = 0; i < points.size(); i += step) chosen.push_back({points[i], 0});
    return chosen;
  };
  return check(points.size(), points_of, "points", cameras, near_plane);
}

}  // namespace pipegs
