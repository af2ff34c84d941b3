// SPDX-License-Identifier: Apache-2.0
// merge.hpp: what the points of a campaign have come to: tables, one JSON, one page.
//
// Files   results.csv     a row for each point, the same wherever they were measured
//         results.json    the same points with all that was measured of them: who draws charts reads this
//         costs.csv       a row for each point: seconds and bytes of the computer
// Page    Figures by view and design point as charts, every point in a table, and those that are missing with the
//         commands that measure them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/command/campaign/campaign_file.hpp"
#include "sim/report/html/study_page.hpp"

namespace pipegs {

// A point with what is known when its scene has been read.
struct PointResult {
  CampaignPoint point;
  std::string camera;
  std::filesystem::path file;                  // where it is kept, or will be
  std::optional<nlohmann::ordered_json> kept;  // result and cost
};

void write_merged(const std::filesystem::path& out, const std::vector<PointResult>& points);

// What the points that are there took, and what of it each took anew: one line.
std::string cost_text(const std::vector<PointResult>& points);

// All of the page, after its title.
void add_campaign(StudyPage& page, const std::vector<PointResult>& points);

}  // namespace pipegs
