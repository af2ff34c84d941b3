// SPDX-License-Identifier: Apache-2.0
// merge.cpp: see merge.hpp.
#include "sim/command/campaign/merge.hpp"

#include <fmt/format.h>

#include <array>

#include "scenes/text/csv.hpp"
#include "scenes/text/json.hpp"
#include "sim/command/campaign/join.hpp"
#include "sim/command/outputs.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;
using Pointer = Json::json_pointer;

constexpr std::array kCosts = {"read_seconds", "pack_seconds", "golden_seconds",
                               "cpu_seconds",  "wall_seconds", "peak_memory_bytes"};

constexpr const char* kNames = "scene,view,camera,configuration,design,window_x,window_y,windows";

std::string names_of(const PointResult& result) {
  const PointArguments& point = result.point.arguments;
  const std::string window = point.view.window.empty()
                                 ? ",,"
                                 : fmt::format("{},{},{}", point.view.window[0], point.view.window[1], point.windows);
  return fmt::format("{},{},{},{},{},{}", result.point.scene, point.view.view, csv_field(result.camera),
                     result.point.configuration, point.view.design_point, window);
}

std::string results_csv(const std::vector<PointResult>& points) {
  std::string text = kNames;
  for (const FigureColumn& column : point_figures()) text += fmt::format(",{}", column.name);
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    text += "\n" + names_of(one);
    for (const FigureColumn& column : point_figures()) text += "," + figure_text((*one.kept)["result"], column.place);
  }
  return text + "\n";
}

std::string costs_csv(const std::vector<PointResult>& points) {
  std::string text = kNames;
  for (const char* name : kCosts) text += fmt::format(",{}", name);
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    text += "\n" + names_of(one);
    for (const char* name : kCosts) text += "," + figure_text((*one.kept)["cost"], std::string("/") + name);
  }
  return text + "\n";
}

Json results_json(const std::vector<PointResult>& points) {
  Json list = Json::array();
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const PointArguments& point = one.point.arguments;
    Json json = {{"scene", one.point.scene},
                 {"view", point.view.view},
                 {"camera", one.camera},
                 {"configuration", one.point.configuration},
                 {"design", point.view.design_point},
                 {"set", point.view.settings},
                 {"engine", point.engine},
                 {"key", one.file.stem().string()}};
    if (!point.view.window.empty()) json["window"] = {point.view.window[0], point.view.window[1], point.windows};
    json["result"] = (*one.kept)["result"];
    list.push_back(std::move(json));
  }
  return {{"points", points.size()}, {"results", std::move(list)}};
}

}  // namespace

const std::vector<FigureColumn>& point_figures() {
  static const std::vector<FigureColumn> kFigures = {{"cycles", "/cycles"},
                                                     {"bytes_read", "/memory/bytes_read"},
                                                     {"bytes_written", "/memory/bytes_written"},
                                                     {"overflow_lines", "/work/overflow_lines"},
                                                     {"fetched", "/work/fetched"},
                                                     {"blended", "/work/blended"},
                                                     {"psnr_numeric_db", "/psnr_numeric_db"},
                                                     {"psnr_order_db", "/psnr_order_db"},
                                                     {"psnr_total_db", "/psnr_total_db"},
                                                     {"beats_compared", "/beats_compared"},
                                                     {"mismatches", "/mismatches"}};
  return kFigures;
}

std::string figure_text(const Json& json, const std::string& place) {
  const Pointer pointer(place);
  // Where the RTL did not run its whole branch is null.
  for (Pointer above = pointer; !above.empty(); above = above.parent_pointer()) {
    if (!json.contains(above) || json[above].is_null()) return "";
  }
  return json_text(json[pointer]);
}

std::string cost_text(const std::vector<PointResult>& points) {
  size_t count = 0;
  double seconds = 0, again = 0;
  for (const PointResult& one : points) {
    if (!one.kept) continue;
    const Json& cost = (*one.kept)["cost"];
    ++count;
    seconds += cost["cpu_seconds"].get<double>();
    again += cost["read_seconds"].get<double>() + cost["pack_seconds"].get<double>();
  }
  if (count == 0 || seconds <= 0) return "Nothing measured yet.";
  return fmt::format(
      "They took {:.1f} s of one core, {:.1f} % of it reading and packing scenes: {:.0f} points an hour and core.",
      seconds, 100 * again / seconds, 3600 * static_cast<double>(count) / seconds);
}

void write_merged(const std::filesystem::path& out, const std::vector<PointResult>& points) {
  join_windows(out / "frames", points);
  write_text(out / "results.csv", results_csv(points));
  write_text(out / "results.json", json_text(results_json(points), 1) + "\n");
  write_text(out / "costs.csv", costs_csv(points));
}

}  // namespace pipegs
