// SPDX-License-Identifier: Apache-2.0
// page.hpp: a sweep as a page: fronts, a chart and a sentence for each knob, pictures of the error, every point.
#pragma once

#include <string>
#include <vector>

#include "sim/report/html/study_page.hpp"
#include "sim/studies/accuracy/report.hpp"

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

// All of it, after the page's title and lead.
void add_accuracy(StudyPage& page, const AccuracySweep& sweep, const std::vector<ErrorPicture>& pictures);

}  // namespace pipegs
