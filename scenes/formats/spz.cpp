// SPDX-License-Identifier: Apache-2.0
// spz: Niantic's .spz, versions 2 and 3 (one gzip member) and 4 (zstd streams); SH degree 0 to 4, of which 3 are kept.
//
// Layout  Header, then for all Gaussians: positions (24 bits fixed point), opacities, colours, scales, rotations, SH
//         (coefficient by coefficient, R G B each). Version 4 has extension records behind its header, then the sizes
//         of its streams, then the streams; before it, extensions stand at the end.
// Rule    The axes are not in the file unless an extension says them: writers store those of their .ply unless they are
//         told what these are. So they are read as stored, and --axes turns them.
//         Writers cut SH to 5 bits and 4 and do not say so: the last bits that are always the same are the ones cut.
// Errors  InputError of a version, a degree, a stream whose size is not that of so many Gaussians.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstddef>
#include <numbers>
#include <optional>

#include "scenes/formats/format.hpp"
#include "scenes/input_error.hpp"
#include "scenes/packed/unpack.hpp"

namespace pipegs {
namespace {

constexpr std::uint64_t kHeader = 16, kHeader4 = 32;
constexpr std::uint32_t kMagic = 0x5053474e, kAxesRecord = 0xADBE0003;
constexpr std::uint8_t kAntialiased = 1, kExtended = 2;
constexpr int kMostDegree = 4;
constexpr std::array kAxes = {"",    "LDB", "RDB", "LUB", "RUB", "LDF", "RDF", "LUF", "RUF",
                              "LFD", "RFD", "LFU", "RFU", "LBD", "RBD", "LBU", "RBU"};

enum Stream { kPosition, kAlpha, kColor, kScale, kRotation, kSh };
constexpr std::array kStreamNames = {"positions", "opacities", "colours", "scales", "rotations", "SH"};

class Reader {
 public:
  Reader(const InputFile& file, SceneFormat& format) : file_(file), format_(format) {}

  Scene read() {
    if (!file_.starts_with("NGSP")) file_ = unpack_gzip(file_);
    else if (file_.size() < 8 || file_.at<std::uint32_t>(4, "header") > 3) packed_ = "zstd";
    if (packed_ == std::string_view("zstd")) read_streams4();
    else read_streams();
    Scene scene = scene_of_size(count_, std::min(degree_, kMaxShDegree));
    scene.antialiased = (flags_ & kAntialiased) != 0;
    for (std::size_t i = 0; i < count_; ++i) decode(scene, i);
    describe();
    return scene;
  }

 private:
  [[noreturn]] void fail(std::string_view where, const std::string& what) const {
    throw InputError(file_.name(), where, what);
  }

  void read_header() {
    const auto magic = file_.at<std::uint32_t>(0, "header");
    if (magic != kMagic)
      fail("header", fmt::format("found signature {:#x}, expected that of .spz, {:#x}", magic, kMagic));
    version_ = file_.at<std::uint32_t>(4, "header");
    const bool gzip = version_ == 2 || version_ == 3;
    if (packed4_ ? version_ != 4 : !gzip)
      fail("header", fmt::format("found version {}, expected {}", version_, packed4_ ? "2 to 4" : "2 or 3"));
    count_ = file_.at<std::uint32_t>(8, "header");
    degree_ = file_.at<std::uint8_t>(12, "header");
    bits_ = file_.at<std::uint8_t>(13, "header");
    flags_ = file_.at<std::uint8_t>(14, "header");
    if (degree_ > kMostDegree)
      fail("header", fmt::format("found SH degree {}, expected 0 to {}", degree_, kMostDegree));
    if (bits_ > 23) fail("header", fmt::format("found {} fractional bits, expected 0 to 23", bits_));
    const std::uint64_t rest = 3 * static_cast<std::uint64_t>((degree_ + 1) * (degree_ + 1) - 1);
    strides_ = {9, 1, 3, 3, version_ == 2 ? 3u : 4u, rest};
  }

  void read_streams() {
    read_header();
    std::uint64_t at = kHeader;
    for (std::size_t s = 0; s < strides_.size(); ++s) {
      if (strides_[s] == 0) continue;
      streams_[s] = file_.rows(at, count_, strides_[s], kStreamNames[s]);
      at += count_ * strides_[s];
    }
    if ((flags_ & kExtended) != 0) at = read_records(at, file_.size());
    tell_behind(file_.behind(at), format_);
  }

  void read_streams4() {
    packed4_ = true;
    read_header();
    const auto streams = file_.at<std::uint8_t>(15, "header");
    std::uint64_t table = file_.at<std::uint32_t>(16, "header");
    const std::size_t wanted = degree_ == 0 ? 5 : 6;
    if (streams != wanted) fail("header", fmt::format("found {} streams, expected {}", streams, wanted));
    if (table < kHeader4)
      fail("header", fmt::format("found the table at byte {}, expected {} or more", table, kHeader4));
    if (read_records(kHeader4, table) != table) fail("extensions", "do not end where the table begins");
    const std::uint64_t all =
        count_ * (strides_[0] + strides_[1] + strides_[2] + strides_[3] + strides_[4] + strides_[5]);
    check_unpacked(file_.name(), "header", file_.size(), all);
    std::uint64_t at = table + 16 * wanted;
    for (std::size_t s = 0; s < wanted; ++s) {
      const auto packed = file_.at<std::uint64_t>(table + 16 * s, "table");
      const auto size = file_.at<std::uint64_t>(table + 16 * s + 8, "table");
      if (size != count_ * strides_[s]) {
        fail(kStreamNames[s],
             fmt::format("found {} bytes, expected {} of {} Gaussians", size, count_ * strides_[s], count_));
      }
      unpacked_[s] = unpack_zstd(file_.name(), kStreamNames[s], file_.part(at, packed, kStreamNames[s]), size);
      streams_[s] = reinterpret_cast<const std::uint8_t*>(unpacked_[s].data());
      at += packed;
    }
    tell_behind(file_.behind(at), format_);
  }

  // Extension records from `at` to `end`: type, length, that many bytes. The byte behind the last.
  std::uint64_t read_records(std::uint64_t at, std::uint64_t end) {
    while (at < end) {
      const auto type = file_.at<std::uint32_t>(at, "extension");
      const auto length = file_.at<std::uint32_t>(at + 4, "extension");
      const auto record = file_.part(at + 8, length, "extension");
      if (type == kAxesRecord && length >= 4) {
        const auto axes = load<std::uint32_t>(record.data());
        if (axes >= kAxes.size())
          fail("extension", fmt::format("found axes {}, expected 0 to {}", axes, kAxes.size() - 1));
        format_.axes = kAxes[axes];
      }
      at += 8 + length;
    }
    return at;
  }

  void decode(Scene& scene, std::size_t i) {
    Gaussian& g = scene.gaussians[i];
    const double step = std::ldexp(1.0, -bits_);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t* p = streams_[kPosition] + 9 * i + 3 * k;
      const std::uint32_t bits = p[0] | p[1] << 8 | p[2] << 16;
      const int fixed = static_cast<int>(bits) - ((bits & 0x800000) != 0 ? 1 << 24 : 0);
      const auto axis = static_cast<int>(k);
      g.mean[axis] = static_cast<float>(fixed * step);
      g.log_scale[axis] = static_cast<float>(streams_[kScale][3 * i + k] / 16.0 - 10);
      g.sh_dc[axis] = static_cast<float>((streams_[kColor][3 * i + k] / 255.0 - 0.5) / 0.15);
    }
    g.opacity_logit = logit_of(streams_[kAlpha][i] / 255.0);
    g.rotation = version_ == 2 ? three_bytes(streams_[kRotation] + 3 * i)
                               : smallest_three(load<std::uint32_t>(streams_[kRotation] + 4 * i));
    const auto kept = 3 * static_cast<std::size_t>(sh_rest_count(scene.sh_degree));
    for (std::size_t k = 0; k < kept; ++k) {
      const std::uint8_t v = streams_[kSh][strides_[kSh] * i + k];
      scene.sh_rest[kept * i + k] = static_cast<float>((v - 128) / 128.0);
      if (v != 255) sh_seen_[k < 9 ? 0 : 1] |= v;  // 255 stands for 256
    }
  }

  // x, y and z; w is what is left of a unit.
  static glm::vec4 three_bytes(const std::uint8_t* bytes) {
    const double x = bytes[0] / 127.5 - 1, y = bytes[1] / 127.5 - 1, z = bytes[2] / 127.5 - 1;
    return {std::sqrt(std::max(0.0, 1 - x * x - y * y - z * z)), x, y, z};
  }

  // The index of the largest of x y z w, then the others from the last to the first: magnitude of 9 bits, sign.
  static glm::vec4 smallest_three(std::uint32_t bits) {
    std::array<double, 4> q{};
    const std::uint32_t largest = bits >> 30;
    double sum = 0;
    for (std::size_t k = q.size(); k-- > 0;) {
      if (k == largest) continue;
      q[k] = (bits & 511) * (1 / std::numbers::sqrt2 / 511) * ((bits & 512) != 0 ? -1 : 1);
      sum += q[k] * q[k];
      bits >>= 10;
    }
    q[largest] = std::sqrt(std::max(0.0, 1 - sum));
    return {q[3], q[0], q[1], q[2]};
  }

  void describe() {
    const auto kept = [](unsigned seen) { return seen == 0 ? 1 : 8 - std::countr_zero(seen); };
    format_.name = fmt::format(".spz version {} ({})", version_, packed_);
    format_.fields = {{"position", fmt::format("24 bits, steps of {:g}", std::ldexp(1.0, -bits_))},
                      {"scale", "8 bits of its logarithm, steps of 1/16"},
                      {"rotation", version_ == 2 ? "3 x 8 bits" : "smallest three of 10 bits"},
                      {"opacity", "8 bits"},
                      {"colour", "3 x 8 bits, f_dc cut to +-3.33"},
                      {"SH", degree_ == 0   ? "none"
                             : degree_ == 1 ? fmt::format("{} bits of 8", kept(sh_seen_[0]))
                                            : fmt::format("{} bits of 8 for degree 1, {} above", kept(sh_seen_[0]),
                                                          kept(sh_seen_[1]))}};
    if (const int others = flags_ & ~(kAntialiased | kExtended); others != 0)
      format_.findings.emplace_back("not_read", fmt::format("flags of the .spz that are not known here: {:#x}; what "
                                                            "they mean (a tree of levels of detail) is not in the "
                                                            "picture",
                                                            others));
    if (degree_ > kMaxShDegree)
      format_.findings.emplace_back("sh_degree", "the SH coefficients of degree 4 are left out");
  }

  InputFile file_;
  SceneFormat& format_;
  const char* packed_ = "gzip";
  bool packed4_ = false;
  std::uint32_t version_ = 0;
  std::uint64_t count_ = 0;
  int degree_ = 0, bits_ = 0;
  std::uint8_t flags_ = 0;
  std::array<std::uint64_t, 6> strides_{};
  std::array<std::string, 6> unpacked_;
  std::array<const std::uint8_t*, 6> streams_{};
  std::array<unsigned, 2> sh_seen_{};  // bits that are set in any coefficient of degree 1, and above
};

}  // namespace

Scene read_spz(const InputFile& file, SceneFormat& format) { return Reader(file, format).read(); }

}  // namespace pipegs
