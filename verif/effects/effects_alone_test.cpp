// SPDX-License-Identifier: Apache-2.0
// effects_alone_test: each part of the machine left out alone, on each design point of other hardware, in RTL with its
// assertions. Long.
//
// A view that does not call for the part gets the pixels of the whole machine. One that does gets those of the golden
// model without it, or an assertion of the RTL speaks: never a wrong bit without a word. The RTL of each machine is
// built on demand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "sim/design/design_point.hpp"
#include "verif/effects/effect_views.hpp"

namespace pipegs {
namespace {

struct Part {
  const char* entry;   // of the configuration
  const char* effect;  // whose detector sees what calls for it
  int Config::*flag;
  const char* drawn;   // a view that calls for it and is drawn without, in other pixels; "" when there is none
  const char* spoken;  // a view that calls for it and where an assertion speaks,
  std::vector<const char*> speakers;  // of one of these modules
};
void PrintTo(const Part& part, std::ostream* out) { *out << part.entry; }

// `antialias` alone is a part that the default machine does not have: it is switched on. Any view is without it, and
// without taps.
const Part kParts[] = {
    {"near_test", "near", &Config::near_test, "near", "behind", {"pu_cull"}},
    {"guard_band", "guard_band", &Config::guard_band, "wide", "", {}},
    {"saturation", "saturation", &Config::saturation, "bright", "", {}},
    {"early_stop", "early_stop", &Config::early_stop, "opaque", "", {}},
    {"layered", "layers", &Config::layered, "turned", "", {}},
    {"index_ties", "ties", &Config::index_ties, "", "two tied", {"su_merge"}},
    {"overflow", "overflow", &Config::overflow, "", "crowd", {"pu_allocate", "su_collect"}},
    {"large_groups", "large_groups", &Config::large_groups, "", "crowd", {"su_split"}},
    {"taps", "taps", &Config::taps, "", "", {}},
    {"antialias", "antialias", &Config::antialias, "", "", {}},
};

SimulateOptions design_point_options(const std::string& design_point) {
  SimulateOptions options;
  options.config = find_design_point(design_point).config;
  options.memory.jitter = 20;
  return options;
}

// A view on a design point with everything; many machines ask for the same one.
const Looked& looked(const std::string& design_point, const std::string& view) {
  static std::map<std::pair<std::string, std::string>, std::unique_ptr<Looked>> all;
  std::unique_ptr<Looked>& one = all[{design_point, view}];
  if (!one) one = std::make_unique<Looked>(view, design_point_options(design_point));
  return *one;
}

// Runs the RTL of what simulate_golden() has set up. What an assertion said, or "".
std::string simulate(const SimulateOptions& options, Simulation& simulation) {
  try {
    simulate_rtl(options, simulation);
  } catch (const RtlBuildError&) { throw; } catch (const std::runtime_error& error) {
    return error.what();
  }
  EXPECT_EQ(simulation.mismatches, 0u) << simulation.first_mismatch->what;
  EXPECT_EQ(simulation.beats > 0, options.config.taps != 0);  // without taps only pixels are compared
  return "";
}

class Alone : public testing::TestWithParam<std::pair<const char*, Part>> {};

TEST_P(Alone, EveryViewIsRightOrAnAssertionSpeaks) {
  const auto& [design_point, part] = GetParam();
  SimulateOptions lean = design_point_options(design_point);
  lean.config.*part.flag = !(lean.config.*part.flag);
  fmt::print("building {}: {}\n", design_point, config_difference(lean.config));
  std::fflush(stdout);
  for (const View& view : views()) {
    SCOPED_TRACE(view.name);
    const Looked& whole = looked(design_point, view.name);
    Simulation simulation;
    simulate_golden(view.scene, view.camera, lean, simulation);
    const std::string said = simulate(lean, simulation);
    const bool called = whole.verdict(part.effect).called_for;
    if (!called) {
      EXPECT_EQ(said, "");
      EXPECT_TRUE(simulation.golden.pixels == whole.simulation.golden.pixels) << "another picture";
    } else if (said != "") {
      EXPECT_FALSE(part.speakers.empty()) << said;
      EXPECT_NE(said.find("assertion failed"), std::string::npos) << said;
    }
    if (view.name == part.drawn) {
      EXPECT_TRUE(called) << whole.verdict(part.effect).evidence;
      EXPECT_EQ(said, "");
      EXPECT_FALSE(simulation.golden.pixels == whole.simulation.golden.pixels) << "the part changes nothing";
    }
    if (view.name == part.spoken) {
      EXPECT_TRUE(called) << whole.verdict(part.effect).evidence;
      EXPECT_TRUE(std::any_of(part.speakers.begin(), part.speakers.end(),
                              [&](const char* module) { return said.find(module) != std::string::npos; }))
          << "said: " << said;
    }
  }
  if (!lean.config.antialias) return;
  Simulation simulation;
  simulate_golden(antialiased_scene(), find_view("quiet").camera, lean, simulation);
  EXPECT_EQ(simulate(lean, simulation), "");
  EXPECT_FALSE(simulation.golden.pixels == looked(design_point, "quiet").simulation.golden.pixels);
}

// No two of these are one machine: each part stands in every design point, if not in the same units (alphas overflow in
// `dop` alone, records in all SUs). The design points left out add none: dpc has the parts of baseline in other Row
// Units, tspp those of baseline and dop.
std::vector<std::pair<const char*, Part>> machines() {
  std::vector<std::pair<const char*, Part>> all;
  for (const char* design_point : {"dop", "late", "exact", "baseline"}) {
    for (const Part& part : kParts) {
      if (part.flag == &Config::layered && find_design_point(design_point).config.order != 0)
        continue;  // there are no layers to leave out
      all.emplace_back(design_point, part);
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Effects, Alone, testing::ValuesIn(machines()), [](const auto& info) {
  return fmt::format("{}_{}", info.param.first, info.param.second.entry);
});

}  // namespace
}  // namespace pipegs
