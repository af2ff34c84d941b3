// SPDX-License-Identifier: Apache-2.0
// options_test: a number on the command line is read whole or refused, in every option that takes one; a list has all
// of its elements, and a name, a key and an option come once.
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

class Options : public Cli {
 protected:
  const std::string view_ = " scene.ply --cameras cameras.json ";

  void expect_no(const std::string& command, const std::string& option, const std::vector<std::string>& values) {
    for (const std::string& value : values)
      expect_refused(command + option + " '" + value + "'", option.substr(option.rfind(' ') + 1) + ":");
  }
};

const std::vector<std::string> kNoInteger = {"12abc", "abc", "",    " 1",  "1 ",  "1.5", "1e3",
                                             "0x10",  "--1", "+-1", "nan", "inf", "-1",  "99999999999999999999"};
const std::vector<std::string> kNoReal = {"1.5abc", "abc", "",     " 1",    "1 ",  "0x1p3", "--1",
                                          "nan",    "inf", "-inf", "1e999", "1,5", "-1"};

TEST_F(Options, IntegersAreReadWhole) {
  const std::string sim = "sim" + view_ + "--no-rtl --no-truth ";
  for (const std::string option : {"--view", "--seed", "--latency", "--jitter"}) expect_no(sim, option, kNoInteger);
  for (const std::string option : {"--seed", "--count", "--gaussians"})
    expect_no("study stress --no-rtl ", option, kNoInteger);
  for (const std::string option : {"--seed", "--count"}) expect_no("study budget ", option, kNoInteger);
  expect_no("accuracy" + view_, "--points", kNoInteger);
  expect_no("study tradeoff" + view_, "--together", kNoInteger);
  expect_no("study shapes" + view_, "--runs", kNoInteger);
}

TEST_F(Options, RealNumbersAreReadWhole) {
  const std::string sim = "sim" + view_ + "--no-rtl --no-truth ";
  for (const std::string option : {"--near", "--bandwidth"}) expect_no(sim, option, kNoReal);
  expect_no("study tradeoff" + view_, "--ghz", kNoReal);
  expect_no("study shapes" + view_, "--area", kNoReal);
  expect_no("study rivals" + view_, "--voxel", kNoReal);
  expect_refused(sim + "--near 0", "--near: found '0', expected a number above 0");
}

TEST_F(Options, PlacesAreTwoWholeNumbers) {
  const std::vector<std::string> no_place = {"1",     "1,2,3", "1,",   ",1",  "1,2x",
                                             "1.0,2", "-1,0",  "0,-1", "1;2", "99999999999,1"};
  const auto expect_no_place = [&](const std::string& command, const std::string& option) {
    for (const std::string& value : no_place) expect_refused(command + option + " '" + value + "'", option);
  };
  expect_no_place("sim" + view_ + "--no-rtl --no-truth ", "--window");
  expect_no_place("explain" + view_ + "--no-rtl ", "--pixel");
}

TEST_F(Options, SizesAndDecibelsAreReadWhole) {
  for (const char* size :
       {"160", "x", "160x", "x120", "160x120x3", "160x120a", "-1x5", "0x5", "1.5x2", "16385x1", "160X120"})
    expect_refused(std::string("study stress --no-rtl --count 1 --size '") + size + "'", "--size: found '");
  for (const char* target : {"dB", "60dBm", "60dB dB", "x60dB", "nan", "infdB", "-3dB", "0dB", "201dB", "60 dB"})
    expect_refused("accuracy" + view_ + "--target '" + target + "'", "--target: found '");
}

// Decimal is what a person means: 010 is ten.
TEST_F(Options, NumbersAreDecimal) {
  const Outcome outcome = run("sim" + view_ +
                              "--no-truth --no-rtl --memory ideal --latency 010 --jitter +3 --seed "
                              "18446744073709551615 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto config = nlohmann::json::parse(outcome.out)["config"];
  EXPECT_EQ(config["memory_latency"], 10);
  EXPECT_EQ(config["memory_jitter"], 3);
  EXPECT_EQ(config["seed"], 18446744073709551615ull);
}

TEST_F(Options, RestIsForMachinesWhosePixelsStop) {
  expect_refused("model" + view_ + "--rest 0.1 --set early_stop=0", "--rest: found no machine whose pixels stop");
  expect_refused("model" + view_ + "--rest 1", "--rest: found '1', expected a number");
  expect_refused("pack" + view_ + "--rest 0.1", "--rest: found one, expected none");
  EXPECT_EQ(run("model" + view_ + "--rest 0.1").code, 0);
}

// Where no machine walks windows part by part there is nothing that it could say.
TEST_F(Options, WalkMostIsForMachinesWithWalks) {
  const std::string refused = "--walk-most: found no machine that walks windows part by part";
  for (const char* machine : {"--design dop", "--design exact", "--set window=64"})
    expect_refused("sim" + view_ + "--no-rtl --no-truth --walk-most 5 " + machine, refused);
  expect_refused("model" + view_ + "--walk-most 5 --designs dop,exact", refused);
  expect_refused("what-if" + view_ + "--walk-most 5 --design dop --set units=2", refused);
  expect_refused("pack" + view_ + "--walk-most 5", "--walk-most: found one, expected none");
  for (const char* line : {"sim --no-rtl --no-truth --out pictures", "model --designs dop,fast",
                           "what-if --design exact --set window=128,quads=1"}) {
    const std::string words = line, command = words.substr(0, words.find(' '));
    const Outcome outcome = run(command + view_ + "--walk-most 5" + words.substr(command.size()));
    EXPECT_EQ(outcome.code, 0) << line << ": " << outcome.err;
  }
}

// Every option that takes a list, with two elements of it.
TEST_F(Options, NoElementOfAListIsEmpty) {
  struct List {
    std::string command, option, one, other;
  };
  const std::vector<List> lists = {
      {"ladder" + view_, "--designs", "dop", "late"},     {"model" + view_, "--designs", "dop", "late"},
      {"silicon" + view_, "--designs", "dop", "late"},    {"accuracy" + view_, "--knobs", "alpha_w", "rgb_w"},
      {"what-if" + view_, "--set", "units=2", "tests=1"}, {"sim" + view_ + "--no-rtl", "--effects", "layers", "taps"},
      {"sim" + view_ + "--no-rtl", "--window", "0", "0"}, {"explain" + view_, "--pixel", "1", "1"}};
  for (const auto& [command, option, one, other] : lists) {
    for (const std::string& list : {one + ",," + other, "," + one + "," + other, one + "," + other + ",",
                                    std::string(","), std::string(), one + ","}) {
      expect_refused(command + " " + option + " '" + list + "'",
                     option + ": found '" + list + "', expected elements by commas, none of them empty");
    }
    expect_refused(command + " " + option + " " + one + " " + other, "");  // one word is one list
    expect_refused(command + " " + option + " '" + one + ", " + other + "'", " " + other);
  }
}

TEST_F(Options, WhatIsNamedComesOnce) {
  expect_refused("sim" + view_ + "--no-rtl --seed 1 --seed 2", "--seed");
  expect_refused("sim" + view_ + "--no-rtl --near 1 --near 2", "--near");
  expect_refused("sim" + view_ + "--no-rtl --out a --out b", "--out");
  expect_refused("sim" + view_ + "--no-rtl --window 0,0 --window 1,0", "--window");
  expect_refused("sim" + view_ + "--no-rtl --set grid=4 --set units=2 --set grid=4", "--set: found a second 'grid'");
  expect_refused("study budget --set alpha_w=8 --set alpha_w=9", "--set: found a second 'alpha_w'");
  expect_refused("sim" + view_ + "--no-rtl --effects taps,layers,taps", "--effects: found a second 'taps'");
  expect_refused("accuracy" + view_ + "--knobs rgb_w,rgb_w", "--knobs: found a second 'rgb_w'");
  expect_refused("ladder" + view_ + "--designs dop --designs late", "--designs");
  expect_refused("ladder" + view_ + "--designs dop,late,dop", "--designs: found a second 'dop'");
}

}  // namespace
}  // namespace pipegs
