// SPDX-License-Identifier: Apache-2.0
// silicon.cpp: see silicon.hpp.
#include "sim/silicon/silicon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"
#include "sim/design/static_cost.hpp"

namespace pipegs {

Range range_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return {values.front(), (values[(n - 1) / 2] + values[n / 2]) / 2, values.back()};
}

Range sram_sum(const Config& config, const SramLaw& law, double SramFigures::*figure) {
  std::vector<double> by_kind;
  for (const std::string& kind : law.kinds()) {
    double sum = 0;
    for (const BufferCost& buffer : static_cost(config).buffers)
      sum += law.memory(kind, buffer.width, buffer.depth, buffer.ports).*figure * buffer.count;
    by_kind.push_back(sum);
  }
  return range_of(by_kind);
}

Synth read_synth(const std::filesystem::path& path, const Config& config) {
  using Json = nlohmann::json;
  if (!std::filesystem::exists(path)) throw InputError(path.string(), "", "not found: `make synth` writes it");
  const Json json = read_json<Json>(path, "what `make synth` writes");
  const auto real = [&](const Json& in, const char* key, const RealRange& range) {
    try {
      return json_real(in.at(key), range);
    } catch (const NumberError& error) { throw InputError(path.string(), key, error.what()); }
  };
  const auto count = [&](const Json& in, const char* key) {
    try {
      return json_integer(in.at(key), 1);
    } catch (const NumberError& error) { throw InputError(path.string(), key, error.what()); }
  };
  try {
    Synth synth;
    synth.configuration = json.at("configuration");
    synth.library = json.at("library");
    if (synth.configuration != config_difference(config)) {
      throw InputError(path.string(), "configuration",
                       fmt::format("found {}, expected {}", quote(synth.configuration), config_difference(config)));
    }
    synth.fo4_ps = real(json, "fo4_ps", kPositive);
    synth.nand2_ff = real(json, "nand2_ff", kPositive);
    synth.volts = real(json, "volts", kPositive);
    for (const Json& unit : json.at("units")) {
      synth.units.push_back({unit.at("unit"), count(unit, "instances"), real(unit, "nand2", kNotNegative),
                             real(unit, "flipflops", kNotNegative), real(unit, "path_ps", kNotNegative),
                             unit.at("path_from"), unit.at("path_to"), real(unit, "switch_j", kNotNegative)});
    }
    for (const Json& memory : json.at("memories")) {
      static const std::regex kUnnamed("genblk[0-9]+\\.");  // blocks that Yosys names, and waves do not
      synth.memories.push_back({std::regex_replace(memory.at("instance").get<std::string>(), kUnnamed, ""),
                                count(memory, "words"), count(memory, "width"), memory.at("ports") == "1RW" ? 1 : 2});
    }
    return synth;
  } catch (const Json::exception& error) {
    throw InputError(path.string(), "", fmt::format("expected what `make synth` writes: {}", quote(error.what())));
  }
}

std::vector<SiliconRow> silicon_rows(const Config& config, const Synth& synth, const SramLaw& law) {
  const auto row_of = [&](const char* name, const char* unit_name) {
    SiliconRow row = {.name = name};
    for (const SynthUnit& unit : synth.units) {
      if (unit.unit != unit_name) continue;
      row.count = unit.instances;
      row.kilo_nand2 = unit.nand2 * unit.instances / 1000;
      row.path_ps = kFo4Ps * (unit.path_ps / synth.fo4_ps);
    }
    return row;
  };
  std::vector<SiliconRow> rows = {row_of("DOPU", "dopu"), row_of("PU", "pu"), row_of("SU", "su"), row_of("RU", "ru")};
  SiliconRow total = row_of("Total", "top"),
             other = {.name = "Other", .kilo_nand2 = total.kilo_nand2};  // the top holds all
  total.count = 0;
  for (const SiliconRow& row : rows) other.kilo_nand2 -= row.kilo_nand2;
  rows.push_back(other);
  for (SiliconRow& row : rows) row.area_mm2 = kNand2Um2 * (row.kilo_nand2 / 1000);
  rows.push_back({.name = "Buffers",
                  .kb = static_cost(config).buffer_kb(),
                  .area_mm2 = sram_sum(config, law, &SramFigures::area_mm2)});
  for (const SiliconRow& row : rows) total.area_mm2 = total.area_mm2 + row.area_mm2;
  total.kb = rows.back().kb;
  rows.push_back(total);
  return rows;
}

}  // namespace pipegs
