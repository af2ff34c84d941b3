// SPDX-License-Identifier: Apache-2.0
// design_point.hpp: the machines that have a name: the design points of the paper's ladder (Fig. 8, 9) and four of our
// own, as configurations of the one machine. design_points.def is the table.
//
// Idea    A design point says what is computed where, and in which order: the entries `late`, `order` and `quadratic`
//         of cpp_model/config.def. Units, lanes and external memory are the same in all of them, and but for `fast` so
//         are the widths. Design points that cache coefficients (late) have no alpha stores and more records in their
//         SUs; what that comes to in bytes: docs/silicon/silicon.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct DesignPoint {
  std::string_view name;
  bool in_paper;
  // What the paper reports of this variant; 0 where its text gives no figure.
  double paper_speedup;   // over Baseline, "up to", Sec. 5.3.2
  double paper_ratio;     // rasterization over sorting time, Sec. 5.3.1
  std::string_view what;  // one line
  Config config;
  Config picture;  // only what changes pixels: design points that are equal here draw the same picture, bit for bit
};

// What a command runs without --design. A plain Config{} is the paper's final design, `dop`.
inline constexpr std::string_view kDefaultDesignPoint = "fast";

// From the paper's baseline upwards.
const std::vector<DesignPoint>& design_points();
std::string design_point_names();  // with commas between

// Throws ConfigError, one line that names the known design points.
const DesignPoint& find_design_point(std::string_view name);
std::vector<const DesignPoint*> find_design_points(
    const std::vector<std::string>& names);  // all of them when there is no name

// The design point to which a configuration belongs: of those with its `late`, `order` and `quadratic` the one from
// which it differs in the fewest entries, the first of equals; "" when there is none.
std::string design_point_name(const Config& config);
// How a table calls a machine: the design point when it is that and nothing else, or all that is set.
std::string machine_name(const Config& config);
// The same machine as every command takes it: --design, and a --set for each entry in which it is another one.
std::string machine_words(const Config& config);

}  // namespace pipegs
