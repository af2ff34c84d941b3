// SPDX-License-Identifier: Apache-2.0
// svg.hpp: what all SVG files of this program share: the frame of the file, text and colours.
//
// Idea    Background is transparent and text takes the page's colour (black or white by the reader's colour scheme when
//         the file stands alone), so that one file serves light and dark pages.
// Units   SVG user units: pixels at normal size.
#pragma once

#include <cstddef>
#include <string>

namespace pipegs {

std::string svg_head(double width, double height);  // up to the first element; "</svg>\n" ends the file
std::string svg_escaped(const std::string& text);   // of XML's special characters; control characters become blanks
// anchor: start, middle or end; more: further attributes, with a blank before.
std::string svg_text(double x, double y, const std::string& anchor, const std::string& words,
                     const std::string& more = "");
const char* svg_color(std::size_t number);  // hues that stand out on white and on black, again from the start after 8

}  // namespace pipegs
