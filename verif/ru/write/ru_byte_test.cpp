// SPDX-License-Identifier: Apache-2.0
// ru_byte_test: rtl/ru/write/ru_byte.sv against its bit-accurate model and the 8-bit picture that C++ writes, for every
// code.
#include <gtest/gtest.h>

#include "cpp_model/float/image.hpp"
#include "cpp_model/ru/ru_raster.hpp"
#include "cpp_model/ru/ru_resolve.hpp"
#include "Vru_byte.h"

namespace pipegs {
namespace {

TEST(RuByte, IsTheByteThatThePictureHasOfEveryCode) {
  Vru_byte dut;
  Image image(1024, 1);
  for (int code = 0; code < 1024; ++code)
    image.rgb[static_cast<size_t>(code)] = glm::dvec3(static_cast<double>(code) / static_cast<double>(kMostCode));
  const Rgb8 picture = to_rgb8(image, glm::dvec3(0));
  for (uint32_t code = 0; code < 1024; ++code) {
    dut.code_i = static_cast<SData>(code);
    dut.eval();
    ASSERT_EQ(dut.byte_o, ru_byte(code)) << "code " << code;
    ASSERT_EQ(dut.byte_o, picture.data[3 * code]) << "code " << code;
  }
}

}  // namespace
}  // namespace pipegs
