// SPDX-License-Identifier: Apache-2.0
// page.hpp: a sweep as one HTML page that needs no other file: fronts, a chart and a sentence for each knob, pictures
// of the error.
#pragma once

#include <string>
#include <vector>

#include "sim/study/accuracy/report.hpp"

namespace pipegs {

// A picture of |image - truth|, `gain` times brighter, no wider than `width` pixels: of pixels that fall together the
// largest.
Rgb8 error_picture(const Image& image, const Image& truth, double gain, int width);

struct ErrorPicture {
  std::string caption;
  std::string png;  // contents of the file
};

inline constexpr double kErrorGain = 100;

// Pictures of the cheapest points at 40, 50, 60, 70 and 80 dB that are reached, of the base, and of the best.
std::vector<ErrorPicture> error_pictures(const AccuracyView& view, const AccuracySweep& sweep);

std::string accuracy_page(const std::string& title, const AccuracySweep& sweep,
                          const std::vector<ErrorPicture>& pictures);

std::string base64(const std::string& bytes);

}  // namespace pipegs
