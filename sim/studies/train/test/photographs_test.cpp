// SPDX-License-Identifier: Apache-2.0
// Against sim/photos: PNG and JPEG are read alike, whatever they are named, with their orientation, depth and colours;
// what is cut, of another size or of another kind is refused in one line; a smaller picture is the mean of what each
// pixel covers.
#include "sim/photos/photograph.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

// It needs <cstdio>.
#include <jpeglib.h>

#include "scenes/input_error.hpp"
#include "sim/photos/color_profile.hpp"
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

Rgb8 read(const std::filesystem::path& path) { return read_photograph(path, test_camera(40, 30)).picture; }

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_refused(const std::filesystem::path& path, const std::vector<std::string>& words) {
  try {
    read(path);
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
  EXPECT_EQ(read(scratch / "a.jpg").data, wanted.data);
  for (const bool progressive : {false, true}) {
    write_jpeg(scratch / "b.png", wanted, progressive);
    const Rgb8 found = read(scratch / "b.png");
    ASSERT_EQ(found.data.size(), wanted.data.size());
    for (std::size_t i = 0; i < found.data.size(); ++i) EXPECT_NEAR(found.data[i], wanted.data[i], 4) << i;
  }
}

TEST(Photograph, AnotherSizeIsRefused) {
  const ScratchFolder scratch;
  write_png8(scratch / "a.png", waves(40, 31));
  write_jpeg(scratch / "a.jpg", waves(42, 30));
  expect_refused(scratch / "a.png", {"found 40x31 pixels, expected 40x30"});
  expect_refused(scratch / "a.jpg", {"found 42x30 pixels, expected 40x30"});
}

// A tag of EXIF in a marker of its own, both byte orders; of the first directory or of the one below it.
std::string with_exif(const std::string& jpeg, unsigned tag, unsigned value, bool big, bool below = false) {
  std::string exif("Exif\0\0", 6);
  const auto put = [&](unsigned value, int bytes) {
    for (int k = 0; k < bytes; ++k) exif += static_cast<char>(value >> 8 * (big ? bytes - 1 - k : k) & 255);
  };
  exif += big ? "MM" : "II";
  put(42, 2), put(8, 4);
  if (below) put(1, 2), put(0x8769, 2), put(4, 2), put(1, 4), put(26, 4), put(0, 4);
  put(1, 2), put(tag, 2), put(3, 2), put(1, 4), put(value, 2), put(0, 2), put(0, 4);
  const std::size_t length = exif.size() + 2;
  return jpeg.substr(0, 2) + "\xff\xe1" + static_cast<char>(length >> 8) + static_cast<char>(length & 255) + exif +
         jpeg.substr(2);
}

// Row 0 and column 0 of what is stored stand where the orientation says.
TEST(Photograph, OneThatIsStoredTurnedIsTurned) {
  const ScratchFolder scratch;
  Rgb8 stored{30, 40, std::vector<std::uint8_t>(30 * 40 * 3, 40)};
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 10; ++x) stored.data[3 * static_cast<std::size_t>(30 * y + x)] = 220;  // a red corner
  }
  write_jpeg(scratch / "stored.jpg", stored);
  const std::string plain = content(scratch / "stored.jpg");
  const std::vector<std::array<int, 3>> corners = {{5, 2, 2}, {6, 37, 2}, {7, 37, 27}, {8, 2, 27}};
  for (const auto& [orientation, x, y] : corners) {
    for (const bool big : {false, true}) {
      const auto path = scratch.write("turned.jpg", with_exif(plain, 0x0112, static_cast<unsigned>(orientation), big));
      const Photograph photograph = read_photograph(path, test_camera(40, 30));
      EXPECT_TRUE(photograph.turned);
      ASSERT_EQ(photograph.picture.width, 40);
      for (const auto& [other, column, row] : corners)
        EXPECT_EQ(photograph.picture.data[3 * static_cast<std::size_t>(40 * row + column)] > 130, other == orientation);
      EXPECT_FALSE(read_photograph(path, test_camera(30, 40)).turned) << "it fits as it is stored";
    }
  }
  expect_refused(scratch.write("a.jpg", plain), {"found 30x40 pixels, expected 40x30", "turned by a quarter"});
}

// Orientations that leave the size as it is, and turns that the camera does not need: as stored, and said.
TEST(Photograph, OneThatFitsAsItIsStoredStays) {
  const ScratchFolder scratch;
  write_jpeg(scratch / "plain.jpg", waves(40, 30));
  for (const unsigned orientation : {1, 2, 3, 4, 6}) {
    const auto path = scratch.write("a.jpg", with_exif(content(scratch / "plain.jpg"), 0x0112, orientation, true));
    const Photograph photograph = read_photograph(path, test_camera(40, 30));
    EXPECT_EQ(photograph.picture.data, read(scratch / "plain.jpg").data);
    PhotographFindings found;
    found.add("a.jpg", photograph);
    ASSERT_EQ(found.all().size(), orientation == 1 ? 0u : 1u) << orientation;
    if (orientation > 1) EXPECT_EQ(found.all()[0].kind->key, "unturned_photographs");
  }
}

TEST(Photograph, ACameraFollowsAnotherSizeOfTheSameShape) {
  const ScratchFolder scratch;
  write_png8(scratch / "half.png", waves(20, 15));
  const Photograph half = read_photograph(scratch / "half.png", test_camera(40, 30));
  EXPECT_TRUE(half.resized);
  EXPECT_EQ(half.camera.width, 20);
  EXPECT_EQ(half.camera.fx, 50);
  EXPECT_EQ(half.camera.cx, 9.5);
  write_png8(scratch / "other.png", waves(20, 18));
  EXPECT_THROW(read_photograph(scratch / "other.png", test_camera(40, 30)), InputError);
}

// What a PNG may hold beside codes of 8 bits.
struct PngKind {
  bool deep = false;
  double gamma = 0;
  std::string icc = {};
  std::string exif = {};
  std::string cicp = {};
  bool p3 = false;  // primaries in a cHRM
};

void write_png(const std::filesystem::path& path, const Rgb8& picture, const PngKind& kind) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::FILE* file = std::fopen(path.c_str(), "wb");
  ASSERT_TRUE(file != nullptr);
  png_init_io(png, file);
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
               kind.deep ? 16 : 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (kind.gamma > 0) png_set_gAMA(png, info, kind.gamma);
  if (!kind.icc.empty())
    png_set_iCCP(png, info, "of a test", 0, reinterpret_cast<png_const_bytep>(kind.icc.data()),
                 static_cast<png_uint_32>(kind.icc.size()));
  std::string exif = kind.exif;
  if (!exif.empty())
    png_set_eXIf_1(png, info, static_cast<png_uint_32>(exif.size()), reinterpret_cast<png_bytep>(exif.data()));
  if (kind.p3) png_set_cHRM(png, info, 0.3127, 0.329, 0.68, 0.32, 0.265, 0.69, 0.15, 0.06);
  png_write_info(png, info);
  if (!kind.cicp.empty())
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("cICP"), reinterpret_cast<png_const_bytep>(kind.cicp.data()),
                    kind.cicp.size());
  for (int y = 0; y < picture.height; ++y) {
    std::vector<png_byte> line;
    for (int i = 0; i < 3 * picture.width; ++i) {
      const std::uint8_t code = picture.data[static_cast<std::size_t>(3 * picture.width * y + i)];
      line.insert(line.end(), kind.deep ? 2 : 1, code);  // of 16 bits 257 times the code
    }
    png_write_row(png, line.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

void put(std::string& bytes, std::size_t at, std::string_view text) { bytes.replace(at, text.size(), text); }

std::string big(std::uint32_t value) {
  std::string bytes;
  for (int k = 24; k >= 0; k -= 8) bytes += static_cast<char>(value >> k & 255);
  return bytes;
}

// A profile of a screen with these primaries, adapted to D50.
std::string icc(const std::string& name, const std::array<double, 9>& xyz) {
  const std::size_t described = 132 + 4 * 12, text = 12 + (name.size() + 1 + 78 + 3) / 4 * 4;
  std::string bytes(described + text + 3 * 20, '\0');
  put(bytes, 0, big(static_cast<std::uint32_t>(bytes.size())));
  put(bytes, 8, big(0x02100000));
  put(bytes, 12, "mntrRGB XYZ ");
  put(bytes, 36, "acsp");
  put(bytes, 68, big(0xf6d6) + big(0x10000) + big(0xd32d));
  put(bytes, 128, big(4));
  put(bytes, 132, "desc" + big(described) + big(static_cast<std::uint32_t>(text)));
  put(bytes, described, "desc");
  put(bytes, described + 8, big(static_cast<std::uint32_t>(name.size() + 1)) + name);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t at = described + text + 20 * k;
    put(bytes, 132 + 12 * (k + 1), std::string(1, "rgb"[k]) + "XYZ" + big(static_cast<std::uint32_t>(at)) + big(20));
    put(bytes, at, "XYZ ");
    for (std::size_t i = 0; i < 3; ++i)
      put(bytes, at + 8 + 4 * i, big(static_cast<std::uint32_t>(std::lround(xyz[3 * k + i] * 65536))));
  }
  return bytes;
}

const std::string& srgb() {
  static const std::string bytes =
      icc("another sRGB", {0.4361, 0.2225, 0.0139, 0.3851, 0.7169, 0.0971, 0.1431, 0.0606, 0.7141});
  return bytes;
}
const std::string& p3() {
  static const std::string bytes =
      icc("Display P3", {0.5151, 0.2412, -0.0011, 0.2919, 0.6922, 0.0419, 0.1572, 0.0666, 0.7841});
  return bytes;
}

TEST(Photograph, SixteenBitsAndGammasBecomeCodesOfSrgb) {
  const ScratchFolder scratch;
  const Rgb8 wanted = waves(40, 30);
  write_png(scratch / "deep.png", wanted, {.deep = true});
  const Photograph deep = read_photograph(scratch / "deep.png", test_camera(40, 30));
  EXPECT_TRUE(deep.deep);
  EXPECT_FALSE(deep.gamma);
  EXPECT_EQ(deep.picture.data, wanted.data);
  write_png(scratch / "said.png", wanted, {.gamma = 0.45455});
  EXPECT_FALSE(read_photograph(scratch / "said.png", test_camera(40, 30)).gamma);
  EXPECT_EQ(read(scratch / "said.png").data, wanted.data);
  for (const bool wide : {false, true}) {
    const Rgb8 linear{40, 30, std::vector<std::uint8_t>(40 * 30 * 3, 55)};
    write_png(scratch / "linear.png", linear, {.deep = wide, .gamma = 1});
    const Photograph light = read_photograph(scratch / "linear.png", test_camera(40, 30));
    EXPECT_TRUE(light.gamma);
    EXPECT_EQ(light.deep, wide);
    EXPECT_NEAR(light.picture.data[0], 255 * std::pow(55 / 255.0, 1 / 2.2), 1.5);
  }
}

// Codes of other colours are left alone and named; the many profiles of sRGB are one.
TEST(Photograph, AnotherProfileIsNamed) {
  const ScratchFolder scratch;
  const Rgb8 wanted = waves(40, 30);
  write_jpeg(scratch / "plain.jpg", wanted);
  const std::string plain = content(scratch / "plain.jpg");
  const auto marker = [](const std::string& part, int number, int all) {
    const std::string body =
        std::string("ICC_PROFILE\0", 12) + static_cast<char>(number) + static_cast<char>(all) + part;
    const std::size_t length = body.size() + 2;
    return "\xff\xe2" + std::string(1, static_cast<char>(length >> 8)) + static_cast<char>(length & 255) + body;
  };
  PhotographFindings found;
  for (const auto& [profile, name] : {std::pair{srgb(), ""}, {p3(), "Display P3"}}) {
    write_png(scratch / "a.png", wanted, {.icc = profile});
    const Photograph of_png = read_photograph(scratch / "a.png", test_camera(40, 30));
    EXPECT_EQ(of_png.profile, name);
    EXPECT_EQ(of_png.picture.data, wanted.data);
    const std::string parts = marker(profile.substr(0, 100), 1, 2) + marker(profile.substr(100), 2, 2);
    const Photograph of_jpeg =
        read_photograph(scratch.write("a.jpg", plain.substr(0, 2) + parts + plain.substr(2)), test_camera(40, 30));
    EXPECT_EQ(of_jpeg.profile, name);
    EXPECT_EQ(of_jpeg.picture.data, read(scratch / "plain.jpg").data);
    found.add("a.png", of_png);
    found.add("b.jpg", of_jpeg);
  }
  ASSERT_EQ(found.all().size(), 1u);
  EXPECT_EQ(found.all()[0].kind->key, "profiled_photographs");
  EXPECT_NE(found.all()[0].what.find("2 of 4 photographs, the first is 'a.png' ('Display P3')"), std::string::npos)
      << found.all()[0].what;
  for (std::size_t length = 0; length < p3().size(); length += 7)  // cut: as a library may leave it
    foreign_profile(p3().substr(0, length));
}

// Where there is no profile but another word about the colours.
TEST(Photograph, OtherColorsAreNamed) {
  const ScratchFolder scratch;
  const Rgb8 wanted = waves(40, 30);
  for (const auto& [kind, name] : std::vector<std::pair<PngKind, std::string>>{
           {{.cicp = std::string("\1\15\0\1", 4)}, ""},
           {{.cicp = std::string("\14\15\0\1", 4)}, "Display P3"},
           {{.cicp = std::string("\11\20\0\1", 4)}, "BT.2020, PQ"},
           {{.cicp = std::string("\11\22\0\1", 4)}, "BT.2020, HLG"},
           {{.cicp = std::string("\3\2\0\1", 4)}, "primaries 3, transfer 2"},
           {{.icc = srgb(), .cicp = std::string("\14\15\0\1", 4)}, "Display P3"},
           {{.icc = p3(), .cicp = std::string("\1\15\0\1", 4)}, ""},
           {{.p3 = true}, "primaries of cHRM"},
           {{.icc = srgb(), .p3 = true}, ""}}) {
    write_png(scratch / "a.png", wanted, kind);
    const Photograph found = read_photograph(scratch / "a.png", test_camera(40, 30));
    EXPECT_EQ(found.profile, name);
    EXPECT_EQ(found.picture.data, wanted.data);
  }
  write_jpeg(scratch / "plain.jpg", wanted);
  const auto said = [&](unsigned value, bool below) {
    const std::string jpeg = with_exif(content(scratch / "plain.jpg"), 0xa001, value, below, below);
    return read_photograph(scratch.write("a.jpg", jpeg), test_camera(40, 30)).profile;
  };
  EXPECT_EQ(said(1, true), "");
  EXPECT_EQ(said(2, true), "Adobe RGB, as EXIF says");
  EXPECT_EQ(said(0xffff, true), "not sRGB, as EXIF says");
  EXPECT_EQ(said(0xffff, false), "not sRGB, as EXIF says");
}

TEST(Photograph, APngIsTurnedAsItsExifSays) {
  const ScratchFolder scratch;
  std::string exif = "MM" + std::string("\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0\6\0\0\0\0\0\0", 24);
  write_png(scratch / "a.png", waves(30, 40), {.exif = exif});
  const Photograph found = read_photograph(scratch / "a.png", test_camera(40, 30));
  EXPECT_TRUE(found.turned);
  EXPECT_EQ(found.picture.width, 40);
}

TEST(Photograph, InksBecomeLight) {
  const ScratchFolder scratch;
  jpeg_compress_struct jpeg;
  jpeg_error_mgr errors;
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  std::FILE* file = std::fopen((scratch / "inks.jpg").c_str(), "wb");
  jpeg_stdio_dest(&jpeg, file);
  jpeg.image_width = 40, jpeg.image_height = 30, jpeg.input_components = 4;
  jpeg.in_color_space = JCS_CMYK;
  jpeg_set_defaults(&jpeg);  // with Adobe's marker: inks are inverted
  jpeg_set_quality(&jpeg, 98, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<JSAMPLE> line;
  for (int x = 0; x < 40; ++x) line.insert(line.end(), {200, 100, 50, 255});
  while (jpeg.next_scanline < jpeg.image_height) {
    JSAMPROW row = line.data();
    jpeg_write_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::fclose(file);
  const Photograph photograph = read_photograph(scratch / "inks.jpg", test_camera(40, 30));
  EXPECT_TRUE(photograph.inks);
  EXPECT_NEAR(photograph.picture.data[0], 200, 4);
  EXPECT_NEAR(photograph.picture.data[1], 100, 4);
  EXPECT_NEAR(photograph.picture.data[2], 50, 4);
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
        EXPECT_EQ(read(scratch.write("b", bytes)).width, 40);
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

TEST(Photograph, AlphaStandsOverBlackAndGreyIsGrey) {
  const ScratchFolder scratch;
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 40 * 30; ++i)
    pixels.insert(pixels.end(), {200, 100, 50, static_cast<std::uint8_t>(i == 0 ? 255 : 0)});
  write_png(scratch / "alpha.png", PNG_FORMAT_RGBA, pixels.data());
  const Rgb8 found = read(scratch / "alpha.png");
  EXPECT_EQ(found.data[0], 200);
  EXPECT_EQ(found.data[3], 0);
  const std::vector<std::uint8_t> grey(40 * 30, 77);
  write_png(scratch / "grey.png", PNG_FORMAT_GRAY, grey.data());
  EXPECT_EQ(read(scratch / "grey.png").data[5], 77);
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
