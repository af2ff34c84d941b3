// SPDX-License-Identifier: Apache-2.0
// cameras_fuzz: any bytes as a file of cameras: each camera can be looked through, or there is an InputError.
//
// Idea    JSON of every format begins as JSON does, or is large (repeated.hpp); another first byte says which of
//         COLMAP's files the rest is.
#include <cstdlib>

#include "scenes/camera.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "verif/fuzz/keep.hpp"
#include "verif/fuzz/repeated.hpp"

namespace {

using namespace pipegs;

std::vector<Camera> cameras_of(std::string_view bytes) {
  const std::string_view rest = bytes.substr(bytes.empty() ? 0 : 1);
  const std::vector<ColmapLens> one = {{.id = 7, .width = 4, .height = 3, .fx = 2, .fy = 2, .cx = 2, .cy = 1}};
  const std::vector<ColmapPose> origin = {{.id = 1, .lens = 7, .rotation = {1, 0, 0, 0}, .name = "a"}};
  const char kind = bytes.empty() ? ' ' : bytes[0];
  if (kind == 'c' || kind == 'C') {
    std::vector<ColmapLens> lenses = parse_colmap_lenses(kind == 'c' ? "cameras.bin" : "cameras.txt", rest, true);
    for (ColmapLens& lens : lenses) lens.id = 7;
    return colmap_cameras("images.bin", lenses.empty() ? one : lenses, origin);
  }
  if (kind == 'i' || kind == 'I') {
    std::vector<ColmapPose> poses = parse_colmap_poses(kind == 'i' ? "images.bin" : "images.txt", rest);
    return colmap_cameras("images.bin", one, poses);
  }
  return parse_cameras("fuzz.json", repeated(bytes), {.width = 4, .height = 3});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    Kept<16> kept;
    for (const Camera& camera : cameras_of({reinterpret_cast<const char*>(data), size})) {
      const bool sized = camera.width >= 1 && camera.width <= kMaxImageSide && camera.height >= 1;
      const bool turned = std::abs(glm::determinant(camera.world_to_camera) - 1) < 1e-9;
      if (!sized || !turned || !(camera.fx > 0) || !(camera.fy > 0)) std::abort();
      kept.add(camera.name);
    }
  } catch (const InputError& error) { refused(error); }
  return 0;
}
