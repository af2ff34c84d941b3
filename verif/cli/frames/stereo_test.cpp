// SPDX-License-Identifier: Apache-2.0
// stereo_test: `pipegs sim --stereo`: two pictures side by side, of a distance or of two cameras of a file.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class StereoCli : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    const Camera middle = test_camera(70, 50);
    Camera left = middle, right = middle, turned = middle, alone = middle;
    left.position -= glm::transpose(middle.world_to_camera)[0] * 0.03;
    right.position += glm::transpose(middle.world_to_camera)[0] * 0.03;
    turned.world_to_camera = glm::dmat3(0, 0, -1, 0, 1, 0, 1, 0, 0) * turned.world_to_camera;
    left.name = "left", right.name = "right", turned.name = "turned", alone.name = "middle";
    write_cameras(folder_ / "cameras.json", {alone, left, right, turned});
  }
  Outcome sim(const std::string& arguments, const std::string& out) {
    return run("sim scene.ply --cameras cameras.json --no-rtl " + arguments + " --out " + out);
  }
};

TEST_F(StereoCli, TwoCamerasAreTheEyesOfTheOneBetween) {
  ASSERT_EQ(sim("--stereo 0.06", "way").code, 0);
  ASSERT_EQ(sim("--stereo 1:2", "views").code, 0);
  ASSERT_EQ(sim("", "one").code, 0);
  EXPECT_EQ(text("way/frame.png"), text("views/frame.png"));
  EXPECT_NE(text("way/frame.png"), text("one/frame.png"));
  // Width and height stand in the head of a PNG.
  const auto side = [&](const std::string& file, size_t at) {
    const std::string png = text(file);
    return static_cast<unsigned char>(png.at(at)) * 256 + static_cast<unsigned char>(png.at(at + 1));
  };
  EXPECT_EQ(side("way/frame.png", 18), 140);
  EXPECT_EQ(side("way/frame.png", 22), 50);
}

// Each eye is held against its own truth: a picture of the other one would be far from it.
TEST_F(StereoCli, ErrorsAreThoseOfBothPictures) {
  const auto total = [&](const std::string& arguments, const std::string& out) {
    EXPECT_EQ(sim(arguments, out).code, 0);
    return nlohmann::json::parse(text(out + "/report.json"))["psnr_total_db"].get<double>();
  };
  const double left = total("--view 1", "left"), right = total("--view 2", "right"),
               pair = total("--stereo 1:2", "pair");
  EXPECT_GT(pair, std::min(left, right) - 1);
  EXPECT_LT(pair, std::max(left, right) + 1);
}

TEST_F(StereoCli, WhatIsNoPairIsRefused) {
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    SCOPED_TRACE(arguments);
    expect_one_line(sim(arguments, "no"), 2, words);
  };
  refused("--stereo 1:3", "views 'left' and 'turned': they are turned by 90 degrees, expected parallel eyes");
  refused("--stereo 1:4", "--stereo: found 4, expected 0 to 3");
  refused("--stereo 1:2 --view 1", "--view: found 1, expected none beside --stereo with two");
  refused("--stereo 1:2 --views all", "--stereo: found two views, expected the way between the eyes of a sequence");
  refused("--stereo 0.06 --background 9,9,9", "--background: found a machine of two eyes");
  refused("--stereo 1:", "--stereo: found ''");
  refused("--stereo wide", "--stereo: found 'wide'");
  refused("--stereo 0.06 --design late", "eyes = 2 needs quads = 1");
}

}  // namespace
}  // namespace pipegs
