// SPDX-License-Identifier: Apache-2.0
// generate_stage: the world as formulas: light, sky, terrain and what a ray meets.
//
// Idea    Gaussians are coloured by a small ray tracer over analytic shapes (plane, spheres, a stack
//         of spheres for the shell), so shadows, contact shade and reflections agree.
// Units   World up is -y, height = -y. Light is linear; tone() turns it into the display colours
//         that 3D Gaussian splatting stores.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace pipegs::generate {

struct Ball {
  glm::dvec3 center;
  double radius;
  glm::dvec3 albedo;
  double mirror;    // share of the reflection at normal incidence
  glm::dvec3 tint;  // of the reflection
};

inline const glm::dvec3 kUp{0, -1, 0};
inline const glm::dvec3 kToSun = glm::normalize(glm::dvec3(-0.80, -0.42, 0.36));
inline const glm::dvec3 kSunLight{3.3, 2.45, 1.55};
inline const glm::dvec3 kSkyLight{0.34, 0.46, 0.68};
inline constexpr double kShellHeight = 2.42;  // from whorl scale 1 to the tip's limit
inline constexpr double kShellSunk = 0.32;    // how deep it stands in the ground
inline constexpr double kPebbleRadius = 2.5;

const std::vector<Ball>& balls();

double terrain_height(double x, double z);
glm::dvec3 on_ground(double x, double z, double above = 0);
glm::dvec3 ground_albedo(double x, double z);
double pebble_share(double x, double z);  // 1 on the pebbles, 0 in the meadow

glm::dvec3 sky(const glm::dvec3& direction);
double cloud_density(const glm::dvec3& direction);  // 0..1
double sunlit(const glm::dvec3& point);             // 0 in shadow .. 1
double openness(const glm::dvec3& point);           // share of sky not hidden by the objects

glm::dvec3 diffuse(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& albedo);
// What comes from `origin` along `direction`, without a second reflection. The shell's own surface
// does not meet the coarse stack that stands for it.
glm::dvec3 radiance(const glm::dvec3& origin, const glm::dvec3& direction, bool with_shell);
// Light of a far point, seen through the air.
glm::dvec3 through_air(const glm::dvec3& light, const glm::dvec3& point);
glm::dvec3 shell_albedo(double whorl, double around);

glm::dvec3 tone(const glm::dvec3& light);

}  // namespace pipegs::generate
