// SPDX-License-Identifier: Apache-2.0
// merge_page.hpp: the points of a campaign as a page: figures by view and design point as charts, every point in a
// table, and those that are missing with the commands that measure them.
#pragma once

#include <vector>

#include "sim/command/campaign/merge.hpp"
#include "sim/report/html/study_page.hpp"

namespace pipegs {

// All of it, after the page's title.
void add_campaign(StudyPage& page, const std::vector<PointResult>& points);

}  // namespace pipegs
