// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/photos: PNG and JPEG are read alike, whatever they are named; what is cut, of another
// size or of another kind is refused in one line; a smaller picture is the mean of what each pixel covers.
#include "sim/photos/photograph.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstdio>
#include <random>

// It needs <cstdio>.
#include <jpeglib.h>

#include "scenes/input_error.hpp"
#include "verif/frame/scenes.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {
namespace {

void write_jpeg(const std::filesystem::path& path, const Rgb8& picture, bool progressive = false) {
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  std::FILE* file = std::fopen(path.c_str(), "wb");
  jpeg_stdio_dest(&jpeg, file);
  jpeg.image_width = static_cast<JDIMENSION>(picture.width);
  jpeg.image_height = static_cast<JDIMENSION>(picture.height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 98, TRUE);
  jpeg.comp_info[0].h_samp_factor = jpeg.comp_info[0].v_samp_factor = 1;  // colours as sharp as brightness
  if (progressive) jpeg_simple_progression(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  while (jpeg.next_scanline < jpeg.image_height) {
    auto* row = const_cast<JSAMPROW>(picture.data.data() +
                                     std::size_t{jpeg.next_scanline} * static_cast<std::size_t>(picture.width) * 3);
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::fclose(file);
}

// Smooth, so that JPEG keeps it to a few codes.
Rgb8 waves(int width, int height) {
  Rgb8 picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const double phase : {0.0, 2.0, 4.0})
        picture.data.push_back(static_cast<std::uint8_t>(127.5 + 100 * std::sin(0.05 * (x + 2 * y) + phase)));
    }
  }
  return picture;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_refused(const std::filesystem::path& path, const std::vector<std::string>& words) {
  try {
    read_photograph(path, test_camera(40, 30));
    ADD_FAILURE() << "was accepted: " << path;
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
    for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " in " << message;
  }
}

TEST(Photograph, BothKindsAreReadByWhatTheyHold) {
  const ScratchFolder scratch;
  const Rgb8 wanted = waves(40, 30);
  write_png8(scratch / "a.jpg", wanted);  // the name says nothing
  EXPECT_EQ(read_photograph(scratch / "a.jpg", test_camera(40, 30)).data, wanted.data);
  for (const bool progressive : {false, true}) {
    write_jpeg(scratch / "b.png", wanted, progressive);
    const Rgb8 found = read_photograph(scratch / "b.png", test_camera(40, 30));
    ASSERT_EQ(found.data.size(), wanted.data.size());
    for (std::size_t i = 0; i < found.data.size(); ++i) EXPECT_NEAR(found.data[i], wanted.data[i], 4) << i;
  }
}

TEST(Photograph, AnotherSizeIsRefused) {
  const ScratchFolder scratch;
  write_png8(scratch / "a.png", waves(40, 31));
  write_jpeg(scratch / "a.jpg", waves(41, 30));
  expect_refused(scratch / "a.png", {"found 40x31 pixels, expected 40x30"});
  expect_refused(scratch / "a.jpg", {"found 41x30 pixels, expected 40x30"});
}

TEST(Photograph, WhatIsCutIsRefused) {
  const ScratchFolder scratch;
  write_png8(scratch / "a.png", waves(40, 30));
  write_jpeg(scratch / "a.jpg", waves(40, 30));
  for (const char* name : {"a.png", "a.jpg"}) {
    const std::string whole = content(scratch / name);
    for (std::size_t length = 0; length + 12 < whole.size(); length += 1 + length / 8)
      expect_refused(scratch.write(std::string("cut_") + name, whole.substr(0, length)), {});
  }
  scratch.write("text.png", "not a picture at all, but long enough to be one");
  expect_refused(scratch / "text.png", {"neither a PNG nor a JPEG"});
  expect_refused(scratch / "missing.png", {"found no file"});
  expect_refused(scratch / "", {"found a folder"});
}

// Bytes changed by chance end in a picture or in one line; a header that promises more is refused by its size.
TEST(Photograph, BrokenOnesAreReadOrRefused) {
  const ScratchFolder scratch;
  write_png8(scratch / "a.png", waves(40, 30));
  write_jpeg(scratch / "a.jpg", waves(40, 30), true);
  std::mt19937 random(7);
  for (const char* name : {"a.png", "a.jpg"}) {
    const std::string whole = content(scratch / name);
    for (int i = 0; i < 150; ++i) {
      std::string bytes = whole;
      for (int k = 0; k < 1 + i % 4; ++k) bytes[4 + random() % (bytes.size() - 4)] = static_cast<char>(random());
      try {
        EXPECT_EQ(read_photograph(scratch.write("b", bytes), test_camera(40, 30)).width, 40);
      } catch (const InputError& error) { EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos); }
    }
  }
}

void write_png(const std::filesystem::path& path, png_uint_32 format, const void* pixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = 40, png.height = 30;
  png.format = format;
  ASSERT_NE(png_image_write_to_file(&png, path.c_str(), 0, pixels, 0, nullptr), 0);
}

TEST(Photograph, AlphaStandsOverBlackAndSixteenBitsAreRefused) {
  const ScratchFolder scratch;
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 40 * 30; ++i)
    pixels.insert(pixels.end(), {200, 100, 50, static_cast<std::uint8_t>(i == 0 ? 255 : 0)});
  write_png(scratch / "alpha.png", PNG_FORMAT_RGBA, pixels.data());
  const Rgb8 found = read_photograph(scratch / "alpha.png", test_camera(40, 30));
  EXPECT_EQ(found.data[0], 200);
  EXPECT_EQ(found.data[3], 0);
  const std::vector<std::uint16_t> wide(40 * 30 * 3, 1000);
  write_png(scratch / "wide.png", PNG_FORMAT_LINEAR_RGB, wide.data());
  expect_refused(scratch / "wide.png", {"found 16 bits", "expected 8"});
  const std::vector<std::uint8_t> grey(40 * 30, 77);
  write_png(scratch / "grey.png", PNG_FORMAT_GRAY, grey.data());
  EXPECT_EQ(read_photograph(scratch / "grey.png", test_camera(40, 30)).data[5], 77);
}

TEST(Photograph, ASmallerOneIsTheMeanOfWhatItCovers) {
  // Three columns to two: the middle one goes half to each.
  const Rgb8 three{3, 1, {0, 10, 20, 90, 90, 90, 30, 60, 3}};
  const Rgb8 two = shrunk(three, 2, 1);
  EXPECT_EQ(two.data, (std::vector<std::uint8_t>{30, 37, 43, 50, 70, 32}));
  // Two rows to one, rounded to the nearest.
  const Rgb8 rows{1, 2, {10, 255, 0, 13, 255, 1}};
  EXPECT_EQ(shrunk(rows, 1, 1).data, (std::vector<std::uint8_t>{12, 255, 1}));
  EXPECT_EQ(shrunk(three, 3, 1).data, three.data);
  const Rgb8 flat{37, 23, std::vector<std::uint8_t>(37 * 23 * 3, 200)};
  EXPECT_EQ(shrunk(flat, 5, 3).data, std::vector<std::uint8_t>(45, 200));
}

}  // namespace
}  // namespace pipegs
