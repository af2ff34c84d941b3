// SPDX-License-Identifier: Apache-2.0
// report_page.hpp: the results of a folder side by side: tables, charts, pictures.
#pragma once

#include "sim/command/report/results.hpp"
#include "sim/report/html/study_page.hpp"

namespace pipegs {

// All of it, after the page's title. Pictures are as large as a page of a few megabytes allows.
void add_results(StudyPage& page, const FolderResults& results);

}  // namespace pipegs
