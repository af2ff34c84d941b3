// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/terms/report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "sim/report/finite.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kLaneKeys[] = {"pixel", "area", "serial"},
                     *kSortKeys[] = {"wide", "splitter", "compare", "network", "exchange"};

std::string cell(double value, int digits = 2) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : std::string("-");
}

// DPC, HGR, DOP over Baseline, DOP over HGR; raster / sort of Baseline, DPC, HGR.
std::array<double, 7> ladder_cells(const TermsLadder& l) {
  return {l.over(Rung::kBaseline, Rung::kDpc),
          l.over(Rung::kBaseline, Rung::kHgr),
          l.over(Rung::kBaseline, Rung::kDop),
          l.over(Rung::kHgr, Rung::kDop),
          l[Rung::kBaseline].ratio,
          l[Rung::kDpc].ratio,
          l[Rung::kHgr].ratio};
}
constexpr const char* kLadderKeys[] = {"dpc", "hgr", "dop", "dop_over_hgr", "ratio_baseline", "ratio_dpc", "ratio_hgr"};

std::string ladder_line(const TermsLadder& l) {
  std::string text;
  for (const double value : ladder_cells(l)) text += fmt::format("{:>8}", cell(value));
  return text;
}

Json ladder_json(const TermsLadder& l) {
  Json json;
  const std::array<double, 7> cells = ladder_cells(l);
  for (size_t i = 0; i < cells.size(); ++i) json[kLadderKeys[i]] = finite_json(cells[i]);
  return json;
}

Json rungs_json(const TermsLadder& l) {
  Json json;
  for (const Rung rung : kRungs) {
    const RungTimes& times = l[rung];
    json[rung_name(rung)] = {{"cycles", times.cycles},
                             {"preprocessing", times.pre},
                             {"sort", times.sort},
                             {"raster", times.raster},
                             {"front", times.front},
                             {"stall", times.stall},
                             {"raster_over_sort", finite_json(times.ratio)},
                             {"idle", finite_json(times.idle())},
                             {"alpha_bytes", times.alpha_bytes},
                             {"bytes", times.bytes}};
  }
  return json;
}

Json terms_of(const Terms& terms) {
  Json json;
  for (const Assumption& one : assumptions()) json[one.key] = one.value(terms);
  return json;
}

Json figures_json(const TermsLadder& l) {
  Json json;
  for (const auto* figures : {&speed_figures(), &other_figures()}) {
    for (const PaperFigure& one : *figures)
      json[one.key] = {{"what", one.what}, {"paper", one.paper}, {"here", finite_json(one.value(l))}};
  }
  return json;
}

Json set_json(const TermsSet& set) {
  return {{"terms", terms_of(set.terms)},
          {"ladder", ladder_json(set.ladder)},
          {"worst_miss", finite_json(set.worst)},
          {"others_within", set.others},
          {"figures", figures_json(set.ladder)}};
}

Json tally_json(const TermsTally& tally) { return {{"sets", tally.sets}, {"values", tally.values}}; }

std::string closed_text(const std::vector<ClosedRow>& rows) {
  std::string text = "the paper's figures against each other, times in units of a tile's sort\n";
  for (const ClosedRow& row : rows)
    text += fmt::format("  {:<44}{:>7.3f}  paper {:<6.4g}{:>+7.1f} %  {}\n", row.figure, row.value, row.paper,
                        100 * row.residue(), row.equation);
  return text;
}

std::string lead_text(const std::vector<LeadRow>& rows) {
  std::string text = fmt::format(
      "\ncycles of a key that raster / sort = 7.48 asks of an SU, by what a lane does, and what sorters take\n  {:<28}"
      "{:>8}{:>9}{:>9}{:>9}  |{:>9}{:>9}{:>9}{:>9}{:>9}\n",
      "pixels", "keys", "pixel", "area", "serial", "16 keys", "1 key", "compare", "8 exch.", "1 exch.");
  for (const LeadRow& row : rows) {
    text += fmt::format("  {:<28}{:>8.1f}", row.work, row.keys);
    for (const double value : row.needed) text += fmt::format("{:>9.2f}", value);
    text += "  |";
    for (const double value : row.sorts) text += fmt::format("{:>9.2f}", value);
    text += "\n";
  }
  return text;
}

std::string waterfall_text(const std::vector<WaterfallRow>& rows) {
  std::string text = fmt::format(
      "\nfrom our terms to the paper's: one assumption alone, all so far, and the paper's without it\n  "
      "{:<38}{:<8}{:>8}"
      "{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}\n",
      "", "", "DPC", "HGR", "DOP", "DOP/HGR", "r/s", "DPC", "HGR");
  const auto line = [&](const std::string& name, const char* which, const TermsLadder& ladder) {
    text += fmt::format("  {:<38}{:<8}{}\n", name, which, ladder_line(ladder));
  };
  for (const WaterfallRow& row : rows) {
    if (row.assumption == nullptr) {
      line(row.value, "", row.together);
      continue;
    }
    line(fmt::format("{}: {}", row.assumption->key, row.value), "alone", row.alone);
    line("", "so far", row.together);
    line("", "without", row.without);
  }
  return text + fmt::format("  {:<46}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}\n", "paper", "-", "2.33", "2.85", "1.22",
                            "7.48", "5.71", "1.83");
}

std::string figures_text(const TermsReport& report) {
  std::string text =
      fmt::format("\n{:<66}{:>8}{:>9}{:>9}\n", "figures, beside the paper's", "paper", "terms", "nearest");
  for (const auto* figures : {&speed_figures(), &other_figures()}) {
    for (const PaperFigure& one : *figures)
      text += fmt::format("  {:<64}{:>8.3g}{:>9}{:>9}\n", one.what, one.paper, cell(one.value(report.paper)),
                          cell(one.value(report.search.nearest.ladder)));
  }
  return text + fmt::format(
                    "  alphas under the paper's terms: {:.1f} MB, {:.1f} MB in the largest layer; Table 2: 428 "
                    "KB of buffers\n",
                    report.alpha_megabytes, report.layer_megabytes);
}

std::string set_text(const TermsSet& set) {
  return fmt::format("  {:.1f} % at most, {} of {} others\n    {}\n    {}\n", 100 * set.worst, set.others,
                     other_figures().size(), ladder_line(set.ladder), describe(set.terms));
}

std::string tally_text(const TermsTally& tally) {
  std::string text;
  for (const auto& [key, values] : tally.values) {
    text += fmt::format("  {:<8}", key);
    for (const auto& [value, count] : values)
      text += fmt::format("  {} {:.0f} %", value, 100.0 * static_cast<double>(count) / static_cast<double>(tally.sets));
    text += "\n";
  }
  return text;
}

std::string search_text(const TermsSearch& search) {
  std::string text = fmt::format("\n{} sets of terms; {} with all three speed-ups within {:.0f} %\n{}", search.sets,
                                 search.speeds.sets, 100 * kWithin, tally_text(search.speeds));
  text += fmt::format("{} with raster / sort of all three rungs within it, too\n{}", search.all.sets,
                      tally_text(search.all));
  if (!search.best.empty()) text += "matches with most of the other figures\n";
  for (const TermsSet& set : search.best) text += set_text(set);
  text += "nearest to the three speed-ups\n" + set_text(search.nearest);
  text += fmt::format("nearest to speed-ups and raster / sort together: {:.1f} %\n", 100 * search.together_worst);
  return text + set_text(search.together);
}

}  // namespace

std::string terms_text(const TermsReport& report) {
  std::string text = closed_text(report.closed) + lead_text(report.lead) + waterfall_text(report.waterfall) +
                     figures_text(report) + search_text(report.search) + "\nassumptions\n";
  const Terms ours = our_terms(), paper = paper_terms();
  for (const Assumption& one : assumptions())
    text += fmt::format("  {:<8} {}; ours: {}; paper's: {}\n           {}\n", one.key, one.what, one.value(ours),
                        one.value(paper), one.words);
  return text;
}

Json terms_json(const TermsReport& report) {
  Json json;
  for (const ClosedRow& row : report.closed)
    json["closed"].push_back({{"figure", row.figure},
                              {"equation", row.equation},
                              {"value", row.value},
                              {"paper", row.paper},
                              {"residue", row.residue()}});
  for (const LeadRow& row : report.lead) {
    Json one = {{"work", row.work}, {"keys", row.keys}};
    for (size_t i = 0; i < row.needed.size(); ++i) one["needed"][kLaneKeys[i]] = row.needed[i];
    for (size_t i = 0; i < row.sorts.size(); ++i) one["sorts"][kSortKeys[i]] = row.sorts[i];
    json["lead"].push_back(one);
  }
  for (const WaterfallRow& row : report.waterfall)
    json["waterfall"].push_back({{"assumption", row.assumption == nullptr ? "" : row.assumption->key},
                                 {"value", row.value},
                                 {"alone", ladder_json(row.alone)},
                                 {"together", ladder_json(row.together)},
                                 {"without", ladder_json(row.without)}});
  json["ours"] = rungs_json(report.waterfall.front().alone);
  json["paper"] = {{"rungs", rungs_json(report.paper)},
                   {"figures", figures_json(report.paper)},
                   {"alpha_megabytes", report.alpha_megabytes},
                   {"layer_megabytes", report.layer_megabytes}};
  const TermsSearch& search = report.search;
  json["search"] = {{"sets", search.sets}, {"speeds", tally_json(search.speeds)}, {"all", tally_json(search.all)}};
  json["search"]["best"] = Json::array();
  for (const TermsSet& set : search.best) json["search"]["best"].push_back(set_json(set));
  json["search"]["nearest"] = set_json(search.nearest);
  json["search"]["together"] = set_json(search.together);
  json["search"]["together_worst_miss"] = finite_json(search.together_worst);
  const Terms ours = our_terms(), paper = paper_terms();
  for (const Assumption& one : assumptions())
    json["assumptions"].push_back({{"key", one.key},
                                   {"what", one.what},
                                   {"words", one.words},
                                   {"ours", one.value(ours)},
                                   {"paper", one.value(paper)}});
  return json;
}

}  // namespace pipegs
