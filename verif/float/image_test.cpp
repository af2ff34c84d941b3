// SPDX-License-Identifier: Apache-2.0
// Against cpp_model/float/image and metrics: files hold what was given, errors are one line.
//
// Idea    PNG is read back by libpng, EXR by OpenEXR itself, channel by channel.
#include "cpp_model/float/image.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cpp_model/float/metrics.hpp"
#include "scenes/input_error.hpp"
#include "verif/scenes/scratch_folder.hpp"

namespace pipegs {
namespace {

Image sample() {
  Image image(3, 2);
  for (std::size_t i = 0; i < 6; ++i) {
    const double v = static_cast<double>(i);
    image.rgb[i] = {0.1 * v, 0.3 - 0.1 * v, 0.5 * v};
    image.transmittance[i] = 1 - 0.15 * v;
    image.depth[i] = 10 * v;
    image.blended[i] = static_cast<std::uint32_t>(i * 1000);
  }
  return image;
}

TEST(Image, PngClampsRoundsAndAddsTheBackground) {
  const ScratchFolder scratch;
  Image image(2, 2);
  image.rgb = {{-1, 0.5, 2}, {1.49 / 255, 1.51 / 255, std::nan("")}, {0, 0, 0}, {0.2, 0.2, 0.2}};
  image.transmittance = {0, 0, 1, 0.5};
  write_png(scratch / "a.png", image, {0.4, 0.2, 1});
  const Rgb8 read = read_png8(scratch / "a.png");
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.data, (std::vector<std::uint8_t>{0, 128, 255, 1, 2, 0, 102, 51, 255, 102, 77, 179}));
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(Image, ExrHoldsAllChannels) {
  const ScratchFolder scratch;
  const Image image = sample();
  write_exr(scratch / "a.exr", image);
  Imf::InputFile file((scratch / "a.exr").c_str());
  const auto read = [&](const char* name) {
    std::vector<float> plane(6);
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), 4, 12));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    return plane;
  };
  const auto r = read("R"), b = read("B"), a = read("A"), t = read("T"), depth = read("depth");
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(r[i], static_cast<float>(image.rgb[i].x));
    EXPECT_EQ(b[i], static_cast<float>(image.rgb[i].z));
    EXPECT_EQ(a[i], static_cast<float>(1 - image.transmittance[i]));
    EXPECT_EQ(t[i], static_cast<float>(image.transmittance[i]));
    EXPECT_EQ(depth[i], static_cast<float>(image.depth[i]));
  }
  ASSERT_NE(file.header().channels().findChannel("blended"), nullptr);
  EXPECT_EQ(file.header().channels().findChannel("blended")->type, Imf::UINT);
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(Image, FailuresAreOneLineAndLeaveNothing) {
  const ScratchFolder scratch;
  EXPECT_THROW(write_png(scratch / "no/a.png", sample(), {0, 0, 0}), InputError);
  EXPECT_THROW(write_exr(scratch / "no/a.exr", sample()), InputError);
  EXPECT_THROW(read_png8(scratch / "a.png"), InputError);
  EXPECT_THROW(read_png8(scratch.write("b.png", "no picture")), InputError);
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(Metrics, MeasureAKnownDifference) {
  const Image a(4, 4);
  Image b = a;
  EXPECT_EQ(psnr(a, b), std::numeric_limits<double>::infinity());
  EXPECT_EQ(max_abs_error(a, b), 0);
  for (auto& rgb : b.rgb) rgb = glm::dvec3(0.1);
  EXPECT_NEAR(psnr(a, b), 20, 1e-12);
  for (auto& rgb : b.rgb) rgb = glm::dvec3(-7);  // a screen shows black
  EXPECT_EQ(psnr(a, b), std::numeric_limits<double>::infinity());
  EXPECT_EQ(max_abs_error(a, b), 7);
  EXPECT_THROW(psnr(a, Image(4, 3)), std::invalid_argument);
  b.rgb[3].y = std::nan("");
  EXPECT_TRUE(std::isnan(max_abs_error(a, b)));
}

}  // namespace
}  // namespace pipegs
