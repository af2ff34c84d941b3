// SPDX-License-Identifier: Apache-2.0
// pack_cells: the table of cells of a machine with watermarks: a cell with many groups becomes several.
//
// Idea    A window tests every group of a cell that it touches, and half of all Gaussians may lie in a few cells of the
//         grid. Where the order of cells says nothing (order 2) the table has more entries than the grid has cells.
//         An entry is any run of groups: the one with most groups is cut where its two parts, groups times surface of
//         the box that holds them, come to least, until the table is full or none has more than kFewGroups. Chunks and
//         groups stay as they are, and so do pixels.
// Pace    Groups times log entries, at most.
#pragma once

#include <vector>

#include "cpp_model/records.hpp"

namespace pipegs {

// `cells` as the grid gives them, `groups` with their boxes filled in; `entries` of the table, at least one for each
// cell with a group. The result has so many; those behind the last one are empty.
std::vector<Node> cell_table(const std::vector<Node>& cells, const std::vector<Node>& groups, size_t entries);

}  // namespace pipegs
