// SPDX-License-Identifier: Apache-2.0
// squared_loss: see squared_loss.hpp.
#include "sim/studies/train/gradient/squared_loss.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace pipegs {

double squared_loss(const std::vector<glm::vec3>& picture, const std::vector<glm::vec3>& wanted,
                    std::vector<glm::vec3>* d_picture) {
  if (picture.size() != wanted.size())
    throw std::invalid_argument(
        fmt::format("squared_loss: pictures of {} and {} pixels, expected one size", picture.size(), wanted.size()));
  const double values = 3 * static_cast<double>(picture.size());
  const auto share = static_cast<float>(2 / values);
  d_picture->resize(picture.size());
  double sum = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    const glm::vec3 difference = picture[i] - wanted[i];
    sum += glm::dot(difference, difference);
    (*d_picture)[i] = share * difference;
  }
  return sum / values;
}

}  // namespace pipegs
