// SPDX-License-Identifier: Apache-2.0
// colmap_fuzz: any bytes as one of COLMAP's files; the first byte says which of the six.
//
// Idea    What is read has the fields that it should have and is no more than the bytes can hold, or there is an
//         InputError. Poses meet a lens, so that cameras come out of them.
#include <cmath>
#include <cstdlib>

#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  if (size == 0) return 0;
  const std::string file = (data[0] & 1) != 0 ? "fuzz.txt" : "fuzz.bin";
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    Kept<2> kept;
    if ((data[0] & 6) == 0) {
      for (const ColmapLens& lens : parse_colmap_lenses(file, bytes)) {
        if (lens.width < 1 || lens.height > kMaxImageSide || !(lens.fx > 0) || !std::isfinite(lens.cy)) std::abort();
      }
    } else if ((data[0] & 6) == 2) {
      for (const ScenePoint& point : parse_colmap_points(file, bytes)) {
        if (!(std::abs(point.position.z) <= kFarthestPoint)) std::abort();
      }
    } else {
      const std::vector<ColmapPose> poses = parse_colmap_poses(file, bytes);
      for (const Camera& camera : colmap_cameras(file, {{1, 40, 30, 50, 50, 20, 15}}, poses)) {
        if (std::abs(glm::determinant(camera.world_to_camera) - 1) > 1e-9) std::abort();
        kept.add(camera.name);
      }
      if (poses.size() > size) std::abort();
    }
  } catch (const InputError& error) { refused(error); }
  return 0;
}
