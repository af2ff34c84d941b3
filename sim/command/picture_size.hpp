// SPDX-License-Identifier: Apache-2.0
// picture_size.hpp: the size of a picture as an option says it, such as 160x120.
//
// Errors  ConfigError: "--size: found '160', expected WxH up to 16384x16384, such as 160x120".
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cpp_model/config.hpp"
#include "scenes/camera.hpp"
#include "scenes/text/number.hpp"
#include "scenes/text/quote.hpp"

namespace pipegs {

struct PictureSize {
  int width = 0, height = 0;  // pixels
};

// `text` is not empty.
inline PictureSize picture_size(const std::string& option, const std::string& text) {
  const std::size_t by = std::min(text.find('x'), text.size() - 1);
  try {
    return {parse_integer<int>(text.substr(0, by), 1, kMaxImageSide),
            parse_integer<int>(text.substr(by + 1), 1, kMaxImageSide)};
  } catch (const NumberError&) {
    throw ConfigError(fmt::format("{}: found {}, expected WxH up to {}x{}, such as 160x120", option, quote(text),
                                  kMaxImageSide, kMaxImageSide));
  }
}

}  // namespace pipegs
