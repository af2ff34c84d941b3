// SPDX-License-Identifier: Apache-2.0
// request_check.cpp: see request_check.hpp.
#include "sim/compare/request_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/compare/simulate.hpp"

namespace pipegs {

RequestCheck::RequestCheck(const GoldenInput& input, const Areas& areas) {
  const Config& config = input.packed->config;
  const Tables& at = input.frame.tables;
  const auto part = [&](int unit, Area area) -> Span {
    return {at.overflow + area_first(config, areas.overflow, static_cast<uint64_t>(unit), area),
            area_lines(config, areas.overflow, area)};
  };
  const auto alphas = [&](int unit) -> std::vector<Span> {
    if (!has_alpha_areas(config)) return {};
    if (config.has_lists()) return {part(unit, Area::kEven)};
    return {part(unit, Area::kEven), part(unit, Area::kOdd)};
  };
  std::vector<Span> all_alphas;
  for (int unit = 0; unit < config.units; ++unit) {
    for (const Span& one : alphas(unit)) all_alphas.push_back(one);
  }
  const Span picture =
      input.picture.format != 0 ? Span{input.picture.base, areas.picture} : Span{at.pixels, areas.pixels};
  const std::vector<std::string> streams = memory_streams(config);
  for (int tag = 0; tag < config.memory_ports(); ++tag) {
    const std::string& stream = streams[memory_stream(config, tag)];
    Port port;
    if (stream == "alpha_overflow_write") port.writes = alphas(tag);
    if (stream == "sort_overflow") {
      const int unit = tag - config.units;
      port.reads = port.writes = {part(unit, Area::kKeys), part(unit, Area::kMerged), part(unit, Area::kRuns),
                                  part(unit, Area::kRecords)};
    }
    if (stream == "raster") {
      port.writes = {picture}, port.reads = all_alphas;  // of every PU
      for (const Aov aov : kAovs) {
        if (wants_aov(config, input.frame, aov))
          port.writes.push_back({aov_line(config, input.frame, aov), input.frame.raster.aovs.lines});
      }
    }
    if (stream == "lists") port.reads = port.writes = {part(0, Area::kLists)};
    if (stream == "geometry") port.reads = {{at.gaussians, areas.gaussians}};
    if (stream == "color") port.reads = {{at.colors, areas.colors}};
    if (stream == "nodes") port.reads = {{at.cells, areas.cells}, {at.groups, areas.groups}, {at.chunks, areas.chunks}};
    ports_.push_back(std::move(port));
  }
}

bool RequestCheck::allows(int tag, bool write, uint64_t line, int lines) const {
  const std::vector<Span>& spans = ports_[static_cast<size_t>(tag)].of(write);
  return std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
    return line >= span.first && line + static_cast<uint64_t>(lines) <= span.first + span.lines;
  });
}

std::string RequestCheck::allowed(int tag, bool write) const {
  std::vector<std::string> texts;
  for (const Span& span : ports_[static_cast<size_t>(tag)].of(write))
    texts.push_back(fmt::format("{} to {}", span.first, span.first + span.lines - 1));
  return texts.empty() ? fmt::format("no {}", write ? "write" : "read") : fmt::format("{}", fmt::join(texts, " or "));
}

}  // namespace pipegs
