// SPDX-License-Identifier: Apache-2.0
// energy_test: energy out of activity by hand, samples out of waves, and what is kept.
#include "sim/silicon/energy/energy.hpp"

#include <gtest/gtest.h>

#include "scenes/input_error.hpp"
#include "scenes/text/number.hpp"
#include "sim/design/static_cost.hpp"

namespace pipegs {
namespace {

constexpr const char* kTable = PIPEGS_SOURCE_DIR "/synth/data/sram.csv";
constexpr double kLibrary = 10e-15 * 2 * 2;  // C V^2 of one input of its NAND2, J
constexpr double kTo28 = 1.0e-15 * 0.81;     // the same in 28 nm, mid

// Two PUs and an SU of a library with round figures; the top has as much again as both.
Synth synth() {
  Synth synth = {"default", "library", 100, 10, 2, {}, {}};
  synth.units = {{"pu", 2, 1000, 10, 500, "", "", 700 * kLibrary},
                 {"su", 1, 500, 5, 500, "", "", 300 * kLibrary},
                 {"top", 1, 3000, 30, 500, "", "", 2000 * kLibrary}};
  synth.memories = {{"u_pu.u_words", 64, 128}};
  return synth;
}

// Of a PU's flip-flops 4 are clocked always and 6 behind two gates; the SU and the top have none behind a gate.
Enables enables() {
  Enables enables;
  enables.gate_joules = 2 * kLibrary;
  GatedModule pu, su, top;
  pu.gates = {{1, GatedModule::kUnknown, 4, 20 * kLibrary}, {1, GatedModule::kUnknown, 2, 10 * kLibrary}};
  pu.clock_gates = 2;
  pu.always_flipflops = 4;
  pu.always_joules = 16 * kLibrary;
  su.always_flipflops = 5;
  su.always_joules = 20 * kLibrary;
  top.always_flipflops = 5;
  top.always_joules = 30 * kLibrary;
  enables.modules = {{"pipegs_pu", pu}, {"pipegs_su", su}, {"pipegs_top", top}};
  enables.instances = {{"", "pipegs_top"},
                       {"gen_unit[0].u_pu", "pipegs_pu"},
                       {"gen_unit[1].u_pu", "pipegs_pu"},
                       {"gen_unit[0].u_su", "pipegs_su"}};
  return enables;
}

// A frame of 1000 cycles of which 2 x 50 are sampled.
FrameActivity frame() {
  Activity half;
  half.cycles = 50;
  half.groups = {{"pu", {200, 400}}, {"su", {50, 25}}, {"top", {100, 300}}};
  half.clocks = {{"pu", 60}, {"su", 0}};
  half.srams = {{"u_pu.u_words", {128, 30, 10}}};
  half.enabled = {
      {"pu", {{"pipegs_pu", {60, {15, 30}}}}}, {"su", {{"pipegs_su", {0, {}}}}}, {"top", {{"pipegs_top", {50, {}}}}}};
  half.unseen = {{"pu", 4}};
  return {1000, 64, {half, half}};
}

const EnergyRow& row(const std::vector<EnergyRow>& rows, const std::string& name) {
  for (const EnergyRow& row : rows) {
    if (row.name == name) return row;
  }
  throw std::logic_error("no row " + name);
}

TEST(Energy, FollowsClockedCyclesTogglesAccessesAndBytes) {
  const SramLaw law(kTable);
  const std::vector<EnergyRow> rows = energy_rows(Config{}, synth(), enables(), law, frame());
  // Ten times what was sampled. PUs: 120 clocked cycles of 4 flip-flops and two gates, of which 30 and 60 edges pass;
  // 800 toggles of the 100 bits that each has.
  constexpr double kClocks = 120 * 16 + 120 * 2 * 2 + 30 * 20 + 60 * 10;
  EXPECT_NEAR(row(rows, "PU").frame_j.mid, 10 * (kClocks + 8 * 700) * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").awake, 0.6, 1e-9);
  EXPECT_NEAR(row(rows, "PU").clocks_j, 10 * kClocks * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").ungated_j, 10 * 120 * 16 * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").gates_j, 10 * 120 * 2 * 2 * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").open_j, 10 * 120 * 30 * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").gated_j(), 10 * (30 * 20 + 60 * 10) * kTo28, 1e-18);
  EXPECT_EQ(row(rows, "PU").flipflops, 20u);
  EXPECT_EQ(row(rows, "PU").gated, 12u);
  EXPECT_EQ(row(rows, "PU").unseen, 4u) << "of all PUs, in one half as in both";
  EXPECT_NEAR(row(rows, "SU").frame_j.mid, 10 * 300 * kTo28, 1e-18) << "50 toggles of 50 bits, its clock stands";
  // The top less two PUs and an SU, clocked always.
  EXPECT_NEAR(row(rows, "Other").frame_j.mid, 10 * (100 * 30 + 6 * 300) * kTo28, 1e-18);
  EXPECT_NEAR(row(rows, "PU").frame_j.low, row(rows, "PU").frame_j.mid / 2, 1e-18);
  std::vector<double> accesses;
  for (const std::string& kind : law.kinds()) {
    const SramFigures figures = law.memory(kind, 128, 64, 2);
    accesses.push_back(10 * (60 * figures.read_pj + 20 * figures.write_pj) * 1e-12);
  }
  EXPECT_NEAR(row(rows, "Buffers").frame_j.low, range_of(accesses).low, 1e-18);
  EXPECT_NEAR(row(rows, "Buffers").frame_j.mid, range_of(accesses).mid, 1e-18);
  EXPECT_NEAR(row(rows, "DRAM").frame_j.mid, 64 * 8 * 8e-12, 1e-18);
  EXPECT_NEAR(row(rows, "PU").leakage_w.mid, 2000 * 12e-9, 1e-15);
  EXPECT_NEAR(row(rows, "Other").leakage_w.mid, 500 * 12e-9, 1e-15);
  EXPECT_EQ(row(rows, "Total").flipflops, 30u);
  const std::vector<ModuleClocks> modules = module_clocks(synth(), enables(), frame());
  ASSERT_EQ(modules.size(), 3u);
  EXPECT_EQ(modules[0].module, "pipegs_pu") << "the dearest first";
  EXPECT_NEAR(modules[0].all_j(), row(rows, "PU").clocks_j, 1e-18);
  double sum = 0, leakage = 0;
  for (const EnergyRow& one : rows) {
    if (one.name == "Total" || one.name == "DRAM") continue;
    sum += one.frame_j.mid, leakage += one.leakage_w.mid;
  }
  EXPECT_NEAR(row(rows, "Total").frame_j.mid, sum, 1e-18);
  EXPECT_NEAR(row(rows, "Total").watts(60).mid, 60 * sum + leakage, 1e-12);
  for (const EnergyRow& one : rows) EXPECT_EQ(one.halves_differ, 0) << one.name;
}

TEST(Energy, TellsHowFarTheHalvesLieApart) {
  FrameActivity activity = frame();
  activity.halves[0].enabled["pu"]["pipegs_pu"].passed = {55, 30};  // 40 more edges of 20
  const std::vector<EnergyRow> rows = energy_rows(Config{}, synth(), enables(), SramLaw(kTable), activity);
  constexpr double kHalf = 60 * (16 + 4) + 15 * 20 + 30 * 10 + 4 * 700;
  EXPECT_NEAR(row(rows, "PU").halves_differ, 2 * 800 / (2 * kHalf + 800), 1e-9);
  EXPECT_EQ(row(rows, "SU").halves_differ, 0);
}

TEST(Energy, RefusesSynthOfOtherRtl) {
  FrameActivity activity = frame();
  activity.halves[0].srams["u_su.u_new"] = {32, 1, 1};
  try {
    energy_rows(Config{}, synth(), enables(), SramLaw(kTable), activity);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no u_su.u_new"), std::string::npos) << error.what();
  }
  activity = frame();
  activity.halves[0].enabled["pu"]["pipegs_pu"].passed.push_back(1);
  EXPECT_THROW(energy_rows(Config{}, synth(), enables(), SramLaw(kTable), activity), InputError);
}

TEST(FrameActivity, SumsByUnitAndIsKept) {
  EXPECT_EQ(unit_of("pipegs_top.gen_unit[2].u_pu.u_fetch"), "pu");
  EXPECT_EQ(unit_of("pipegs_top.gen_unit[2].gen_store.u_store_gate"), "buf");
  EXPECT_EQ(unit_of("pipegs_top.u_memory_arbiter"), "top");
  Activity activity;
  activity.cycles = 3;
  activity.clocks = {{"pipegs_top.gen_unit[0].u_pu_gate", 1}, {"pipegs_top.gen_unit[1].u_pu_gate", 2}};
  activity.srams = {{"pipegs_top.gen_unit[0].u_su.u_keys", {8, 1, 2}},
                    {"pipegs_top.gen_unit[1].u_su.u_keys", {8, 3, 4}}};
  const Activity summed = by_unit(activity);
  EXPECT_EQ(summed.clocks, (std::map<std::string, uint64_t>{{"pu", 3}}));
  ASSERT_EQ(summed.srams.size(), 1u);
  EXPECT_EQ(summed.srams.at("gen_unit[k].u_su.u_keys").reads, 4u);
  EXPECT_EQ(summed.srams.at("gen_unit[k].u_su.u_keys").writes, 6u);
  const FrameActivity measured = frame();
  EXPECT_EQ(to_json(frame_activity_from_json(to_json(measured))), to_json(measured));
}

// What is read back from a file is a count or is refused.
TEST(FrameActivity, ReadsNoNumberThatIsNoCount) {
  using Json = nlohmann::ordered_json;
  const Json whole = to_json(frame());
  for (const char* place : {"/cycles", "/bytes", "/halves/0/cycles", "/halves/1/cycles"}) {
    for (const Json& wrong : {Json("7"), Json(-1), Json(1.5), Json(nullptr), Json(1e300)}) {
      Json json = whole;
      json[Json::json_pointer(place)] = wrong;
      EXPECT_THROW(frame_activity_from_json(json), NumberError) << place << " " << wrong;
    }
  }
  Json json = whole;
  json["cycles"] = 0;
  EXPECT_THROW(frame_activity_from_json(json), NumberError) << "a frame without a cycle";
}

// Every period has its sample, all of a length, always at the same place, and not at the same place in each.
TEST(FrameActivity, SamplesAreSpreadAndRepeat) {
  RtlOptions options;
  EXPECT_TRUE(in_sample(options, 7)) << "without a period waves show all";
  options.sample_period = 100;
  options.sample_cycles = 16;
  std::vector<uint64_t> begins;
  for (uint64_t period = 0; period < 50; ++period) {
    uint64_t count = 0, begin = 0;
    for (uint64_t at = 0; at < 100; ++at) {
      if (!in_sample(options, 100 * period + at)) continue;
      if (count++ == 0) begin = at;
      EXPECT_TRUE(in_sample(options, 100 * period + at)) << "twice the same";
    }
    EXPECT_EQ(count, 16u);
    begins.push_back(begin);
  }
  EXPECT_LT(*std::min_element(begins.begin(), begins.end()), 15u);
  EXPECT_GT(*std::max_element(begins.begin(), begins.end()), 69u);
}

}  // namespace
}  // namespace pipegs
