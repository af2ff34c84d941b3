// SPDX-License-Identifier: Apache-2.0
// campaign_file.hpp: what a campaign measures: scenes x views x configurations x design points, from a file.
//
// Format  JSON, docs/campaign.md has every field. Paths are those of the file's folder. A field that is not known is
//         refused, for it would be a misspelled one that is known.
// Rule    The points come in the order of the file: scene by scene, view by view, then configurations, then design
//         points.
// Errors  InputError with the file and the place inside, such as scenes[1].views[0].
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/command/campaign/point.hpp"

namespace pipegs {

struct CampaignPoint {
  std::string scene, configuration;  // their names in the file
  PointArguments arguments;
};

// `keep` is where the points shall be kept.
std::vector<CampaignPoint> read_campaign(const std::filesystem::path& path, const std::filesystem::path& keep);

}  // namespace pipegs
