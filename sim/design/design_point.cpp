// SPDX-License-Identifier: Apache-2.0
// design_point.cpp: see design_point.hpp.
#include "sim/design/design_point.hpp"

#include <fmt/format.h>

namespace pipegs {

namespace {

// How many entries two configurations set unlike.
int differences(const Config& one, const Config& other) {
  int count = 0;
  for (const ConfigEntry& entry : config_entries(one))
    count += entry.member != nullptr && entry.value != other.*entry.member;
  return count;
}

}  // namespace

const std::vector<DesignPoint>& design_points() {
  static const std::vector<DesignPoint> kDesignPoints = [] {
    std::vector<DesignPoint> points;
#define PIPEGS_POINT(name_, in_paper_, speedup_, ratio_, what_) \
  points.push_back({.name = #name_,                             \
                    .in_paper = in_paper_,                      \
                    .paper_speedup = speedup_,                  \
                    .paper_ratio = ratio_,                      \
                    .what = what_,                              \
                    .config = {},                               \
                    .picture = {}});
#define PIPEGS_SETTING(entry, value) points.back().config.entry = value;
#define PIPEGS_PICTURE(entry, value) points.back().config.entry = points.back().picture.entry = value;
#define PIPEGS_END(name_)
#include "sim/design/design_points.def"
#undef PIPEGS_POINT
#undef PIPEGS_SETTING
#undef PIPEGS_PICTURE
#undef PIPEGS_END
    return points;
  }();
  return kDesignPoints;
}

std::string design_point_names() {
  std::string names;
  for (const DesignPoint& design_point : design_points())
    names += (names.empty() ? "" : ", ") + std::string(design_point.name);
  return names;
}

const DesignPoint& find_design_point(std::string_view name) {
  for (const DesignPoint& design_point : design_points()) {
    if (design_point.name == name) return design_point;
  }
  throw ConfigError("unknown design point '" + std::string(name) + "'; known: " + design_point_names());
}

std::vector<const DesignPoint*> find_design_points(const std::vector<std::string>& names) {
  std::vector<const DesignPoint*> found;
  if (names.empty()) {
    for (const DesignPoint& design_point : design_points()) found.push_back(&design_point);
  }
  for (const std::string& name : names) {
    const DesignPoint& design_point = find_design_point(name);
    for (const DesignPoint* other : found) {
      if (other == &design_point) throw ConfigError("design point '" + name + "' is named twice");
    }
    found.push_back(&design_point);
  }
  return found;
}

std::string design_point_name(const Config& config) {
  const DesignPoint* nearest = nullptr;
  for (const DesignPoint& point : design_points()) {
    const Config& own = point.config;
    if (own.late != config.late || own.order != config.order || own.quadratic != config.quadratic) continue;
    if (nearest == nullptr || differences(own, config) < differences(nearest->config, config)) nearest = &point;
  }
  return nearest == nullptr ? "" : std::string(nearest->name);
}

std::string machine_name(const Config& config) {
  const std::string design_point = design_point_name(config);
  if (!design_point.empty() && find_design_point(design_point).config == config) return design_point;
  return config_difference(config);
}

std::string machine_words(const Config& config) {
  const std::string name = design_point_name(config);
  const Config base = name.empty() ? Config{} : find_design_point(name).config;
  std::string words = fmt::format("--design {}", name.empty() ? "dop" : name);
  for (const ConfigEntry& entry : config_entries(config)) {
    if (entry.member != nullptr && base.*entry.member != entry.value)
      words += fmt::format(" --set {}={}", entry.name, entry.value);
  }
  return words;
}

}  // namespace pipegs
