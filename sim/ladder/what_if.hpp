// SPDX-License-Identifier: Apache-2.0
// what_if.hpp: one view on a machine and on changes of it, side by side: time, traffic, area, energy, accuracy.
//
// Idea    Cycles and bytes are the timing model's, decibels the golden model's, area, clock and energy those of the
//         frame model, which says of each whether such a machine was synthesised or measured: no RTL is built.
// Rule    Decibels to the truth are those of the picture against float64 in depth order, with all SH bands of the scene
//         whatever the machine leaves out. Microseconds need a clock: there are none where no longest path of such a
//         machine is known.
// Docs    docs/commands.md
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/ladder/frame_figures.hpp"
#include "sim/report/chart.hpp"
#include "sim/silicon/frame_model.hpp"

namespace pipegs {

struct WhatIfRow {
  std::string name;  // of the base, or what was set: "units=2,records=2048"
  Config config;
  FrameFigures frame = {};
  double truth_db = 0, base_db = 0;                 // infinite of equal pictures
  std::optional<FrameCost> silicon = std::nullopt;  // none of a machine whose area is not known
};

// The base comes first.
Table what_if_table(const std::vector<WhatIfRow>& rows);
nlohmann::ordered_json what_if_json(const std::vector<WhatIfRow>& rows);
std::vector<Chart> what_if_charts(const std::vector<WhatIfRow>& rows);

}  // namespace pipegs
