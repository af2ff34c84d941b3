// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/terms/search: the grid is finite and without doubles; the search finds what trying every set
// finds.
#include "sim/studies/terms/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/studies/terms/report.hpp"
#include "verif/frame/scenes.hpp"
#include "sim/studies/terms/test/view.hpp"

namespace pipegs {
namespace {

TEST(TermsSearch, GridHasEachSetOnceAndThePapersTerms) {
  const std::vector<Terms> grid = search_grid();
  std::set<std::string> names;
  for (size_t i = 0; i < grid.size(); i += 7) names.insert(describe(grid[i]));
  EXPECT_EQ(names.size(), (grid.size() + 6) / 7);
  EXPECT_EQ(std::count(grid.begin(), grid.end(), paper_terms()), 1);
  EXPECT_EQ(std::count(grid.begin(), grid.end(), our_terms()), 0);
}

TEST(TermsSearch, FindsWhatEverySetGives) {
  const TermsView view = terms_view(count_frame(random_scene(31, 6000, 0), test_camera(260, 200), {.grids = {4, 8}}));
  TermsModel model(view, memory_rates(view, "lpddr5-6400x4", 1.0));
  std::vector<Terms> grid;
  const std::vector<Terms> whole = search_grid();
  for (size_t i = 5; i < whole.size(); i += 331) grid.push_back(whole[i]);
  const TermsSearch found = search_terms(model, grid);
  EXPECT_EQ(found.sets, grid.size());
  size_t matches = 0, all_matches = 0;
  double nearest = 1e9, together = 1e9;
  for (const Terms& terms : grid) {
    const TermsLadder l = TermsModel(model).ladder(terms);
    const double hgr = l[Rung::kBaseline].cycles / l[Rung::kHgr].cycles,
                 dop = l[Rung::kBaseline].cycles / l[Rung::kDop].cycles;
    const double worst = std::max({std::abs(hgr / 2.33 - 1), std::abs(dop / 2.85 - 1), std::abs(dop / hgr / 1.22 - 1)});
    const double all = std::max({worst, std::abs(l[Rung::kBaseline].ratio / 7.48 - 1),
                                 std::abs(l[Rung::kDpc].ratio / 5.71 - 1), std::abs(l[Rung::kHgr].ratio / 1.83 - 1)});
    matches += worst <= 0.1, all_matches += all <= 0.1;
    nearest = std::min(nearest, worst), together = std::min(together, all);
  }
  EXPECT_GT(matches, 0u);
  EXPECT_EQ(found.speeds.sets, matches);
  EXPECT_EQ(found.all.sets, all_matches);
  EXPECT_NEAR(found.nearest.worst, nearest, 1e-12);
  EXPECT_NEAR(found.together_worst, together, 1e-12);
  EXPECT_EQ(found.best.size(), std::min(matches, kBest));
  for (size_t i = 1; i < found.best.size(); ++i) EXPECT_GE(found.best[i - 1].others, found.best[i].others);
  for (const auto& [key, values] : found.speeds.values) {
    size_t sum = 0;
    for (const auto& [value, count] : values) sum += count;
    EXPECT_EQ(sum, matches) << key;
  }
}

// What is known is computed once: the second answer is the first.
TEST(TermsSearch, ModelsDoNotDependOnWhatWasAskedBefore) {
  const TermsView view = hand_view();
  TermsModel used(view, {});
  for (const Terms& terms : {hand_terms(), paper_terms(), our_terms()}) used.ladder(terms);
  for (const Terms& terms : {our_terms(), hand_terms(), paper_terms()}) {
    const TermsLadder fresh = TermsModel(view, {}).ladder(terms), again = used.ladder(terms);
    for (const Rung rung : kRungs) EXPECT_EQ(again[rung].cycles, fresh[rung].cycles) << rung_name(rung);
  }
}

// Each step takes one assumption; the last has all of the paper's.
TEST(TermsReport, WaterfallEndsInThePapersTerms) {
  const TermsView view = hand_view();
  const TermsReport report = terms_report(view, {0.1, 0.2, 0.1, 0.5, 0.25, 0.125});
  const std::vector<WaterfallRow>& rows = report.waterfall;
  ASSERT_GT(rows.size(), 8u);
  EXPECT_EQ(rows[0].assumption, nullptr);
  for (const Rung rung : kRungs) {
    EXPECT_EQ(rows.back().together[rung].cycles, report.paper[rung].cycles);
    EXPECT_EQ(rows[1].alone[rung].cycles, rows[1].together[rung].cycles);
  }
  Terms alone = our_terms();
  rows[2].assumption->take(alone, paper_terms());
  Terms without = paper_terms();
  rows[2].assumption->take(without, our_terms());
  EXPECT_EQ(rows[2].without[Rung::kDop].cycles,
            TermsModel(view, {0.1, 0.2, 0.1, 0.5, 0.25, 0.125}).ladder(without)[Rung::kDop].cycles);
  EXPECT_EQ(rows[2].alone[Rung::kHgr].cycles,
            TermsModel(view, {0.1, 0.2, 0.1, 0.5, 0.25, 0.125}).ladder(alone)[Rung::kHgr].cycles);
}

// Tile A: 20 keys of the oriented box, 128 and 128 pixels of parts a key; so 128 / 16 / 7.48 cycles a key at a pixel a
// cycle.
TEST(TermsReport, LeadIsTheSortThatTheRatioAsksFor) {
  const TermsReport report = terms_report(hand_view(), {});
  const auto row = std::find_if(report.lead.begin(), report.lead.end(),
                                [](const LeadRow& one) { return one.work == "tiles of the square"; });
  ASSERT_NE(row, report.lead.end());
  EXPECT_EQ(row->keys, 11);
  EXPECT_DOUBLE_EQ(row->needed[0], 256 / 16.0 / 7.48);
  EXPECT_DOUBLE_EQ(row->needed[1], 256 / 16.0 / 7.48 * 4);
  EXPECT_DOUBLE_EQ(row->needed[2], 256 / 16.0 / 7.48 * 36);
  EXPECT_DOUBLE_EQ(row->sorts[static_cast<size_t>(SortPace::kCompare)], (100 + 2) / 22.0);
}

}  // namespace
}  // namespace pipegs
