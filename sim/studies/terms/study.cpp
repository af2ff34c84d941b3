// SPDX-License-Identifier: Apache-2.0
// study.cpp: what report.hpp shows, computed.
#include <algorithm>
#include <cmath>

#include "sim/studies/terms/report.hpp"

namespace pipegs {
namespace {

constexpr double kPaperRatio = 7.48, kOfRu = 16;  // raster over sort of Baseline; lanes of an RU

LeadRow lead_of(const TermsView& view, PixelSet work, const char* name) {
  LeadRow row{.work = name};
  double lists = 0, keys = 0, pixels_of_key = 0;
  std::array<double, kKeySorts> sorts = {};
  for (const ListWork& list : view.frame.tiles) {
    const double n = list.keys[list_cover(work)];
    if (n == 0) continue;
    ++lists, keys += n, pixels_of_key += list.pixels(work, true) / n;
    for (size_t s = 0; s < sorts.size(); ++s) sorts[s] += sort_cycles(static_cast<SortPace>(s), n);
  }
  if (lists == 0) return row;
  const double pixel = pixels_of_key / lists / kOfRu / kPaperRatio;
  const double ops = raster_ops(Rung::kBaseline, 16);
  row.keys = keys / lists;
  row.needed = {pixel, pixel * ops / kBlendOps, pixel * ops};
  for (size_t s = 0; s < sorts.size(); ++s) row.sorts[s] = sorts[s] / keys;
  return row;
}

std::vector<WaterfallRow> waterfall(TermsModel& model) {
  const Terms ours = our_terms(), paper = paper_terms();
  Terms together = ours;
  std::vector<WaterfallRow> rows(1);
  rows[0].value = "as our RTL";
  rows[0].alone = rows[0].together = model.ladder(ours);
  rows[0].without = model.ladder(paper);
  for (const Assumption& one : assumptions()) {
    const Terms before = together;
    one.take(together, paper);
    if (together == before) continue;
    Terms alone = ours, without = paper;
    one.take(alone, paper);
    one.take(without, ours);
    rows.push_back({&one, one.value(paper), model.ladder(alone), model.ladder(together), model.ladder(without)});
  }
  return rows;
}

}  // namespace

TermsReport terms_report(const TermsView& view, const MemoryRates& rates) {
  TermsModel model(view, rates);
  TermsReport report;
  report.closed = closed_form();
  report.lead = {lead_of(view, PixelSet::kSquareTiles, "tiles of the square"),
                 lead_of(view, PixelSet::kOrientedTiles, "tiles of the oriented box"),
                 lead_of(view, PixelSet::kOrientedParts, "parts of the oriented box"),
                 lead_of(view, PixelSet::kExactParts, "parts, exact")};
  report.waterfall = waterfall(model);
  const Terms paper = paper_terms();
  report.paper = model.ladder(paper);
  report.search = search_terms(model, search_grid());
  report.alpha_megabytes = report.paper[Rung::kHgr].alpha_bytes / 1e6;
  for (const Slice& layer : view.grids.at(paper.grid)) {
    const double bytes = layer.all_tiles.pixels(paper.active, !paper.opaque) * paper.alpha_bytes;
    report.layer_megabytes = std::max(report.layer_megabytes, bytes / 1e6);
  }
  return report;
}

}  // namespace pipegs
