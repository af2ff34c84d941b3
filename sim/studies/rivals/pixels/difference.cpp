// SPDX-License-Identifier: Apache-2.0
// difference.cpp: see difference.hpp.
#include "sim/studies/rivals/pixels/difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cpp_model/float/metrics.hpp"

namespace pipegs {

Difference difference(const Image& found, const Image& exact) {
  Difference d{.psnr_db = psnr(found, exact)};
  size_t pixels = 0;
  for (size_t i = 0; i < exact.rgb.size(); ++i) {
    const glm::dvec3 apart = glm::abs(glm::clamp(found.rgb[i], 0.0, 1.0) - glm::clamp(exact.rgb[i], 0.0, 1.0));
    const double most = std::max({apart.x, apart.y, apart.z});
    d.largest = std::max(d.largest, most);
    pixels += most > 1.0 / 255;
  }
  d.visible = static_cast<double>(pixels) / static_cast<double>(exact.rgb.size());
  return d;
}

Difference together(const std::vector<Difference>& frames) {
  Difference all;
  double error = 0;
  for (const Difference& frame : frames) {
    error += std::pow(10, -frame.psnr_db / 10);
    all.largest = std::max(all.largest, frame.largest);
    all.visible += frame.visible / static_cast<double>(frames.size());
  }
  all.psnr_db = error > 0 ? -10 * std::log10(error / static_cast<double>(frames.size()))
                          : std::numeric_limits<double>::infinity();
  return all;
}

double worst_db(const std::vector<Difference>& frames) {
  double worst = std::numeric_limits<double>::infinity();
  for (const Difference& frame : frames) worst = std::min(worst, frame.psnr_db);
  return worst;
}

}  // namespace pipegs
