// SPDX-License-Identifier: Apache-2.0
// what_if_test: a machine beside changes of it: each figure is that of the command which measures one machine alone.
#include <cmath>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class WhatIf : public Cli {
 protected:
  const std::string view_ = " scene.ply --cameras cameras.json ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  // The line of a table that begins so.
  static std::string line_of(const Outcome& outcome, const std::string& name) {
    const size_t at = outcome.out.find("\n  " + name);
    if (at == std::string::npos) return "";
    return outcome.out.substr(at + 1, outcome.out.find('\n', at + 1) - at - 1);
  }
};

TEST_F(WhatIf, FiguresAreThoseOfEachMachineAlone) {
  const Json machines = json("what-if" + view_ + "--set units=2 --set alpha_w=8,rgb_w=12")["machines"];
  ASSERT_EQ(machines.size(), 3u);
  const std::string settings[] = {"", "--set units=2 ", "--set alpha_w=8 --set rgb_w=12 "};
  for (size_t i = 0; i < 3; ++i) {
    const Json& one = machines[i];
    SCOPED_TRACE(one["name"]);
    const Json model = json("model" + view_ + settings[i])["designs"][0];
    EXPECT_EQ(one["cycles"], model["cycles"]);
    double bytes = 0;
    for (const Json& stream : model["bytes"]) bytes += stream["read"].get<double>() + stream["written"].get<double>();
    EXPECT_NEAR(one["megabytes"].get<double>(), bytes / 1e6, 1e-9);
    const std::string store = "--store points" + std::to_string(i);
    const Json shape = json("study shapes" + view_ + settings[i] + "--runs 1 " + store)["shapes"][0];
    EXPECT_EQ(one["mm2"], shape["mm2"]["mid"]);
    EXPECT_EQ(one["ghz"], shape["ghz"]);
    EXPECT_EQ(one["us"], shape["us"]);
    EXPECT_NEAR(one["mj"].get<double>(), 1e3 / shape["frames_per_joule_with_dram"].get<double>(), 1e-6);
    for (const char* key : {"extrapolated_area", "extrapolated_path", "extrapolated_energy"})
      EXPECT_EQ(one["silicon"][key], shape[key]) << key;
    const Json base = json("accuracy" + view_ + settings[i] + "--knobs exp_linear --points 0 " + store)["base"];
    EXPECT_NEAR(one["psnr_truth_db"].get<double>(), base["total"]["psnr_db"].get<double>(), 1e-6);
    for (const char* key : {"cycles", "us", "mm2", "mj"})
      EXPECT_NEAR(one["of_base"][key].get<double>(), one[key].get<double>() / machines[0][key].get<double>(), 1e-12);
  }
  EXPECT_TRUE(machines[1]["psnr_base_db"].is_null()) << "half the units draw the same picture";
  EXPECT_LT(machines[2]["psnr_base_db"], 60);
}

TEST_F(WhatIf, WhatBoundsTheBaseIsWhatSimSays) {
  const Json base = json("what-if" + view_ + "--set units=2")["machines"][0];
  ASSERT_EQ(run("sim" + view_ + "--no-truth --out sim").code, 0);
  const Json report = Json::parse(text("sim/report.json"));
  EXPECT_EQ(base["cycles"], report["cycles"]);
  EXPECT_EQ(base["largest_bound"], report["bounds"]["largest"]);
  EXPECT_EQ(base["cycles_over_largest_bound"], report["bounds"]["cycles_over_largest"]);
}

// A bound is one: no machine needs fewer cycles. Through a narrow bus the bus is it.
TEST_F(WhatIf, ANarrowBusBounds) {
  const Json machines = json("what-if" + view_ +
                             "--set bus_w=128 --set records=16 --set late=1,quads=0,window=64 "
                             "--memory lpddr5-6400x8")["machines"];
  EXPECT_EQ(machines[1]["largest_bound"], "bus");
  for (const Json& one : machines) EXPECT_GE(one["cycles_over_largest_bound"], 1) << one;
}

// The picture and the trace of the base serve every machine that differs in time only.
TEST_F(WhatIf, MachinesThatDrawAlikeHaveTheirOwnFigures) {
  const Json machines = json("what-if" + view_ + "--set records=16 --set units=1")["machines"];
  for (size_t i = 1; i < 3; ++i) {
    const std::string setting = machines[i]["name"];
    const Json alone = json("what-if" + view_ + "--set " + setting)["machines"][1];
    EXPECT_EQ(machines[i], alone);
    write("my.cfg", setting + "\n");
    Json base = json("what-if" + view_ + "--config my.cfg --set tests=1")["machines"][0];
    for (const char* key :
         {"cycles", "megabytes", "mm2", "us", "mj", "psnr_truth_db", "largest_bound", "cycles_over_largest_bound"})
      EXPECT_EQ(base[key], alone[key]) << key;
  }
}

TEST_F(WhatIf, ChangesStandBesideTheBase) {
  const Outcome outcome = run("what-if" + view_ + "--set units=2 --set sh_degree=0");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "") << "no terminal, so no progress";
  const std::string head = line_of(outcome, "figure");
  for (const char* part : {"fast", "units=2", "sh_degree=0", "%"}) EXPECT_NE(head.find(part), head.npos) << head;
  for (const char* name : {"cycles", "clock, GHz", "time, us", "memory, MB", "area, mm2", "energy, mJ",
                           "to the truth, dB", "to the base, dB", "bound by", "roofline ratio", "seen by the models"})
    EXPECT_NE(line_of(outcome, name), "") << name << " is not in:\n" << outcome.out;
  EXPECT_NE(line_of(outcome, "area, mm2").find(" -"), std::string::npos) << "half the units take less";
  EXPECT_NE(line_of(outcome, "to the base, dB").find("equal"), std::string::npos);
  // A machine that no synthesised one is like is marked, and told.
  EXPECT_NE(line_of(outcome, "area, mm2").find("~"), std::string::npos);
  EXPECT_NE(line_of(outcome, "seen by the models").find("not area"), std::string::npos);
}

// The truth has all bands of the scene, whatever a machine leaves out.
TEST_F(WhatIf, WhatAMachineLeavesOutCostsDecibels) {
  const Json machines = json("what-if" + view_ + "--set sh_degree=0")["machines"];
  EXPECT_LT(machines[1]["psnr_truth_db"].get<double>(), machines[0]["psnr_truth_db"].get<double>() - 5);
}

TEST_F(WhatIf, AMachineOfAnUnknownKindHasNoAreaAndNoClock) {
  const Outcome outcome = run("what-if" + view_ + "--design tspp --set units=2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* name : {"clock, GHz", "time, us", "area, mm2", "energy, mJ"}) {
    const std::string line = line_of(outcome, name);
    EXPECT_EQ(line.find_first_of("0123456789", 12), line.npos) << line;
  }
  EXPECT_NE(outcome.out.find("no machine of its kind was synthesised"), std::string::npos) << outcome.out;
  const Json machines = json("what-if" + view_ + "--design tspp --set units=2")["machines"];
  for (const char* key : {"ghz", "us", "mm2", "mj", "silicon"}) EXPECT_TRUE(machines[1][key].is_null()) << key;
  EXPECT_GT(machines[1]["cycles"], machines[0]["cycles"]);
}

TEST_F(WhatIf, AChangeThatIsNoneIsSaid) {
  const Outcome outcome = run("what-if" + view_ + "--set units=4");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("units=4: as in the base, so nothing changes"), std::string::npos) << outcome.out;
}

TEST_F(WhatIf, TheBaseIsADesignPointWithAFile) {
  write("my.cfg", "records=2048\n");
  const Json machines = json("what-if" + view_ + "--design exact --config my.cfg --set bucket_bits=4")["machines"];
  EXPECT_EQ(machines[0]["configuration"], "late=1,order=2,records=2048,bucket_bits=5");
  EXPECT_EQ(machines[1]["configuration"], "late=1,order=2,records=2048,bucket_bits=4");
}

TEST_F(WhatIf, FilesHoldTheSame) {
  const Json printed = json("what-if" + view_ + "--set units=2 --out found");
  EXPECT_EQ(printed, Json::parse(text("found/what-if.json")));
  EXPECT_TRUE(text("found/what-if.csv").starts_with("figure,fast,units=2,units=2 %\n")) << text("found/what-if.csv");
  const std::string cycles =
      "cycles," + printed["machines"][0]["cycles"].dump() + "," + printed["machines"][1]["cycles"].dump() + ",";
  EXPECT_NE(text("found/what-if.csv").find("\n" + cycles), std::string::npos) << text("found/what-if.csv");
}

TEST_F(WhatIf, AMachineThatCannotBeIsRefusedWithKeyAndReason) {
  const std::string command = "what-if" + view_;
  expect_refused(command, "--set is required");
  expect_refused(command + "--set unit=2", "--set unit=2: unknown key 'unit'; nearest: units");
  expect_refused(command + "--set units=2 --set units=3",
                 "--set units=3: configuration: units = 3, expected a power of");
  expect_refused(command + "--set units=16", "--set units=16: units: found '16', expected an integer from 1 to 8");
  expect_refused(command + "--set quads=0", "--set quads=0: configuration: window = 128 needs quads = 1");
  expect_refused(command + "--set bucket_w=3", "'bucket_w' follows from other keys");
  expect_refused(command + "--set units", "expected key=value");
  expect_refused(command + "--set units=2,units=1", "--set units=2,units=1: found a second 'units', expected one");
  expect_refused(command + "--set units=2 --set units=2", "--set units=2: found a second time, expected once");
  expect_refused(command + "--set units=2,,tests=1", "expected elements by commas, none of them empty");
  expect_refused(command + "--set units=2 tests=1", "tests=1");
  expect_refused(command + "--window 0,0 --set window=64", "--window: found windows of 64 pixels, expected the base's");
  expect_refused(command + "--set units=2 --design fastest", "unknown design point 'fastest'");
  expect_refused("what-if missing.ply --set units=2", "missing.ply");
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

TEST_F(WhatIf, AnInterruptLeavesNothingBehind) {
  const Outcome outcome =
      shell("timeout --preserve-status -s INT 1 '" PIPEGS_BINARY "' what-if --set units=2 --set units=1 --out left");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

}  // namespace
}  // namespace pipegs
