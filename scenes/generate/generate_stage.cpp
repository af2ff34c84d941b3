// SPDX-License-Identifier: Apache-2.0
// generate_stage: see generate_stage.hpp.
//
// Idea    Low sun from the left and behind, hence long shadows, a warm horizon on its side and rims
//         of light. The shell is a stack of spheres for rays; its surface is generate_objects'.
#include "scenes/generate/generate_stage.hpp"

#include <cmath>

#include "scenes/generate/generate_random.hpp"

namespace pipegs::generate {
namespace {

constexpr int kStack = 22;

// The shell as balls of whorl scale s = 0.06..1, coloured like its surface.
std::vector<Ball> shell_stack() {
  std::vector<Ball> out;
  for (int i = 0; i < kStack; ++i) {
    const double s = 1.06 * std::pow(0.053, static_cast<double>(i) / (kStack - 1));
    out.push_back({glm::dvec3(0, -(0.40 * s + kShellHeight * (1 - s) - kShellSunk), 0), 0.60 * s,
                   shell_albedo(1 - s, 0.3), 0, glm::dvec3(1)});
  }
  return out;
}

const std::vector<Ball>& shell() {
  static const std::vector<Ball> stack = shell_stack();
  return stack;
}

// Distance along the ray, or a negative number.
double hit(const Ball& ball, const glm::dvec3& origin, const glm::dvec3& direction) {
  const glm::dvec3 to = ball.center - origin;
  const double along = glm::dot(to, direction);
  const double inside = ball.radius * ball.radius - (glm::dot(to, to) - along * along);
  return inside < 0 ? -1 : along - std::sqrt(inside);
}

double shade_of(const Ball& ball, const glm::dvec3& point) {
  const glm::dvec3 to = ball.center - point;
  const double along = glm::dot(to, kToSun);
  if (along <= 0) return 1;
  const double miss = std::sqrt(std::max(0.0, glm::dot(to, to) - along * along));
  const double blur = 0.02 + 0.045 * along;
  return glm::smoothstep(ball.radius - blur, ball.radius + blur, miss);
}

}  // namespace

const std::vector<Ball>& balls() {
  static const std::vector<Ball> all = {
      {on_ground(1.55, -0.60, 0.54), 0.54, {0.02, 0.025, 0.03}, 0.88, {0.96, 0.98, 1.0}},  // mirror
      {on_ground(-1.25, -0.95, 0.40), 0.40, {0.46, 0.018, 0.022}, 0.07, {1, 1, 1}},        // red lacquer
      {on_ground(-0.35, -1.65, 0.23), 0.23, {0.20, 0.10, 0.02}, 0.62, {1.0, 0.74, 0.32}},  // gold
      {on_ground(0.62, -1.75, 0.15), 0.15, {0.01, 0.16, 0.20}, 0.09, {1, 1, 1}},           // turquoise glaze
      {on_ground(-2.15, 0.55, 0.30), 0.30, {0.03, 0.09, 0.36}, 0.08, {1, 1, 1}},           // cobalt
  };
  return all;
}

double terrain_height(double x, double z) {
  const double r = std::sqrt(x * x + z * z);
  const double rolling = glm::smoothstep(6.0, 45.0, r);
  return 0.05 * (fbm(x * 0.9, z * 0.9, 3) - 0.5) * glm::smoothstep(2.0, 4.0, r) +
         rolling * 5.5 * (fbm(x * 0.035 + 3, z * 0.035 - 2, 3) - 0.52);
}

glm::dvec3 on_ground(double x, double z, double above) { return {x, -(terrain_height(x, z) + above), z}; }

double pebble_share(double x, double z) {
  const double edge = kPebbleRadius + 1.5 * (fbm(x * 0.8 + 9, z * 0.8, 3) - 0.5);
  return glm::smoothstep(edge + 0.35, edge - 0.35, std::sqrt(x * x + z * z));
}

glm::dvec3 ground_albedo(double x, double z) {
  const double patch = fbm(x * 0.22 + 40, z * 0.22, 4), fine = fbm(x * 2.3, z * 2.3 + 7, 3);
  const glm::dvec3 meadow =
      glm::mix(glm::dvec3(0.075, 0.13, 0.022), glm::dvec3(0.25, 0.24, 0.05), glm::smoothstep(0.3, 0.75, patch));
  const glm::dvec3 sand = glm::mix(glm::dvec3(0.20, 0.155, 0.11), glm::dvec3(0.34, 0.28, 0.205), fine);
  return glm::mix(meadow * (0.65 + 0.7 * fine), sand, pebble_share(x, z));
}

double cloud_density(const glm::dvec3& d) {
  const double h = glm::dot(d, kUp);
  if (h < 0.005) return 0;
  const double u = d.x / (h + 0.16), v = d.z / (h + 0.16);
  const double shape = fbm(u * 0.8 + 2.1, v * 1.3 + 8.4, 5);
  return glm::smoothstep(0.48, 0.62, shape) * glm::smoothstep(0.04, 0.16, h);
}

glm::dvec3 sky(const glm::dvec3& d) {
  const double h = std::max(0.0, glm::dot(d, kUp));
  const double toward =
      glm::dot(glm::normalize(glm::dvec3(d.x, 1e-9, d.z)), glm::normalize(glm::dvec3(kToSun.x, 0, kToSun.z)));
  const double warm = glm::smoothstep(-0.6, 1.0, toward);
  const glm::dvec3 horizon = glm::mix(glm::dvec3(0.52, 0.56, 0.66), glm::dvec3(1.35, 0.80, 0.42), warm);
  const glm::dvec3 zenith{0.045, 0.155, 0.46};
  glm::dvec3 light = glm::mix(zenith, horizon, std::exp(-h * 8.5));
  const double sun = std::max(0.0, glm::dot(d, kToSun));
  light += kSunLight * (0.10 * std::pow(sun, 12) + 0.9 * std::pow(sun, 350));
  const double cloud = cloud_density(d);
  // A second look a little toward the sun: less cloud there means a lit edge.
  const double edge = glm::clamp(cloud - cloud_density(glm::normalize(d + 0.10 * kToSun)) + 0.45, 0.0, 1.0);
  const glm::dvec3 lit = glm::mix(glm::dvec3(0.33, 0.34, 0.46), glm::dvec3(1.45, 1.08, 0.80), edge);
  return glm::mix(light, glm::mix(lit, horizon, 0.35 * std::exp(-h * 6)), 0.85 * cloud);
}

double sunlit(const glm::dvec3& point) {
  double light = 1;
  for (const Ball& ball : balls()) light *= shade_of(ball, point);
  double tower = 1;
  for (const Ball& ball : shell()) tower = std::min(tower, shade_of(ball, point));
  return light * tower;
}

double openness(const glm::dvec3& point) {
  double open = 1;
  const auto darken = [&](const Ball& ball) {
    const glm::dvec3 to = ball.center - point;
    const double distance2 = std::max(glm::dot(to, to), ball.radius * ball.radius);
    const double rising = 0.5 + 0.5 * glm::dot(to, kUp) / std::sqrt(distance2);
    return 1 - 0.75 * ball.radius * ball.radius / distance2 * rising;
  };
  for (const Ball& ball : balls()) open *= darken(ball);
  return open * darken(shell()[0]) * darken(shell()[8]);
}

glm::dvec3 diffuse(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& albedo) {
  const double facing = std::max(0.0, glm::dot(normal, kToSun));
  const double up = 0.5 + 0.5 * glm::dot(normal, kUp);
  const glm::dvec3 bounce = glm::dvec3(0.20, 0.16, 0.08) * (1 - up);
  const double sun = facing > 0 ? facing * sunlit(point + 0.02 * normal) : 0;
  return albedo * (kSunLight * sun + (kSkyLight * up + bounce) * openness(point) * 1.5);
}

glm::dvec3 radiance(const glm::dvec3& origin, const glm::dvec3& direction, bool with_shell) {
  double nearest = 1e30;
  const Ball* found = nullptr;
  for (const auto* group : {&balls(), &shell()}) {
    if (group == &shell() && !with_shell) continue;
    for (const Ball& ball : *group) {
      const double t = hit(ball, origin, direction);
      if (t > 1e-3 && t < nearest) {
        nearest = t;
        found = &ball;
      }
    }
  }
  const double falling = -glm::dot(direction, kUp);
  const double height = glm::dot(origin, kUp);
  const double ground = falling > 1e-4 ? height / falling : 1e30;
  if (found != nullptr && nearest < ground) {
    const glm::dvec3 point = origin + nearest * direction;
    const glm::dvec3 normal = (point - found->center) / found->radius;
    const glm::dvec3 body = diffuse(point, normal, found->albedo);
    return found->mirror > 0 ? body + found->mirror * found->tint * sky(glm::reflect(direction, normal)) * 0.7 : body;
  }
  if (ground < 400) {
    const glm::dvec3 point = origin + ground * direction;
    return through_air(diffuse(point, kUp, ground_albedo(point.x, point.z)), point);
  }
  return sky(direction);
}

glm::dvec3 through_air(const glm::dvec3& light, const glm::dvec3& point) {
  const double distance = glm::length(point);
  const glm::dvec3 air = sky(glm::normalize(glm::dvec3(point.x, -0.03 * distance, point.z)));
  return glm::mix(light, glm::mix(air, glm::dvec3(0.26, 0.35, 0.60), 0.75),
                  1 - std::exp(-std::pow(distance / 2500, 0.8)));
}

glm::dvec3 shell_albedo(double whorl, double around) {
  // From a deep teal mouth through coral and cream to a violet tip, with spiral bands.
  const glm::dvec3 stops[] = {{0.02, 0.16, 0.19}, {0.03, 0.30, 0.30}, {0.72, 0.52, 0.30},
                              {0.78, 0.22, 0.12}, {0.42, 0.06, 0.22}, {0.20, 0.06, 0.36}};
  const double at = glm::clamp(whorl, 0.0, 0.999) * 5;
  const int i = static_cast<int>(at);
  const glm::dvec3 base = glm::mix(stops[i], stops[i + 1], glm::smoothstep(0.0, 1.0, at - i));
  const double band = glm::smoothstep(0.55, 0.95, std::sin(around * 9) * 0.5 + 0.5);
  return glm::mix(base, glm::dvec3(0.85, 0.74, 0.58), 0.55 * band);
}

glm::dvec3 tone(const glm::dvec3& light) {
  const glm::dvec3 exposed = 1.0 - glm::exp(-1.25 * light);
  const glm::dvec3 display = glm::pow(glm::max(exposed, 0.0), glm::dvec3(1 / 2.2));
  return glm::mix(display, display * display * (3.0 - 2.0 * display), 0.40);  // a photograph's contrast
}

}  // namespace pipegs::generate
