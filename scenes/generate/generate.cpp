// SPDX-License-Identifier: Apache-2.0
// generate: puts the parts of the scene together; see generate.hpp.
//
// Idea    Each part gets a share of the count; sizes follow from area per Gaussian, so a scene of
//         6,000 or 600,000 shows the same picture, coarser or finer. The grass takes what rounding
//         leaves, so the count is exact.
#include "scenes/generate/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "scenes/generate/generate_builder.hpp"

namespace pipegs {
namespace generate {
namespace {

// Coarser than what mathematical libraries disagree about, finer than what can be seen.
float on_grid(double value) { return static_cast<float>(std::round(value * 4096) / 4096); }

}  // namespace

glm::dmat3 frame_of(const glm::dvec3& normal, const glm::dvec3& tangent_hint) {
  glm::dvec3 tangent = tangent_hint - glm::dot(tangent_hint, normal) * normal;
  if (glm::dot(tangent, tangent) < 1e-12) {
    const glm::dvec3 other = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    tangent = other - glm::dot(other, normal) * normal;
  }
  tangent = glm::normalize(tangent);
  return {tangent, glm::cross(normal, tangent), normal};
}

Builder::Builder(std::uint64_t seed, std::size_t count) : random(seed), count_(count) {
  scene_.name = "generated";
  scene_.sh_degree = kMaxShDegree;
  scene_.gaussians.reserve(count);
  scene_.sh_rest.reserve(count * 45);
}

void Builder::add(const glm::dvec3& mean, const glm::dmat3& axes, const glm::dvec3& scale, double opacity,
                  ShColor color) {
  if (left() == 0) return;
  constexpr double kShNoise = 0.006;  // what training leaves in coefficients nothing asks for
  const double kept = glm::clamp(opacity, 1e-4, 0.9999);
  const glm::dquat q = glm::quat_cast(axes);
  Gaussian g;
  g.mean = glm::vec3(mean);
  for (int a = 0; a < 3; ++a) g.log_scale[a] = on_grid(std::log(scale[a]));
  g.rotation = {on_grid(q.w), on_grid(q.x), on_grid(q.y), on_grid(q.z)};
  g.opacity_logit = on_grid(std::log(kept / (1 - kept)));
  for (int c = 0; c < 3; ++c) g.sh_dc[c] = on_grid(color[0][c]);
  scene_.gaussians.push_back(g);
  for (std::size_t k = 1; k < color.size(); ++k) {
    for (int c = 0; c < 3; ++c) scene_.sh_rest.push_back(on_grid(color[k][c] + kShNoise * random.normal()));
  }
}

void Builder::surface(const glm::dvec3& mean, const glm::dmat3& axes, double size, double stretch, double solid,
                      const ShColor& color) {
  const double kind = random.uniform();
  const double spread = std::exp(0.18 * random.normal());
  const double thickness = size * 0.10 * std::exp(0.4 * random.normal());
  double opacity = 0, sigma = 0;
  if (kind < solid) {
    opacity = 1 / (1 + std::exp(-(3.4 + 0.9 * random.normal())));
    sigma = 0.56 * size * spread;
  } else if (kind < solid + 0.5 * (1 - solid)) {
    opacity = 1 / (1 + std::exp(-(0.2 + 1.0 * random.normal())));
    sigma = 0.45 * size * spread;
  } else {
    opacity = 1 / (1 + std::exp(-(-2.8 + 0.9 * random.normal())));
    sigma = 0.5 * size * spread;
  }
  add(mean, axes, {sigma * std::sqrt(stretch), sigma / std::sqrt(stretch), thickness}, opacity, color);
}

void Builder::needle(const glm::dvec3& a, const glm::dvec3& b, double width, double opacity, const ShColor& color) {
  const double length = glm::length(b - a);
  const glm::dvec3 along = (b - a) / length;
  const glm::dmat3 axes = frame_of(frame_of(along, {0.3, 0.2, 1})[0], along);
  add((a + b) * 0.5, axes, {length * 0.27, width, width * (0.5 + 0.5 * random.uniform())}, opacity, color);
}

double attention(const glm::dvec3& point) {
  constexpr double kElsewhere = 0.10, kMargin = 1.08;
  static const std::vector<Camera> cameras = generated_cameras();
  for (const Camera& camera : cameras) {
    const glm::dvec3 view = camera.world_to_camera * (point - camera.position);
    const double wide = kMargin * camera.width / (2 * camera.fx), high = kMargin * camera.height / (2 * camera.fy);
    if (view.z > 0.6 && std::abs(view.x) < wide * view.z + 0.1 && std::abs(view.y) < high * view.z + 0.1) return 1;
  }
  return kElsewhere;
}

}  // namespace generate

namespace {

// One of `parts` parts of Gaussian i.
Gaussian part_of(const Scene& scene, std::size_t i, std::size_t parts, generate::Random random) {
  Gaussian part = scene.gaussians[i];
  ActivatedGaussian parent;
  if (parts == 1 || activate(scene, i, parent) != Cull::kNone) return part;
  const glm::dquat rotation(parent.rotation[0], parent.rotation[1], parent.rotation[2], parent.rotation[3]);
  part.mean = glm::vec3(parent.mean + rotation * (parent.scale * random.normals()));
  part.log_scale -= static_cast<float>(0.5 * std::log(static_cast<double>(parts)));
  return part;
}

}  // namespace

Scene generate_scene(std::uint64_t seed, std::size_t count) {
  using namespace generate;
  Builder builder(mixed(seed + 0x5eed), count);
  add_sky(builder, builder.share(0.030));
  add_clouds(builder, builder.share(0.055));
  add_mountains(builder, builder.share(0.095));
  add_ground(builder, builder.share(0.140));
  add_trees(builder, builder.share(0.040));
  add_haze(builder, builder.share(0.002));
  add_pebbles(builder, builder.share(0.115));
  add_flowers(builder, builder.share(0.045));
  add_balls(builder, builder.share(0.105));
  add_shell(builder, builder.share(0.120));
  add_spines(builder, builder.share(0.018));
  add_motes(builder, builder.share(0.006));
  add_veil(builder, builder.share(0.080));
  add_grass(builder, builder.left());
  return builder.take();
}

std::vector<Camera> generated_cameras() {
  constexpr int kWidth = 1024, kHeight = 768;
  constexpr double kFov = 60;
  return {look_at("front", 0, kWidth, kHeight, {0.55, -1.30, -4.9}, {0.05, -1.02, 0}, kFov),
          look_at("against_the_light", 1, kWidth, kHeight, {4.3, -1.15, 1.5}, {0, -1.05, -0.15}, kFov),
          look_at("left", 2, kWidth, kHeight, {-3.6, -2.15, -3.4}, {0.1, -0.70, 0.2}, kFov)};
}

Scene split_scene(const Scene& scene, std::size_t count, int sh_degree, std::uint64_t seed) {
  check_consistent(scene);
  const std::size_t parents = scene.gaussians.size();
  if (parents == 0 || count < parents) {
    throw std::invalid_argument(
        fmt::format("split_scene: found a count of {}, expected at least one for each of {} Gaussians, and a Gaussian",
                    count, parents));
  }
  Scene out;
  out.name = scene.name;
  out.sh_degree = std::min(scene.sh_degree, sh_degree);
  out.antialiased = scene.antialiased;
  out.gaussians.reserve(count);
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(out.sh_degree));
  out.sh_rest.reserve(count * rest);
  for (std::size_t c = 0; c < count; ++c) {
    const std::size_t i = c % parents, parts = (count - i + parents - 1) / parents;
    out.gaussians.push_back(part_of(scene, i, parts, generate::Random(generate::mixed(seed) + c)));
    if (rest > 0) out.sh_rest.insert(out.sh_rest.end(), sh_rest_of(scene, i), sh_rest_of(scene, i) + rest);
  }
  return out;
}

}  // namespace pipegs
