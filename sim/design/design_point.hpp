// SPDX-License-Identifier: Apache-2.0
// design_point.hpp: the design points of the paper's ladder (Fig. 8, 9) as configurations of the one machine, and two
// of our own.
//
// Idea    A design point is what is computed where, and in which order: the entries `late`, `order` and `quadratic` of
//         cpp_model/config.def. Units, widths and memory stay the same from design point to design point. Design points
//         that cache coefficients (late) have no alpha stores and twice the records in their SUs; what that comes to in
//         bytes: docs/silicon/memories.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct DesignPoint {
  std::string_view name;
  int late, order, quadratic, records, bucket_bits = 3;
  std::string_view what;  // one line
  bool in_paper;
  // What the paper reports of this variant; 0 where its text gives no figure.
  double paper_speedup;  // over Baseline, "up to", Sec. 5.3.2
  double paper_ratio;    // rasterization over sorting time, Sec. 5.3.1
};

// From the paper's baseline upwards.
const std::vector<DesignPoint>& design_points();
std::string design_point_names();  // with commas between

// Throws ConfigError, one line that names the known design points.
const DesignPoint& find_design_point(std::string_view name);
std::vector<const DesignPoint*> find_design_points(
    const std::vector<std::string>& names);  // all of them when there is no name

void apply_design_point(const DesignPoint& design_point, Config& config);

// The configuration's design point by name, "" when it is none of them.
std::string design_point_name(const Config& config);

}  // namespace pipegs
