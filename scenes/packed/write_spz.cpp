// SPDX-License-Identifier: Apache-2.0
// write_spz: see write_spz.hpp.
#include "scenes/packed/write_spz.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "scenes/own_failure.hpp"

namespace pipegs {
namespace {

constexpr std::uint32_t kMagic = 0x5053474e, kVersion = 3;
constexpr int kMostBits = 20, kHeader = 16;  // bits behind the point
constexpr double kLargestPosition = 8388607;

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {}

  Spz write() {
    spz_.position_bits = position_bits();
    append(kMagic, 4);
    append(kVersion, 4);
    append(static_cast<std::uint32_t>(scene_.gaussians.size()), 4);
    append(static_cast<std::uint32_t>(scene_.sh_degree), 1);
    append(static_cast<std::uint32_t>(spz_.position_bits), 1);
    append(scene_.antialiased ? 1 : 0, 2);
    const double step = std::ldexp(1.0, spz_.position_bits);
    for (const Gaussian& g : scene_.gaussians) {
      for (int k = 0; k < 3; ++k)
        append(static_cast<std::uint32_t>(cut(g.mean[k] * step, -kLargestPosition, kLargestPosition)), 3);
    }
    for (const Gaussian& g : scene_.gaussians) byte(255 / (1 + std::exp(-double{g.opacity_logit})));
    for (const Gaussian& g : scene_.gaussians) {
      for (int k = 0; k < 3; ++k) byte((g.sh_dc[k] * 0.15 + 0.5) * 255);
    }
    for (const Gaussian& g : scene_.gaussians) {
      for (int k = 0; k < 3; ++k) byte((std::max(-10.0, double{g.log_scale[k]}) + 10) * 16);  // flat is its least
    }
    for (const Gaussian& g : scene_.gaussians) append(smallest_three(g.rotation), 4);
    for (const float value : scene_.sh_rest) byte(double{value} * 128 + 128);
    spz_.bytes = gzip();
    return std::move(spz_);
  }

 private:
  // The most with which the farthest coordinate still fits into 24 bits.
  int position_bits() const {
    double far = 1e-30;
    for (const Gaussian& g : scene_.gaussians) {
      for (int k = 0; k < 3; ++k) far = std::max(far, std::abs(double{g.mean[k]}));
    }
    return std::clamp(static_cast<int>(std::floor(std::log2(kLargestPosition / far))), 0, kMostBits);
  }

  void append(std::uint32_t bits, int bytes) {
    for (int k = 0; k < bytes; ++k) raw_ += static_cast<char>(bits >> 8 * k & 255);
  }

  std::int64_t cut(double value, double low, double high) {
    const double rounded = std::round(value);
    ++spz_.numbers;
    spz_.cut += rounded < low || rounded > high;
    return static_cast<std::int64_t>(std::clamp(rounded, low, high));
  }
  void byte(double value) { raw_ += static_cast<char>(cut(value, 0, 255)); }

  // The index of the largest of x y z w, then the others: sign, magnitude of 9 bits.
  static std::uint32_t smallest_three(const glm::vec4& rotation) {
    const glm::dvec4 q = glm::normalize(glm::dvec4(rotation.y, rotation.z, rotation.w, rotation.x));
    int largest = 0;
    for (int k = 1; k < 4; ++k) largest = std::abs(q[k]) > std::abs(q[largest]) ? k : largest;
    auto bits = static_cast<std::uint32_t>(largest);
    for (int k = 0; k < 4; ++k) {
      if (k == largest) continue;
      const bool negative = (q[k] < 0) != (q[largest] < 0);
      const double size = std::min(511.0, std::round(std::abs(q[k]) * std::numbers::sqrt2 * 511));
      bits = bits << 10 | (negative ? 512u : 0u) | static_cast<std::uint32_t>(size);
    }
    return bits;
  }

  std::string gzip() const {
    z_stream stream{};
    constexpr int kGzip = 16;
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip + MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
      throw OwnFailure("zlib cannot deflate an .spz");
    std::string packed(deflateBound(&stream, raw_.size()) + kHeader, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(raw_.data()));
    stream.avail_in = static_cast<uInt>(raw_.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    const int done = deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    if (done != Z_STREAM_END) throw OwnFailure("zlib cannot deflate an .spz");
    return packed;
  }

  const Scene& scene_;
  Spz spz_;
  std::string raw_;
};

}  // namespace

Spz write_spz(const Scene& scene) { return Writer(scene).write(); }

}  // namespace pipegs
