// metrics: see metrics.hpp.
//
// Idea    Plain sums in double in pixel order: the result does not depend on threads.
//         A NaN on either side makes the result NaN rather than being lost in a comparison.
#include "cpp_model/float/metrics.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pipegs {
namespace {

void check_same_size(const Image& a, const Image& b) {
  if (a.width == b.width && a.height == b.height) return;
  throw std::invalid_argument("metrics: images of " + std::to_string(a.width) + "x" + std::to_string(a.height) + " and " +
                              std::to_string(b.width) + "x" + std::to_string(b.height) + " cannot be compared");
}

}  // namespace

double psnr(const Image& a, const Image& b) {
  check_same_size(a, b);
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const glm::dvec3 d = glm::clamp(a.rgb[i], 0.0, 1.0) - glm::clamp(b.rgb[i], 0.0, 1.0);
    sum += glm::dot(d, d);
  }
  if (sum == 0) return std::numeric_limits<double>::infinity();
  return -10 * std::log10(sum / (3 * static_cast<double>(a.rgb.size())));
}

double max_abs_error(const Image& a, const Image& b) {
  check_same_size(a, b);
  double worst = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(a.rgb[i][c] - b.rgb[i][c]);
      if (!(error <= worst)) worst = error;
      if (std::isnan(error)) return error;
    }
  }
  return worst;
}

}  // namespace pipegs
