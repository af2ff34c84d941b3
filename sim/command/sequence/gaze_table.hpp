// SPDX-License-Identifier: Apache-2.0
// gaze_table.hpp: what pictures in parts took as a whole, and how good their rings are, as tables and JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "sim/command/sequence/frame_table.hpp"

namespace pipegs {

// None, or pictures and rings.
std::vector<Table> gaze_tables(const FrameTable& table);
nlohmann::ordered_json gaze_json(const FrameTable& table);

}  // namespace pipegs
