// SPDX-License-Identifier: Apache-2.0
// photo_loss: see photo_loss.hpp.
//
// Idea    Per pixel, with blurred planes m = [p], n = [q], and a = [p^2] - m^2, b = [q^2] - n^2, c = [p q] - m n:
//           SSIM = (2 m n + C1)(2 c + C2) / ((m^2 + n^2 + C1)(a + b + C2))
//         Its derivatives by [p], [p^2] and [p q] are blurred again (a blur with zeros beyond the edge is its own
//         transpose) and come back as  d/dp = blur(by [p]) + 2 p blur(by [p^2]) + q blur(by [p q]).
#include "sim/studies/train/gradient/photo_loss.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cpp_model/float/parallel.hpp"
#include "sim/studies/train/gradient/raster/lanes.hpp"

namespace pipegs {
namespace {

constexpr int kReach = 5;  // of a window to each side
constexpr double kSigma = 1.5, kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;

template <class Scalar>
using Plane = std::vector<Scalar>;

struct Size {
  std::size_t width, height;
  std::size_t pixels() const { return width * height; }
};

template <class Scalar>
std::array<Scalar, kReach + 1> window_weights() {
  std::array<double, kReach + 1> weights;
  double sum = 0;
  for (int i = 0; i <= kReach; ++i) {
    weights[i] = std::exp(-i * i / (2 * kSigma * kSigma));
    sum += (i == 0 ? 1 : 2) * weights[i];
  }
  std::array<Scalar, kReach + 1> result;
  for (int i = 0; i <= kReach; ++i) result[i] = static_cast<Scalar>(weights[i] / sum);
  return result;
}

// Down the columns, then along the rows; zeros beyond the edge.
template <class Scalar>
PIPEGS_INLINED void blur_rows(const Scalar* in, const Size& size, const Scalar* weights, Scalar* padded, Scalar* out) {
  for (std::size_t y = 0; y < size.height; ++y) {
    Scalar* const row = padded + kReach;
    for (std::size_t x = 0; x < size.width; ++x) row[x] = weights[0] * in[y * size.width + x];
    const auto add = [&](std::size_t from, Scalar weight) {
      for (std::size_t x = 0; x < size.width; ++x) row[x] += weight * in[from * size.width + x];
    };
    for (std::size_t i = 1; i <= kReach; ++i) {
      if (y >= i) add(y - i, weights[i]);
      if (y + i < size.height) add(y + i, weights[i]);
    }
    Scalar* const result = out + y * size.width;
    for (std::size_t x = 0; x < size.width; ++x) {
      Scalar total = weights[0] * row[x];
      for (int i = 1; i <= kReach; ++i) total += weights[i] * (*(row + x - i) + *(row + x + i));
      result[x] = total;
    }
  }
}
PIPEGS_LEVELS void blur_floats(const float* in, const Size& size, const float* weights, float* padded, float* out) {
  blur_rows(in, size, weights, padded, out);
}

template <class Scalar>
Plane<Scalar> blur(const Plane<Scalar>& in, const Size& size) {
  static const std::array<Scalar, kReach + 1> weights = window_weights<Scalar>();
  Plane<Scalar> padded(size.width + 2 * kReach), out(in.size());
  if constexpr (sizeof(Scalar) == 4) blur_floats(in.data(), size, weights.data(), padded.data(), out.data());
  else blur_rows(in.data(), size, weights.data(), padded.data(), out.data());
  return out;
}

template <class Scalar>
Plane<Scalar> product(const Plane<Scalar>& a, const Plane<Scalar>& b) {
  Plane<Scalar> out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
  return out;
}

// The sum of SSIM over the pixels of one channel; `gradient` is its derivative by p.
template <class Scalar>
double ssim_plane(const Plane<Scalar>& p, const Plane<Scalar>& q, const Size& size, Plane<Scalar>* gradient) {
  Plane<Scalar> pm = blur(p, size), qm = blur(q, size), pp = blur(product(p, p), size), qq = blur(product(q, q), size),
                pq = blur(product(p, q), size);
  constexpr auto c1 = static_cast<Scalar>(kC1), c2 = static_cast<Scalar>(kC2);
  double total = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Scalar m = pm[i], n = qm[i], spread = pp[i] - m * m + (qq[i] - n * n) + c2, cross = 2 * (pq[i] - m * n) + c2;
    const Scalar light = 2 * m * n + c1, bright = m * m + n * n + c1, value = light * cross / (bright * spread);
    total += value;
    // By [p^2] and [p q] alone, then by [p], on which both differences depend, too.
    pp[i] = -value / spread;
    pq[i] = 2 * light / (bright * spread);
    pm[i] = 2 * n * cross / (bright * spread) - 2 * m * value / bright - 2 * m * pp[i] - n * pq[i];
  }
  if (gradient == nullptr) return total;
  const Plane<Scalar> by_p = blur(pm, size), by_pp = blur(pp, size), by_pq = blur(pq, size);
  gradient->resize(p.size());
  for (std::size_t i = 0; i < p.size(); ++i) (*gradient)[i] = by_p[i] + 2 * p[i] * by_pp[i] + q[i] * by_pq[i];
  return total;
}

template <class Scalar>
Plane<Scalar> plane_of(const std::vector<glm::vec<3, Scalar>>& picture, int channel) {
  Plane<Scalar> plane(picture.size());
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = picture[i][channel];
  return plane;
}

template <class Scalar>
double loss_of(const std::vector<glm::vec<3, Scalar>>& picture, const std::vector<glm::vec<3, Scalar>>& photo,
               int width, int height, double dssim_weight, std::vector<glm::vec<3, Scalar>>* d_picture) {
  const Size size{static_cast<std::size_t>(std::max(width, 0)), static_cast<std::size_t>(std::max(height, 0))};
  if (size.pixels() == 0 || picture.size() != size.pixels() || photo.size() != size.pixels()) {
    throw std::invalid_argument("photo_loss: pictures of " + std::to_string(picture.size()) + " and " +
                                std::to_string(photo.size()) + " pixels, expected " + std::to_string(width) + "x" +
                                std::to_string(height));
  }
  const double values = 3 * static_cast<double>(size.pixels());
  const auto l1_share = static_cast<Scalar>((1 - dssim_weight) / values),
             ssim_share = static_cast<Scalar>(dssim_weight / values);
  if (d_picture != nullptr) d_picture->resize(size.pixels());
  std::array<double, 3> losses{};
  parallel_for(3, 0, [&](std::size_t c) {
    const int channel = static_cast<int>(c);
    const Plane<Scalar> p = plane_of(picture, channel), q = plane_of(photo, channel);
    Plane<Scalar> d_ssim;
    const double ssim = dssim_weight == 0 ? 0 : ssim_plane(p, q, size, d_picture != nullptr ? &d_ssim : nullptr);
    double difference = 0;
    for (std::size_t i = 0; i < p.size(); ++i) difference += std::abs(p[i] - q[i]);
    losses[c] = (1 - dssim_weight) * difference + dssim_weight * (static_cast<double>(size.pixels()) - ssim);
    if (d_picture == nullptr) return;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Scalar sign = p[i] > q[i] ? 1 : p[i] < q[i] ? -1 : 0;
      (*d_picture)[i][channel] = l1_share * sign - (d_ssim.empty() ? 0 : ssim_share * d_ssim[i]);
    }
  });
  return (losses[0] + losses[1] + losses[2]) / values;
}

}  // namespace

double photo_loss(const std::vector<glm::vec3>& picture, const std::vector<glm::vec3>& photo, int width, int height,
                  double dssim_weight, std::vector<glm::vec3>* d_picture) {
  return loss_of(picture, photo, width, height, dssim_weight, d_picture);
}

double photo_loss(const std::vector<glm::dvec3>& picture, const std::vector<glm::dvec3>& photo, int width, int height,
                  double dssim_weight, std::vector<glm::dvec3>* d_picture) {
  return loss_of(picture, photo, width, height, dssim_weight, d_picture);
}

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
