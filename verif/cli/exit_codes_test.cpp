// SPDX-License-Identifier: Apache-2.0
// exit_codes_test: 0 agrees, 1 differs, 2 bad input or bad use, 3 our own failure: of every command that can end so.
//
// Idea    A machine that differs is `pipegs_faulty` (faulty_rtl.cpp); a full disk is a limit on the size of files, a
//         full memory one on the process (ulimit). Disk, memory and standard output are the real ones.
#include <fmt/format.h>

#include "verif/cli/cli.hpp"
#include "verif/effects/effect_views.hpp"

namespace pipegs {
namespace {

class ExitCodes : public Cli {
 protected:
  Outcome faulty(const std::string& fault, const std::string& arguments) {
    return shell("PIPEGS_FAULT=" + fault + " '" PIPEGS_FAULTY "' " + arguments);
  }
  // Every command that runs the default machine, so that nothing is built.
  std::vector<std::string> runs() const {
    return {"sim" + view_ + "--no-truth", "explain" + view_ + "--pixel 66,3",
            "ladder" + view_ + "--designs dop --no-truth", "model" + view_ + "--design dop --check",
            "study stress --count 1 --size 40x30 --gaussians 3"};
  }
};

TEST_F(ExitCodes, ZeroWhenAllAgrees) {
  for (const std::string& arguments : runs()) {
    const Outcome outcome = faulty("none", arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err << outcome.out;
  }
}

TEST_F(ExitCodes, OneWhenAPixelDiffers) {
  for (const std::string& arguments : runs()) {
    const Outcome outcome = faulty("pixel", arguments);
    EXPECT_EQ(outcome.code, arguments.starts_with("model") ? 0 : 1)  // it compares cycles and bytes, no pixel
        << arguments << "\n"
        << outcome.err << outcome.out;
  }
}

TEST_F(ExitCodes, ThePictureIsWhatTheMachineHasWritten) {
  ASSERT_EQ(run("render" + view_ + "--out golden").code, 0);
  ASSERT_EQ(faulty("none", "sim" + view_ + "--no-truth --out good").code, 0);
  ASSERT_EQ(faulty("pixel", "sim" + view_ + "--no-truth --out bad").code, 1);
  for (const std::string file : {"/frame.png", "/frame.exr"}) {
    EXPECT_EQ(text("good" + file), text("golden" + file)) << file;
    EXPECT_NE(text("bad" + file), text("golden" + file)) << file;
  }
}

TEST_F(ExitCodes, OneWhenTheMachineHangs) {
  for (const std::string& arguments : runs()) {
    const Outcome outcome = faulty("hang", arguments);
    EXPECT_EQ(outcome.code, 1) << arguments << "\n" << outcome.err;
    EXPECT_NE((outcome.err + outcome.out).find("the machine hangs"), std::string::npos) << arguments << outcome.err;
  }
}

// Where both part is told: the first unit and the cycle.
TEST_F(ExitCodes, OneWhenTheTimingModelDiffersByOneCycle) {
  EXPECT_EQ(faulty("none", "model" + view_ + "--check").code, 0);
  const Outcome text = faulty("cycles", "model" + view_ + "--check"),
                json = faulty("cycles", "model" + view_ + "--check --json");
  EXPECT_EQ(text.code, 1) << text.err;
  EXPECT_NE(text.out.find("differs"), std::string::npos) << text.out;
  EXPECT_EQ(json.code, 1) << json.err;
  EXPECT_FALSE(Json::parse(json.out)["designs"][0]["differences"].empty());
  EXPECT_NE(text.out.find("    cycles: RTL "), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("    they part in cycle "), std::string::npos) << text.out;
  const Json first = Json::parse(json.out)["designs"][0]["first_difference"];
  ASSERT_TRUE(first.is_object()) << json.out;
  EXPECT_GT(first["cycle"], 0);
  EXPECT_EQ(first["rtl"], "nothing");
  EXPECT_TRUE(first["unit"].get<std::string>().starts_with("PU ")) << first;
  EXPECT_EQ(first["model"], "takes a chunk");
}

// Gates are held against the timing model in time as well, the first event in which they part is named.
TEST_F(ExitCodes, OneWhenGatesTakeAnotherCycle) {
  const std::string gates = "sim" + view_ + "--no-truth --netlist --json --out gates";
  const Outcome none = faulty("none", gates), cycles = faulty("cycles", gates);
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_EQ(faulty("cycles", "sim" + view_ + "--no-truth").code, 0) << "a run without gates compares no cycles";
  EXPECT_EQ(cycles.code, 1) << cycles.err;
  EXPECT_EQ(Json::parse(cycles.out)["mismatches"], 1);
  const uint64_t taken = Json::parse(none.out)["cycles"];
  EXPECT_NE(cycles.err.find(fmt::format("gates take {} cycles, RTL {} ", taken + 1, taken)), std::string::npos);
  EXPECT_NE(cycles.err.find("they part in cycle "), std::string::npos) << cycles.err;
  EXPECT_NE(cycles.err.find(": gates nothing, RTL takes a chunk\n"), std::string::npos) << cycles.err;
}

// The view of verif/effects whose machine without all effects is built for its tests.
TEST_F(ExitCodes, OneWhenAMachineOfEffectsDiffers) {
  write_ply(folder_ / "quiet.ply", quiet_scene());
  write_cameras(folder_ / "quiet.json", {test_camera(128, 64)});
  const std::string lean =
      "sim quiet.ply --cameras quiet.json --design dop --memory ideal --jitter 0 --no-truth --effects auto --json ";
  const Outcome none = faulty("none", lean);
  EXPECT_EQ(none.code, 0) << none.err << none.out;
  const Outcome pixel = faulty("pixel", lean);
  EXPECT_EQ(pixel.code, 1) << pixel.err;
  EXPECT_NE(pixel.err.find("the machine is wrong"), std::string::npos) << pixel.err;
  EXPECT_GT(Json::parse(pixel.out)["mismatches"], 0);
  EXPECT_EQ(faulty("hang", lean).code, 1);
}

TEST_F(ExitCodes, OneWhenAnErrorIsBeyondItsBound) {
  const Outcome none = faulty("none", "study budget --count 100"), beyond = faulty("bound", "study budget --count 100");
  EXPECT_EQ(none.code, 0) << none.out;
  EXPECT_NE(none.out.find("beyond the bound: 0"), std::string::npos) << none.out;
  EXPECT_EQ(beyond.code, 1) << beyond.out;
  EXPECT_NE(beyond.out.find("beyond the bound: 1"), std::string::npos) << beyond.out;
  EXPECT_EQ(Json::parse(faulty("bound", "study budget --count 100 --json").out)["beyond_bound"], 1);
}

TEST_F(ExitCodes, OneWhenAPictureDiffers) {
  ASSERT_EQ(run("render" + view_ + "--out golden").code, 0);
  EXPECT_EQ(run("render" + view_ + "--out again --compare golden/frame.png").code, 0);
  const Outcome outcome = run("render" + view_ + "--near 2 --out near --compare golden/frame.png");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("pixels differ"), std::string::npos) << outcome.out;
}

TEST_F(ExitCodes, TwoForWhatTheMachineCannotHold) {
  write("flat.json", R"([{"id":0,"img_name":"a","width":70,"height":50,"position":[0,0,0],)"
                     R"("rotation":[[1,0,0],[0,1,0],[0,0,1]],"fx":1e-9,"fy":50}])");
  expect_refused("sim scene.ply --cameras flat.json", "fx");
  expect_refused("model scene.ply --cameras flat.json", "fx");
  expect_refused("sim" + view_ + "--memory nothing", "--memory: nothing not in {lpddr5");
  expect_refused("sim" + view_ + "--waves --netlist", "--waves: the netlist writes none");
  expect_refused("sim" + view_ + "--page --netlist", "--page excludes --netlist");
  expect_refused("sim" + view_ + "--netlist --gates ru,pus",
                 "--gates: found ru,pus, expected some of dopu, pu, su, ru");
  expect_refused("ladder" + view_ + "--set taps=0", "taps=1");
}

TEST_F(ExitCodes, TwoForANameThatIsNotUtf8) {
  fs::copy(folder_ / "scene.ply", folder_ / "sc\xe8ne.ply");
  expect_refused("sim 'sc\xe8ne.ply' --cameras cameras.json --no-rtl",
                 "argument 2: found \"sc\\ufffdne.ply\", expected text in UTF-8");
  expect_refused("info 'sc\xe8ne.ply'", "UTF-8");
}

TEST_F(ExitCodes, TwoForBadUse) {
  expect_one_line(run(""), 2, "found nothing, expected a command: sim, render, explain");
  expect_one_line(run("simm"), 2, "found 'simm' (nearest: sim), expected a command: sim, render, explain");
  expect_one_line(run("study"), 2, "found nothing, expected a study: tradeoff, shapes, rivals");
  expect_one_line(run("study shape"), 2, "found 'shape' (nearest: shapes), expected a study: tradeoff, shapes, rivals");
  expect_one_line(run("sim --nonsense"), 2, "--nonsense");
  expect_one_line(run("explain" + view_), 2, "--pixel is required");
  expect_one_line(run("sim --out"), 2, "--out");
}

TEST_F(ExitCodes, TwoForAPictureThatDoesNotFitInMemory) {
  write("huge.json", R"([{"id":0,"img_name":"wall","width":16384,"height":16384,"position":[0,0,0],)"
                     R"("rotation":[[1,0,0],[0,1,0],[0,0,1]],"fx":9000,"fy":9000}])");
  const std::string view = " scene.ply --cameras huge.json ";
  for (const std::string& arguments :
       {"sim" + view, "sim" + view + "--no-rtl --no-truth", "render" + view, "explain" + view + "--pixel 1,1",
        "ladder" + view, "study profile" + view, "accuracy" + view, "study tradeoff" + view, "effects" + view,
        "silicon" + view, "model" + view + "--check", std::string("study stress --size 16384x16384")}) {
    SCOPED_TRACE(arguments);
    expect_one_line(run(arguments, "ulimit -v 4000000; "), 2, "16384x16384 pixels would take ");
  }
  EXPECT_NE(text("err.txt").find(" bytes ("), std::string::npos) << text("err.txt");
  EXPECT_EQ(left_behind(), std::vector<std::string>{"huge.json"});
}

TEST_F(ExitCodes, ThreeWhenAMachineDoesNotBuild) {
  const std::string nothing = "PATH=/nowhere ", other = "--set alpha_lines=128 ";
  const auto expect_three = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments, nothing);
    EXPECT_EQ(outcome.code, 3) << arguments << "\n" << outcome.err;
    EXPECT_NE((outcome.err + outcome.out).find("does not build"), std::string::npos) << outcome.err;
  };
  expect_three("sim" + view_ + other + "--no-truth");
  expect_three("sim" + view_ + other + "--no-truth --effects layers");
  expect_three("explain" + view_ + other + "--pixel 1,1");
  expect_three("model" + view_ + other + "--check");
  expect_three("study stress --count 1 --set alpha_lines=128");
  expect_three("ladder" + view_ + other + "--designs dop --no-truth");
}

TEST_F(ExitCodes, ThreeWhenThereIsNoMemory) {
  expect_one_line(run("study budget --count 2000000", "ulimit -v 150000; "), 3, "out of memory");
  for (const std::string& arguments : runs()) EXPECT_EQ(faulty("memory", arguments).code, 3) << arguments;
}

TEST_F(ExitCodes, ThreeForABug) {
  expect_one_line(faulty("bug", "sim" + view_ + "--no-truth"), 3, "a bug of ours: a promise is broken");
}

TEST_F(ExitCodes, ThreeWhenStandardOutputCannotBeWritten) {
  const Outcome outcome = shell("'" PIPEGS_BINARY "' info scene.ply > /dev/full");
  expect_one_line(outcome, 3, "standard output cannot be written");
}

// Files of at most a few blocks: what is larger fails as on a full disk.
TEST_F(ExitCodes, ThreeWhenTheDiskIsFull) {
  const std::string full = "trap '' XFSZ; ulimit -f 8; ";
  for (const std::string& arguments : {"render" + view_ + "--out pictures", std::string("convert scene.ply --out copy"),
                                       "sim" + view_ + "--no-truth --no-rtl --out pictures"}) {
    SCOPED_TRACE(arguments);
    expect_one_line(run(arguments, full), 3, "cannot write");
  }
  for (const std::string& name : left_behind())
    EXPECT_TRUE(fs::is_directory(folder_ / name)) << "half-written: " << name;
}

}  // namespace
}  // namespace pipegs
