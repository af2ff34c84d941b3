// SPDX-License-Identifier: Apache-2.0
// ply_layout: see ply_layout.hpp.
#include "scenes/ply/ply_layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

#include "scenes/input_error.hpp"
#include "scenes/text/number.hpp"

namespace pipegs {
namespace {

constexpr int kMostRest = 9999;    // to be counted and refused, far above the 360 of degree 10
constexpr int kMostDegree = 10;    // of a file, of which kMaxShDegree are kept
constexpr std::size_t kShown = 4;  // names in a line

// Names of other programs for a value: its parts are the prefix with a number or a letter behind it.
struct Names {
  int slot, parts;
  const char* inria;  // prefix
  std::vector<const char*> others;
  std::string_view letters;  // instead of 0, 1, 2, 3
};
const std::array kNames = {
    Names{kSlotX, 3, "", {"p", "pos_", "position_", "mean_", "means_", "xyz_", "center_"}, "xyz"},
    Names{kSlotDc, 3, "f_dc_", {"features_dc_", "feature_dc_", "sh_dc_", "sh0_", "dc_"}, "rgb"},
    Names{kSlotScale, 3, "scale_", {"scales_", "scaling_", "scal_", "log_scale_", "log_scales_", "s"}, "xyz"},
    Names{kSlotRotation,
          4,
          "rot_",
          {"rotation_", "rotations_", "quat_", "quats_", "quaternion_", "orientation_", "q_", "q", "r"},
          "wxyz"}};
constexpr std::array kOpacities = {"opacity",       "opacities",     "alpha",     "alphas",
                                   "opacity_logit", "logit_opacity", "opacity_0", "a"};
constexpr std::array kColors = {std::array{"red", "green", "blue"}, std::array{"r", "g", "b"},
                                std::array{"diffuse_red", "diffuse_green", "diffuse_blue"},
                                std::array{"color_r", "color_g", "color_b"},
                                std::array{"color_red", "color_green", "color_blue"}};
constexpr std::array kRests = {"f_rest_", "features_rest_", "feature_rest_", "sh_rest_", "shn_"};
// Left out by every program that draws Gaussians.
constexpr std::array kHarmless = {"nx",    "ny",    "nz",        "confidence", "quality", "intensity",
                                  "label", "class", "object_id", "segment_id", "id",      "index"};

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The place of a name, and the name that INRIA gives it.
struct Place {
  int slot;
  std::string inria;
};

std::optional<Place> place_of(const std::string& name) {
  for (const Names& names : kNames) {
    for (int k = 0; k < names.parts; ++k) {
      const std::string number = std::to_string(k),
                        letter(names.letters.empty() ? "" : names.letters.substr(static_cast<std::size_t>(k), 1));
      const std::string inria = names.inria + (names.slot == kSlotX ? letter : number);
      const auto is = [&](const std::string& prefix) {
        const bool joined = !prefix.empty() && prefix.back() == '_';
        return (joined && (name == prefix + number || name == prefix.substr(0, prefix.size() - 1) + number)) ||
               (!letter.empty() && name == prefix + letter);
      };
      if (is(names.inria) || std::any_of(names.others.begin(), names.others.end(), is))
        return Place{names.slot + k, inria};
    }
  }
  if (std::find(kOpacities.begin(), kOpacities.end(), name) != kOpacities.end()) return Place{kSlotOpacity, "opacity"};
  if (name == "filter_3d") return Place{kSlotFilter, "filter_3D"};
  return std::nullopt;
}

// Of red, green and blue 0, 1 and 2.
int color_of(const std::string& name) {
  for (const auto& colors : kColors) {
    const auto found = std::find(colors.begin(), colors.end(), name);
    if (found != colors.end()) return static_cast<int>(found - colors.begin());
  }
  return -1;
}

// The number behind "f_rest_", or -1 if this is another property: f_rest_07 is one, so that none has two names.
int rest_number(const std::string& name) {
  for (const std::string prefix : kRests) {
    if (!name.starts_with(prefix)) continue;
    try {
      const int number = parse_integer(name.substr(prefix.size()), 0, kMostRest);
      return name == fmt::format("{}{}", prefix, number) ? number : -1;
    } catch (const NumberError&) { return -1; }
  }
  return -1;
}

// Of a type that holds shares of 1 in whole numbers the one that is 1.
double range_of(PlyType type) {
  return type == PlyType::kUint8 ? 255 : type == PlyType::kUint16 ? 65535 : is_integer(type) ? 0 : 1;
}

std::string some(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kShown);
  std::string text =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  return one_line(names.size() > shown ? fmt::format("{} and {} more", text, names.size() - shown) : text);
}

class Finder {
 public:
  Finder(const std::string& file, const PlyHeader& header, const PlyElement& vertex, SceneFormat& format)
      : file_(file), header_(header), vertex_(vertex), format_(format), types_(kSlotRest) {}

  PlyLayout find() {
    layout_.sh_degree = std::min(file_degree(), kMaxShDegree);
    for (const PlyProperty& property : vertex_.properties) layout_.slots.push_back(slot_of(property));
    for (int& slot : layout_.slots) {
      if (layout_.wide && slot >= kSlotX && slot < kSlotX + 3) slot = kWide - slot;  // all three or none
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (!has(kSlotX + axis)) missing(std::string(1, "xyz"[axis]));
    }
    refuse_what_is_no_splat();
    take_colors();
    take_scales();
    layout_.rotated = has(kSlotRotation);
    for (int k = 0; k < 4; ++k) {
      if (has(kSlotRotation + k) || (!layout_.rotated && layout_.scales == 1)) continue;
      missing(fmt::format("rot_{}", k));
    }
    if (!has(kSlotOpacity)) missing("opacity");
    // Where all values are whole numbers they are what they would be as floats.
    if (is_integer(*types_[kSlotOpacity]) && !is_integer(*types_[kSlotScale]) && range_of(*types_[kSlotOpacity]) > 0) {
      layout_.opacity_range = range_of(*types_[kSlotOpacity]);
      format_.findings.emplace_back("opacity_codes",
                                    fmt::format("opacities are whole numbers up to {:g} and are taken as such, not as "
                                                "logits",
                                                layout_.opacity_range));
    }
    layout_.filtered = has(kSlotFilter);
    tell();
    return std::move(layout_);
  }

 private:
  bool has(int slot) const { return types_[static_cast<std::size_t>(slot)].has_value(); }
  std::string line() const { return fmt::format("line {}, element vertex", vertex_.line); }
  [[noreturn]] void missing(const std::string& name) const {
    const std::string others = unread_.empty() ? "" : fmt::format("; found {}, which are not known", some(unread_));
    throw InputError(
        file_, line(),
        fmt::format("property {} is missing, expected the properties of INRIA's point_cloud.ply{}", name, others));
  }

  // The degree of the file, of which not all may be kept.
  int file_degree() {
    int count = 0, highest = -1;
    for (const PlyProperty& property : vertex_.properties) {
      const int number = rest_number(lower(property.name));
      if (number < 0) continue;
      ++count;
      highest = std::max(highest, number);
    }
    for (int degree = 0; degree <= kMostDegree; ++degree) {
      if (count != 3 * sh_rest_count(degree) || highest != count - 1) continue;
      if (degree > kMaxShDegree)
        format_.findings.emplace_back(
            "sh_degree", fmt::format("the SH coefficients above degree {} are left out, the file has degree {}",
                                     kMaxShDegree, degree));
      in_file_ = sh_rest_count(degree);
      return degree;
    }
    throw InputError(
        file_, fmt::format("line {}, f_rest", vertex_.line),
        fmt::format("found {} properties numbered up to {}, expected 0, 9, 24 or 45 numbered from 0", count, highest));
  }

  int slot_of(const PlyProperty& property) {
    const std::string name = lower(property.name);
    const auto check = [&] {
      if (property.is_list)
        throw InputError(file_, fmt::format("line {}, {}", property.line, property.name),
                         "found a list, expected a scalar property");
    };
    if (const int number = rest_number(name); number >= 0) {
      check();
      if (!name.starts_with(kRests[0])) others_.push_back(property.name);
      const int coefficient = number % in_file_;
      return coefficient < sh_rest_count(layout_.sh_degree) ? kSlotRest + coefficient * 3 + number / in_file_ : kSkip;
    }
    if (const std::optional<Place> place = place_of(name); place && !has(place->slot)) {
      check();
      types_[static_cast<std::size_t>(place->slot)] = property.type;
      if (place->inria != property.name) others_.push_back(property.name);
      const bool exact = property.type == PlyType::kFloat64 || property.type == PlyType::kInt32 ||
                         property.type == PlyType::kUint32 || header_.format == PlyFormat::kAscii;
      layout_.wide = layout_.wide || (place->slot < kSlotX + 3 && exact);
      return place->slot;
    }
    if (const int color = color_of(name); color >= 0) {
      colors_[static_cast<std::size_t>(color)] = property.is_list ? nullptr : &property;
      return kSkip;
    }
    const bool harmless = std::find(kHarmless.begin(), kHarmless.end(), name) != kHarmless.end();
    if (!harmless && !name.starts_with("padding")) unread_.push_back(property.name);
    return kSkip;
  }

  void refuse_what_is_no_splat() const {
    const auto begins = [&](const char* prefix) {
      return std::any_of(vertex_.properties.begin(), vertex_.properties.end(),
                         [&](const PlyProperty& property) { return property.name.starts_with(prefix); });
    };
    if (begins("f_anchor_feat") || begins("f_offset"))
      throw InputError(file_, line(),
                       "found anchors of Scaffold-GS (f_anchor_feat, f_offset), whose Gaussians come out of networks "
                       "that are not in the file: convert them with its own tools first");
    if (has(kSlotOpacity) && (has(kSlotScale) || has(kSlotRotation))) return;
    if (has(kSlotScale) && has(kSlotRotation)) return;
    const bool mesh = std::any_of(header_.elements.begin(), header_.elements.end(), [](const PlyElement& element) {
      return element.count > 0 && (element.name == "face" || element.name == "tristrips");
    });
    throw InputError(
        file_, line(),
        fmt::format("found a {}, not Gaussian splats: {} without opacity, scales and rotations; export the "
                    "splat .ply of your program, or train from photographs",
                    mesh ? "mesh" : "point cloud", colors_[0] != nullptr ? "positions and colours" : "positions"));
  }

  void take_colors() {
    const int coefficients = has(kSlotDc) + has(kSlotDc + 1) + has(kSlotDc + 2);
    const bool all = std::all_of(colors_.begin(), colors_.end(), [](const auto* color) { return color != nullptr; });
    layout_.beside = coefficients == 3;
    if (layout_.beside && !all) return;
    if (!layout_.beside && (!all || coefficients > 0)) {
      for (int k = 0; k < 3; ++k)
        if (!has(kSlotDc + k)) missing(fmt::format("f_dc_{}", k));
    }
    for (int k = 0; k < 3; ++k) {
      const PlyProperty* color = colors_[static_cast<std::size_t>(k)];
      layout_.colors.push_back(color->name);
      if (color->type == PlyType::kFloat32 || color->type == PlyType::kFloat64) layout_.color_range = 1;
      layout_.slots[static_cast<std::size_t>(color - vertex_.properties.data())] =
          (layout_.beside ? kSlotColor : kSlotDc) + k;
    }
    if (layout_.color_range == 0) layout_.color_range = colors_[0]->type == PlyType::kUint16 ? 65535 : 255;
  }

  void take_scales() {
    while (layout_.scales > 1 && !has(kSlotScale + layout_.scales - 1)) --layout_.scales;
    if (!has(kSlotScale)) missing("scale_0");
    if (layout_.scales > 1 && !has(kSlotScale + 1)) missing("scale_1");
    if (layout_.scales == 1)
      format_.findings.emplace_back("one_scale", "each Gaussian has one scale: it is taken for all three axes");
  }

  void tell() {
    std::vector<std::string> elements;
    for (const PlyElement& element : header_.elements) {
      if (&element != &vertex_ && element.count > 0) elements.push_back(element.name);
    }
    if (!elements.empty())
      format_.findings.emplace_back("other_elements",
                                    fmt::format("elements beside the Gaussians are not read: {}", some(elements)));
    if (!others_.empty())
      format_.findings.emplace_back(
          "other_names", fmt::format("properties under other names than INRIA's are read: {}", some(others_)));
    if (!unread_.empty())
      format_.findings.emplace_back("not_read", fmt::format("properties that are not read: {}; what they change is not "
                                                            "in the picture",
                                                            some(unread_)));
  }

  const std::string& file_;
  const PlyHeader& header_;
  const PlyElement& vertex_;
  SceneFormat& format_;
  PlyLayout layout_;
  int in_file_ = 1;  // coefficients of a channel
  std::vector<std::optional<PlyType>> types_;
  std::array<const PlyProperty*, 3> colors_{};
  std::vector<std::string> others_, unread_;
};

}  // namespace

PlyLayout ply_layout(const std::string& file, const PlyHeader& header, const PlyElement& vertex, SceneFormat& format) {
  return Finder(file, header, vertex, format).find();
}

}  // namespace pipegs
