// SPDX-License-Identifier: Apache-2.0
// gaze_test: cpp_model/driver/pipegs_gaze.c and cpp_model/gaze_parts.hpp: parts tile a picture, each is what a frame of
// its own would be, and joined they are the picture again.
#include "cpp_model/gaze_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cpp_model/driver/pipegs_gaze.h"
#include "cpp_model/frame_setup.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/compare/simulate.hpp"
#include "verif/support/draws.hpp"

namespace pipegs {
namespace {

Camera camera_of(int width, int height) {
  return look_at("gaze", 0, width, height, glm::dvec3(0.3, -0.8, -4), glm::dvec3(0, 0, 0), 70);
}

// How often each pixel lies in a part.
std::vector<int> cover(const Camera& whole, const std::vector<GazePart>& parts) {
  std::vector<int> counts(static_cast<size_t>(whole.width) * static_cast<size_t>(whole.height));
  for (const GazePart& part : parts) {
    for (int y = part.y; y < std::min(whole.height, part.y + part.camera.height * part.side()); ++y) {
      for (int x = part.x; x < std::min(whole.width, part.x + part.camera.width * part.side()); ++x)
        ++counts[static_cast<size_t>(y) * static_cast<size_t>(whole.width) + static_cast<size_t>(x)];
    }
  }
  return counts;
}

TEST(Gaze, EachPixelLiesInOneSampleOfOnePart) {
  std::mt19937_64 rng(1);
  const auto any = [&](int low, int high) { return static_cast<int>(draw_integer(rng, low, high)); };
  for (int i = 0; i < 400; ++i) {
    const int width = any(1, 300), height = any(1, 300);
    const Camera camera = camera_of(width, height);
    const int full = any(0, 200), half = full + any(0, 150);
    const Gaze gaze = {any(-100, 400), any(-100, 400), full, half};
    const std::vector<GazePart> parts = gaze_parts(camera, gaze);
    for (const int count : cover(camera, parts)) ASSERT_EQ(count, 1) << i;
    for (const GazePart& part : parts) {
      EXPECT_EQ(part.x % part.side(), 0);
      EXPECT_EQ(part.y % part.side(), 0);
      EXPECT_GT(part.x + part.camera.width * part.side(), part.x);
      EXPECT_LT(part.camera.width * part.side(), camera.width + 4);
      // Whatever lies within a radius has samples as small as it says.
      for (const int x : {gaze.x - full, gaze.x + full - 1}) {
        const int y = gaze.y;
        const bool inside = x >= part.x && x < part.x + part.camera.width * part.side() && y >= part.y &&
                            y < part.y + part.camera.height * part.side();
        if (inside && full > 0) EXPECT_EQ(part.pitch, 0);
      }
    }
  }
}

// A sample's centre is the centre of its pixels: what the whole camera shows there.
TEST(Gaze, PartsLookWhereTheirPixelsLook) {
  const Camera camera = camera_of(301, 203);
  for (const GazePart& part : gaze_parts(camera, {150, 90, 40, 90})) {
    const Camera& c = part.camera;
    for (const double x : {0.0, c.width - 1.0}) {
      const double pixel = part.x + (x + 0.5) * part.side() - 0.5;
      EXPECT_NEAR((x - c.cx) / c.fx, (pixel - camera.cx) / camera.fx, 1e-15);
    }
    for (const double y : {0.0, c.height - 1.0}) {
      const double pixel = part.y + (y + 0.5) * part.side() - 0.5;
      EXPECT_NEAR((y - c.cy) / c.fy, (pixel - camera.cy) / camera.fy, 1e-15);
    }
    EXPECT_NEAR(c.tan_x(), camera.tan_x(), 3 / camera.fx) << "the guard band is that of the whole picture";
  }
}

TEST(Gaze, RefusesWhatItCannotCut) {
  const pipegs_camera camera = driver_camera(camera_of(640, 480), kNearPlane);
  pipegs_gaze_part parts[PIPEGS_GAZE_PARTS];
  pipegs_gaze gaze = {320, 240, 100, 99};
  EXPECT_EQ(pipegs_gaze_parts(&camera, &gaze, parts), 0u);
  gaze.half = 100;
  EXPECT_EQ(pipegs_gaze_parts(&camera, &gaze, parts), 5u) << "without a ring of 2 x 2";
  gaze = {-2000000000, 2000000000, 4000000000u, 4000000000u};
  EXPECT_EQ(pipegs_gaze_parts(&camera, &gaze, parts), 1u);
  for (const pipegs_number far : {pipegs_number{1, 15}, pipegs_number{-1, 15}, pipegs_number{1, 1000000},
                                  pipegs_number{INT64_MIN, -48}, pipegs_number{INT64_MAX, 0}}) {
    pipegs_camera off = camera;
    off.center[1] = far;
    EXPECT_EQ(pipegs_gaze_parts(&off, &gaze, parts), 0u) << far.mantissa << " " << far.exponent;
  }
  for (const pipegs_number near : {pipegs_number{1, -1000000}, pipegs_number{INT64_MIN, -127}, pipegs_number{0, 99}}) {
    pipegs_camera tiny = camera;
    tiny.center[1] = near;
    ASSERT_EQ(pipegs_gaze_parts(&tiny, &gaze, parts), 1u);
    EXPECT_NEAR(std::ldexp(static_cast<double>(parts[0].camera.center[1].mantissa), parts[0].camera.center[1].exponent),
                std::ldexp(static_cast<double>(near.mantissa), near.exponent), 1e-14);
  }
}

// What the golden model draws, each part a frame.
std::vector<Image> drawn(const PackedScene& packed, const std::vector<GazePart>& parts,
                         const SimulateOptions& options) {
  std::vector<Image> images;
  for (const GazePart& part : parts) {
    Simulation simulation;
    simulate_frame(packed, part.camera, options, simulation);
    simulate_golden(options, simulation, {});
    images.push_back(simulation.golden.image);
  }
  return images;
}

// Where rings begin at windows, parts are windows of the pictures of a whole, a half and a quarter of the resolution,
// to the bit.
TEST(Gaze, PartsAreWindowsOfWholePictures) {
  SimulateOptions options;
  for (const char* setting : {"late=1", "order=2", "window=64", "tight_cull=1"}) config_set(options.config, setting);
  const Camera camera = camera_of(768, 256);
  const Scene scene = generate_scene(1);
  const PackedScene packed = pack_views(scene, {camera}, options);
  std::vector<Image> wholes;  // one part is all of it
  for (const Gaze& all : {Gaze{256, 128, 768, 768}, Gaze{256, 128, 0, 768}, Gaze{256, 128, 0, 0}}) {
    const std::vector<GazePart> one = gaze_parts(camera, all);
    ASSERT_EQ(one.size(), 1u);
    wholes.push_back(drawn(packed, one, options)[0]);
  }
  const std::vector<GazePart> parts = gaze_parts(camera, {192, 64, 64, 320});
  ASSERT_EQ(parts.size(), 5u);
  const std::vector<Image> images = drawn(packed, parts, options);
  for (size_t i = 0; i < parts.size(); ++i) {
    const GazePart& part = parts[i];
    const Image& whole = wholes[static_cast<size_t>(part.pitch)];
    const int x0 = part.x / part.side(), y0 = part.y / part.side();
    ASSERT_EQ(x0 % 64, 0);
    ASSERT_EQ(y0 % 64, 0);
    for (int y = 0; y < images[i].height; ++y) {
      for (int x = 0; x < images[i].width; ++x)
        ASSERT_EQ(images[i].rgb[images[i].at(x, y)], whole.rgb[whole.at(x0 + x, y0 + y)]) << i << ": " << x << "," << y;
    }
  }
}

// A picture that grows evenly is the same whether blended from large samples or not, but at edges of a ring, where half
// a sample's neighbours are missing.
TEST(Gaze, BlendedSamplesShowALinePlane) {
  const Camera camera = camera_of(200, 120);
  const auto plane = [](double x, double y) { return glm::dvec3(x, y, x + 2 * y) / 1000.0; };
  const std::vector<GazePart> parts = gaze_parts(camera, {100, 60, 12, 36});
  std::vector<Image> images;
  for (const GazePart& part : parts) {
    Image& image = images.emplace_back(part.camera.width, part.camera.height);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x)
        image.rgb[image.at(x, y)] =
            plane(part.x + (x + 0.5) * part.side() - 0.5, part.y + (y + 0.5) * part.side() - 0.5);
    }
  }
  const GazePicture picture = join_gaze(camera, parts, images);
  size_t exact = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const size_t at = picture.smooth.at(x, y);
      const double side = 1 << picture.pitch[at];
      const glm::dvec3 error = picture.smooth.rgb[at] - plane(x, y), step = plane(side / 2, side / 2);
      if (glm::length(error) < 1e-12) ++exact;
      for (int j = 0; j < 3; ++j) {
        EXPECT_LT(std::abs(error[j]), step[j]) << x << "," << y << ": its own sample at least";
        EXPECT_LE(std::abs(picture.repeated.rgb[at][j] - plane(x, y)[j]), step[j] - plane(0.5, 0.5)[j] + 1e-12);
      }
    }
  }
  EXPECT_GT(static_cast<double>(exact) / static_cast<double>(picture.pitch.size()), 0.9);
}

}  // namespace
}  // namespace pipegs
