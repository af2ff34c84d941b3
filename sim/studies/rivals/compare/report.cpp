// SPDX-License-Identifier: Apache-2.0
// report.cpp: see report.hpp.
#include "sim/studies/rivals/compare/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/studies/rivals/compare/published.hpp"
#include "sim/silicon/published.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *kMachines = "  {:<16}{:<10}{:>5}{:>12}{:>9}{:>9}{:>8}{:>7}{:>22}{:>24}{:>22}  {}\n",
                     *kAgainst = "  {:<13}{:>9}{:>9}  {}\n", *kChecks = "  {:<12}{:<72}{:>10}{:>9}{:>7}  {:<5} {}\n",
                     *kParameters = "  {:<14}{:>8}{:>8}{:>8} {:<16}{} {:>9}{:>10}  {}\n";

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const double magnitude = std::floor(std::log10(std::abs(value)));
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - static_cast<int>(magnitude)));
}

std::string text_of(const Range& range) {
  if (range.low == range.high) return number(range.mid, 3);
  return fmt::format("{}..{}..{}", number(range.low, 3), number(range.mid, 3), number(range.high, 3));
}

std::string machines_text(const Comparison& comparison) {
  std::string text = "machines, this view, the same memory\n" +
                     fmt::format(kMachines, "", "node", "GHz", "cycles", "ms", "frames/s", "MB", "mm2", "frames/s/mm2",
                                 "frames/J, chip", "frames/J with DRAM", "bound by");
  for (const RivalResult& one : comparison.rivals) {
    const MachineFrame& frame = one.frame;
    text += fmt::format(kMachines, one.rival->name, one.rival->node.name, one.rival->ghz,
                        fmt::format("{:.0f}", frame.cycles), number(frame.seconds() * 1e3, 3), number(frame.fps(), 3),
                        number(frame.all_bytes() * 1e-6, 3), number(one.mm2.mid, 3), text_of(one.figures.fps_mm2),
                        text_of(one.figures.frames_j), text_of(one.figures.frames_j_dram),
                        fmt::format("{} {:.0f} %", frame.bound, 100 * frame.bound_share));
  }
  const PublishedRow& printed = kPipegsTable2.back();
  text += fmt::format(
      kMachines, "PipeGS, printed", "28 nm", 1, "-", "-", "-", "-", number(printed.area_mm2, 4), "-", "-", "-",
      fmt::format("{} W; frames only as ratios: {}x its GSCore at most", printed.power_w, kPipegsSpeed));
  for (const OwnMachine& own : comparison.ours) {
    text += fmt::format(kMachines, own.name, "28 nm", number(own.ghz, 2), fmt::format("{:.0f}", own.cycles),
                        number(1e3 / own.figures.fps.mid, 3), number(own.figures.fps.mid, 3),
                        number(own.bytes * 1e-6, 3), number(own.mm2.mid, 3), text_of(own.figures.fps_mm2),
                        text_of(own.figures.frames_j), text_of(own.figures.frames_j_dram), "");
  }
  for (const Variant& one : comparison.variants)
    text += fmt::format("  {}, {}: {} ms, {} MB, bound by {}\n", one.rival->name, one.what,
                        number(one.frame.seconds() * 1e3, 3), number(one.frame.all_bytes() * 1e-6, 3), one.frame.bound);
  return text + "  bound by: the unit or memory that bounds most cycles, and the share of the cycles that it bounds\n";
}

std::string against_text(const Comparison& comparison) {
  std::string text = fmt::format(
      "\nwhat the paper prints, published ratios multiplied, and this frame: over each rival\n"
      "  printed: frames/s/mm2 {:.2f} to {:.2f}, frames/J {:.2f} to {:.2f}, over GSCore, GS-TG, STREAMINGGS and GSAcc\n"
      "  chained: {:.2f} over what the rival prints over GSCore, plain scaling of area; 2.77 over its energy\n",
      kPrintedArea[0], kPrintedArea[1], kPrintedEnergy[0], kPrintedEnergy[1], kPipegsSpeed);
  std::string heads;
  for (const OwnMachine& own : comparison.ours)
    heads += fmt::format("{:<24}{:<24}{:<24}", own.name + ": frames/s/mm2", own.name + ": frames/J, chip",
                         own.name + ": with DRAM");
  text += fmt::format(kAgainst, "chained", "area", "energy", heads);
  for (const RivalResult& one : comparison.rivals) {
    const Chained chain = chained(*one.rival);
    std::string cells;
    for (const OwnMachine& own : comparison.ours) {
      for (const Range Figures::*figure : {&Figures::fps_mm2, &Figures::frames_j, &Figures::frames_j_dram})
        cells += fmt::format("{:<24}", text_of(ratio(own.figures.*figure, one.figures.*figure)));
    }
    text += fmt::format(kAgainst, one.rival->name, chain.area > 0 ? number(chain.area, 3) : "-",
                        chain.energy > 0 ? number(chain.energy, 3) : "-", cells);
  }
  return text;
}

std::string checks_text(const Comparison& comparison) {
  std::string text = "\neach model against figures that are published\n" +
                     fmt::format(kChecks, "", "figure", "published", "ours", "ratio", "15 %", "");
  for (const Check& check : comparison.checks)
    text += fmt::format(kChecks, check.rival, check.figure,
                        fmt::format("{}{} {}", check.at_most ? "<=" : "", number(check.published, 3), check.unit),
                        number(check.ours, 3), number(check.ratio(), 2),
                        check.chosen     ? "set"
                        : check.passes() ? "yes"
                                         : "no",
                        check.why);
  return text + fmt::format(
                    "  set: a parameter is from this figure\n  an efficiency of {:.2f} would close Lego; it is applied "
                    "to no frame\n",
                    comparison.lego_cycles / kLegoCycles);
}

std::string parameters_text(const Comparison& comparison) {
  std::string text =
      "\nparameters: H read in the paper or its simulator, M in notes about it, L assumed; frames/s at low, at high\n";
  for (const RivalResult& one : comparison.rivals) {
    text += fmt::format("  {}, {}: {} mm2 in {} ({}), plain square {} mm2\n", one.rival->name, one.rival->venue,
                        one.rival->mm2, one.rival->node.name, one.rival->node.source,
                        number(one.rival->mm2 * one.rival->node.plain(), 3));
    text += fmt::format(kParameters, "", "value", "low", "high", "", " ", "fps low", "fps high", "");
    for (const Parameter& parameter : one.rival->parameters) {
      const auto swing = std::find_if(one.swings.begin(), one.swings.end(),
                                      [&](const Swing& found) { return found.parameter == &parameter; });
      const bool swings = swing != one.swings.end();
      text += fmt::format(kParameters, parameter.name, parameter.value, swings ? fmt::format("{}", parameter.low) : "",
                          swings ? fmt::format("{}", parameter.high) : "", parameter.unit, letter(parameter.mark),
                          swings ? number(swing->fps_low, 3) : "", swings ? number(swing->fps_high, 3) : "",
                          parameter.source);
    }
  }
  return text;
}

Json json_of(const Figures& figures) {
  return {{"fps", to_json(figures.fps)},
          {"fps_per_mm2", to_json(figures.fps_mm2)},
          {"frames_per_joule", to_json(figures.frames_j)},
          {"frames_per_joule_with_dram", to_json(figures.frames_j_dram)}};
}

Json json_of(const MachineFrame& frame) {
  Json spans = Json::array();
  for (const StageSpan& span : frame.spans)
    spans.push_back({{"phase", span.phase},
                     {"unit", span.unit},
                     {"units", span.units},
                     {"begin", span.begin},
                     {"end", span.end},
                     {"busy", span.busy}});
  return {{"ghz", frame.ghz},
          {"cycles", frame.cycles},
          {"seconds", frame.seconds()},
          {"bytes", frame.all_bytes()},
          {"bytes_by_kind", frame.bytes},
          {"memory_cycles", frame.memory_cycles},
          {"bound_by", frame.bound},
          {"bound_share", frame.bound_share},
          {"chip_joules", frame.chip_joules},
          {"dram_joules", to_json(frame.dram_joules)},
          {"spans", spans}};
}

Json rival_json(const RivalResult& one) {
  Json json = json_of(one.frame);
  json["name"] = one.rival->name;
  json["venue"] = one.rival->venue;
  json["node"] = one.rival->node.name;
  json["mm2_published"] = one.rival->mm2;
  json["mm2"] = to_json(one.mm2);
  json["mm2_plain"] = one.rival->mm2 * one.rival->node.plain();
  json.update(json_of(one.figures));
  for (const Parameter& parameter : one.rival->parameters)
    json["parameters"][parameter.name] = {{"value", parameter.value},
                                          {"low", parameter.low},
                                          {"high", parameter.high},
                                          {"unit", parameter.unit},
                                          {"mark", std::string(1, letter(parameter.mark))},
                                          {"source", parameter.source}};
  for (const Swing& swing : one.swings) {
    Json& parameter = json["parameters"][swing.parameter->name];
    parameter["fps_at_low"] = swing.fps_low, parameter["fps_at_high"] = swing.fps_high;
    parameter["frames_per_joule_with_dram_at_low"] = swing.frames_j_low;
    parameter["frames_per_joule_with_dram_at_high"] = swing.frames_j_high;
  }
  return json;
}

Json against_json(const Comparison& comparison) {
  const auto known = [](double value) { return value > 0 ? Json(value) : Json(nullptr); };
  Json json;
  json["printed"] = {{"fps_per_mm2", kPrintedArea}, {"frames_per_joule", kPrintedEnergy}, {"speed", kPipegsSpeed}};
  for (const RivalResult& one : comparison.rivals) {
    const Chained chain = chained(*one.rival);
    Json& row = json["over"][one.rival->key];
    row["chained"] = {{"fps_per_mm2", known(chain.area)}, {"frames_per_joule", known(chain.energy)}};
    for (const OwnMachine& own : comparison.ours)
      row[own.name] = {
          {"fps_per_mm2", to_json(ratio(own.figures.fps_mm2, one.figures.fps_mm2))},
          {"frames_per_joule", to_json(ratio(own.figures.frames_j, one.figures.frames_j))},
          {"frames_per_joule_with_dram", to_json(ratio(own.figures.frames_j_dram, one.figures.frames_j_dram))}};
  }
  return json;
}

Chart chart_of(const Comparison& comparison, const std::string& name, const std::string& title, const std::string& unit,
               Range Figures::*figure) {
  Chart chart{.name = name, .title = title, .y_label = unit, .log_y = true};
  chart.series = {{"low", {}, true}, {"mid", {}}, {"high", {}, true}};
  const auto add = [&](const std::string& name, const Figures& figures) {
    const Range& range = figures.*figure;
    chart.categories.push_back(name);
    chart.series[0].values.push_back(range.low);
    chart.series[1].values.push_back(range.mid);
    chart.series[2].values.push_back(range.high);
  };
  for (const RivalResult& one : comparison.rivals) add(one.rival->name, one.figures);
  for (const OwnMachine& own : comparison.ours) add(own.name, own.figures);
  return chart;
}

}  // namespace

Comparison compare(const FrameCounts& counts, PlayedMemory& memory, std::vector<OwnMachine> ours) {
  Comparison comparison{.ours = std::move(ours)};
  for (const Rival* rival : all_rivals()) comparison.rivals.push_back(rival_result(*rival, counts, memory));
  comparison.variants.push_back(
      {&gsacc(), "tiles that are not in its cache in memory", frame_of(gsacc(), counts, memory, {{"spilled", 1}})});
  comparison.checks = checks_of(counts, memory);
  comparison.lego_cycles = lego_least_cycles(memory);
  return comparison;
}

Chained chained(const Rival& rival) {
  const auto claim =
      std::find_if(kClaims.begin(), kClaims.end(), [&](const PublishedClaim& one) { return one.key == rival.key; });
  if (claim == kClaims.end()) return {};
  const double area = rival.mm2 * rival.node.plain() / kPipegsTable2.back().area_mm2;
  return {claim->speed > 0 ? kPipegsSpeed / claim->speed * area : 0,
          claim->energy > 0 ? kPrintedEnergy[1] / claim->energy : 0};
}

Json comparison_json(const Comparison& comparison) {
  Json json;
  for (const RivalResult& one : comparison.rivals) json["rivals"][one.rival->key] = rival_json(one);
  for (const Variant& one : comparison.variants) {
    json["variants"].push_back({{"rival", one.rival->key}, {"what", one.what}});
    json["variants"].back().update(json_of(one.frame));
  }
  const PublishedRow& printed = kPipegsTable2.back();
  json["printed"] = {{"mm2", printed.area_mm2}, {"watts", printed.power_w}, {"speed_over_its_gscore", kPipegsSpeed}};
  for (const OwnMachine& own : comparison.ours) {
    Json& row = json["ours"][own.name];
    row = {{"ghz", own.ghz}, {"cycles", own.cycles}, {"bytes", own.bytes}, {"mm2", to_json(own.mm2)}};
    row.update(json_of(own.figures));
  }
  json["against"] = against_json(comparison);
  for (const Check& check : comparison.checks)
    json["checks"].push_back({{"rival", check.rival},
                              {"figure", check.figure},
                              {"unit", check.unit},
                              {"published", check.published},
                              {"at_most", check.at_most},
                              {"chosen", check.chosen},
                              {"ours", check.ours},
                              {"ratio", check.ratio()},
                              {"passes", check.passes()},
                              {"why", check.why}});
  json["lego"] = {{"published_cycles", kLegoCycles},
                  {"least_cycles", comparison.lego_cycles},
                  {"efficiency", comparison.lego_cycles / kLegoCycles}};
  return json;
}

std::string comparison_text(const Comparison& comparison) {
  return machines_text(comparison) + against_text(comparison) + checks_text(comparison) + parameters_text(comparison);
}

std::vector<Chart> comparison_charts(const Comparison& comparison) {
  return {chart_of(comparison, "fps_per_mm2", "Frames per second and area", "frames/s/mm2", &Figures::fps_mm2),
          chart_of(comparison, "frames_per_joule", "Frames for each joule of the chip", "frames/J", &Figures::frames_j),
          chart_of(comparison, "frames_per_joule_with_dram", "Frames for each joule of chip and DRAM", "frames/J",
                   &Figures::frames_j_dram)};
}

}  // namespace pipegs
