// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/silicon/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/silicon/published.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDisplay = 60;  // frames/s

const PublishedRow* paper_row(const std::string& unit) {
  const auto found = std::find_if(kPipegsTable2.begin(), kPipegsTable2.end(),
                                  [&](const PublishedRow& row) { return row.unit == unit; });
  return found == kPipegsTable2.end() ? nullptr : &*found;
}

std::string text_of(const Range& range, int digits) {
  return fmt::format("{:.{}f} ({:.{}f} to {:.{}f})", range.mid, digits, range.low, digits, range.high, digits);
}

std::string percent(double share, int digits) { return share > 0 ? fmt::format("{:.{}f} %", 100 * share, digits) : ""; }

std::string area_text(const SiliconPoint& design_point) {
  std::string text = fmt::format("  {}, gates of {}\n  {:<9}{:>6}{:>9}{:>8}{:>25}{:>24}{:>11}\n", design_point.name,
                                 design_point.synth.library, "", "units", "kNAND2", "KB", "mm2 in 28 nm",
                                 "longest path, ps", "paper mm2");
  for (const SiliconRow& row : design_point.rows) {
    const PublishedRow* paper = paper_row(row.name);
    text += fmt::format("  {:<9}{:>6}{:>9}{:>8}{:>25}{:>24}{:>11}\n", row.name,
                        row.count > 0 ? std::to_string(row.count) : "",
                        row.kilo_nand2 > 0 ? fmt::format("{:.0f}", row.kilo_nand2) : "",
                        row.kb > 0 ? fmt::format("{:.0f}", row.kb) : "", text_of(row.area_mm2, 3),
                        row.path_ps.mid > 0 ? text_of(row.path_ps, 0) : "",
                        paper == nullptr ? "" : fmt::format("{:.3f}", paper->area_mm2));
  }
  return text;
}

constexpr size_t kDearest = 12;  // modules whose clocks are told

std::string clocks_text(const SiliconPoint& design_point) {
  if (design_point.energy.empty()) return "";
  std::string text = fmt::format("  {:<9}{:>12}{:>8}{:>9}{:>14}{:>15}{:>12}{:>11}\n", "", "flip-flops", "gated",
                                 "unseen", "uJ of clocks", "gates' enables", "no enable", "the gates");
  for (const EnergyRow& row : design_point.energy) {
    if (row.flipflops == 0) continue;
    const auto count = static_cast<double>(row.flipflops);
    text += fmt::format("  {:<9}{:>12}{:>8}{:>9}{:>14.1f}{:>15}{:>12.1f}{:>11.1f}\n", row.name, row.flipflops,
                        percent(static_cast<double>(row.gated) / count, 1),
                        percent(static_cast<double>(row.unseen) / count, 1), row.clocks_j * 1e6,
                        percent(row.gated_j() / row.open_j, 1), row.ungated_j * 1e6, row.gates_j * 1e6);
  }
  text +=
      "  gated: flip-flops whose clock an enable gates; unseen: those whose enable the waves do not show, counted as "
      "high; gates' enables: share of the edges that pass\n";
  if (design_point.clocks.empty()) return text;
  text += fmt::format("  modules whose clocks take most\n  {:<9}{:<40}{:>12}{:>8}{:>14}{:>12}\n", "", "module",
                      "flip-flops", "gated", "uJ of clocks", "no enable");
  for (size_t i = 0; i < std::min(kDearest, design_point.clocks.size()); ++i) {
    const ModuleClocks& one = design_point.clocks[i];
    text += fmt::format("  {:<9}{:<40}{:>12}{:>8}{:>14.1f}{:>12.1f}\n", one.row, one.module, one.flipflops, one.gated,
                        one.all_j() * 1e6, one.ungated_j * 1e6);
  }
  return text;
}

std::string energy_text(const SiliconPoint& design_point) {
  if (design_point.energy.empty()) return "";
  const double full = design_point.fps(), display = std::min(full, kDisplay);
  std::string text = fmt::format("  {:<9}{:>7}{:>24}{:>8}{:>8}{:>21}{:>24}{:>25}{:>9}\n", "", "awake", "uJ of a frame",
                                 "clocks", "halves", "leakage, mW", fmt::format("mW at {:.0f} frames/s", display),
                                 fmt::format("W at {:.0f} frames/s", full), "paper W");
  for (const EnergyRow& row : design_point.energy) {
    const PublishedRow* paper = paper_row(row.name);
    text += fmt::format("  {:<9}{:>7}{:>24}{:>8}{:>8}{:>21}{:>24}{:>25}{:>9}\n", row.name, percent(row.awake, 0),
                        text_of(row.frame_j * 1e6, 0), percent(row.clocks_j / row.frame_j.mid, 0),
                        percent(row.halves_differ, 1), text_of(row.leakage_w * 1e3, 1),
                        text_of(row.watts(display) * 1e3, 0), text_of(row.watts(full), 3),
                        paper == nullptr ? "" : fmt::format("{:.3f}", paper->power_w));
  }
  return text +
         "  awake: cycles in which a unit has its clock; uJ: without leakage; clocks: share of flip-flops' clocks; "
         "halves of the samples differ by so much\n";
}

// The design points against each other, as Figs. 10 and 11 do: over the baseline where it is among them.
// `mm2`: the area at which they are compared, too, or 0.
std::string design_points_text(const std::vector<SiliconPoint>& design_points, double mm2) {
  const SiliconPoint* baseline = design_points.front().name == "baseline" ? &design_points.front() : nullptr;
  const auto over = [&](double ratio) { return baseline == nullptr ? "" : fmt::format("{:.2f}", ratio); };
  std::string text =
      fmt::format("  {:<28}{:>10}{:>7}{:>10}{:>8}{:>8}{:>14}{:>8}{:>10}{:>8}{:>11}{:>8}{}\n", "design point", "cycles",
                  "GHz", "us", "x", "mm2", "frames/s/mm2", "x", "frames/J", "x", "with DRAM", "x",
                  mm2 > 0 ? fmt::format("{:>20}{:>8}", fmt::format("us at {:g} mm2", mm2), "x") : "");
  for (const SiliconPoint& design_point : design_points) {
    text += fmt::format("  {:<28}{:>10}{:>7.3f}{:>10.1f}{:>8}{:>8.2f}", design_point.name, design_point.cycles,
                        design_point.ghz(), design_point.us(),
                        over(baseline == nullptr ? 0 : baseline->us() / design_point.us()), design_point.mm2());
    const auto add = [&](double (SiliconPoint::*value)() const, int width, int digits) {
      text += fmt::format("{:>{}.{}f}{:>8}", (design_point.*value)(), width, digits,
                          over(baseline == nullptr ? 0 : (design_point.*value)() / (baseline->*value)()));
    };
    add(&SiliconPoint::fps_per_mm2, 14, 1);
    if (design_point.energy.empty()) {
      text += mm2 > 0 ? fmt::format("{:>37}", "") : "";
    } else {
      add(&SiliconPoint::frames_per_joule, 10, 0);
      add(&SiliconPoint::frames_per_joule_with_dram, 11, 0);
    }
    if (mm2 > 0) {
      const double us = design_point.us_of_area(mm2);
      text += fmt::format("{:>20.1f}{:>8}", us, over(baseline == nullptr ? 0 : baseline->us_of_area(mm2) / us));
    }
    text += "\n";
  }
  text += "  GHz: the clock that the longest path allows, at most 1; x: over the baseline\n";
  if (mm2 > 0)
    text += "  at equal area: by the law time = c area^-p through each machine and the one of half as many units\n";
  return text;
}

std::string gscore_text() {
  std::string text = "  GSCore, as published:";
  for (const PublishedRow& row : kGscore)
    text += fmt::format(" {} {:.2f} mm2 {:.2f} W{}", row.unit, row.area_mm2, row.power_w,
                        &row == &kGscore.back() ? "\n" : ",");
  return text;
}

// Bars of the design points, stacked by the rows that Table 2 has too, and the paper's.
template <class Rows, class Value>
Chart stack(const char* chart_name, const char* title, const char* y_label,
            const std::vector<SiliconPoint>& design_points, Rows rows, Value value, double PublishedRow::*paper_value) {
  Chart chart{.name = chart_name, .form = Chart::Form::kStacked, .title = title, .y_label = y_label};
  for (size_t row = 0; row < rows(design_points.front()).size(); ++row) {
    const std::string name = rows(design_points.front())[row].name;
    if (name == "Total" || name == "DRAM") continue;
    Series series{.name = name, .values = {}};
    for (const SiliconPoint& design_point : design_points)
      series.values.push_back(value(design_point, rows(design_point)[row]));
    const PublishedRow* paper = paper_row(name);
    series.values.push_back(paper == nullptr ? 0 : paper->*paper_value);
    chart.series.push_back(series);
  }
  for (const SiliconPoint& design_point : design_points) chart.categories.push_back(design_point.name);
  chart.categories.push_back("paper");
  chart.note = "mid of the ranges";
  return chart;
}

Chart efficiency(const char* name, const char* title, const char* y_label,
                 const std::vector<SiliconPoint>& design_points, double (SiliconPoint::*value)() const) {
  Chart chart{.name = name, .form = Chart::Form::kBars, .title = title, .y_label = y_label};
  Series series{.name = y_label, .values = {}};
  for (const SiliconPoint& design_point : design_points) {
    chart.categories.push_back(design_point.name);
    series.values.push_back((design_point.*value)());
  }
  chart.series = {series};
  return chart;
}

}  // namespace

Json to_json(const Range& range) { return {{"low", range.low}, {"mid", range.mid}, {"high", range.high}}; }

double SiliconPoint::us_of_area(double area) const {
  const double power = std::log(half->us / us()) / std::log(mm2() / half->mm2);
  return us() * std::pow(mm2() / area, power);
}

Json to_json(const std::vector<SiliconPoint>& design_points, double mm2) {
  Json list = Json::array();
  for (const SiliconPoint& design_point : design_points) {
    Json json = {{"name", design_point.name},
                 {"configuration", design_point.synth.configuration},
                 {"library", design_point.synth.library},
                 {"cycles", design_point.cycles},
                 {"ghz", design_point.ghz()},
                 {"us", design_point.us()},
                 {"fps", design_point.fps()},
                 {"fps_per_mm2", design_point.fps_per_mm2()},
                 {"fps_per_mm2_at_1_ghz", design_point.fps_per_mm2() / design_point.ghz()},
                 {"rows", Json::array()}};
    for (const SiliconRow& row : design_point.rows) {
      json["rows"].push_back({{"name", row.name},
                              {"count", row.count},
                              {"kilo_nand2", row.kilo_nand2},
                              {"kb", row.kb},
                              {"area_mm2", to_json(row.area_mm2)},
                              {"path_ps", to_json(row.path_ps)}});
    }
    if (mm2 > 0) {
      json["equal_area"] = {{"mm2", mm2},
                            {"us", design_point.us_of_area(mm2)},
                            {"half_mm2", design_point.half->mm2},
                            {"half_us", design_point.half->us}};
    }
    if (!design_point.energy.empty()) {
      json["frames_per_joule"] = design_point.frames_per_joule();
      json["frames_per_joule_with_dram"] = design_point.frames_per_joule_with_dram();
      for (const EnergyRow& row : design_point.energy) {
        json["energy"].push_back({{"name", row.name},
                                  {"frame_j", to_json(row.frame_j)},
                                  {"awake", row.awake},
                                  {"clocks_j", row.clocks_j},
                                  {"ungated_j", row.ungated_j},
                                  {"gates_j", row.gates_j},
                                  {"open_j", row.open_j},
                                  {"flipflops", row.flipflops},
                                  {"gated", row.gated},
                                  {"unseen", row.unseen},
                                  {"halves_differ", row.halves_differ},
                                  {"leakage_w", to_json(row.leakage_w)},
                                  {"watts_60", to_json(row.watts(std::min(design_point.fps(), kDisplay)))},
                                  {"watts_full", to_json(row.watts(design_point.fps()))}});
      }
      for (const ModuleClocks& one : design_point.clocks) {
        json["clocks"].push_back({{"row", one.row},
                                  {"module", one.module},
                                  {"flipflops", one.flipflops},
                                  {"gated", one.gated},
                                  {"ungated_j", one.ungated_j},
                                  {"gated_j", one.gated_j},
                                  {"gates_j", one.gates_j},
                                  {"open_j", one.open_j}});
      }
    }
    list.push_back(json);
  }
  const auto published = [](const auto& rows) {
    Json json = Json::array();
    for (const PublishedRow& row : rows)
      json.push_back({{"name", row.unit},
                      {"count", row.count},
                      {"kb", row.kb},
                      {"area_mm2", row.area_mm2},
                      {"power_w", row.power_w}});
    return json;
  };
  return {{"designs", list}, {"paper", published(kPipegsTable2)}, {"gscore", published(kGscore)}};
}

std::string to_text(const std::vector<SiliconPoint>& design_points, double mm2) {
  std::string text;
  for (const SiliconPoint& design_point : design_points)
    for (const std::string& part : {area_text(design_point), energy_text(design_point), clocks_text(design_point)})
      text += part.empty() ? "" : part + "\n";
  return text + design_points_text(design_points, mm2) + "\n" + gscore_text();
}

std::vector<Chart> silicon_charts(const std::vector<SiliconPoint>& design_points) {
  std::vector<Chart> charts = {stack(
      "area", "Area in 28 nm", "mm2", design_points,
      [](const SiliconPoint& design_point) -> const std::vector<SiliconRow>& { return design_point.rows; },
      [](const SiliconPoint&, const SiliconRow& row) { return row.area_mm2.mid; }, &PublishedRow::area_mm2)};
  const bool energy = !design_points.front().energy.empty();
  if (energy) {
    charts.push_back(stack(
        "power", "Power at full speed", "W", design_points,
        [](const SiliconPoint& design_point) -> const std::vector<EnergyRow>& { return design_point.energy; },
        [](const SiliconPoint& design_point, const EnergyRow& row) { return row.watts(design_point.fps()).mid; },
        &PublishedRow::power_w));
  }
  charts.push_back(efficiency("fps_per_mm2", "Frames per second for each mm2", "frames/s/mm2", design_points,
                              &SiliconPoint::fps_per_mm2));
  if (energy)
    charts.push_back(efficiency("frames_per_joule", "Frames for each joule", "frames/J", design_points,
                                &SiliconPoint::frames_per_joule));
  return charts;
}

}  // namespace pipegs
