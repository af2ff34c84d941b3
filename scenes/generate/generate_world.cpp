// SPDX-License-Identifier: Apache-2.0
// generate_world: sky, clouds, mountains, ground and haze of the generated scene.
//
// Idea    Far things are spread by angle, near ones log-polar around the middle, both by the r2
//         sequence: about equal size on the screen, as training makes them, and no holes.
// Reach   Ground to 900 units, mountains 70 to 1,100, sky dome 2,000 to 3,200.
#include <cmath>

#include "scenes/generate/generate_builder.hpp"
#include "scenes/generate/generate_stage.hpp"

namespace pipegs::generate {
namespace {

constexpr double kFarGround = 900;

glm::dvec3 from_angles(double azimuth, double elevation) {
  return {std::sin(azimuth) * std::cos(elevation), -std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

struct Ridge {
  double distance, height, roughness;
  glm::dvec3 low, high;
  double snow;  // height share above which it is white; above 1: never
};

constexpr int kRidges = 4;
const Ridge kRidge[kRidges] = {{70, 7.5, 7, {0.035, 0.07, 0.02}, {0.07, 0.11, 0.03}, 9},
                               {190, 24, 6, {0.05, 0.085, 0.05}, {0.09, 0.12, 0.06}, 9},
                               {480, 70, 5, {0.04, 0.06, 0.075}, {0.10, 0.10, 0.12}, 9},
                               {1100, 205, 4, {0.035, 0.045, 0.10}, {0.085, 0.085, 0.14}, 0.46}};

double ridge_height(int r, double azimuth) {
  // Noise on a circle, so that the ridge closes.
  const double k = kRidge[r].roughness, u = std::sin(azimuth) * k + 20 * r, v = std::cos(azimuth) * k - 7 * r;
  const double shape = fbm(u * 0.55, v * 0.55, 6);
  const double peaks = r >= 2 ? 1 - std::abs(2 * fbm(u * 0.8 + 5, v * 0.8, 4) - 1) * 2.2 : shape;
  return kRidge[r].height * (0.18 + 0.55 * shape + 0.42 * std::max(0.0, peaks));
}

}  // namespace

void add_sky(Builder& builder, std::size_t count) {
  // Three quarters below 28 degrees, where cameras look and clouds have detail.
  const std::size_t low = count * 3 / 4;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_low = i < low;
    const glm::dvec2 u = r2(i);
    const double bottom = is_low ? -0.03 : 0.46, top = is_low ? 0.47 : 1.0;  // sines of elevation
    const double azimuth = u.x * 2 * kPi, elevation = std::asin(bottom + (top - bottom) * u.y);
    const glm::dvec3 d = from_angles(azimuth, elevation);
    const double solid_angle = 2 * kPi * (top - bottom) / static_cast<double>(is_low ? low : count - low + 1);
    const double radius = builder.random.uniform(2000, 3200);
    const double sigma = radius * std::sqrt(solid_angle) * builder.random.uniform(0.62, 0.70);
    const ShColor color = plain_color(tone(sky(d)));
    builder.add(radius * d, frame_of(-d, {d.z, 0, -d.x}), {1.08 * sigma, 0.98 * sigma, 0.05 * sigma}, 0.97, color);
  }
}

void add_clouds(Builder& builder, std::size_t count) {
  for (std::size_t i = 0, tried = 0; i < count; ++tried) {
    const glm::dvec2 u = r2(tried);
    const glm::dvec3 d = from_angles(u.x * 2 * kPi, 0.02 + 0.46 * u.y * u.y);
    const double cloud = cloud_density(d);
    // Edges are where detail is; the limit ends the search in a seed's cloudless sky.
    if (tried < 40 * count && (cloud < 0.06 || builder.random.uniform() > 1.1 - std::abs(cloud - 0.5))) continue;
    const double radius = builder.random.uniform(1500, 1950);
    const double sigma =
        radius * 0.0075 * std::exp(0.45 * builder.random.normal()) * std::sqrt(3300.0 / static_cast<double>(count));
    const double opacity = glm::clamp(0.15 + 0.55 * cloud + 0.12 * builder.random.normal(), 0.03, 0.9);
    ShColor color = plain_color(tone(sky(d) * (0.97 + 0.12 * builder.random.uniform())));
    add_gradient(color, kToSun, glm::dvec3(0.02, 0.014, 0.006));
    const glm::dvec3 level(d.z, 0.18 * builder.random.normal(), -d.x);
    builder.add(radius * d, frame_of(-d, level), {sigma * builder.random.uniform(1.6, 3.4), 0.55 * sigma, 0.2 * sigma},
                opacity, color);
    ++i;
  }
}

void add_mountains(Builder& builder, std::size_t count) {
  // Of seven, two thin courses run along the ridge line and draw it sharply; the rest fill below.
  constexpr std::size_t kCourses = 7, kLines = 2;
  const double rounds = static_cast<double>(count) / static_cast<double>(kRidges * kCourses);
  for (std::size_t i = 0; i < count; ++i) {
    const int r = static_cast<int>(i % kRidges);
    const Ridge& ridge = kRidge[r];
    const std::size_t round = i / kRidges / kCourses, course = i / kRidges % kCourses;
    const bool line = course < kLines;
    // A sequence of its own for the lines and for the fill: every seventh point of r2 is not even.
    const glm::dvec2 u = r2(line ? round + 1000 * course : round * (kCourses - kLines) + course - kLines);
    const double azimuth = u.x * 2 * kPi, top = ridge_height(r, azimuth), around = 2 * kPi * ridge.distance;
    const double spacing = std::sqrt(around * 0.5 * ridge.height / (rounds * (kCourses - kLines)));
    const double thin = course == 0 ? 0.10 : 0.22, below = course == 0 ? 0.10 : course == 1 ? 0.35 : 0.75;
    const double height = line ? top - below * spacing : (top - below * spacing) * u.y - 0.03 * ridge.height;
    const glm::dvec3 d = from_angles(azimuth, 0);
    const glm::dvec3 mean = ridge.distance * d *
                                (1 + (course == 0   ? 0.0
                                      : course == 1 ? 0.004
                                                    : 0.01 - 0.02 * u.y * (1 - u.y))) +
                            height * kUp;
    const double step = 0.3 * 2 * kPi / rounds;
    const double slope =
        (ridge_height(r, azimuth + step) - ridge_height(r, azimuth - step)) / (2 * step * ridge.distance);
    const glm::dvec3 tangent =
        glm::dvec3(d.z, 0, -d.x) + (line ? slope : 0.6 * slope + 0.15 * builder.random.normal()) * kUp;
    const double share = glm::clamp(height / ridge.height, 0.0, 1.2);
    glm::dvec3 albedo =
        glm::mix(ridge.low, ridge.high, share) * (0.7 + 0.6 * fbm(azimuth * 90, height * 40 / ridge.height, 2));
    const double snow =
        glm::smoothstep(ridge.snow - 0.08, ridge.snow + 0.08, share + 0.35 * (fbm(azimuth * 60, share * 9, 3) - 0.5));
    albedo = glm::mix(albedo, glm::dvec3(0.62, 0.66, 0.74), snow);
    // The slope of the ridge decides which flank the sun reaches.
    const glm::dvec3 normal = glm::normalize(-d + 0.9 * kUp - 1.3 * slope * glm::dvec3(d.z, 0, -d.x));
    const glm::dvec3 light = albedo * (kSunLight * std::max(0.0, glm::dot(normal, kToSun)) * 1.1 + kSkyLight * 1.2);
    const ShColor color = plain_color(tone(through_air(light, mean)));
    const glm::dvec3 scale = line ? glm::dvec3(0.40 * around / rounds, thin * spacing, 0.05 * spacing)
                                  : glm::dvec3(0.85 * spacing, 0.55 * spacing, 0.1 * spacing);
    builder.add(mean, frame_of(-d, tangent), scale, 0.96, color);
  }
}

namespace {

void ground_patch(Builder& builder, double x, double z, double size, double stretch) {
  const double step = 0.2 * size + 0.01;
  const glm::dvec3 normal =
      glm::normalize(glm::dvec3(terrain_height(x - step, z) - terrain_height(x + step, z), -2 * step,
                                terrain_height(x, z - step) - terrain_height(x, z + step)));
  const glm::dvec3 mean = on_ground(x, z, -0.12 * size);
  const glm::dvec3 light = diffuse(mean, normal, ground_albedo(x, z) * builder.random.uniform(0.78, 1.22));
  // Far ones lie along the line of sight: round on the screen, long on the ground.
  const glm::dvec3 tangent = glm::dvec3(x, 0, z) / std::hypot(x, z) + 0.1 * builder.random.level_normals();
  ShColor color = plain_color(tone(through_air(light, mean)));
  add_gradient(color, kToSun, glm::dvec3(0.03, 0.025, 0.01) * (1 - pebble_share(x, z)));
  builder.surface(mean, frame_of(normal, tangent), size, stretch, 0.78, color);
}

}  // namespace

void add_ground(Builder& builder, std::size_t count) {
  // The inner disc, denser to the middle, where cameras are near; beyond it log-polar to the
  // horizon. Where no camera looks, few and larger ones do.
  constexpr double kInner = 5.6, kPower = 0.68;
  const double ratio = std::log(kFarGround / (kInner * 0.97));
  const auto radius = [&](bool inner, double u) {
    return inner ? kInner * std::pow(u, kPower) : kInner * 0.97 * std::exp(ratio * u);
  };
  const auto attended = [&](bool inner, const glm::dvec2& u) {
    const double r = radius(inner, u.x);
    return attention({r * std::sin(2 * kPi * u.y), 0, r * std::cos(2 * kPi * u.y)});
  };
  for (const bool inner : {true, false}) {
    const std::size_t wanted = inner ? count * 3 / 5 : count - count * 3 / 5;
    constexpr std::uint64_t kSamples = 2000;
    double share = 0;
    for (std::uint64_t i = 0; i < kSamples; ++i) share += attended(inner, r2(i)) / kSamples;
    const double places = static_cast<double>(wanted) / share;
    std::size_t added = 0;
    for (std::uint64_t place = 0; added < wanted; ++place) {
      const glm::dvec2 u = r2(place);
      const double here = attended(inner, u);
      if (builder.random.uniform() > here) continue;
      const double r = radius(inner, u.x), azimuth = 2 * kPi * u.y;
      // Round near the cameras: a long one that reaches behind the image plane would veil the picture.
      const double area =
          inner ? 2 * kPi * kInner * kInner * kPower * std::pow(u.x + 0.01, 2 * kPower - 1) : 2 * kPi * ratio * r * r;
      ground_patch(builder, r * std::sin(azimuth), r * std::cos(azimuth), 1.10 * std::sqrt(area / (places * here)),
                   here == 1 ? glm::clamp(r / 4, 1.25, 5.0) : 1.25);
      ++added;
    }
  }
}

void add_haze(Builder& builder, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 u = r2(i);
    const double r = 14 * std::pow(25.0, u.x), azimuth = 2 * kPi * u.y;
    const double sigma = r * builder.random.uniform(0.10, 0.22);
    const glm::dvec3 mean = on_ground(r * std::sin(azimuth), r * std::cos(azimuth), 0.12 * sigma);
    ShColor color = plain_color(tone(sky(glm::normalize(glm::dvec3(mean.x, -0.04 * r, mean.z))) * 0.95));
    add_gradient(color, kToSun, glm::dvec3(0.06, 0.04, 0.015));
    builder.add(mean, frame_of(kUp, {mean.z, 0, -mean.x}), {sigma * 1.6, sigma, 0.16 * sigma},
                builder.random.uniform(0.015, 0.05), color);
  }
}

}  // namespace pipegs::generate
