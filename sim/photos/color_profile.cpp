// SPDX-License-Identifier: Apache-2.0
// color_profile: see color_profile.hpp.
//
// Layout  ICC.1: "acsp" at 36, the number of tags at 128, then a signature, place and size of each. Big-endian.
#include "sim/photos/color_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace pipegs {
namespace {

struct Primary {
  std::string_view tag;
  std::array<double, 3> xyz;
};
constexpr std::array kPrimaries = {Primary{"rXYZ", {0.4360, 0.2225, 0.0139}}, Primary{"gXYZ", {0.3851, 0.7169, 0.0971}},
                                   Primary{"bXYZ", {0.1431, 0.0606, 0.7141}}};
constexpr double kNear = 0.01;
constexpr std::size_t kMostTags = 100;

class Profile {
 public:
  explicit Profile(std::string_view bytes) : bytes_(bytes) {}

  bool is_one() const { return part(36, 4) == "acsp"; }

  std::string_view tag(std::string_view name) const {
    for (std::size_t i = 0; i < std::min<std::size_t>(number(128), kMostTags); ++i) {
      const std::size_t entry = 132 + 12 * i;
      if (part(entry, 4) == name) return part(number(entry + 4), number(entry + 8));
    }
    return {};
  }

  // 0 where there is none.
  std::uint32_t number(std::size_t at) const {
    std::uint32_t value = 0;
    for (const char c : part(at, 4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  }

 private:
  std::string_view part(std::size_t at, std::size_t size) const {
    return at <= bytes_.size() && size <= bytes_.size() - at ? bytes_.substr(at, size) : std::string_view();
  }

  std::string_view bytes_;
};

// What of the text of a "desc" is ASCII: a string in the old form, UTF-16 in the new one.
std::string name_of(std::string_view desc) {
  const Profile tag(desc);
  const bool unicode = desc.starts_with("mluc");
  const std::size_t at = unicode ? tag.number(24) : 12, size = tag.number(unicode ? 20 : 8);
  std::string name;
  for (std::size_t i = at; i < desc.size() && i - at < size; ++i) {
    if (desc[i] >= ' ' && desc[i] <= '~') name += desc[i];
  }
  return name.empty() ? "without a name" : name;
}

}  // namespace

std::string foreign_profile(std::string_view bytes) {
  const Profile profile(bytes);
  if (!profile.is_one()) return {};
  const std::string name = name_of(profile.tag("desc"));
  for (const Primary& primary : kPrimaries) {
    const std::string_view xyz = profile.tag(primary.tag);
    if (xyz.size() < 20) return name.find("sRGB") != std::string::npos ? "" : name;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = static_cast<std::int32_t>(Profile(xyz).number(8 + 4 * k));
      if (std::abs(value / 65536.0 - primary.xyz[k]) > kNear) return name;
    }
  }
  return {};
}

std::string foreign_codes(int primaries, int transfer) {
  const std::string first = primaries == 1    ? "BT.709"
                            : primaries == 9  ? "BT.2020"
                            : primaries == 12 ? "Display P3"
                                              : fmt::format("primaries {}", primaries);
  if (transfer == 13) return primaries == 1 ? "" : first;
  return first + (transfer == 16 ? ", PQ" : transfer == 18 ? ", HLG" : fmt::format(", transfer {}", transfer));
}

}  // namespace pipegs
