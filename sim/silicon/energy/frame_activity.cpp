// SPDX-License-Identifier: Apache-2.0
// frame_activity.cpp: see frame_activity.hpp.
#include "sim/silicon/energy/frame_activity.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <regex>
#include <string_view>
#include <utility>

#include "scenes/text/json.hpp"
#include "sim/rtl/rtl_fault.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<std::string_view, const char*>, 6> kUnits = {
    {{"u_dopu", "dopu"}, {"u_pu", "pu"}, {"u_su", "su"}, {"u_ru", "ru"}, {"u_lists", "list"}, {"u_store", "buf"}}};

Json to_json(const Activity& activity) {
  Json json = {{"cycles", activity.cycles}};
  for (const char* key : {"groups", "clocks", "srams", "enabled", "unseen"}) json[key] = Json::object();
  for (const auto& [name, group] : activity.groups) json["groups"][name] = {group.bits, group.toggles};
  for (const auto& [name, edges] : activity.clocks) json["clocks"][name] = edges;
  for (const auto& [name, sram] : activity.srams) json["srams"][name] = {sram.width, sram.reads, sram.writes};
  for (const auto& [unit, modules] : activity.enabled) {
    for (const auto& [name, one] : modules) json["enabled"][unit][name] = {one.edges, one.passed};
  }
  for (const auto& [unit, flipflops] : activity.unseen) json["unseen"][unit] = flipflops;
  return json;
}

Activity activity_from_json(const Json& json) {
  Activity activity;
  const auto count = [](const Json& value) { return json_integer<uint64_t>(value); };
  activity.cycles = count(json.at("cycles"));
  for (const auto& [name, group] : json.at("groups").items())
    activity.groups[name] = {count(group.at(0)), count(group.at(1))};
  for (const auto& [name, edges] : json.at("clocks").items()) activity.clocks[name] = count(edges);
  for (const auto& [name, sram] : json.at("srams").items())
    activity.srams[name] = {json_integer(sram.at(0), 1), count(sram.at(1)), count(sram.at(2))};
  for (const auto& [unit, modules] : json.at("enabled").items()) {
    for (const auto& [name, one] : modules.items()) {
      Enabled& enabled = activity.enabled[unit][name];
      enabled.edges = count(one.at(0));
      for (const Json& passed : one.at(1)) enabled.passed.push_back(count(passed));
    }
  }
  for (const auto& [unit, flipflops] : json.at("unseen").items()) activity.unseen[unit] = count(flipflops);
  return activity;
}

}  // namespace

Activity FrameActivity::sum() const {
  Activity sum = halves[0];
  sum.add(halves[1]);
  return sum;
}

Json to_json(const FrameActivity& activity) {
  return {{"cycles", activity.cycles},
          {"bytes", activity.bytes},
          {"halves", {to_json(activity.halves[0]), to_json(activity.halves[1])}}};
}

FrameActivity frame_activity_from_json(const Json& json) {
  const Json& halves = json.at("halves");
  return {json_integer<uint64_t>(json.at("cycles"), 1),
          json_integer<uint64_t>(json.at("bytes")),
          {activity_from_json(halves.at(0)), activity_from_json(halves.at(1))}};
}

std::string unit_of(const std::string& scope) {
  for (size_t at = 0; at < scope.size();) {
    const size_t end = std::min(scope.find('.', at), scope.size());
    std::string_view part = std::string_view(scope).substr(at, end - at);
    if (part.ends_with("_gate")) part.remove_suffix(5);
    for (const auto& [name, unit] : kUnits) {
      if (part == name) return unit;
    }
    at = end + 1;
  }
  return "top";
}

Activity by_unit(const Activity& activity) {
  static const std::regex kNumber("\\[[0-9]+\\]");
  Activity result;
  result.cycles = activity.cycles;
  result.groups = activity.groups;
  result.enabled = activity.enabled;
  result.unseen = activity.unseen;
  for (const auto& [name, edges] : activity.clocks) result.clocks[unit_of(name)] += edges;
  for (const auto& [name, sram] : activity.srams) {
    const std::string inside = name.substr(name.find('.') + 1);
    SramAccesses& sum = result.srams[std::regex_replace(inside, kNumber, "[k]")];
    sum = {sram.width, sum.reads + sram.reads, sum.writes + sram.writes};
  }
  return result;
}

FrameActivity measure_activity(const Scene& scene, const Camera& camera, SimulateOptions options,
                               const Enables& enables, uint64_t cycles, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path waves = folder / fmt::format("waves.{}.fst", getpid());
  const auto remove = [](const std::filesystem::path* path) {
    std::error_code error;
    for (const char* end : {"", ".hier"}) std::filesystem::remove(path->string() + end, error);
  };
  const std::unique_ptr<const std::filesystem::path, decltype(remove)> removed(&waves, remove);
  options.rtl.waves = waves;
  options.rtl.sample_cycles = kSampleCycles;
  options.rtl.sample_period = std::max(kSampleCycles, cycles / kSamples);

  Simulation simulation;
  simulate_golden(scene, camera, options, simulation);
  simulate_rtl(options, simulation);
  if (simulation.mismatches != 0)
    throw RtlFault("the RTL differs from the golden model: " + simulation.first_mismatch->what);
  FrameActivity result;
  result.cycles = simulation.rtl.cycles;
  for (const MemoryTraffic& traffic : simulation.traffic) result.bytes += traffic.bytes_read + traffic.bytes_written;
  size_t number = 0;
  read_samples(waves, unit_of, enables, [&](const Activity& sample) { result.halves[number++ % 2].add(sample); });
  for (Activity& half : result.halves) half = by_unit(half);
  return result;
}

}  // namespace pipegs
