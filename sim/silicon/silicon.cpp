// silicon.cpp: see silicon.hpp.
#include "sim/silicon/silicon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "scenes/input_error.hpp"
#include "sim/static_cost.hpp"

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
    for (const BufferCost& buffer : static_cost(config).buffers) sum += law.memory(kind, buffer.width, buffer.depth).*figure * buffer.count;
    by_kind.push_back(sum);
  }
  return range_of(by_kind);
}

Synth read_synth(const std::filesystem::path& path, const Config& config) {
  std::ifstream file(path);
  if (!file) throw InputError(path.string(), "", "not found: `make synth` writes it");
  const nlohmann::json json = nlohmann::json::parse(file, nullptr, false);
  try {
    Synth synth = {json.at("configuration"), json.at("library"), json.at("fo4_ps"), json.at("nand2_ff"), json.at("volts"), {}, {}};
    if (synth.configuration != config_difference(config)) {
      throw InputError(path.string(), "configuration", fmt::format("found {}, expected {}", quote(synth.configuration), config_difference(config)));
    }
    for (const nlohmann::json& unit : json.at("units")) {
      synth.units.push_back({unit.at("unit"), unit.at("instances"), unit.at("nand2"), unit.at("flipflops"), unit.at("path_ps"),
                             unit.at("path_from"), unit.at("path_to"), unit.at("clock_j"), unit.at("switch_j")});
    }
    for (const nlohmann::json& memory : json.at("memories")) {
      static const std::regex kUnnamed("genblk[0-9]+\\.");  // blocks that Yosys names, and waves do not
      synth.memories.push_back({std::regex_replace(memory.at("instance").get<std::string>(), kUnnamed, ""), memory.at("words"), memory.at("width")});
    }
    for (const auto& [name, value] : {std::pair{"fo4_ps", synth.fo4_ps}, {"nand2_ff", synth.nand2_ff}, {"volts", synth.volts}}) {
      if (!(value > 0)) throw InputError(path.string(), name, "expected a positive number");
    }
    return synth;
  } catch (const nlohmann::json::exception& error) {
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
  SiliconRow total = row_of("Total", "top"), other = {.name = "Other", .kilo_nand2 = total.kilo_nand2};  // the top holds all
  total.count = 0;
  for (const SiliconRow& row : rows) other.kilo_nand2 -= row.kilo_nand2;
  rows.push_back(other);
  for (SiliconRow& row : rows) row.area_mm2 = kNand2Um2 * (row.kilo_nand2 / 1000);
  rows.push_back({.name = "Buffers", .kb = static_cost(config).buffer_kb(""), .area_mm2 = sram_sum(config, law, &SramFigures::area_mm2)});
  for (const SiliconRow& row : rows) total.area_mm2 = total.area_mm2 + row.area_mm2;
  total.kb = rows.back().kb;
  rows.push_back(total);
  return rows;
}

}  // namespace pipegs
