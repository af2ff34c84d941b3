// SPDX-License-Identifier: Apache-2.0
// pixels_report.hpp: the study of pixels as tables and as JSON, each column with what it is.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "sim/studies/rivals/pixels/pixels.hpp"

namespace pipegs {

// {"parameters": {...}, "streaminggs": [...], "path": {...}, "frames": [...], "definitions": {COLUMN: WHAT}}; decibels
// of equal pictures are null.
nlohmann::ordered_json pixels_json(const PixelStudy& study, const PixelOptions& options);
std::string pixels_text(const PixelStudy& study, const PixelOptions& options);

}  // namespace pipegs
