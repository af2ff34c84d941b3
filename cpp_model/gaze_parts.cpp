// SPDX-License-Identifier: Apache-2.0
// gaze_parts: see gaze_parts.hpp.
#include "cpp_model/gaze_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/driver/pipegs_gaze.h"
#include "cpp_model/frame_setup.hpp"

namespace pipegs {
namespace {

double value(const pipegs_number& number) { return std::ldexp(static_cast<double>(number.mantissa), number.exponent); }

// The samples of one size, each where it lies in a picture of such samples.
struct Samples {
  Image image;
  std::vector<bool> there;

  Samples(int width, int height) : image(width, height), there(image.rgb.size()) {}
  // That at (x, y), else `own`.
  size_t near(int x, int y, size_t own) const {
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) return own;
    const size_t at = image.at(x, y);
    return there[at] ? at : own;
  }
};

// Where a pixel lies between the centres of two samples, the first of them and the way to the second.
struct Between {
  int first;
  double way;
};
Between between(int pixel, int pitch) {
  const double at = (pixel + 0.5) / (1 << pitch) - 0.5;
  return {static_cast<int>(std::floor(at)), at - std::floor(at)};
}

}  // namespace

std::vector<GazePart> gaze_parts(const Camera& camera, const Gaze& gaze) {
  const pipegs_camera whole = driver_camera(camera, kNearPlane);
  const pipegs_gaze taken = {gaze.x, gaze.y, static_cast<uint32_t>(gaze.full), static_cast<uint32_t>(gaze.half)};
  pipegs_gaze_part cut[PIPEGS_GAZE_PARTS] = {};
  const uint32_t count = pipegs_gaze_parts(&whole, &taken, cut);
  if (count == 0)
    throw FrameError(fmt::format("camera '{}': found a principal point of {:g}, {:g}, expected less than {}",
                                 camera.name, camera.cx, camera.cy, 1 << 15));
  std::vector<GazePart> parts;
  for (uint32_t i = 0; i < count; ++i) {
    GazePart& part = parts.emplace_back();
    part.camera = camera;
    part.camera.name = fmt::format("{} at {},{}", camera.name, cut[i].x, cut[i].y);
    part.camera.width = static_cast<int>(cut[i].camera.width),
    part.camera.height = static_cast<int>(cut[i].camera.height);
    part.camera.of_width = static_cast<int>(cut[i].camera.of_width);
    part.camera.of_height = static_cast<int>(cut[i].camera.of_height);
    part.camera.fx = value(cut[i].camera.focal[0]), part.camera.fy = value(cut[i].camera.focal[1]);
    part.camera.cx = value(cut[i].camera.center[0]), part.camera.cy = value(cut[i].camera.center[1]);
    part.x = static_cast<int>(cut[i].x), part.y = static_cast<int>(cut[i].y);
    part.pitch = static_cast<int>(cut[i].pitch);
  }
  return parts;
}

GazePicture join_gaze(const Camera& whole, const std::vector<GazePart>& parts, const std::vector<Image>& images) {
  std::vector<Samples> samples;
  for (int pitch = 0; pitch < 3; ++pitch)
    samples.emplace_back((whole.width + (1 << pitch) - 1) >> pitch, (whole.height + (1 << pitch) - 1) >> pitch);
  GazePicture picture{Image(whole.width, whole.height), Image(whole.width, whole.height), {}};
  picture.pitch.resize(picture.smooth.rgb.size());
  for (size_t i = 0; i < parts.size(); ++i) {
    const GazePart& part = parts[i];
    Samples& all = samples[static_cast<size_t>(part.pitch)];
    const int x0 = part.x >> part.pitch, y0 = part.y >> part.pitch;
    for (int y = 0; y < images[i].height; ++y) {
      for (int x = 0; x < images[i].width; ++x) {
        const size_t to = all.image.at(x0 + x, y0 + y), from = images[i].at(x, y);
        all.image.rgb[to] = images[i].rgb[from];
        all.image.transmittance[to] = images[i].transmittance[from];
        all.there[to] = true;
      }
    }
    const int x1 = std::min(whole.width, part.x + images[i].width * part.side()),
              y1 = std::min(whole.height, part.y + images[i].height * part.side());
    for (int y = part.y; y < y1; ++y)
      std::fill(picture.pitch.begin() + static_cast<ptrdiff_t>(picture.smooth.at(part.x, y)),
                picture.pitch.begin() + static_cast<ptrdiff_t>(picture.smooth.at(part.x, y)) + (x1 - part.x),
                part.pitch);
  }
  for (int y = 0; y < whole.height; ++y) {
    for (int x = 0; x < whole.width; ++x) {
      const size_t at = picture.smooth.at(x, y);
      const int pitch = picture.pitch[at];
      const Samples& all = samples[static_cast<size_t>(pitch)];
      const size_t own = all.image.at(x >> pitch, y >> pitch);
      const Between across = between(x, pitch), down = between(y, pitch);
      picture.repeated.rgb[at] = all.image.rgb[own];
      picture.repeated.transmittance[at] = all.image.transmittance[own];
      glm::dvec3 rgb(0);
      double left = 0;
      for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1, below = corner >> 1;
        const double weight = (right ? across.way : 1 - across.way) * (below ? down.way : 1 - down.way);
        const size_t one = all.near(across.first + right, down.first + below, own);
        rgb += weight * all.image.rgb[one];
        left += weight * all.image.transmittance[one];
      }
      picture.smooth.rgb[at] = rgb;
      picture.smooth.transmittance[at] = left;
    }
  }
  return picture;
}

}  // namespace pipegs
