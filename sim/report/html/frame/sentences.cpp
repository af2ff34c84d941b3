// SPDX-License-Identifier: Apache-2.0
// sentences.cpp: frame_sentences of frame_page.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/report/html/frame/frame_page.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kWorth = 0.03;  // a share below this is not worth a word

struct UnitWords {
  const char *key, *name, *task, *input, *output;
};
constexpr std::array<UnitWords, 4> kUnits = {{
    {"dopu", "DOPU", "walks the tree of chunks and hands chunks to the PUs", "the next window", "the PUs"},
    {"pu", "PU", "projects Gaussians and computes their colour, and their alphas or coefficients", "Gaussians",
     "SU or RU"},
    {"su", "SU", "sorts the records of a window by depth", "records of the PUs", "the RUs"},
    {"ru", "RU", "blends Gaussians into pixels", "sorted records", "memory that takes the pixels"},
}};

// 1234567 as 1 234 567.
std::string grouped(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (auto at = static_cast<ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<size_t>(at), "\u202f");
  return digits;
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

// Mean share of each state over the units of a kind: busy, starved, blocked, memory.
std::array<double, 4> shares(const Json& units, double cycles) {
  std::array<double, 4> sum{};
  for (const Json& unit : units) {
    size_t state = 0;
    for (const char* key : {"busy", "starved", "blocked", "memory"}) sum[state++] += unit[key].get<double>();
  }
  for (double& share : sum) share /= cycles * static_cast<double>(units.size());
  return sum;
}

std::string unit_sentence(const UnitWords& kind, const Json& units, double cycles) {
  const std::array<double, 4> share = shares(units, cycles);
  const bool several = units.size() > 1;
  const std::string who =
      several ? fmt::format("The {} {}s work", units.size(), kind.name) : fmt::format("The {} works", kind.name);
  std::string text =
      fmt::format("{} in {} of the cycles: {} {}.", who, percent(share[0]), several ? "each" : "it", kind.task);
  std::vector<std::string> waits;
  if (share[1] >= kWorth) waits.push_back(fmt::format("{} for {}", percent(share[1]), kind.input));
  if (share[2] >= kWorth) waits.push_back(fmt::format("{} until {} can take more", percent(share[2]), kind.output));
  if (share[3] >= kWorth) waits.push_back(fmt::format("{} for answers of external memory", percent(share[3])));
  if (waits.empty()) return text + " It hardly waits.";
  text += several ? " They wait " : " It waits ";
  for (size_t i = 0; i < waits.size(); ++i) {
    if (i > 0) text += i + 1 == waits.size() ? " and " : ", ";
    text += waits[i];
  }
  return text + ".";
}

// Which kind of unit works most.
std::string busiest(const Json& report, double cycles) {
  double most = -1;
  std::string name;
  for (const UnitWords& kind : kUnits) {
    const double share = shares(report["units"][kind.key], cycles)[0];
    if (share > most) most = share, name = kind.name;
  }
  return fmt::format("The units that work most are the {}s, {} of the cycles", name, percent(most));
}

std::string frame_sentence(const Json& report) {
  const auto cycles = report["cycles"].get<double>();
  const Json& bounds = report["bounds"];
  if (bounds["largest"].is_null()) return "Nothing of the scene is in this view: there is no work that could bound it.";
  const auto ratio = bounds["cycles_over_largest"].get<double>();
  const auto name = bounds["largest"].get<std::string>();
  const std::string what = name == "memory"      ? "external memory at its peak bandwidth"
                           : name == "bus"       ? "the bus to memory, a beat in a cycle"
                           : name == "Row Units" ? "the Row Units, which compute alphas"
                           : name == "RU"        ? "blending in the RUs"
                           : name == "SU"        ? "the records that the SUs take"
                                                 : "the cull of Gaussians in the PUs";
  const double share = 1 / ratio;
  std::string text = fmt::format(
      "The work of this frame needs at least {} cycles of {}: {} of the {} cycles "
      "that it took.",
      grouped(cycles * share), what, percent(share), grouped(cycles));
  if (share >= 0.85)
    return text + fmt::format(
                      " That bounds the frame: only less of this work, or more units for it, "
                      "makes it faster.");
  return text + fmt::format(
                    " The rest is time in which no unit could work at its full rate: one waits for another. {}; "
                    "the bars below show what they wait for.",
                    busiest(report, cycles));
}

}  // namespace

Json frame_sentences(const Json& report) {
  if (!report["ran"]["rtl"].get<bool>())
    return {{"frame", "The RTL was not run (--no-rtl), so there are no cycles to tell of."}, {"units", Json::object()}};
  Json units = Json::object();
  for (const UnitWords& kind : kUnits)
    units[kind.key] = unit_sentence(kind, report["units"][kind.key], report["cycles"].get<double>());
  return {{"frame", frame_sentence(report)}, {"units", units}};
}

}  // namespace pipegs
