// SPDX-License-Identifier: Apache-2.0
// picture_test: what `pipegs` makes of a frame's pixels: a part of them, over a background, at another scale.
#include "cpp_model/float/image.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class PictureCli : public Cli {
 protected:
  const std::string dop_ = view_ + "--design dop ";

  Rgb8 picture(const std::string& command) {
    fs::remove_all(folder_ / "pictures");
    const Outcome outcome = run(command + " --out pictures");
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
    return read_png8(folder_ / "pictures" / "frame.png");
  }
  static std::vector<uint8_t> part(const Rgb8& whole, int x, int y, int width, int height) {
    std::vector<uint8_t> data;
    for (int row = y; row < y + height; ++row) {
      const auto begin = whole.data.begin() + 3 * (row * whole.width + x);
      data.insert(data.end(), begin, begin + 3 * width);
    }
    return data;
  }
};

TEST_F(PictureCli, ACropHoldsThePixelsOfTheWholePicture) {
  const std::string sim = "sim" + dop_ + "--no-truth ";
  const Rgb8 whole = picture(sim), crop = picture(sim + "--crop 40,3,29,47");
  EXPECT_EQ(crop.width, 29);
  EXPECT_EQ(crop.height, 47);
  EXPECT_EQ(crop.data, part(whole, 40, 3, 29, 47));
  const auto report = Json::parse(text("pictures/report.json"));
  EXPECT_EQ(report["crop"], (std::vector<int>{40, 3, 29, 47}));
  EXPECT_EQ(report["mismatches"], 0);
  EXPECT_EQ(picture(sim + "--crop 60,3,10,20 --picture raster").data, part(whole, 60, 3, 10, 20));
  EXPECT_EQ(picture("render" + dop_ + "--crop 40,3,29,47").data, crop.data);
  const std::string truth = "render" + dop_ + "--model truth ";
  EXPECT_EQ(picture(truth + "--crop 1,2,3,4").data, part(picture(truth), 1, 2, 3, 4));
}

TEST_F(PictureCli, ABackgroundShinesThrough) {
  const std::string sim = "sim" + dop_ + "--no-truth ";
  const Rgb8 black = picture(sim), white = picture(sim + "--background '#FFffff'");
  int brighter = 0;
  for (size_t i = 0; i < black.data.size(); ++i) {
    EXPECT_GE(white.data[i], black.data[i]) << i;
    brighter += white.data[i] > black.data[i];
  }
  EXPECT_GT(brighter, 1000);
  EXPECT_EQ(picture(sim + "--background 255,255,255").data, white.data);
  EXPECT_EQ(picture(sim + "--background 0,0,0").data, black.data);
  EXPECT_EQ(picture("render" + dop_ + "--background 255,255,255").data, white.data);
  // As the truth has it, but for the machine's errors.
  const Rgb8 truth = picture("render" + dop_ + "--model truth --background 255,255,255");
  for (size_t i = 0; i < truth.data.size(); ++i) EXPECT_NEAR(truth.data[i], white.data[i], 12) << i;
}

TEST_F(PictureCli, PixelsWithoutTAreMadeWiderOrRefused) {
  const std::string sim = "sim scene.ply --cameras cameras.json --design fast --no-truth --no-rtl ";
  EXPECT_EQ(picture(sim + "--background 9,9,9").width, 70);
  EXPECT_EQ(Json::parse(text("pictures/report.json"))["config"]["pixel_w"], 64);
  picture(sim);
  EXPECT_EQ(Json::parse(text("pictures/report.json"))["config"]["pixel_w"], 32);
  fs::remove_all(folder_ / "pictures");
  const std::string wish = "--background: found pixel_w=32, whose pixels hold no T, expected 64";
  expect_refused(sim + "--background 9,9,9 --set pixel_w=32", wish);
  write("narrow.cfg", "pixel_w=32\n");
  expect_refused(sim + "--background 9,9,9 --config narrow.cfg", wish);
  expect_refused(sim + "--background 9,9,9 --picture raster", "--background: found --picture raster");
}

TEST_F(PictureCli, ScaleIsOfTheCamera) {
  EXPECT_EQ(picture("render" + dop_ + "--scale 0.5").width, 35);
  const Rgb8 twice = picture("render" + dop_ + "--scale 2");
  EXPECT_EQ(twice.width, 140);
  EXPECT_EQ(twice.height, 100);
  EXPECT_EQ(twice.data, picture("render" + dop_ + "--size 140x100").data);
  EXPECT_EQ(picture("render" + dop_ + "--scale 2 --crop 130,90,10,10").data, part(twice, 130, 90, 10, 10));
}

TEST_F(PictureCli, BadPicturesAreOneLine) {
  const std::string sim = "sim" + dop_ + "--no-truth --no-rtl ";
  for (const char* crop : {"", "1", "1,2,3", "1,2,3,4,5", "1,,3,4", "-1,0,5,5", "0,0,0,5", "0,0,5,0", "a,b,c,d",
                           "0,0,99999999999,1", "1.5,0,5,5", "0;0;5;5"})
    expect_refused(sim + "--crop '" + crop + "'", "--crop: found ");
  for (const char* crop : {"0,0,71,50", "0,0,70,51", "70,0,1,1", "16384,16384,16384,16384"})
    expect_refused(sim + "--crop " + crop, std::string("--crop ") + crop + ": expected a rectangle of 70x50 pixels");
  expect_refused(sim + "--crop 0,0,1,1 --window 0,0", "--window excludes --crop");
  for (const char* color :
       {"", "white", "1,2", "1,2,3,4", "256,0,0", "-1,0,0", "#fff", "#fffffg", "#ffffff0", "1.0,0,0"})
    expect_refused(sim + "--background '" + color + "'", "--background: found ");
  for (const char* scale : {"0", "-1", "nan", "1e9", "0.001"})
    expect_refused(sim + "--scale " + scale, "--scale: found ");
  expect_refused(sim + "--scale 100 --size 200x200", "--scale: found '100', which makes 20000x20000 pixels");
}

}  // namespace
}  // namespace pipegs
