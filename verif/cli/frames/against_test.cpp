// SPDX-License-Identifier: Apache-2.0
// against_test: `--against`, `--truth` and `render --views`: how far pictures are from photographs and from float64.
//
// Idea    Photographs are made of our own pictures: some codes are changed, so PSNR follows from counting. What differs
//         in one sensible way gives the same figures, all else is refused by name before anything is drawn.
#include <cmath>

#include "cpp_model/float/image.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

constexpr int kWidth = 70, kHeight = 50;

class Against : public Cli {
 protected:
  const std::string sim_ = "sim" + view_ + "--no-rtl --views all ";

  void SetUp() override {
    Cli::SetUp();
    Camera first = test_camera(kWidth, kHeight), second = first, third = first;
    first.name = "one", second.name = "left/IMG_2.JPG", third.name = "three.5";
    second.position.x = 0.2, third.position.x = 0.4;
    write_cameras(folder_ / "cameras.json", {first, second, third});
    fs::create_directories(folder_ / "photos");
  }
  Json json(const std::string& arguments, const std::string& file) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    return Json::parse(text(file));
  }
  Rgb8 drawn(const std::string& file) { return read_png8(folder_ / file); }
  void photograph(const std::string& name, const Rgb8& picture) { write_png8(folder_ / "photos" / name, picture); }
  // Pixels repeated: the mean of what covers one is the pixel.
  static Rgb8 larger(const Rgb8& picture, int times) {
    Rgb8 out{picture.width * times, picture.height * times, {}};
    for (int y = 0; y < out.height; ++y) {
      for (int x = 0; x < out.width; ++x) {
        const auto at = picture.data.begin() + 3 * (y / times * picture.width + x / times);
        out.data.insert(out.data.end(), at, at + 3);
      }
    }
    return out;
  }
};

TEST_F(Against, FiguresOfEachViewTheirMeanAndTheLeast) {
  json("render" + view_ + "--views all --out drawn", "drawn/render.json");
  Rgb8 one = drawn("drawn/frame_0000.png");
  for (size_t i = 0; i < one.data.size(); i += 5) one.data[i] = static_cast<uint8_t>(one.data[i] ^ 16);
  double sum = 0;
  const Rgb8 before = drawn("drawn/frame_0000.png");
  for (size_t i = 0; i < one.data.size(); ++i) sum += std::pow((one.data[i] - before.data[i]) / 255.0, 2);
  const double psnr = -10 * std::log10(sum / static_cast<double>(one.data.size()));
  photograph("one.png", larger(one, 2));
  photograph("IMG_2.png", drawn("drawn/frame_0001.png"));

  for (const char* when : {"measured", "kept"}) {
    SCOPED_TRACE(when);
    const Json sequence = json(sim_ + "--against photos --truth --out out", "out/sequence.json");
    const Json& views = sequence["views"];
    EXPECT_NEAR(views[0]["psnr_db"].get<double>(), psnr, 1e-9);
    EXPECT_LT(views[0]["ssim"], 1);
    EXPECT_EQ(views[0]["photograph"], "photos/one.png");
    EXPECT_TRUE(views[1]["psnr_db"].is_null()) << "equal";
    EXPECT_EQ(views[1]["ssim"], 1);
    EXPECT_FALSE(views[2].contains("psnr_db")) << "there is no photograph";
    const Json& quality = sequence["quality"];
    EXPECT_TRUE(quality["psnr_db"]["mean"].is_null());
    EXPECT_EQ(quality["psnr_db"]["least"], views[0]["psnr_db"]);
    EXPECT_EQ(quality["psnr_db"]["frames"], 2);
    EXPECT_DOUBLE_EQ(quality["ssim"]["mean"], (views[0]["ssim"].get<double>() + 1) / 2);
    EXPECT_EQ(quality["psnr_total_db"]["frames"], 3);
    for (const Json& view : views) EXPECT_LE(quality["psnr_total_db"]["least"], view["psnr_total_db"].get<double>());
    // Of float64 they are those of a view alone, in the same memory image: its cameras are the ones of all.
    EXPECT_GT(views[0]["psnr_numeric_db"], 40);
    EXPECT_NE(text("out/frames.csv").find(",psnr_db,ssim,psnr_numeric_db,psnr_order_db,psnr_total_db,photograph\n"),
              std::string::npos);
  }
  const Outcome printed = run(sim_ + "--against photos --out out");
  EXPECT_NE(printed.out.find("dB, photograph"), std::string::npos) << printed.out;
  EXPECT_NE(printed.err.find("of another size than their cameras"), std::string::npos) << printed.err;

  // The pictures of another run, by their own names.
  const Json again = json("render" + view_ + "--views all --against drawn --out again", "again/render.json");
  EXPECT_EQ(again["quality"]["ssim"]["least"], 1);
  EXPECT_EQ(again["quality"]["ssim"]["frames"], 3);
  const Json truth =
      json("render" + view_ + "--views all --model truth --against photos --out truth", "truth/render.json");
  EXPECT_NEAR(truth["views"][0]["psnr_db"].get<double>(), psnr, 3);
}

TEST_F(Against, OneViewHasItsFiguresInTextAndReport) {
  const std::string view = view_ + "--view 1 ";
  ASSERT_EQ(run("render" + view + "--out drawn").code, 0);
  photograph("IMG_2.png", drawn("drawn/frame.png"));
  const Outcome outcome = run("render" + view + "--out again --against photos");
  EXPECT_NE(outcome.out.find("against photos/IMG_2.png: equal, SSIM 1.0000\n"), std::string::npos) << outcome.out;
  const Json report = json("sim" + view + "--no-rtl --no-truth --crop 8,8,40,30 --against photos/IMG_2.png --out out",
                           "out/report.json");
  EXPECT_TRUE(report["psnr_db"].is_null());
  EXPECT_EQ(report["ssim"], 1);
  EXPECT_EQ(report["photograph"], "photos/IMG_2.png");
}

TEST_F(Against, WhatDoesNotFitIsRefusedByName) {
  const auto plain = [](int width, int height) {
    return Rgb8{width, height, std::vector<uint8_t>(static_cast<size_t>(3 * width * height), 99)};
  };
  const auto refused = [&](const std::string& part) {
    expect_refused(sim_ + "--against photos", part);
    expect_one_line(run("render" + view_ + "--views all --out pictures --against photos"), 2, part);
  };
  refused(
      "photos: found no picture of a view, expected one named as its camera, such as 'one.png', or as ours, "
      "frame_0000.png");
  photograph("one.png", plain(kWidth, kHeight + 3));
  refused("photos/one.png: found 70x53 pixels, expected 70x50");
  photograph("one.png", plain(kHeight, kWidth));
  refused("photos/one.png: found 50x70 pixels, expected 70x50: it is turned by a quarter");
  photograph("one.png", plain(kWidth / 2, kHeight / 2));
  refused("photos/one.png: found 35x25 pixels, fewer than the view's 70x50 (--size 35x25 draws as many)");
  write("photos/one.png", "no picture");
  refused("photos/one.png: found neither a PNG nor a JPEG");
  photograph("one.png", plain(kWidth, kHeight));
  fs::copy_file(folder_ / "photos/one.png", folder_ / "photos/one.PNG");
  refused("photos: found 'one.png' and 'one.PNG', expected one picture of view 'one'");
  expect_refused(sim_ + "--against photos/one.png", "--against: found a file, expected a folder");
  expect_refused("sim" + view_ + "--no-rtl --truth", "--truth: found one frame, expected --views or --path");
  expect_refused(sim_ + "--against nowhere", "nowhere: ");
}

}  // namespace
}  // namespace pipegs
