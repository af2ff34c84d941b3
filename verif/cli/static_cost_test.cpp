// SPDX-License-Identifier: Apache-2.0
// static_cost_test: the memories of a design point, against the SRAMs of the RTL as Yosys elaborates it.
#include "sim/design/static_cost.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/design/design_point.hpp"
#include "sim/silicon/area/machine_kind.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

// "$paramod$hash\name" or "$paramod\name\Width=..." -> "name"
std::string plain(std::string name) {
  if (name.starts_with("$paramod")) name = name.substr(name.find('\\') + 1);
  if (name.starts_with("\\")) name = name.substr(1);
  return name.substr(0, name.find('\\'));
}

// The bits of all SRAMs below a module that have so many ports.
uint64_t sram_bits(const Json& modules, const std::string& name, int ports) {
  const Json& module = modules[name];
  if (plain(name) == "pipegs_sram") {
    if (std::stoi(module["parameter_default_values"]["Ports"].get<std::string>(), nullptr, 2) != ports) return 0;
    uint64_t words = 0;
    for (const auto& [cell, body] : module["memories"].items()) words += body["size"].get<uint64_t>();
    return words * module["ports"]["wdata_i"]["bits"].size();
  }
  uint64_t bits = 0;
  for (const auto& [cell, body] : module["cells"].items()) {
    const std::string type = body["type"];
    if (modules.contains(type)) bits += sram_bits(modules, type, ports);
  }
  return bits;
}

// As synth/elaborate.py keeps it.
std::array<uint64_t, 2> elaborated_bits(const std::string& settings) {
  FILE* pipe = popen((PIPEGS_SOURCE_DIR "/synth/elaborate.py '" PIPEGS_BUILD_DIR "' " + settings).c_str(), "r");
  std::string folder;
  for (int c; (c = fgetc(pipe)) != EOF;) folder += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << "Yosys fails, as it says above";
  if (folder.empty()) return {};
  folder.pop_back();  // the end of the line
  std::ifstream text(folder + "/merged.json");
  const Json modules = Json::parse(text)["modules"];
  for (const auto& [name, module] : modules.items()) {
    if (plain(name) == "pipegs_top") return {sram_bits(modules, name, 1), sram_bits(modules, name, 2)};
  }
  return {};
}

void expect_as_built(std::string settings) {
  SCOPED_TRACE(settings);
  std::array<uint64_t, 2> bits{};  // of one port, of two
  for (const BufferCost& row : static_cost(config_of(settings)).buffers) bits.at(row.ports - 1) += row.bits();
  if (settings == "default") settings.clear();
  std::replace(settings.begin(), settings.end(), ',', ' ');
  EXPECT_EQ(bits, elaborated_bits(settings));
}

// With the second cull, and with living quads, in windows of one part; synth/lint.sh leaves both to this test.
TEST(StaticCost, OtherCountsAndWidthsAreAsBuilt) {
  expect_as_built(
      "units=2,pixels_per_row=1,grid=8,window=32,tight_cull=1,alpha_w=10,records=64,alpha_lines=256,fetch_lines=16");
  expect_as_built("units=2,late=1,order=2,quads=1,tests=2,pixel_w=32");
}

TEST(StaticCostLong, OneUnitIsAsBuilt) {
  expect_as_built("units=1,pixels_per_row=1,grid=1,late=1,quadratic=1,records=512");
  expect_as_built("units=2,late=1,order=2,quads=1,window=128,tests=2,pixel_w=32,tight_cull=1");
}

// The paper's, with alphas and layers, and the default, with coefficients and watermarks.
const std::set<std::string_view> kUnlike = {"dop", kDefaultDesignPoint};

TEST(StaticCost, TheTwoMostUnlikeDesignPointsAreAsBuilt) {
  for (const std::string_view name : kUnlike)
    expect_as_built(config_difference(find_design_point(std::string(name)).config));
}

TEST(StaticCostLong, FewNodesWaitAsBuilt) { expect_as_built("units=1,late=1,order=2,nearest_nodes=128,records=64"); }

TEST(StaticCostLong, AllOtherDesignPointsAreAsBuilt) {
  for (const DesignPoint& design_point : design_points()) {
    if (!kUnlike.contains(design_point.name)) expect_as_built(config_difference(design_point.config));
  }
}

}  // namespace
}  // namespace pipegs
