// SPDX-License-Identifier: Apache-2.0
// merge.hpp: what the points of a campaign have come to: one table, one JSON, what it cost, whole pictures.
//
// Files   results.csv     a row for each point, the same wherever they were measured
//         results.json    the same points with all that was measured of them: who draws charts reads this
//         costs.csv       a row for each point: seconds and bytes of the computer
//         frames/*/frame.exr, frame.png  of a view whose windows are all there, joined
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/campaign/campaign_file.hpp"

namespace pipegs {

// A point with what is known when its scene has been read.
struct PointResult {
  CampaignPoint point;
  std::string camera;
  int width = 0, height = 0;                   // of the view, pixels
  int window = 0;                              // the side of a window of its machine
  std::filesystem::path file;                  // where it is kept, or will be
  std::optional<nlohmann::ordered_json> kept;  // result and cost
};

// A figure of a point.
struct FigureColumn {
  const char *name, *place;  // in the tables, and in what was measured
};
const std::vector<FigureColumn>& point_figures();
// Empty for what was not measured. Numbers as JSON writes them: the shortest text that reads back the same.
std::string figure_text(const nlohmann::ordered_json& json, const std::string& place);

// Writes the files. Throws InputError of pixels that are not those of their point.
void write_merged(const std::filesystem::path& out, const std::vector<PointResult>& points);

// What the points that are there took, and what of it each took anew: one line.
std::string cost_text(const std::vector<PointResult>& points);

}  // namespace pipegs
