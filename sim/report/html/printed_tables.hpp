// SPDX-License-Identifier: Apache-2.0
// printed_tables.hpp: the tables in a text as commands print it, for a page.
//
// Idea    What a command prints is all that it has to say, in the words and with the digits that were chosen for a
//         reader; a page that takes it from there cannot leave out any of it.
// Format  Blocks with an empty line between. A line whose words are never two blanks apart is a sentence; the other
//         lines are a table, the first of them its names, unless it has numbers wherever the second has. Columns are
//         apart where all lines have two blanks, or one where that is not enough; one row may be wider than its
//         columns. A sentence right above the names is the table's title, the others are notes.
#pragma once

#include <string>
#include <vector>

#include "sim/report/html/study_page.hpp"

namespace pipegs {

std::vector<Table> printed_tables(const std::string& text);

// The number at the beginning of a cell ("~1.2", "+3 %", "0.12 (0.1 to 0.2)"), if there is one.
std::optional<double> leading_number(const std::string& cell);

}  // namespace pipegs
