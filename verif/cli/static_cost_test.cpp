// SPDX-License-Identifier: Apache-2.0
// static_cost_test: what a design point is built of, against the RTL as Yosys elaborates it: every multiplier, adder
// and SRAM.
#include "sim/design/static_cost.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/design/design_point.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

constexpr size_t kAdderWidth = 14;  // narrower sums and indices are not counted, see static_cost.hpp

// Products of addresses and of numbers of windows, which are not counted: how many in one module.
int address_products(const std::string& module) {
  static const std::set<std::string> kModules = {"ru_window",     "ru_offset",        "pipegs_scheduler",
                                                 "pipegs_errors", "pipegs_list_read", "pipegs_list_write",
                                                 "pu_expand"};
  return kModules.contains(module) ? 1 : 0;
}

struct Found {
  int instances = 0, multipliers = 0, adders = 0, constant_adders = 0;
};

struct Elaborated {
  std::map<std::string, Found> modules;
  uint64_t sram_bits = 0;
};

// Nonzero digits of the non-adjacent form, less one, counted another way: a digit is where 3n and n differ.
int shifts_and_adders(uint64_t n) {
  const int digits = __builtin_popcountll((n ^ 3 * n) >> 1);
  return digits > 0 ? digits - 1 : 0;
}

// "$paramod$hash\name" or "$paramod\name\Width=..." -> "name"
std::string plain(std::string name) {
  if (name.starts_with("$paramod")) name = name.substr(name.find('\\') + 1);
  if (name.starts_with("\\")) name = name.substr(1);
  return name.substr(0, name.find('\\'));
}

size_t variable_bits(const Json& bits) {
  std::set<int> variables;
  for (const Json& bit : bits) {
    if (bit.is_number()) variables.insert(bit.get<int>());
  }
  return variables.size();
}

uint64_t constant_value(const Json& bits) {
  uint64_t value = 0;
  for (size_t i = 0; i < bits.size() && i < 64; ++i) value |= uint64_t{bits[i] == "1"} << i;
  return value;
}

class Netlist {
 public:
  explicit Netlist(const Json& design) : modules_(design["modules"]) {
    for (const auto& [name, module] : modules_.items()) {
      if (plain(name) == "pipegs_top") add(name, 1);
    }
  }
  Elaborated result;

 private:
  void add(const std::string& name, int times) {
    const Json& module = modules_[name];
    Found& found = result.modules[plain(name)];
    found.instances += times;
    if (plain(name) == "pipegs_sram") {
      uint64_t words = 0;
      for (const auto& [cell, body] : module["memories"].items()) words += body["size"].get<uint64_t>();
      result.sram_bits += uint64_t(times) * words * module["ports"]["wdata_i"]["bits"].size();
    }
    for (const auto& [cell, body] : module["cells"].items()) {
      const std::string type = body["type"];
      if (modules_.contains(type)) {
        add(type, times);
        continue;
      }
      if (type != "$mul" && type != "$add" && type != "$sub") continue;
      const Json &a = body["connections"]["A"], &b = body["connections"]["B"];
      const size_t wide_a = variable_bits(a), wide_b = variable_bits(b);
      Found& place = result.modules[plain(name)];
      if (type != "$mul") {
        place.adders += std::min(wide_a, wide_b) >= kAdderWidth ? times : 0;
      } else if (wide_a > 0 && wide_b > 0) {
        place.multipliers += times;
      } else if (std::max(wide_a, wide_b) >= kAdderWidth) {
        place.constant_adders += times * shifts_and_adders(constant_value(wide_a == 0 ? a : b));
      }
    }
  }
  const Json modules_;
};

// As synth/elaborate.py keeps it.
Elaborated elaborate(const std::string& settings) {
  FILE* pipe = popen((PIPEGS_SOURCE_DIR "/synth/elaborate.py '" PIPEGS_BUILD_DIR "' " + settings).c_str(), "r");
  std::string folder;
  for (int c; (c = fgetc(pipe)) != EOF;) folder += static_cast<char>(c);
  EXPECT_EQ(pclose(pipe), 0) << "Yosys fails, as it says above";
  if (folder.empty()) return {};
  folder.pop_back();  // the end of the line
  std::ifstream text(folder + "/merged.json");
  return Netlist(Json::parse(text)).result;
}

void expect_as_built(const std::string& settings) {
  SCOPED_TRACE(settings);
  Config config;
  for (size_t at = 0; at < settings.size();) {
    const size_t space = std::min(settings.find(' ', at), settings.size());
    config_set(config, settings.substr(at, space - at));
    at = space + 1;
  }
  const Elaborated built = elaborate(settings);
  const StaticCost cost = static_cost(config);
  std::map<std::string, Found> claimed;
  for (const ArithmeticCost& row : cost.arithmetic) {
    Found& sum = claimed[row.module];
    sum.instances += row.instances, sum.multipliers += row.multipliers, sum.adders += row.adders,
        sum.constant_adders += row.constant_adders;
  }
  // rsqrt and recip may serve more than one kind: sums by module.
  for (const auto& [module, sum] : claimed) {
    SCOPED_TRACE(module);
    const auto found = built.modules.find(module);
    ASSERT_NE(found, built.modules.end()) << "no such module is built";
    EXPECT_EQ(sum.instances, found->second.instances);
    EXPECT_EQ(sum.multipliers, found->second.multipliers - found->second.instances * address_products(module));
    EXPECT_EQ(sum.adders, found->second.adders);
    EXPECT_EQ(sum.constant_adders, found->second.constant_adders);
  }
  // Nothing else multiplies.
  for (const auto& [module, found] : built.modules) {
    if (!claimed.contains(module))
      EXPECT_EQ(found.multipliers, found.instances * address_products(module)) << module << " is not in the table";
  }
  uint64_t bits = 0;
  for (const BufferCost& row : cost.buffers) bits += row.bits();
  EXPECT_EQ(bits, built.sram_bits);
}

// With the second cull, and with living quads, in windows of one part; synth/lint.sh leaves both to this test.
TEST(StaticCost, OtherCountsAndWidthsAreAsBuilt) {
  expect_as_built(
      "units=2 pixels_per_row=1 grid=8 window=32 tight_cull=1 alpha_w=10 records=64 alpha_lines=256 fetch_lines=16");
  expect_as_built("units=2 late=1 order=2 quads=1 tests=2 pixel_w=32");
}

TEST(StaticCostLong, OneUnitIsAsBuilt) {
  expect_as_built("units=1 pixels_per_row=1 grid=1 late=1 quadratic=1 records=512");
  expect_as_built("units=2 late=1 order=2 quads=1 window=128 tests=2 pixel_w=32 tight_cull=1");
}

// What static_cost says of the design points of the ladder: each as it stands.
void expect_point_as_built(const DesignPoint& design_point) {
  std::string settings = config_difference(design_point.config);
  if (settings == "default") settings.clear();
  for (char& c : settings) c = c == ',' ? ' ' : c;
  expect_as_built(settings);
}

// The paper's, with alphas and layers, and the default, with coefficients and watermarks.
const std::set<std::string_view> kUnlike = {"dop", kDefaultDesignPoint};

TEST(StaticCost, TheTwoMostUnlikeDesignPointsAreAsBuilt) {
  for (const std::string_view name : kUnlike) expect_point_as_built(find_design_point(std::string(name)));
}

TEST(StaticCostLong, FewNodesWaitAsBuilt) { expect_as_built("units=1 late=1 order=2 nearest_nodes=128 records=64"); }

TEST(StaticCostLong, AllOtherDesignPointsAreAsBuilt) {
  for (const DesignPoint& design_point : design_points()) {
    if (!kUnlike.contains(design_point.name)) expect_point_as_built(design_point);
  }
}

TEST(StaticCost, ConstantProducts) {
  for (const auto& [constant, adders] :
       {std::pair{0, 0}, {1, 0}, {8, 0}, {3, 1}, {7, 1}, {14, 1}, {49, 2}, {361, 4}, {25, 2}, {15, 1}}) {
    EXPECT_EQ(constant_product_adders(constant), adders) << constant;
    EXPECT_EQ(constant_product_adders(constant), shifts_and_adders(static_cast<uint64_t>(constant))) << constant;
  }
}

}  // namespace
}  // namespace pipegs
