// SPDX-License-Identifier: Apache-2.0
// join.hpp: the pixels of points of windows, put together to whole pictures.
//
// Rule    A view is joined when all its windows are there; a pixel is what its point kept, bit for bit.
#pragma once

#include <filesystem>
#include <vector>

namespace pipegs {

struct PointResult;

// Writes FOLDER/SCENE-VIEW-CONFIGURATION-DESIGN/frame.exr and frame.png; nothing for points of whole views.
void join_windows(const std::filesystem::path& folder, const std::vector<PointResult>& points);

}  // namespace pipegs
