// SPDX-License-Identifier: Apache-2.0
// image: PNG and EXR files; see image.hpp.
//
// Idea    libpng's simplified interface, which reports errors without longjmp. It reads any PNG as 8 bit RGB: a regular
//         file, with no more pixels than its bytes can hold. A NaN (a renderer's fault) is written as 0 and never as
//         undefined behaviour.
#include "cpp_model/float/image.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <png.h>

#include <cmath>
#include <exception>
#include <memory>
#include <string>

#include "scenes/atomic_file.hpp"
#include "scenes/camera.hpp"
#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/text/text_file.hpp"

namespace pipegs {
namespace {

// Deflate makes at most 1032 bytes of one, and a bit at most the three bytes of a pixel.
constexpr std::uint64_t kMostPixelsPerByte = std::uint64_t{1032} * 8;

// libpng takes the memory that the header asks for.
void check_fits(const std::filesystem::path& path, const png_image& png) {
  const std::uint64_t bytes = std::filesystem::file_size(path), pixels = std::uint64_t{png.width} * png.height;
  if (png.width <= kMaxImageSide && png.height <= kMaxImageSide && pixels <= bytes * kMostPixelsPerByte) return;
  throw InputError(path.string(), "",
                   "found " + std::to_string(png.width) + "x" + std::to_string(png.height) + " pixels in " +
                       std::to_string(bytes) + " bytes, expected a picture of at most " +
                       std::to_string(kMaxImageSide) + "x" + std::to_string(kMaxImageSide) + " that is whole");
}

}  // namespace

Image::Image(int width_pixels, int height_pixels) : width(width_pixels), height(height_pixels) {
  const std::size_t n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  rgb.assign(n, glm::dvec3(0));
  transmittance.assign(n, 1.0);
  depth.assign(n, 0.0);
  blended.assign(n, 0);
}

Rgb8 to_rgb8(const Image& image, const glm::dvec3& background) {
  Rgb8 out{image.width, image.height, {}};
  out.data.reserve(image.rgb.size() * 3);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    const glm::dvec3 color = image.rgb[i] + image.transmittance[i] * background;
    for (int c = 0; c < 3; ++c) {
      const double value = color[c] > 0 ? (color[c] < 1 ? color[c] : 1) : 0;
      out.data.push_back(static_cast<std::uint8_t>(std::lround(value * 255)));
    }
  }
  return out;
}

void write_png8(const std::filesystem::path& path, const Rgb8& picture) {
  AtomicFile out(path);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(picture.width);
  png.height = static_cast<png_uint_32>(picture.height);
  png.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&png, out.temporary().c_str(), 0, picture.data.data(), 0, nullptr) == 0) {
    throw OwnFailure(path.string() + ": cannot write: " + png.message);
  }
  out.commit();
}

void write_png(const std::filesystem::path& path, const Image& image, const glm::dvec3& background) {
  write_png8(path, to_rgb8(image, background));
}

Rgb8 read_png8(const std::filesystem::path& path) {
  require_regular_file(path, "a .png file");
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, path.c_str()) == 0) {
    throw InputError(path.string(), "", std::string("cannot read: ") + png.message);
  }
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&png, png_image_free);
  check_fits(path, png);
  png.format = PNG_FORMAT_RGB;
  Rgb8 out{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  out.data.resize(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, out.data.data(), 0, nullptr) == 0) {
    throw InputError(path.string(), "", std::string("cannot read: ") + png.message);
  }
  return out;
}

void write_exr(const std::filesystem::path& path, const Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  Imf::Header header(image.width, image.height);
  Imf::FrameBuffer frame;
  std::vector<std::vector<float>> planes;
  constexpr const char* kNames[] = {"R", "G", "B", "A", "T", "depth", "median"};
  planes.reserve(std::size(kNames));
  for (std::size_t c = 0; c < std::size(kNames) - image.median.empty(); ++c) {
    std::vector<float>& plane = planes.emplace_back(image.rgb.size());
    for (std::size_t i = 0; i < plane.size(); ++i) {
      const double t = image.transmittance[i];
      const double value = c < 3    ? image.rgb[i][static_cast<int>(c)]
                           : c == 3 ? 1 - t
                           : c == 4 ? t
                           : c == 5 ? image.depth[i]
                                    : image.median[i];
      plane[i] = static_cast<float>(value);
    }
    header.channels().insert(kNames[c], Imf::Channel(Imf::FLOAT));
    frame.insert(kNames[c],
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float), sizeof(float) * width));
  }
  std::vector<std::uint32_t> blended = image.blended, index = image.index;  // OpenEXR's slices are not const
  const auto insert = [&](const char* name, std::vector<std::uint32_t>& values) {
    header.channels().insert(name, Imf::Channel(Imf::UINT));
    frame.insert(name, Imf::Slice(Imf::UINT, reinterpret_cast<char*>(values.data()), sizeof(std::uint32_t),
                                  sizeof(std::uint32_t) * width));
  };
  insert("blended", blended);
  if (!index.empty()) insert("index", index);

  AtomicFile out(path);
  try {
    Imf::OutputFile file(out.temporary().c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
  } catch (const std::exception& error) { throw OwnFailure(path.string() + ": cannot write: " + error.what()); }
  out.commit();
}

}  // namespace pipegs
