// SPDX-License-Identifier: Apache-2.0
// words_test: what was not run is not printed or stored as run; help texts; the line that replays a mismatch does.
#include <map>
#include <sstream>

#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class Words : public Cli {
 protected:
  const std::string view_ = " scene.ply --cameras cameras.json ";

  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  // What stands behind `before` on its line of standard error.
  static std::string behind(const std::string& before, const Outcome& outcome) {
    const size_t at = outcome.err.find(before);
    if (at == std::string::npos) return "";
    return outcome.err.substr(at + before.size(), outcome.err.find('\n', at) - at - before.size());
  }
  // The commands that the help of these words lists.
  std::vector<std::string> named_in_help(const std::string& words) {
    std::istringstream help(run(words + "--help").out);
    std::vector<std::string> names;
    std::string line;
    while (std::getline(help, line) && line != "Subcommands:") {}
    while (std::getline(help, line) && line.starts_with("  ")) names.push_back(line.substr(2, line.find(' ', 2) - 2));
    return names;
  }
};

TEST_F(Words, TheVersionNamesSourcesAndVerilator) {
  const Outcome outcome = run("--version");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  for (const char* part : {"PipeGS", "sources of the models ", "Verilator 5"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << outcome.out;
}

TEST_F(Words, NothingOfTheRtlIsSaidWithoutIt) {
  const Outcome outcome = run("sim" + view_ + "--no-rtl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("RTL not run, nothing compared"), std::string::npos) << outcome.out;
  for (const char* part : {"mismatches", "compared:", "where every cycle went", "kHz", "overflow lines", "roofline"})
    EXPECT_EQ(outcome.out.find(part), std::string::npos) << part << "\n" << outcome.out;
  const Json report = Json::parse(text("out/report.json"));
  EXPECT_EQ(report["ran"], Json({{"truth", true}, {"rtl", false}}));
  for (const char* key :
       {"cycles", "preprocess_cycles", "units", "memory", "beats_compared", "mismatches", "rtl_khz", "effects"})
    EXPECT_TRUE(report.at(key).is_null()) << key << ": " << report[key];
  for (const char* key : {"memory", "largest", "cycles_over_largest"})
    EXPECT_TRUE(report["bounds"].at(key).is_null()) << key;
  EXPECT_TRUE(report["work"].at("overflow_lines").is_null());
  EXPECT_TRUE(report["wall_seconds"].at("rtl").is_null());
  EXPECT_TRUE(report["psnr_total_db"].is_number());
}

TEST_F(Words, NothingOfTheTruthIsSaidWithoutIt) {
  const Outcome outcome = run("sim" + view_ + "--no-truth");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("truth not run, no PSNR"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("beats and every pixel compared: 0 mismatches"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find(" dB"), std::string::npos) << outcome.out;
  const Json report = Json::parse(text("out/report.json"));
  EXPECT_EQ(report["ran"], Json({{"truth", false}, {"rtl", true}}));
  for (const char* key : {"psnr_numeric_db", "psnr_order_db", "psnr_total_db", "max_abs_error"})
    EXPECT_TRUE(report.at(key).is_null()) << key << ": " << report[key];
  EXPECT_TRUE(report["wall_seconds"].at("truth").is_null());
  EXPECT_EQ(report["mismatches"], 0);
}

// A picture that equals the truth has no finite PSNR either; `ran` and the largest error tell the two apart.
TEST_F(Words, EqualIsNotTheSameAsNotRun) {
  write_ply(folder_ / "empty.ply", scene_of({}));
  const Outcome outcome = run("sim empty.ply --cameras cameras.json --no-rtl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("numeric equal, order equal, total equal"), std::string::npos) << outcome.out;
  const Json report = Json::parse(text("out/report.json"));
  EXPECT_TRUE(report["psnr_numeric_db"].is_null());
  EXPECT_EQ(report["max_abs_error"], 0.0);
}

// The largest error follows the rule of the decibels beside it: a 10-bit channel ends at 1, the truth does not.
TEST_F(Words, ABrightPixelIsNoError) {
  Scene bright = random_scene(2, 20, 0);
  for (Gaussian& g : bright.gaussians) g.sh_dc = glm::vec3(4), g.opacity_logit = 4;
  write_ply(folder_ / "bright.ply", bright);
  const Outcome outcome = run("sim bright.ply --cameras cameras.json --no-rtl");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json report = Json::parse(text("out/report.json"));
  EXPECT_GT(report["max_abs_error"], 0.0);
  EXPECT_LT(report["max_abs_error"], 0.02);
}

TEST_F(Words, OtherCommandsSayAsLittle) {
  EXPECT_TRUE(json("explain" + view_ + "--pixel 1,1 --no-rtl").at("mismatches").is_null());
  EXPECT_EQ(json("explain" + view_ + "--pixel 1,1").at("mismatches"), 0);
  const Json ladder = json("ladder" + view_ + "--designs dop --no-truth");
  EXPECT_EQ(ladder["designs"][0]["ran"], Json({{"truth", false}, {"rtl", true}}));
  EXPECT_TRUE(ladder["designs"][0].at("psnr_numeric_db").is_null());
  const Outcome stress = run("study stress --count 1 --no-rtl");
  EXPECT_NE(stress.out.find("RTL                   not run"), std::string::npos) << stress.out;
}

TEST_F(Words, TablesSayRooflineRatio) {
  const Outcome sim = run("sim" + view_ + "--no-truth"), ladder = run("ladder" + view_ + "--designs dop --no-truth");
  EXPECT_NE(sim.out.find("roofline ratio"), std::string::npos) << sim.out;
  EXPECT_NE(ladder.out.find("roofline ratio"), std::string::npos) << ladder.out;
  EXPECT_NE(ladder.out.find("design point"), std::string::npos) << ladder.out;
}

TEST_F(Words, EveryHelpHasAnExampleAndItsExitCodes) {
  std::vector<std::string> commands = named_in_help(""), studies = named_in_help("study ");
  EXPECT_GE(commands.size(), 15u);
  EXPECT_GE(studies.size(), 6u);
  std::erase(commands, "study");
  for (const std::string& study : studies) commands.push_back("study " + study);
  for (const std::string& command : commands) {
    SCOPED_TRACE(command);
    const Outcome outcome = run(command + " --help");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("Example: pipegs " + command + " "), std::string::npos) << outcome.out;
    const size_t codes = outcome.out.find("\nExit codes: 0 ");
    ASSERT_NE(codes, std::string::npos) << outcome.out;
    const std::string line = outcome.out.substr(codes + 1, outcome.out.find('\n', codes + 1) - codes - 1);
    EXPECT_NE(line.find("2 bad input or bad use, 3 our own failure"), std::string::npos) << line;
    for (const char* word : {"design of the ladder", "twin", "cycles / bound"})
      EXPECT_EQ(outcome.out.find(word), std::string::npos) << word;
  }
  EXPECT_NE(run("study stress --help").out.find("fuzzing with shrinking"), std::string::npos);
  EXPECT_NE(run("sim --help").out.find("design point: gscore"), std::string::npos);
  EXPECT_NE(run("--help").out.find("Exit codes: 0 agrees"), std::string::npos);
}

TEST_F(Words, TheListOfCommandsFitsAScreen) {
  std::istringstream help(run("--help").out);
  int lines = 0;
  for (std::string line; std::getline(help, line); ++lines) EXPECT_LE(line.size(), 80u) << line;
  EXPECT_LE(lines, 24);
}

TEST_F(Words, AnOptionStandsInTheSameGroupOfEveryHelp) {
  std::map<std::string, std::string> group_of;
  std::vector<std::string> commands = named_in_help("");
  for (const std::string& study : named_in_help("study ")) commands.push_back("study " + study);
  for (const std::string& command : commands) {
    std::istringstream help(run(command + " --help").out);
    std::string group;
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with(" ")) group = line;
      if (!line.starts_with("  --")) continue;
      const std::string name = line.substr(2, line.find(' ', 2) - 2);
      EXPECT_EQ(group_of.emplace(name, group).first->second, group) << command << " " << name;
    }
  }
  EXPECT_EQ(group_of.at("--lod"), "Scene:");
  EXPECT_EQ(group_of.at("--cameras"), "Camera:");
  EXPECT_EQ(group_of.at("--set"), "Machine:");
  EXPECT_EQ(group_of.at("--memory"), "Memory:");
  EXPECT_EQ(group_of.at("--out"), "Output:");
}

// All that was given stands in the replay line again, and running that line meets the same mismatch, with waves.
TEST_F(Words, TheReplayLineReplays) {
  write("my machine.cfg", "# one unit of each kind\nunits=1\n");
  fs::copy(folder_ / "scene.ply", folder_ / "it's.ply");
  const std::string given =
      "\"it's.ply\" --cameras cameras.json --config 'my machine.cfg' --near 0.25 --effects all "
      "--memory ideal --latency 50 --jitter 7 --bandwidth 32.5 --seed 9 --design dop "
      "--set pace=4 --set alpha_lines=64 --set records=16 --out pictures";
  const std::string faulty = "PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' ";
  const Outcome first = shell(faulty + "sim " + given);
  ASSERT_EQ(first.code, 1) << first.err;
  const std::string line = behind("replay with waves: ", first);
  for (const char* part :
       {"'it'\\''s.ply'", "--cameras cameras.json", "--config 'my machine.cfg'", "--near 0.25", "--effects all",
        "--memory ideal", "--latency 50", "--jitter 7", "--bandwidth 32.5", "--seed 9", "--design dop",
        "--set alpha_lines=64", "--set records=16", "--out replay --window 1,0 --waves"})
    EXPECT_NE(line.find(part), std::string::npos) << part << " is not in: " << line;
  EXPECT_EQ(line.find("--out pictures"), std::string::npos) << line;
  const Outcome second = shell("PIPEGS_FAULT=pixel " + line);
  EXPECT_EQ(second.code, 1) << second.err;
  EXPECT_EQ(behind(", window 1,0: ", second), behind(", window 1,0: ", first));
  EXPECT_NE(behind(", window 1,0: ", first).find("pixel 66,3"), std::string::npos) << first.err;
  EXPECT_GT(fs::file_size(folder_ / "replay/waves.fst"), 1000u);
}

// Gates write no waves, so the line asks for none.
TEST_F(Words, TheReplayLineOfGatesAsksForNoWaves) {
  const Outcome first = shell("PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' sim" + view_ + "--no-truth --netlist");
  ASSERT_EQ(first.code, 1) << first.err;
  const std::string line = behind("replay with waves: ", first);
  EXPECT_NE(line.find("--netlist"), std::string::npos) << line;
  EXPECT_EQ(line.find("--waves"), std::string::npos) << line;
  EXPECT_EQ(shell("PIPEGS_FAULT=pixel " + line).code, 1);
}

// Waves are an effect: a list that leaves them out gets them.
TEST_F(Words, TheReplayLineOfSomeEffectsHasWaves) {
  std::string names;
  const Json effects = json("effects" + view_);  // taps are one of them
  for (const Json& effect : effects["effects"]) {
    const std::string name = effect["name"];
    if (name != "waves" && name != "dram") names += (names.empty() ? "" : ",") + name;
  }
  const Outcome first =
      shell("PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' sim" + view_ + smallest_ + "--no-truth --effects " + names);
  ASSERT_EQ(first.code, 1) << first.err;
  const std::string line = behind("replay with waves: ", first);
  EXPECT_NE(line.find("--effects " + names + ",waves"), std::string::npos) << line;
  EXPECT_EQ(shell("PIPEGS_FAULT=pixel " + line).code, 1);
  EXPECT_TRUE(fs::exists(folder_ / "replay/waves.fst"));
}

TEST_F(Words, AMachineThatHangsIsReplayedToo) {
  const Outcome first =
      shell("PIPEGS_FAULT=hang '" PIPEGS_FAULTY "' sim" + view_ + smallest_ + "--no-truth --window 1,0");
  ASSERT_EQ(first.code, 1) << first.err;
  const std::string line = behind("replay with waves: ", first);
  EXPECT_NE(line.find("--window 1,0"), std::string::npos) << line;
  EXPECT_EQ(shell("PIPEGS_FAULT=hang " + line).code, 1);
  EXPECT_GT(fs::file_size(folder_ / "replay/waves.fst"), 1000u) << "what led to it";
}

// The view that fails is written, and its line shows the same failure.
TEST_F(Words, TheReplayLineOfFuzzingReplays) {
  const Outcome first =
      shell("PIPEGS_FAULT=pixel '" PIPEGS_FAULTY "' study stress --count 1 --size 40x30 --gaussians 3");
  ASSERT_EQ(first.code, 1) << first.err;
  const size_t at = first.out.find("replay: ");
  ASSERT_NE(at, std::string::npos) << first.out;
  const std::string line = first.out.substr(at + 8, first.out.find('\n', at) - at - 8);
  EXPECT_EQ(shell("PIPEGS_FAULT=pixel " + line).code, 1) << line;
  EXPECT_EQ(shell("PIPEGS_FAULT=none " + line).code, 0) << line;
}

}  // namespace
}  // namespace pipegs
