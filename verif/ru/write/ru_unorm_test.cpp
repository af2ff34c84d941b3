// SPDX-License-Identifier: Apache-2.0
// ru_unorm_test: rtl/ru/write/ru_unorm.sv against its bit-accurate model and the nearest code, for every colour; in 8
// bits against the 8-bit picture that C++ writes.
#include <gtest/gtest.h>

#include <cmath>

#include "cpp_model/float/image.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "verif/support/config.hpp"
#include "Vru_unorm.h"

namespace pipegs {
namespace {

#ifdef PIPEGS_BYTES
TEST(RuUnorm, IsTheByteThatThePictureHasOfEveryColour) {
  const Config config = test_config();
  Vru_unorm dut;
  Image image(1 << config.rgb_w, 1);
  for (size_t color = 0; color < image.rgb.size(); ++color)
    image.rgb[color] = glm::dvec3(std::ldexp(static_cast<double>(color), 2 - config.rgb_w));
  const Rgb8 picture = to_rgb8(image, glm::dvec3(0));
  for (uint64_t color = 0; color < image.rgb.size(); ++color) {
    dut.color_i = static_cast<SData>(color);
    dut.eval();
    const auto shown = static_cast<uint32_t>(color);
    const uint64_t pixel = ru_resolve(config, {0, {shown, shown, shown}, false});
    ASSERT_EQ(dut.code_o * 0x010101u | 0xff000000, ru_rgba8(config, pixel)) << "colour " << color;
    ASSERT_EQ(dut.code_o, picture.data[3 * color]) << "colour " << color;
  }
}
#else
TEST(RuUnorm, IsTheNearestCodeOfEveryColour) {
  const Config config = test_config();
  Vru_unorm dut;
  for (uint64_t color = 0; color < uint64_t{1} << config.rgb_w; ++color) {
    dut.color_i = static_cast<SData>(color);
    dut.eval();
    ASSERT_EQ(dut.code_o, ru_unorm(config, color)) << "colour " << color;
    const double exact = std::ldexp(static_cast<double>(color), 2 - config.rgb_w);
    ASSERT_EQ(dut.code_o, std::min(1023.0, std::floor(1023 * exact + 0.5))) << "colour " << color;
  }
}
#endif

}  // namespace
}  // namespace pipegs
