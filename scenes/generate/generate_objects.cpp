// SPDX-License-Identifier: Apache-2.0
// generate_objects: the still life: shell, spheres, pebbles, and what grows around it.
//
// Idea    Surfaces are sampled by area; glossy ones ask fit_color for every Gaussian, with a ray
//         into the scene per view. The shell is a logarithmic spiral: whorl scale s shrinks by
//         kWhorlRatio per turn, centre and height follow s, so it is similar to itself.
#include <cmath>

#include "scenes/generate/generate_builder.hpp"
#include "scenes/generate/generate_stage.hpp"

namespace pipegs::generate {
namespace {

constexpr double kWhorlRatio = 0.76, kWhorlRadius = 0.30, kTube = 0.36, kTubeHeight = 0.40, kLargest = 1.16;

struct ShellPoint {
  glm::dvec3 position, normal, along;  // along: the direction of growth
};

glm::dvec3 shell_surface(double s, double around) {
  const double turn = std::log(s) / std::log(kWhorlRatio) * 2 * kPi;
  const double rib = 1 + 0.035 * std::cos(11 * turn) * std::cos(around);
  const double radial = s * (kWhorlRadius + kTube * rib * std::cos(around));
  const double height = s * kTubeHeight * (1 + rib * std::sin(around)) + kShellHeight * (1 - s) - kShellSunk;
  return {radial * std::sin(turn), -height, radial * std::cos(turn)};
}

ShellPoint shell_point(double s, double around) {
  constexpr double kStep = 1e-4;
  const glm::dvec3 p = shell_surface(s, around);
  const glm::dvec3 along = glm::normalize(shell_surface(s * (1 + kStep), around) - p);
  const glm::dvec3 across = shell_surface(s, around + kStep) - p;
  glm::dvec3 normal = glm::normalize(glm::cross(along, across));
  if (glm::dot(normal, glm::dvec3(p.x, 0, p.z)) + 0.2 * glm::dot(normal, kUp) * std::sin(around) < 0) normal = -normal;
  return {p, normal, along};
}

// A clear coat over a diffuse body: Schlick's reflection of the scene and a blurred sun.
glm::dvec3 glossy(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& view, const glm::dvec3& body,
                  double mirror, const glm::dvec3& tint, double highlight, bool with_shell) {
  const double facing = glm::clamp(glm::dot(normal, view), 0.0, 1.0);
  const double fresnel = mirror + (1 - mirror) * std::pow(1 - facing, 5);
  const glm::dvec3 reflected = glm::reflect(-view, normal);
  const double sun = std::pow(std::max(0.0, glm::dot(reflected, kToSun)), 60.0) * sunlit(point + 0.03 * normal);
  return body * (1 - fresnel) + fresnel * tint * radiance(point + 1e-3 * normal, reflected, with_shell) +
         highlight * sun * kSunLight;
}

}  // namespace

void add_balls(Builder& builder, std::size_t count) {
  double area = 0;
  for (const Ball& ball : balls()) area += std::pow(ball.radius, 1.6);
  for (const Ball& ball : balls()) {
    const auto n = static_cast<std::size_t>(static_cast<double>(count) * std::pow(ball.radius, 1.6) / area);
    constexpr std::size_t kCore = 10;  // one in ten lies below the surface and closes it
    for (std::size_t i = 0; i < n; ++i) {
      const bool core = i % kCore == 0;
      // Fibonacci's lattice: even over the sphere.
      const double h = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
      const double turn = static_cast<double>(i) * kPi * (3 - std::sqrt(5.0)), ring = std::sqrt(1 - h * h);
      const glm::dvec3 normal(ring * std::cos(turn), -h, ring * std::sin(turn));
      const glm::dvec3 mean = ball.center + ball.radius * (core ? 0.95 : 1.0) * normal;
      const glm::dvec3 body = diffuse(mean, normal, ball.albedo);
      const ShColor color = fit_color(mean, normal, [&](const glm::dvec3& view) {
        return tone(glossy(mean, normal, view, body, ball.mirror, ball.tint, 0.8, true));
      });
      const double spacing = ball.radius * std::sqrt(4 * kPi / static_cast<double>(n));
      const glm::dmat3 axes = frame_of(normal, builder.random.normals());
      if (core) builder.add(mean, axes, spacing * glm::dvec3(1.7, 1.7, 0.2), 0.985, color);
      else builder.surface(mean, axes, spacing, 1.12, 0.92, color);
    }
  }
}

void add_shell(Builder& builder, std::size_t count) {
  for (std::size_t i = 0, place = 0; i < count; ++place) {
    const glm::dvec2 u = r2(place);
    const double s = kLargest * std::pow(0.008 + 0.992 * u.x, 0.7);  // finer toward the tip
    const double around = kPi * (-0.62 + 1.30 * u.y);                // the outer side of the tube
    const ShellPoint p = shell_point(s, around);
    if (glm::dot(p.position, kUp) < -0.03) continue;  // the last whorl is half sunk in the ground
    ++i;
    const double turn = std::log(s) / std::log(kWhorlRatio) * 2 * kPi;
    const double growth = 0.80 + 0.20 * std::cos(44 * turn + 2 * std::sin(3 * around));  // fine growth lines
    const double seam = glm::smoothstep(0.0, 0.55, std::abs(around + 0.62 * kPi)) *
                        glm::smoothstep(0.0, 0.5, std::abs(0.68 * kPi - around));
    const glm::dvec3 albedo = shell_albedo(1 - s, around) * growth * (0.35 + 0.65 * seam);
    const glm::dvec3 body = diffuse(p.position, p.normal, albedo);
    const ShColor color = fit_color(p.position, p.normal, [&](const glm::dvec3& view) {
      // Nacre: the hue of the coat turns with the angle.
      const double phase = 5.5 * glm::dot(p.normal, view) + 2.2 * around;
      const glm::dvec3 nacre(0.5 + 0.5 * std::cos(phase), 0.5 + 0.5 * std::cos(phase + 2.1),
                             0.5 + 0.5 * std::cos(phase + 4.2));
      return tone(glossy(p.position, p.normal, view, body, 0.05, glm::dvec3(1), 0.35, false) +
                  0.045 * nacre * sunlit(p.position + 0.05 * p.normal));
    });
    const double spacing = std::sqrt(15.4 * std::pow(s, 0.57) / static_cast<double>(count)) * 1.0;
    builder.surface(p.position, frame_of(p.normal, p.along), spacing, 1.7, 0.90, color);
  }
}

void add_spines(Builder& builder, std::size_t count) {
  // Each spine is six needles from a broad base to the tip, along the shoulder of the whorls.
  constexpr std::size_t kParts = 6;
  const std::size_t spines = count / kParts;
  for (std::size_t i = 0; i < spines; ++i) {
    const double s = 1.05 * std::pow(0.12, (static_cast<double>(i / 2) * 2 + builder.random.uniform()) /
                                               static_cast<double>(spines));
    const double around = i % 2 == 0 ? 0.62 : 0.12;
    const ShellPoint p = shell_point(s, around);
    const double length = s * (i % 2 == 0 ? 0.30 : 0.17) * builder.random.uniform(0.8, 1.2);
    const glm::dvec3 out = glm::normalize(p.normal + 0.45 * kUp - 0.25 * p.along);
    for (std::size_t k = 0; k < kParts; ++k) {
      const double from = static_cast<double>(k) / kParts, to = (static_cast<double>(k) + 1.9) / kParts;
      const glm::dvec3 a = p.position + length * (from * out + 0.22 * from * from * kUp);
      const glm::dvec3 b = p.position + length * (to * out + 0.22 * to * to * kUp);
      const glm::dvec3 albedo =
          glm::mix(shell_albedo(1 - s, around), glm::dvec3(0.95, 0.60, 0.22), glm::smoothstep(0.1, 0.9, from));
      const glm::dvec3 middle = (a + b) * 0.5;
      const glm::dvec3 light =
          diffuse(middle, p.normal, albedo) + 0.5 * albedo * kSunLight * sunlit(middle + 0.06 * p.normal) * from;
      ShColor color = plain_color(tone(light));
      add_gradient(color, kToSun, glm::dvec3(0.10, 0.06, 0.02) * from);
      builder.needle(a, b, length * 0.050 * (1.15 - to * 0.5), 0.93, color);
    }
  }
}

void add_motes(Builder& builder, std::size_t count) {
  // Gold dust that winds up around the shell.
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (static_cast<double>(i) + builder.random.uniform()) / static_cast<double>(count);
    const double turn = 2 * kPi * 2.6 * t + 0.8, radius = 1.15 - 0.75 * t + 0.07 * builder.random.normal();
    const glm::dvec3 mean(radius * std::sin(turn), -(0.5 + 2.35 * t + 0.07 * builder.random.normal()),
                          radius * std::cos(turn));
    const glm::dvec3 along = glm::normalize(glm::dvec3(std::cos(turn), -0.30, -std::sin(turn)));
    const double half = 0.012 * std::exp(0.5 * builder.random.normal());
    ShColor color = plain_color(tone(glm::dvec3(2.2, 1.35, 0.45) * builder.random.uniform(0.6, 1.5)));
    add_gradient(color, kToSun, glm::dvec3(0.10, 0.08, 0.05));
    builder.needle(mean - half * along, mean + half * along, 0.16 * half, builder.random.uniform(0.15, 0.9), color);
  }
}

}  // namespace pipegs::generate
