// SPDX-License-Identifier: Apache-2.0
// design_point.cpp: see design_point.hpp.
#include "sim/design/design_point.hpp"

namespace pipegs {

const std::vector<DesignPoint>& design_points() {
  static const std::vector<DesignPoint> kDesignPoints = {
      {.name = "baseline",
       .late = 1,
       .order = 1,
       .quadratic = 1,
       .records = 2048,
       .what = "preprocess all, list per window, sort, then every pixel's power by the full quadratic form in the RUs",
       .in_paper = true,
       .paper_speedup = 1,
       .paper_ratio = 7.48},
      {.name = "dpc",
       .late = 1,
       .order = 1,
       .quadratic = 0,
       .records = 2048,
       .what = "baseline with the power by differences along rows (DPC)",
       .in_paper = true,
       .paper_speedup = 0,
       .paper_ratio = 5.71},
      {.name = "tspp",
       .late = 0,
       .order = 1,
       .quadratic = 0,
       .records = 1024,
       .what = "dpc with the alphas computed once in the PUs and cached (TSPP): the paper's HGR",
       .in_paper = true,
       .paper_speedup = 2.33,
       .paper_ratio = 1.83},
      {.name = "dop",
       .late = 0,
       .order = 0,
       .quadratic = 0,
       .records = 1024,
       .what = "tspp with layers instead of lists (DOP): the paper's final design",
       .in_paper = true,
       .paper_speedup = 2.85,
       .paper_ratio = 0},
      {.name = "late",
       .late = 1,
       .order = 0,
       .quadratic = 0,
       .records = 2048,
       .what = "layers, but coefficients are cached instead of alphas; the Row Units stand in the RUs",
       .in_paper = false,
       .paper_speedup = 0,
       .paper_ratio = 0},
      {.name = "exact",
       .late = 1,
       .order = 2,
       .quadratic = 0,
       .records = 2048,
       .bucket_bits = 5,
       .what = "late with chunks taken nearest first and released by watermarks: depth order without layers",
       .in_paper = false,
       .paper_speedup = 0,
       .paper_ratio = 0},
  };
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

void apply_design_point(const DesignPoint& design_point, Config& config) {
  config.late = design_point.late;
  config.order = design_point.order;
  config.quadratic = design_point.quadratic;
  config.records = design_point.records;
  config.bucket_bits = design_point.bucket_bits;
}

std::string design_point_name(const Config& config) {
  for (const DesignPoint& design_point : design_points()) {
    if (design_point.late == config.late && design_point.order == config.order &&
        design_point.quadratic == config.quadratic)
      return std::string(design_point.name);
  }
  return "";
}

}  // namespace pipegs
