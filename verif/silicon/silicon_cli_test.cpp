// SPDX-License-Identifier: Apache-2.0
// silicon_cli_test: `pipegs silicon` on a synth.json and an activity that are written by hand; RTL runs only to differ.
#include "sim/design/design_point.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/silicon/energy/energy.hpp"
#include "sim/silicon/energy/frame_activity.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class SiliconCli : public Cli {
 protected:
  const std::string silicon_ = "silicon scene.ply --cameras cameras.json --synth synth --library hand ";
  const std::string view_ = silicon_ + "--no-energy --design dop ";

  Json synth() {
    Json json = {{"configuration", "default"},
                 {"library", "hand"},
                 {"nand2_um2", 20},
                 {"nand2_ff", 10},
                 {"volts", 1.8},
                 {"fo4_ps", 100},
                 {"memories", Json::array()}};
    for (const auto& [unit, instances, nand2] :
         {std::tuple{"dopu", 1, 1e5}, {"pu", 4, 5e5}, {"su", 4, 4e4}, {"ru", 4, 2e5}, {"top", 1, 3.1e6}}) {
      json["units"].push_back({{"unit", unit},
                               {"instances", instances},
                               {"nand2", nand2},
                               {"flipflops", 10},
                               {"path_ps", 6000},
                               {"path_from", "a"},
                               {"path_to", "b"},
                               {"switch_j", 1e-11}});
    }
    return json;
  }
  // One PU's registers: four behind a gate, one without.
  Json enables() {
    Json json = {{"configuration", "default"},
                 {"library", "hand"},
                 {"program", "0123"},
                 {"gate_j", 1e-13},
                 {"instances", {{"gen_unit[0].u_pu", "stage"}}}};
    json["modules"]["stage"] =
        Json::parse(R"({"leaves": [["hold_q", 0]], "operations": [["not", 2]], "gates": [[3, null, 4, 1e-12]],
                        "clock_gates": 1, "always": [1, 3e-13]})");
    return json;
  }
  void plant(const std::string& text, const std::string& configuration = "default", const std::string& gated = "") {
    const std::string folder = "synth/" + configuration + "/hand";
    fs::create_directories(folder_ / folder);
    write(folder + "/synth.json", text);
    Json json = enables();
    json["configuration"] = configuration;
    write(folder + "/enables.json", gated.empty() ? json.dump() : gated);
  }
};

TEST_F(SiliconCli, SetsAreaAndClockBesideThePapers) {
  plant(synth().dump());
  const Outcome outcome = run(view_ + "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["charts"][0]["name"], "area");
  const Json& design_point = json["designs"][0];
  EXPECT_EQ(design_point["name"], "dop");
  EXPECT_FALSE(design_point.contains("energy"));
  ASSERT_EQ(design_point["rows"].size(), 7u);
  EXPECT_NEAR(design_point["rows"][1]["kilo_nand2"], 2000, 1e-9);
  EXPECT_NEAR(design_point["rows"][1]["area_mm2"]["mid"], 2e6 * 0.49e-6, 1e-9);
  EXPECT_NEAR(design_point["rows"][1]["path_ps"]["mid"], 60 * 16, 1e-9);
  EXPECT_NEAR(design_point["rows"][4]["kilo_nand2"], 3100 - 100 - 4 * 740, 1e-6) << "what the top has beside its units";
  double sum = 0;
  for (size_t row = 0; row < 6; ++row) sum += design_point["rows"][row]["area_mm2"]["mid"].get<double>();
  EXPECT_NEAR(design_point["rows"][6]["area_mm2"]["mid"], sum, 1e-9);
  EXPECT_DOUBLE_EQ(design_point["fps_per_mm2"], design_point["fps"].get<double>() / sum);
  EXPECT_EQ(json["paper"].back()["area_mm2"], 3.283);
  EXPECT_EQ(json["gscore"].back()["power_w"], 0.87);
  const Outcome table = run(view_);
  for (const char* part : {"kNAND2", "paper mm2", "frames/s/mm2", "GSCore"})
    EXPECT_NE(table.out.find(part), std::string::npos) << part;
}

// Longer than a nanosecond: the machine is no faster than its path.
TEST_F(SiliconCli, CountsFramesAtTheClockThatThePathAllows) {
  Json slow = synth();
  slow["units"][3]["path_ps"] = 8000;  // the RU's
  slow["units"][4]["path_ps"] = 8000;
  plant(slow.dump());
  const Outcome outcome = run(view_ + "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json design_point = Json::parse(outcome.out)["designs"][0];
  EXPECT_DOUBLE_EQ(design_point["ghz"], 1e3 / (80 * 16));
  const double us = design_point["cycles"].get<double>() * 80 * 16 / 1e6;
  EXPECT_DOUBLE_EQ(design_point["us"], us);
  EXPECT_DOUBLE_EQ(design_point["fps"], 1e6 / us);
  EXPECT_DOUBLE_EQ(design_point["fps_per_mm2_at_1_ghz"], design_point["fps_per_mm2"].get<double>() * 80 * 16 / 1e3);
}

// The activity of this frame is in the folder already.
TEST_F(SiliconCli, SetsEnergyBesideThePapers) {
  plant(synth().dump());
  SimulateOptions options;
  options.memory.dram = "lpddr5-6400x4";
  const MeasurementStore store(folder_ / "kept", read_ply(folder_ / "scene.ply"),
                               read_cameras(folder_ / "cameras.json").at(0), options,
                               {{"rtl", hash_of_files(PIPEGS_SOURCE_DIR "/rtl", ".sv")},
                                {"samples", {kSamples, kSampleCycles}},
                                {"enables", "0123"}});
  Activity half;
  half.cycles = 100;
  half.groups = {{"dopu", {10, 20}}, {"pu", {400, 1000}}, {"su", {40, 10}}, {"ru", {80, 200}}, {"top", {10, 10}}};
  half.clocks = {{"dopu", 50}, {"pu", 200}, {"su", 20}, {"ru", 100}};
  half.enabled = {{"pu", {{"stage", {90, {30}}}}}};
  half.unseen = {{"pu", 1}};
  const FrameActivity kept = {10000, 64000, {half, half}};
  store.save(Config{}, to_json(kept));
  const Outcome outcome = run(silicon_ + "--design dop --store kept --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json design_point = Json::parse(outcome.out)["designs"][0];
  EXPECT_EQ(design_point["cycles"], 10000u);
  ASSERT_EQ(design_point["energy"].size(), 8u);
  const std::vector<EnergyRow> rows =
      energy_rows(Config{}, read_synth(folder_ / "synth/default/hand/synth.json", Config{}),
                  read_enables(folder_ / "synth/default/hand/enables.json", Config{}),
                  SramLaw(PIPEGS_SOURCE_DIR "/synth/data/sram.csv"), kept);
  for (size_t i = 0; i < rows.size(); ++i) {
    const Json& row = design_point["energy"][i];
    EXPECT_EQ(row["name"], rows[i].name);
    EXPECT_DOUBLE_EQ(row["frame_j"]["mid"], rows[i].frame_j.mid);
    EXPECT_DOUBLE_EQ(row["clocks_j"], rows[i].clocks_j);
    EXPECT_EQ(row["gated"], rows[i].gated);
    EXPECT_DOUBLE_EQ(row["watts_full"]["high"], rows[i].watts(1e5).high);
    EXPECT_DOUBLE_EQ(row["watts_60"]["mid"], rows[i].watts(60).mid);
  }
  ASSERT_EQ(design_point["clocks"].size(), 1u);
  EXPECT_EQ(design_point["clocks"][0]["module"], "stage");
  EXPECT_EQ(design_point["clocks"][0]["flipflops"], 5);
  EXPECT_DOUBLE_EQ(design_point["clocks"][0]["gated_j"], rows[1].gated_j());
  const Outcome table = run(silicon_ + "--design dop --store kept");
  for (const char* part :
       {"unseen, %", "  80.0  ", "  33.3  ", "modules whose clocks take most", "           5      4  "})
    EXPECT_NE(table.out.find(part), std::string::npos) << part << " in\n" << table.out;
  EXPECT_DOUBLE_EQ(design_point["frames_per_joule"], 1e5 / rows[6].watts(1e5).mid);
  EXPECT_DOUBLE_EQ(design_point["frames_per_joule_with_dram"], 1e5 / (rows[6].watts(1e5).mid + rows[7].watts(1e5).mid));
}

// What switches is seen in the waves of a machine that runs, inside of the border that stands around its core.
TEST_F(SiliconCli, SeesWhatSwitchesInAMachineThatRuns) {
  SimulateOptions options;
  options.config = find_design_point("dop").config;
  for (const char* setting : {"units=1", "alpha_lines=64", "records=16"}) config_set(options.config, setting);
  Enables enables;
  const auto add = [&](const char* instance, const char* module, const char* leaf) {
    GatedModule& gated = enables.modules[module];
    gated.leaves = {{leaf, 0}};
    gated.gates = {{2, GatedModule::kUnknown, 4, 1e-12}};
    enables.instances[instance] = module;
  };
  add("", "pipegs_top", "frame_valid_i");
  add("u_front.gen_unit[0].u_pu", "pipegs_pu", "chunk_valid_i");
  const Activity seen = measure_activity(read_ply(folder_ / "scene.ply"), read_cameras(folder_ / "cameras.json").at(0),
                                         options, enables, kSamples * kSampleCycles, folder_)
                            .sum();
  EXPECT_TRUE(seen.unseen.empty());
  for (const auto& [unit, module] : {std::pair{"top", "pipegs_top"}, {"pu", "pipegs_pu"}}) {
    const Enabled& enabled = seen.enabled.at(unit).at(module);
    EXPECT_GT(enabled.passed.at(0), 0u) << module;
    EXPECT_LT(enabled.passed.at(0), enabled.edges) << module;
    EXPECT_GT(seen.groups.at(unit).toggles, 0u);
  }
  for (const auto& [name, accesses] : seen.srams) EXPECT_TRUE(name.starts_with("u_") && !name.starts_with("u_core"));
  EXPECT_EQ(seen.clocks.count("pu"), 1u);
}

// A machine that differs, that hangs, that does not build: none of its figures is kept or shown.
TEST_F(SiliconCli, FiguresAreThoseOfAMachineThatAgrees) {
  Json small = synth();
  small["configuration"] = "units=1,pace=4,alpha_lines=64,records=16";
  plant(small.dump(), small["configuration"]);
  const std::string command = silicon_ + "--store kept ";
  const std::string measure = command + smallest_;
  const auto expect_none = [&](const Outcome& outcome, int code, const std::string& part) {
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(!fs::exists(folder_ / "kept") || fs::is_empty(folder_ / "kept"));
  };
  expect_none(shell("PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' " + measure), 1, "the RTL differs from the golden model");
  expect_none(shell("PIPEGS_FAULT=hang '" PIPEGS_FAULTY "' " + measure), 1, "the machine hangs");
  Json other = synth();
  other["configuration"] = "alpha_lines=128";
  plant(other.dump(), "alpha_lines=128");
  const Outcome unbuilt = run(command + "--design dop --set alpha_lines=128", "PATH=/nowhere ");
  EXPECT_EQ(unbuilt.code, 3);
  EXPECT_NE(unbuilt.err.find("does not build"), std::string::npos) << unbuilt.err;
}

TEST_F(SiliconCli, RefusesWhatMakeSynthDidNotWrite) {
  expect_refused(view_, "not found: `make synth` writes it");
  plant("{");
  expect_refused(view_, "synth.json: not JSON");
  Json json = synth();
  json["configuration"] = "units=2";
  plant(json.dump());
  expect_refused(view_, "configuration: found 'units=2', expected default");
  json = synth();
  json["units"][1].erase("switch_j");
  plant(json.dump());
  expect_refused(view_, "switch_j");
  const std::string good = synth().dump();
  plant(good.substr(0, good.size() - 1) + ",\"volts\":1.8}");
  expect_refused(view_, "found a second 'volts', expected one");
  plant(good + "}");
  expect_refused(view_, "synth.json: not JSON");
  plant(std::string(400000, '[') + std::string(400000, ']'));
  expect_refused(view_, "more than 64 brackets");
  fs::remove(folder_ / "synth/default/hand/synth.json");
  fs::create_directory(folder_ / "synth/default/hand/synth.json");
  expect_refused(view_, "found a folder");
  fs::remove(folder_ / "synth/default/hand/synth.json");
  json = synth();
  json["volts"] = -1;
  plant(json.dump());
  expect_refused(view_, "volts: found '-1', expected a number above 0");
  json = synth();
  json["units"][0]["instances"] = 1.5;
  plant(json.dump());
  expect_refused(view_, "found '1.5', expected an integer");
  json = synth();
  json["volts"] = 0;
  plant(json.dump());
  expect_refused(view_, "volts: found '0', expected a number above 0");
  expect_refused(silicon_ + "--no-energy --designs dop,nothing", "unknown design point 'nothing'");
}

}  // namespace
}  // namespace pipegs
