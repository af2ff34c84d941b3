// SPDX-License-Identifier: Apache-2.0
// effects_test: detectors against scenes that call for one thing each, and machines without the rest against the whole
// one.
//
// Golden level: a plan's configuration gives the same pixels as the full one, for every scene. RTL level: one machine
// without anything that can be left out (built by CMakeLists.txt) draws what calls for nothing, and is caught where it
// may not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/effects/effects.hpp"
#include "verif/effects/effect_views.hpp"

namespace pipegs {
namespace {

using Names = std::vector<std::string>;

TEST(Effects, AQuietSceneCallsForNothing) { EXPECT_EQ(Looked("quiet").called(), Names{}); }

TEST(Effects, EachBandOfShIsSeenWithItsCoefficient) {
  EXPECT_EQ(Looked("band 1").called(), Names{"sh1"});
  EXPECT_EQ(Looked("band 2").called(), (Names{"sh1", "sh2"}));
  EXPECT_EQ(Looked("band 3").called(), (Names{"sh1", "sh2", "sh3"}));
  EXPECT_EQ(Looked("band 1").verdict("sh1").evidence, "largest coefficient 0.3");
  EXPECT_EQ(Looked("band 1").verdict("sh3").evidence, "largest coefficient 0");
  EXPECT_EQ(Looked("band 3").verdict("sh1").evidence, "largest coefficient 0, but a higher band needs it");
  EXPECT_EQ(Looked("quiet").verdict("sh1").evidence, "the scene has degree 0");
}

TEST(Effects, EachPartIsSeenWithItsCount) {
  const auto expect = [](const char* view, const char* effect, const char* evidence) {
    const Effect::Verdict verdict = Looked(view).verdict(effect);
    EXPECT_TRUE(verdict.called_for) << view << ", " << effect;
    EXPECT_EQ(verdict.evidence, evidence) << view;
  };
  expect("near", "near", "1 pairs of Gaussian and window before the near plane");
  expect("near", "layers", "at most 2 layers of a window hold something");
  expect("wide", "guard_band", "1 visible pairs of Gaussian and window beyond the guard band");
  expect("bright", "saturation", "1 colours, 0 accumulated colours at the top");
  expect("two tied", "ties", "1 neighbours of equal depth in the sorted order");
  expect("twenty tied", "large_groups", "a bucket of depth holds 20 keys");
  EXPECT_TRUE(Looked("opaque").verdict("early_stop").called_for);
  EXPECT_TRUE(Looked("behind").verdict("near").called_for);
  EXPECT_TRUE(Looked("crowd").verdict("large_groups").called_for);
  EXPECT_EQ(Looked("bright").called(), (Names{"sh1", "saturation"}));
  EXPECT_EQ(Looked("wide").called(), Names{"guard_band"});
  EXPECT_EQ(Looked("two tied").called(), Names{"ties"});
}

TEST(Effects, StoresThatFillUpCallForTheirOverflow) {
  EXPECT_FALSE(Looked("cloud").verdict("overflow").called_for) << Looked("cloud").verdict("overflow").evidence;
  EXPECT_TRUE(Looked("crowd").verdict("overflow").called_for) << Looked("crowd").verdict("overflow").evidence;
  SimulateOptions tiny;
  tiny.config.alpha_lines = 64, tiny.config.records = 16;
  EXPECT_TRUE(Looked("cloud", tiny).verdict("overflow").called_for)
      << Looked("cloud", tiny).verdict("overflow").evidence;
}

TEST(Effects, AScenesTagCallsForTheCompensation) {
  const Scene scene = antialiased_scene();
  SimulateOptions options;
  options.config.antialias = 1;
  Simulation simulation;
  simulate_golden(scene, test_camera(128, 64), options, simulation);
  const EffectPlan plan = plan_effects(options, find_effects(effect_facts(scene, options, simulation, true)));
  EXPECT_EQ(plan.simulated, Names{"antialias"});
  EXPECT_EQ(plan.options.config.antialias, 1);
}

TEST(Effects, TheTimingOfMemoryIsCalledForWhereItMovesCycles) {
  SimulateOptions options;
  options.memory.dram = "lpddr5-6400x4";
  const Looked run("cloud", options);
  EXPECT_TRUE(run.verdict("dram").called_for) << run.verdict("dram").evidence;
  options.memory.dram = "ideal";
  EXPECT_FALSE(Looked("cloud", options).verdict("dram").called_for);
}

TEST(Effects, WhatWatchesTheMachineCallsForItsParts) {
  SimulateOptions options;
  options.rtl.waves = "window.fst";
  const Looked waves("quiet", options);
  for (const char* name : {"waves", "taps", "asserts"}) EXPECT_TRUE(waves.verdict(name).called_for) << name;
  options.rtl.waves.clear();
  options.watch = {1, 1};
  const Looked watch("quiet", options);
  EXPECT_FALSE(watch.verdict("waves").called_for);
  for (const char* name : {"taps", "asserts"}) EXPECT_TRUE(watch.verdict(name).called_for) << name;
}

TEST(Effects, AutoGivesThePixelsOfAll) {
  for (const View& view : views()) {
    const Looked run(view.name);
    const EffectPlan plan = plan_effects(run.options, run.findings);
    EXPECT_EQ(run.pixels(plan.options), run.simulation.golden.pixels)
        << view.name << ": " << config_difference(plan.options.config);
  }
}

TEST(Effects, AnEffectThatIsNotCalledForChangesNoPixelWhenItIsForcedOn) {
  for (const char* name : {"quiet", "band 1"}) {
    const Looked run(name);
    for (const EffectFinding& finding : run.findings) {
      if (finding.verdict.called_for) continue;
      Names names = run.called();
      names.emplace_back(finding.effect->name);
      EXPECT_EQ(run.pixels(plan_effects(run.options, names).options), run.simulation.golden.pixels)
          << name << ", " << finding.effect->name;
    }
  }
}

// Of every scene: leaving out one thing that is called for shows.
TEST(Effects, LeavingOutWhatIsCalledForChangesPixels) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"band 1", "sh1"},      {"band 2", "sh2"},        {"band 3", "sh3"},        {"near", "near"},
      {"wide", "guard_band"}, {"bright", "saturation"}, {"opaque", "early_stop"}, {"turned", "layers"}};
  for (const auto& [name, effect] : cases) {
    const Looked run(name);
    ASSERT_TRUE(run.verdict(effect).called_for) << name << ": " << run.verdict(effect).evidence;
    SimulateOptions without = run.options;
    std::find_if(effects().begin(), effects().end(), [&, e = effect](const Effect& x) {
      return x.name == e;
    })->leave_out(without);
    EXPECT_NE(run.pixels(without), run.simulation.golden.pixels) << name << " without " << effect;
  }
}

TEST(Effects, NamesAreChecked) {
  const SimulateOptions full;
  EXPECT_EQ(plan_effects(full, Names{"sh2"}).simulated, (Names{"sh1", "sh2"}));
  try {
    plan_effects(full, Names{"sh4"});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 41), "--effects sh4: expected auto, all, or som") << error.what();
  }
  SimulateOptions waves;
  waves.rtl.waves = "window.fst";
  EXPECT_THROW(plan_effects(waves, Names{"sh1"}), ConfigError);
}

// --- RTL: one machine without everything -----------------------------------------------------------------------------

EffectPlan nothing(const Looked& run) { return plan_effects(run.options, Names{}); }

TEST(EffectsRtl, AMachineWithoutEffectsDrawsWhatCallsForNone) {
  Looked run("quiet");
  EXPECT_EQ(simulate_effects(run.view.scene, run.view.camera, run.options, nothing(run), run.simulation), "");
  EXPECT_EQ(run.simulation.mismatches, 0u);
  Looked all("quiet");
  simulate_rtl(all.options, all.simulation);
  EXPECT_EQ(all.simulation.mismatches, 0u);
  EXPECT_LE(run.simulation.rtl.cycles,
            all.simulation.rtl.cycles);  // without SH and layers a pipeline and a walk are shorter
}

TEST(EffectsRtl, AWrongDecisionIsCaught) {
  for (const auto& [name, effect] : {std::pair{"band 1", "sh1"}, {"opaque", "early_stop"}, {"bright", "saturation"}}) {
    Looked run(name);
    ASSERT_TRUE(run.verdict(effect).called_for);
    const std::string caught =
        simulate_effects(run.view.scene, run.view.camera, run.options, nothing(run), run.simulation);
    EXPECT_NE(caught.find(effect), std::string::npos) << caught;
    EXPECT_NE(caught.find("something left out is called for"), std::string::npos) << caught;
    EXPECT_EQ(run.simulation.mismatches, 0u) << "with all effects";
  }
}

}  // namespace
}  // namespace pipegs
