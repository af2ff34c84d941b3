// SPDX-License-Identifier: Apache-2.0
// config_test: `pipegs config` says of every key what config.def says; and every command names the key nearest to one
// that does not exist.
#include "cpp_model/config.hpp"
#include "sim/design/design_point.hpp"
#include "verif/cli/cli.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;

class ConfigCommand : public Cli {
 protected:
  Json json(const std::string& arguments) {
    const Outcome outcome = run(arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }
  static Json of(const Json& entries, std::string_view key) {
    for (const Json& entry : entries) {
      if (entry["key"] == key) return entry;
    }
    ADD_FAILURE() << key << " is not listed";
    return {};
  }
};

TEST_F(ConfigCommand, EveryEntryIsListedAsInTheTable) {
  const Json keys = json("config")["entries"], all = json("config --all")["entries"];
  const Outcome outcome = run("config");
  size_t free = 0;
  for (const ConfigEntry& entry : config_entries(find_design_point(kDefaultDesignPoint).config)) {
    SCOPED_TRACE(entry.name);
    const bool is_key = entry.member != nullptr;
    const Json found = of(is_key ? keys : all, entry.name);
    EXPECT_EQ(found["value"], entry.value);
    EXPECT_EQ(found["meaning"], entry.what);
    EXPECT_EQ(found["unit"], entry.unit);
    EXPECT_EQ(found["in_systemverilog"], entry.camel_name);
    EXPECT_EQ(found["may_be_set"], is_key);
    EXPECT_EQ(found["low"], is_key ? Json(entry.low) : Json(nullptr));
    EXPECT_EQ(found["high"], is_key ? Json(entry.high) : Json(nullptr));
    if (!is_key) continue;
    ++free;
    EXPECT_FALSE(entry.unit.empty());
    EXPECT_FALSE(entry.what.empty());
    const size_t at = outcome.out.find("\n  " + std::string(entry.name) + " ");
    ASSERT_NE(at, std::string::npos) << outcome.out;
    const std::string line = outcome.out.substr(at + 1, outcome.out.find('\n', at + 1) - at - 1);
    for (const std::string& part : {std::to_string(entry.low) + " to " + std::to_string(entry.high),
                                    std::to_string(entry.value), std::string(entry.unit)})
      EXPECT_NE(line.find(" " + part), std::string::npos) << part << " is not in: " << line;
  }
  EXPECT_EQ(keys.size(), free);
  EXPECT_EQ(all.size(), config_entries(Config{}).size());
}

TEST_F(ConfigCommand, TheListIsReadableOnATerminal) {
  const Outcome outcome = run("config --all");
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
}

TEST_F(ConfigCommand, ValuesAreThoseOfTheMachine) {
  EXPECT_EQ(of(json("config --design exact --set alpha_w=9")["entries"], "alpha_w")["value"], 9);
  EXPECT_EQ(of(json("config --design exact --set alpha_w=9")["entries"], "bucket_bits")["value"], 5);
  write("my.cfg", "grid=8\n");
  EXPECT_EQ(json("config grid --config my.cfg")["value"], 8);
}

TEST_F(ConfigCommand, OneEntryInFull) {
  const Json window = json("config window");
  EXPECT_EQ(window["value"], 128);
  EXPECT_EQ(window["low"], 16);
  EXPECT_EQ(window["unit"], "pixel");
  EXPECT_EQ(window["design_points"].size(), design_points().size());
  EXPECT_EQ(window["design_points"]["gscore"], 16);
  const auto moves = window["moves"].get<std::vector<std::string>>();
  for (const char* name : {"parts", "regions", "mask_w"})
    EXPECT_NE(std::find(moves.begin(), moves.end(), name), moves.end()) << name;
  EXPECT_EQ(std::find(moves.begin(), moves.end(), "alpha_max"), moves.end());
  EXPECT_EQ(json("config parts")["follows_from"], Json({"window", "eyes"}));
  EXPECT_EQ(json("config Window"), window) << "the name in SystemVerilog";
  const Outcome outcome = run("config window");
  for (const char* part : {"16 to 128", "pixel", "side of a window", "gscore 16", "pipegs_pkg::Window", "128 in fast"})
    EXPECT_NE(outcome.out.find(part), std::string::npos) << part << " is not in:\n" << outcome.out;
}

TEST_F(ConfigCommand, FilesHoldTheSame) {
  const Json printed = json("config --out found");
  EXPECT_EQ(printed, Json::parse(text("found/config.json")));
  EXPECT_TRUE(text("found/config.csv").starts_with("key,value,default,range,unit,meaning\nunits,4,4,1 to 8,units,"));
}

TEST_F(ConfigCommand, WhatIsUnknownIsToldWithTheNearest) {
  expect_refused("config widow", "KEY: unknown key 'widow'; nearest: window");
  expect_refused("config unitz", "nearest: units");
  expect_refused("config sh_degre", "nearest: sh_degree");
  expect_refused("config --set units=3", "units = 3, expected a power of two");
  expect_refused("config --design fastest", "unknown design point 'fastest'");
  const Outcome hostile = run("config $(head -c 100000 /dev/zero | tr '\\0' x)");
  expect_one_line(hostile, 2, "unknown key 'xxx");
  EXPECT_LT(hostile.err.size(), 300u);
  for (const char* command : {"sim scene.ply --no-rtl", "model scene.ply", "study budget"})
    expect_refused(std::string(command) + " --set alphaw=8", "--set: unknown key 'alphaw'; nearest: alpha_w");
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
}

}  // namespace
}  // namespace pipegs
