// SPDX-License-Identifier: Apache-2.0
// image: what a renderer hands over, and the files it is kept in.
//
// Layout  Row-major, pixel (x, y) at y * width + x. rgb is the sum of weight * colour, without a
//         background; transmittance is what is left for the background; depth the sum of
//         weight * view z; blended the number of Gaussians that took part. Where somebody asked for them (else
//         empty): median, view z of the Gaussian with which the transmittance fell below one half, 0 where none did;
//         index of the Gaussian that weighs most, kNoGaussian where none does.
// Files   write_png: 8 bit RGB over a background, clamped to [0,1] and rounded to nearest.
//         write_exr: OpenEXR float channels R G B A (A = 1 - T), T, depth and uint blended, median and uint index
//         where they are.
//         Both appear under their name only when complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace pipegs {

struct Image {
  int width = 0, height = 0;
  std::vector<glm::dvec3> rgb;
  std::vector<double> transmittance, depth;
  std::vector<std::uint32_t> blended;
  std::vector<double> median;
  std::vector<std::uint32_t> index;

  Image() = default;
  Image(int width_pixels, int height_pixels);  // black and fully transparent
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

inline constexpr std::uint32_t kNoGaussian = ~std::uint32_t{0};

struct Rgb8 {
  int width = 0, height = 0;
  std::vector<std::uint8_t> data;  // r,g,b per pixel
};

// The 8 bit picture that write_png stores.
Rgb8 to_rgb8(const Image& image, const glm::dvec3& background);

void write_png(const std::filesystem::path& path, const Image& image, const glm::dvec3& background);
void write_png8(const std::filesystem::path& path, const Rgb8& picture);
Rgb8 read_png8(const std::filesystem::path& path);
void write_exr(const std::filesystem::path& path, const Image& image);

}  // namespace pipegs
