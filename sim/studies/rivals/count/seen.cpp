// SPDX-License-Identifier: Apache-2.0
// seen.cpp: see seen.hpp.
//
// Idea    The shorter eigenvalue is det / longer, as the projection's det has no cancellation. Of the two ways to write
//         the longer eigenvector the one without cancellation is taken; a round covariance has its axes along x and y.
#include "sim/studies/rivals/count/seen.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cpp_model/float/parallel.hpp"
#include "sim/studies/rivals/count/cover.hpp"

namespace pipegs {
namespace {

constexpr size_t kBlock = 8192;  // Gaussians that a thread projects at a time

double longer_variance(double a, double b, double c) { return 0.5 * (a + c) + std::hypot(0.5 * (a - c), b); }

SeenGaussian seen_of(const TruthProjection& p, const Camera& camera) {
  SeenGaussian s;
  s.mean = p.mean;
  s.conic = p.conic;
  s.variance_x = p.a, s.variance_y = p.c;
  s.opacity = p.opacity, s.depth = p.depth;
  s.least_power = -std::log(255 * p.opacity) - 1e-9;
  s.radius = inria_radius(p);
  const double longer = longer_variance(p.a, p.b, p.c);
  s.half_long = 3 * std::sqrt(longer), s.half_short = 3 * std::sqrt(p.det / longer);
  const glm::dvec2 direction = p.a >= p.c ? glm::dvec2(longer - p.c, p.b) : glm::dvec2(p.b, longer - p.a);
  const double length = glm::length(direction);
  if (length > 0) s.axis = direction / length;
  const PixelRect reach = footprint(p, camera, Semantics::kExact);
  if (!reach.empty()) s.reach = reach;
  return s;
}

bool in_any_tile(const SeenGaussian& s, const Camera& camera) {
  if (!s.reach.empty()) return true;
  return std::any_of(kListSides.begin(), kListSides.end(),
                     [&](int side) { return !square_tiles(s, TileGrid(camera, side)).empty(); });
}

}  // namespace

double three_sigma(double a, double b, double c) { return 3 * std::sqrt(longer_variance(a, b, c)); }

std::vector<SeenGaussian> see(const Scene& scene, const Camera& camera, const CountOptions& options) {
  const ProjectionOptions projection{Semantics::kExact, options.near_plane, scene.antialiased, 0};
  const size_t count = scene.gaussians.size(), blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::vector<SeenGaussian>> found(blocks);
  parallel_for(blocks, options.threads, [&](size_t b) {
    for (size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i) {
      ActivatedGaussian gaussian;
      if (activate(scene, i, gaussian) != Cull::kNone) continue;
      const TruthProjection p = project_truth(gaussian, scene.gaussians[i].sh_dc, nullptr, 0, camera, projection);
      if (!p.visible) continue;
      SeenGaussian s = seen_of(p, camera);
      s.index = static_cast<uint32_t>(i);
      if (in_any_tile(s, camera)) found[b].push_back(s);
    }
  });
  std::vector<SeenGaussian> seen;
  for (const std::vector<SeenGaussian>& block : found) seen.insert(seen.end(), block.begin(), block.end());
  std::sort(seen.begin(), seen.end(), [](const SeenGaussian& a, const SeenGaussian& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.index < b.index;
  });
  return seen;
}

}  // namespace pipegs
