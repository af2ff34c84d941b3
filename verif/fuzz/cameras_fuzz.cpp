// SPDX-License-Identifier: Apache-2.0
// cameras_fuzz: any bytes as a cameras.json: each camera can be looked through, or there is an InputError.
#include <cstdlib>

#include "scenes/camera.hpp"
#include "scenes/input_error.hpp"
#include "verif/fuzz/keep.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pipegs;
  try {
    Kept<1> kept;
    for (const Camera& camera : parse_cameras("fuzz.json", {reinterpret_cast<const char*>(data), size})) {
      const bool sized = camera.width >= 1 && camera.width <= kMaxImageSide && camera.height >= 1;
      const bool turned = std::abs(glm::determinant(camera.world_to_camera) - 1) < 1e-9;
      if (!sized || !turned || !(camera.fx > 0) || !(camera.fy > 0)) std::abort();
      kept.add(camera.name);
    }
  } catch (const InputError&) { return 0; }
  return 0;
}
