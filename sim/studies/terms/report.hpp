// SPDX-License-Identifier: Apache-2.0
// report.hpp: the paper's ladder in its own terms as text and JSON: closed form, lead, waterfall, search, figures.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/studies/terms/closed.hpp"
#include "sim/studies/terms/search.hpp"

namespace pipegs {

// Whether the sort that the ratio 7.48 asks for is one that an SU could have: cycles of a key.
struct LeadRow {
  std::string work;
  double keys = 0;                    // of a list, mean
  std::array<double, 3> needed = {};  // by LanePace: mean raster time of a key in a 16-px tile over 7.48, 36 operations
  std::array<double, kKeySorts> sorts = {};  // by SortPace: sum of times over sum of keys
};

// A step from our terms to the paper's.
struct WaterfallRow {
  const Assumption* assumption = nullptr;  // none: our terms as they are
  std::string value;
  TermsLadder alone, together;  // of ours this one switched; all up to this one
  TermsLadder without;          // of the paper's this one as ours
};

struct TermsReport {
  std::vector<ClosedRow> closed;
  std::vector<LeadRow> lead;
  std::vector<WaterfallRow> waterfall;
  TermsLadder paper;  // under paper_terms
  TermsSearch search;
  double alpha_megabytes = 0;  // of a frame under paper_terms
  double layer_megabytes = 0;  // of its largest layer
};
TermsReport terms_report(const TermsView& view, const MemoryRates& rates);

std::string terms_text(const TermsReport& report);
nlohmann::ordered_json terms_json(const TermsReport& report);

}  // namespace pipegs
