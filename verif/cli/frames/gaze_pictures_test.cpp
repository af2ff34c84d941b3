// SPDX-License-Identifier: Apache-2.0
// gaze_pictures_test: `pipegs sim --gaze`: a picture in parts whose resolution falls off around a pixel.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class GazeCli : public Cli {
 protected:
  const std::string sim_ = "sim scene.ply --cameras cameras.json ", model_ = sim_ + "--no-rtl ";

  void SetUp() override {
    Cli::SetUp();
    Camera second = test_camera(70, 50);
    second.position = {0.2, 0.1, 0.3};
    write_cameras(folder_ / "cameras.json", {test_camera(70, 50), second});
  }
  Json report(const std::string& arguments, const std::string& out) {
    const Outcome outcome = run(arguments + " --out " + out);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    return Json::parse(text(out + "/sequence.json"));
  }
};

TEST_F(GazeCli, RtlDrawsEveryPartAsTheModel) {
  const Json rtl = report(sim_ + "--gaze 30,20,8,16 --memory ideal", "rtl"),
             model = report(model_ + "--gaze 30,20,8,16 --memory ideal --truth", "model");
  ASSERT_EQ(rtl["gaze"].size(), 1u);
  const size_t parts = rtl["gaze"][0]["parts"];
  EXPECT_EQ(parts, 9u);
  ASSERT_EQ(rtl["views"].size(), parts);
  for (const Json& part : rtl["views"]) EXPECT_EQ(part["mismatches"], 0);
  EXPECT_EQ(text("rtl/gaze_0000.png"), text("model/gaze_0000.png"));
  EXPECT_EQ(rtl["gaze"][0]["samples"], model["gaze"][0]["samples"]);
  EXPECT_LT(rtl["gaze"][0]["samples"], 70 * 50 / 2);
  // Three rings that are the picture, each less exact than the one inside.
  uint64_t pixels = 0;
  double before = 1000;
  ASSERT_EQ(model["gaze"][0]["rings"].size(), 3u);
  for (const Json& ring : model["gaze"][0]["rings"]) {
    pixels += ring["pixels"].get<uint64_t>();
    EXPECT_LT(ring["smooth_db"].get<double>(), before);
    before = ring["smooth_db"];
  }
  EXPECT_EQ(pixels, 70u * 50u);
}

TEST_F(GazeCli, OnePartIsTheFrame) {
  report(model_ + "--views all", "frames");
  report(model_ + "--views all --gaze 35,25,70,70", "gaze");
  const Json one = report(model_ + "--view 1 --gaze 35,25,70,70", "one");
  EXPECT_EQ(one["gaze"][0]["view"], 1);
  EXPECT_EQ(one["gaze"][0]["parts"], 1);
  for (const std::string name : {"0000.png", "0001.png"})
    EXPECT_EQ(text("gaze/gaze_" + name), text("frames/frame_" + name)) << name;
  EXPECT_EQ(text("one/gaze_0000.png"), text("frames/frame_0001.png"));
}

// The gaze of a pair is one pixel of both pictures.
TEST_F(GazeCli, EachEyeHasItsPicture) {
  report(model_ + "--stereo 0.06 --gaze 30,20,8,16", "pair");
  EXPECT_NE(text("pair/gaze_0000.png"), text("pair/gaze_0000_right.png"));
  Camera left = test_camera(70, 50), right = left;
  left.position -= glm::transpose(left.world_to_camera)[0] * 0.03;
  right.position += glm::transpose(right.world_to_camera)[0] * 0.03;
  write_cameras(folder_ / "cameras.json", {left, right});
  report(model_ + "--stereo 0:1 --gaze 30,20,8,16", "views");
  EXPECT_EQ(text("views/gaze_0000.png"), text("pair/gaze_0000.png"));
  EXPECT_EQ(text("views/gaze_0000_right.png"), text("pair/gaze_0000_right.png"));
}

TEST_F(GazeCli, WhatIsNoGazeIsRefused) {
  const std::string gaze = model_ + "--gaze 30,20,8,16 ";
  for (const char* other : {"--budget 4M", "--viewer", "--crop 1,1,9,9", "--window 0,0"}) {
    const std::string option = std::string(other).substr(0, std::string(other).find(' '));
    expect_refused(gaze + other, option + ": found --gaze, too, expected one of them");
  }
  expect_refused(gaze + "--views all --view 1", "--view: found a sequence, expected one view");
  expect_refused(gaze + "--effects auto", "--effects: found a sequence, expected one view");
  expect_refused(gaze + "--view 2", "--view: found 2, expected 0 to 1");
  expect_refused(model_ + "--gaze 30,20,16,8",
                 "--gaze: found half the resolution from 16 pixels and a quarter from 8, expected no less");
  for (const char* words : {"30,20,8", "30,20,8,16,24", "30,20,8,x", "-1,20,8,16", ""})
    expect_refused(model_ + "--gaze '" + words + "'", "--gaze: found '");
}

}  // namespace
}  // namespace pipegs
