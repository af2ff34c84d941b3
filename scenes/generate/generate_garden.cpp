// SPDX-License-Identifier: Apache-2.0
// generate_garden: pebbles, grass and flowers of the generated scene.
//
// Idea    Small things repeat a simple recipe at random places: a stone is an ellipsoid with a lit
//         cap and an earth-bound shade, a blade a needle, a flower a few discs. Their number makes
//         the scene's statistics: thousands of needles of anisotropy 20 to 100.
#include <algorithm>
#include <cmath>

#include "scenes/generate/generate_builder.hpp"
#include "scenes/generate/generate_stage.hpp"

namespace pipegs::generate {
namespace {

bool inside_an_object(const glm::dvec3& point, double margin) {
  for (const Ball& ball : balls()) {
    if (glm::length(glm::dvec2(point.x - ball.center.x, point.z - ball.center.z)) < 0.55 * ball.radius + margin)
      return true;
  }
  return glm::length(glm::dvec2(point.x, point.z)) < 0.80 + margin;
}

void add_stone(Builder& builder, const glm::dvec3& base, double size, std::size_t patches) {
  Random& random = builder.random;
  const glm::dvec3 kinds[] = {
      {0.34, 0.31, 0.28}, {0.20, 0.20, 0.215}, {0.44, 0.36, 0.27}, {0.55, 0.53, 0.50}, {0.30, 0.19, 0.15}};
  const std::uint64_t kind = random.bits() % 5;
  const glm::dvec3 albedo = kinds[kind] * random.uniform(0.75, 1.25);
  const double length = random.uniform(0.9, 1.4), width = random.uniform(0.7, 1.0), height = random.uniform(0.45, 0.65);
  const glm::dvec3 radii = size * glm::dvec3(length, width, height);
  const glm::dvec3 up = glm::normalize(kUp + 0.12 * random.level_normals());
  const glm::dmat3 axes = frame_of(up, random.level_normals());
  const glm::dvec3 center = base + 0.35 * radii.z * kUp;
  for (std::size_t k = 0; k < patches; ++k) {
    // Patches on the upper half, by Fibonacci's lattice.
    const double h = 1 - 1.25 * (static_cast<double>(k) + 0.5) / static_cast<double>(patches);
    const double turn = static_cast<double>(k) * 2.399963, ring = std::sqrt(1 - h * h);
    const glm::dvec3 local(ring * std::cos(turn), ring * std::sin(turn), h);
    const glm::dvec3 mean = center + axes * (radii * local);
    const glm::dvec3 normal = glm::normalize(axes * (local / radii));
    const double dark = 0.55 + 0.45 * glm::smoothstep(-0.2, 0.5, h);  // near the earth less light arrives
    const ShColor color = plain_color(tone(diffuse(mean, normal, albedo * dark * random.uniform(0.88, 1.12))));
    builder.surface(mean, frame_of(normal, axes[0]), 2.1 * size / std::sqrt(static_cast<double>(patches)), 1.15, 0.84,
                    color);
  }
}

}  // namespace

void add_pebbles(Builder& builder, std::size_t count) {
  const double size_factor = std::pow(6600.0 / static_cast<double>(std::max<std::size_t>(count, 1)), 0.35);
  for (std::size_t used = 0, place = 0; used < count; ++place) {
    const glm::dvec2 u = r2(place);
    const double r = (kPebbleRadius + 0.9) * std::pow(u.x, 0.55), azimuth = 2 * kPi * u.y;
    const glm::dvec3 base = on_ground(r * std::sin(azimuth), r * std::cos(azimuth));
    const double share = pebble_share(base.x, base.z);
    if (inside_an_object(base, 0.0) || builder.random.uniform() > 0.05 + 0.95 * share) continue;
    const double size = size_factor * std::min(0.038 * std::exp(0.55 * builder.random.normal()), 0.14);
    const auto patches =
        static_cast<std::size_t>(glm::clamp(size * size * 4200 / (size_factor * size_factor), 3.0, 40.0));
    const std::size_t n = std::min(patches, count - used);
    add_stone(builder, base, size, n);
    used += n;
  }
}

void add_grass(Builder& builder, std::size_t count) {
  Random& random = builder.random;
  const double growth = std::pow(12000.0 / static_cast<double>(std::max<std::size_t>(count, 1)), 0.4);
  for (std::size_t i = 0, place = 0; i < count; ++place) {
    const glm::dvec2 u = r2(place);
    const double r = 1.9 * std::pow(9.5, std::pow(u.x, 0.9)), azimuth = 2 * kPi * u.y;
    const double x = r * std::sin(azimuth), z = r * std::cos(azimuth);
    if (random.uniform() < 0.97 * pebble_share(x, z) || random.uniform() > attention(on_ground(x, z, 0.1))) continue;
    const double tuft = glm::smoothstep(0.30, 0.62, fbm(x * 1.7, z * 1.7 + 31, 3));
    const double height = growth * (0.085 + 0.17 * tuft) * (0.65 + 0.085 * r) * random.uniform(0.55, 1.35);
    const glm::dvec3 lean = 0.35 * random.level_normals() + glm::dvec3(0.22, 0, 0);
    const glm::dvec3 a = on_ground(x, z, -0.02), b = a + height * (kUp + lean);
    const double dry = glm::smoothstep(0.45, 0.75, fbm(x * 0.4 + 3, z * 0.4, 3) + 0.18 * random.normal());
    const glm::dvec3 albedo =
        glm::mix(glm::dvec3(0.075, 0.17, 0.022), glm::dvec3(0.36, 0.29, 0.075), dry) * random.uniform(0.6, 1.4);
    const glm::dvec3 middle = (a + b) * 0.5;
    const double lit = sunlit(middle);
    const glm::dvec3 light = albedo * (kSunLight * (0.42 * lit) + kSkyLight * openness(middle));
    ShColor color = plain_color(tone(through_air(light, middle)));
    add_gradient(color, kToSun, glm::dvec3(0.09, 0.085, 0.02) * lit);
    const double width = growth * 0.0058 * (0.6 + 0.09 * r) * std::exp(0.3 * random.normal());
    const double kind = random.uniform();
    builder.needle(a, b, width,
                   kind < 0.45   ? random.uniform(0.6, 0.98)
                   : kind < 0.68 ? random.uniform(0.15, 0.6)
                                 : random.uniform(0.01, 0.15),
                   color);
    ++i;
  }
}

void add_flowers(Builder& builder, std::size_t count) {
  Random& random = builder.random;
  constexpr std::size_t kParts = 5;  // stem, three petals, heart
  const glm::dvec3 petals[] = {
      {0.72, 0.035, 0.02}, {0.80, 0.78, 0.74}, {0.09, 0.12, 0.62}, {0.85, 0.50, 0.03}, {0.55, 0.12, 0.42}};
  const glm::dvec3 hearts[] = {
      {0.03, 0.01, 0.015}, {0.85, 0.52, 0.03}, {0.05, 0.04, 0.22}, {0.45, 0.16, 0.01}, {0.85, 0.6, 0.1}};
  const double growth = std::pow(2700.0 / static_cast<double>(std::max<std::size_t>(count, 1)), 0.4);
  for (std::size_t used = 0, place = 0; used + kParts <= count; ++place) {
    const glm::dvec2 u = r2(place + 77);
    const double r = 2.2 * std::pow(6.0, u.x), azimuth = 2 * kPi * u.y;
    const double x = r * std::sin(azimuth) + 0.1 * random.normal(), z = r * std::cos(azimuth) + 0.1 * random.normal();
    const double meadow = fbm(x * 0.55 + 60, z * 0.55, 3);
    if (random.uniform() > attention(on_ground(x, z, 0.2)) || random.uniform() < pebble_share(x, z) * 0.98 ||
        random.uniform() > glm::smoothstep(0.38, 0.60, meadow))
      continue;
    // One kind prevails in each patch of the meadow.
    const double kind_noise = noise(x * 0.35 + 90, z * 0.35) * 1.3 + 0.25 * random.normal();
    const auto kind = static_cast<std::size_t>(glm::clamp(kind_noise * 5, 0.0, 4.0));
    const double height = growth * random.uniform(0.14, 0.30) * (0.8 + 0.06 * r),
                 size = growth * random.uniform(0.018, 0.030) * (0.8 + 0.06 * r);
    const glm::dvec3 foot = on_ground(x, z), head = foot + height * (kUp + 0.15 * random.level_normals());
    const double lit = sunlit(head);
    builder.needle(foot, head, 0.09 * size, 0.8, plain_color(tone(glm::dvec3(0.10, 0.2, 0.03) * (0.8 * lit + 0.4))));
    const glm::dvec3 normal = glm::normalize(kUp + 0.6 * kToSun + 0.35 * random.level_normals());
    const double start = random.uniform(0, 2 * kPi);
    for (int k = 0; k < 3; ++k) {
      const glm::dmat3 axes = frame_of(normal, {std::cos(start + k * kPi / 3), 0, std::sin(start + k * kPi / 3)});
      ShColor color =
          plain_color(tone(petals[kind] * (kSunLight * 0.75 * lit + kSkyLight) * random.uniform(0.85, 1.2)));
      add_gradient(color, kToSun, petals[kind] * 0.18 * lit);
      builder.add(head, axes, {size, 0.42 * size, 0.12 * size}, 0.92, color);
    }
    const glm::dmat3 axes = frame_of(normal, {1, 0, 0});
    builder.add(head + 0.25 * size * normal, axes, {0.3 * size, 0.3 * size, 0.15 * size}, 0.95,
                plain_color(tone(hearts[kind] * (kSunLight * 0.7 * lit + kSkyLight))));
    used += kParts;
  }
}

void add_trees(Builder& builder, std::size_t count) {
  // Firs in groves: boughs on a cone, drooping outward, lit on the side of the sun.
  constexpr std::size_t kBoughs = 46;
  Random& random = builder.random;
  for (std::size_t used = 0, place = 0; used + kBoughs <= count; ++place) {
    const glm::dvec2 u = r2(place + 5);
    const double r = 15 * std::pow(4.0, u.x), azimuth = 2 * kPi * u.y;
    const double x = r * std::sin(azimuth), z = r * std::cos(azimuth);
    if (random.uniform() > attention(on_ground(x, z, 1)) || fbm(x * 0.06 + 12, z * 0.06 + 4, 2) < 0.52) continue;
    const double height = random.uniform(1.7, 3.6);
    const glm::dvec3 green = glm::dvec3(0.035, 0.085, 0.03) + glm::dvec3(0.05, 0.03, 0.0) * random.uniform();
    for (std::size_t k = 0; k < kBoughs; ++k) {
      const double t = (static_cast<double>(k) + 0.5) / kBoughs,
                   turn = static_cast<double>(k) * 2.399963 + static_cast<double>(place);
      const double reach = height * (0.025 + 0.20 * (1 - t)) * random.uniform(0.7, 1.15);
      const glm::dvec3 out(std::sin(turn), 0, std::cos(turn));
      const glm::dvec3 stem = on_ground(x, z, height * (0.08 + 0.92 * t));
      const glm::dvec3 a = stem + 0.05 * height * kUp, b = stem + reach * out - 0.25 * reach * kUp;
      const glm::dvec3 light =
          diffuse((a + b) * 0.5, glm::normalize(out + 0.5 * kUp), green * random.uniform(0.7, 1.4));
      builder.needle(a, b + 1e-3 * out, height * (0.012 + 0.030 * (1 - t)), 0.9,
                     plain_color(tone(through_air(light, b))));
    }
    used += kBoughs;
  }
}

void add_veil(Builder& builder, std::size_t count) {
  // Faint Gaussians just above everything near: what training leaves where it could not decide.
  Random& random = builder.random;
  for (std::size_t i = 0, place = 0; i < count; ++place) {
    const glm::dvec2 u = r2(place + 991);
    const double r = 6 * std::pow(u.x, 0.6), azimuth = 2 * kPi * u.y;
    const double x = r * std::sin(azimuth), z = r * std::cos(azimuth);
    const double low = std::abs(0.05 * random.normal()), high = random.uniform(0, 1.5);
    const glm::dvec3 mean = on_ground(x, z, random.uniform() < 0.1 ? high : low);
    if (random.uniform() > attention(mean)) continue;
    const double size = 0.022 * std::exp(0.6 * random.normal());
    const ShColor color = plain_color(tone(diffuse(mean, kUp, ground_albedo(x, z) * random.uniform(0.7, 1.5))));
    const glm::dvec3 normal = glm::normalize(kUp + 0.6 * random.normals());
    const glm::dmat3 axes = frame_of(normal, random.normals());
    const double opacity = 1 / (1 + std::exp(3.6 + 0.8 * random.normal()));
    builder.add(mean, axes, {size * random.uniform(1, 4), size, 0.2 * size}, opacity, color);
    ++i;
  }
}

}  // namespace pipegs::generate
