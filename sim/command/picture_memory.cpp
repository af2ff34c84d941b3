// SPDX-License-Identifier: Apache-2.0
// picture_memory.cpp: see picture_memory.hpp.
#include "sim/command/picture_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "scenes/input_error.hpp"

namespace pipegs {

void check_picture_memory(const Camera& camera, const SimulateOptions& options, const PixelBytes& bytes) {
  const auto width = static_cast<uint64_t>(camera.width), height = static_cast<uint64_t>(camera.height);
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  const uint64_t asked = static_cast<uint64_t>(r.x1 - r.x0) * static_cast<uint64_t>(r.y1 - r.y0);
  const uint64_t needed = width * height * bytes.frame + asked * bytes.asked;
  constexpr uint64_t kSmall = uint64_t{1} << 26, kSaid = 1000000000;
  if (needed <= kSmall) return;  // not worth a look
  const uint64_t free = free_memory();
  static bool said = false;
  if (needed <= free && needed > kSaid && !std::exchange(said, true))
    fmt::print(stderr, "note: camera {}: {}x{} pixels take up to {:.1f} GB of memory\n", quote(camera.name),
               camera.width, camera.height, static_cast<double>(needed) / 1e9);
  if (needed <= free) return;
  throw InputError(fmt::format("camera {}: {}x{} pixels would take {} bytes ({:.1f} GB) of memory, {:.1f} GB are free",
                               quote(camera.name), camera.width, camera.height, needed,
                               static_cast<double>(needed) / 1e9, static_cast<double>(free) / 1e9));
}

}  // namespace pipegs
