// SPDX-License-Identifier: Apache-2.0
// camera_arguments.cpp: see camera_arguments.hpp.
#include "sim/command/camera_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scenes/cameras/forms.hpp"
#include "scenes/cameras/framing.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/command/picture_size.hpp"

namespace pipegs {
namespace {

std::optional<glm::dvec3> vector_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return glm::dvec3(values[0], values[1], values[2]);
}

}  // namespace

void CameraArguments::add(CLI::App& app) {
  add_text(app, "--cameras", file,
           "cameras: INRIA's cameras.json, a folder or file of COLMAP, transforms.json of nerfstudio, instant-ngp "
           "or Blender, SuperSplat's; without it the scene is framed");
  add_text(app, "--size", size, "pixels of the picture, WxH; a framed scene has 1280x720 without it");
  add_real(app, "--scale", scale, "sides of the picture over those of the camera", {.low = 0.01, .high = 100})
      .shows_default();
  add_flag(app, "--ignore-distortion", ignore_distortion, "take a lens that bends rays for one that does not");
  add_integer(app, "--orbit", orbit, "without --cameras: so many views on a circle round the scene", 1, 100000);
  constexpr RealRange kFar{.low = -1e9, .high = 1e9};
  add_vector(app, "--from", from, "without --cameras: where the camera stands", kFar);
  add_vector(app, "--look-at", look_at, "without --cameras: what it looks at", kFar);
  add_vector(app, "--up", up, "without --cameras: which way is up", kFar);
  add_real(app, "--fov", fov, "without --cameras: degrees from left to right (60)",
           {.low = 0, .high = 170, .above = true});
}

CameraReading CameraArguments::reading() const {
  CameraReading reading;
  reading.ignore_distortion = ignore_distortion;
  if (size.empty()) return reading;
  const PictureSize pixels = picture_size("--size", size);
  reading.width = pixels.width;
  reading.height = pixels.height;
  return reading;
}

std::vector<Camera> CameraArguments::scaled(std::vector<Camera> cameras) const {
  if (scale == 1) return cameras;
  for (Camera& camera : cameras) {
    camera = scaled_camera(camera, scale);
    if (std::max(camera.width, camera.height) > kMaxImageSide)
      throw ConfigError(fmt::format("--scale: found '{}', which makes {}x{} pixels, expected sides up to {}", scale,
                                    camera.width, camera.height, kMaxImageSide));
  }
  return cameras;
}

std::optional<std::vector<Camera>> CameraArguments::read(Findings& findings) const {
  if (up == std::vector<double>{0, 0, 0}) throw ConfigError("--up: found '0,0,0', expected a direction");
  const CameraReading how = reading();
  if (file.empty()) {
    if (ignore_distortion) throw ConfigError("--ignore-distortion: found no --cameras, expected a file of them");
    return std::nullopt;
  }
  if (frames())
    throw ConfigError("--cameras: found --orbit, --from, --look-at, --up or --fov too, expected a file or a framing");
  return scaled(read_cameras(file, how, findings));
}

std::vector<Camera> CameraArguments::views(const std::optional<std::vector<Camera>>& given, const Scene& scene,
                                           bool own, const glm::dvec3& origin) const {
  if (!given) return frame(scene, own, origin);
  std::vector<Camera> cameras = *given;
  for (Camera& camera : cameras) camera.position -= origin;
  return cameras;
}

std::vector<Camera> CameraArguments::frame(const Scene& scene, bool own, const glm::dvec3& origin) const {
  const CameraReading how = reading();
  if (own && !frames()) {
    std::vector<Camera> cameras = generated_cameras();
    for (Camera& camera : cameras) {
      if (how.width > 0) camera = resized(camera, how.width, how.height);
    }
    return scaled(std::move(cameras));
  }
  Framing framing;
  if (how.width > 0) framing.width = how.width, framing.height = how.height;
  if (orbit > 0) framing.views = orbit;
  if (fov > 0) framing.fov = fov;
  framing.from = vector_of(from);
  framing.look_at = vector_of(look_at);
  if (framing.from) *framing.from -= origin;
  if (framing.look_at) *framing.look_at -= origin;
  framing.up = vector_of(up);
  return scaled(framed_cameras(scene, framing));
}

}  // namespace pipegs
