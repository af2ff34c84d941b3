// SPDX-License-Identifier: Apache-2.0
// picture_memory.hpp: a picture that would not fit in memory is refused before anything is computed.
//
// Idea    A camera of 16384x16384 pixels is legal and takes 70 GB in `pipegs sim`. What each part of a run holds for
//         a pixel is known, so the sum is held against the memory that is free: of the computer, of the container
//         (cgroup) and of the process (ulimit -v), whichever is least.
// Units   Bytes for each pixel: of the whole frame, or of the windows that were asked for.
// Errors  InputError naming the camera, its size, the bytes that it would take and those that are free.
#pragma once

#include <cstdint>

#include "scenes/free_memory.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

struct PixelBytes {
  uint64_t frame = 0, asked = 0;
  PixelBytes operator+(const PixelBytes& o) const { return {frame + o.frame, asked + o.asked}; }
};

// An Image is 44: colour, transmittance, depth, count. Measured as the largest resident size of a run / its pixels.
inline constexpr PixelBytes kGoldenPixels{.frame = 53};           // the image, the RTL's words, who stopped
inline constexpr PixelBytes kTruthPixels{.asked = 176};           // three images, and the golden one cropped to compare
inline constexpr PixelBytes kRtlPixels{.frame = 8, .asked = 16};  // its words, lines of external memory
inline constexpr PixelBytes kWritePixels{.asked = 76};            // a cropped image, and its planes as EXR
inline constexpr PixelBytes kPagePixels{.asked = 16};             // pictures and maps, and their text
inline constexpr PixelBytes kCountPixels{.frame = 2};             // the counts of a tile of 256
inline constexpr PixelBytes kImagePixels{.asked = 44};

// What takes more than a gigabyte is said in one line.
void check_picture_memory(const Camera& camera, const SimulateOptions& options, const PixelBytes& bytes);

}  // namespace pipegs
