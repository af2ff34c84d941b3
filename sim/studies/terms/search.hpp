// SPDX-License-Identifier: Apache-2.0
// search.hpp: which sets of terms within the paper's words give the paper's speed-ups on a view.
//
// Idea    A finite grid, every set of it computed. No number is fitted: what the paper leaves open takes each of a few
//         values, cycles of a Gaussian the powers of two from 1 to 512.
// Rule    A match has HGR over Baseline, DOP over HGR and DOP over Baseline within kWithin of the paper's.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/studies/terms/model.hpp"

namespace pipegs {

inline constexpr double kWithin = 0.10;
inline constexpr size_t kRatios = 3;  // of the other figures, the first ones: raster / sort

// A figure of the paper, and what a ladder has for it.
struct PaperFigure {
  const char *key, *what;
  double paper;
  double (*value)(const TermsLadder&);
};
const std::vector<PaperFigure>& speed_figures();                    // the three that a match has
const std::vector<PaperFigure>& other_figures();                    // those of Fig. 3 and 8, by their nearest reading
double miss(const PaperFigure& figure, const TermsLadder& ladder);  // |value / paper - 1|
double worst_miss(const std::vector<PaperFigure>& figures, const TermsLadder& ladder);

struct TermsSet {
  Terms terms;
  TermsLadder ladder;
  double worst = 0;   // miss of the three speed-ups
  size_t others = 0;  // other figures within kWithin
};

// Of some sets how many have each value of each assumption.
struct TermsTally {
  size_t sets = 0;
  std::map<std::string, std::map<std::string, size_t>> values = {};
  void add(const Terms& terms);
};

struct TermsSearch {
  size_t sets = 0;
  TermsTally speeds = {};           // matches
  TermsTally all = {};              // matches with all three raster / sort within kWithin, too
  std::vector<TermsSet> best = {};  // matches, most other figures first, then the least miss; at most kBest
  TermsSet nearest = {};            // least miss of the speed-ups, match or not
  TermsSet together = {};           // least miss of speed-ups and raster / sort
  double together_worst = 0;
};
inline constexpr size_t kBest = 5;

std::vector<Terms> search_grid();
TermsSearch search_terms(TermsModel& model, const std::vector<Terms>& grid);

}  // namespace pipegs
