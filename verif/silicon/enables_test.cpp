// SPDX-License-Identifier: Apache-2.0
// enables_test: functions of enables against plain bits, and waves by hand of which every passed edge is known.
#include "sim/silicon/energy/enables.hpp"

#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "scenes/input_error.hpp"
#include "sim/silicon/energy/activity.hpp"

namespace pipegs {
namespace {

using Kind = GatedModule::Kind;

TEST(Enables, EvaluatesEachOperationIn64CyclesAtOnce) {
  GatedModule module;
  module.leaves = {{"a", 0}, {"b", 0}, {"c", 0}};
  module.operations = {{Kind::kAnd, {2, 3, 0}},  {Kind::kOr, {2, 3, 0}},  {Kind::kXor, {2, 3, 0}},
                       {Kind::kXnor, {2, 3, 0}}, {Kind::kNot, {2, 0, 0}}, {Kind::kMux, {2, 3, 4}},
                       {Kind::kOr, {5, 10, 0}},  {Kind::kAnd, {1, 2, 0}}};
  std::mt19937_64 random(7);
  const uint64_t leaves[] = {random(), random(), random()};
  std::vector<uint64_t> nodes;
  module.evaluate(leaves, nodes);
  ASSERT_EQ(nodes.size(), static_cast<size_t>(module.nodes()));
  for (int i = 0; i < 64; ++i) {
    const auto bit = [&](uint64_t word) { return (word >> i & 1) != 0; };
    const bool a = bit(leaves[0]), b = bit(leaves[1]), c = bit(leaves[2]);
    const bool expected[] = {
        false, true, a, b, c, a && b, a || b, a != b, a == b, !a, a ? b : c, (a && b) || (a ? b : c), a};
    for (size_t node = 0; node < nodes.size(); ++node)
      EXPECT_EQ(bit(nodes[node]), expected[node]) << node << " of " << i;
  }
  EXPECT_EQ(module.known({true, false, true}),
            (std::vector<bool>{true, true, true, false, true, false, false, false, false, true, false, false, true}));
}

// A stage with two gates, one with an enable over two signals of which one stands in a block of its own.
class EnabledWaves : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  static Enables enables() {
    GatedModule stage;
    stage.leaves = {{"load", 0}, {"gen_part[0].hold_q", 1}, {"data_q", 0}, {"gone", 0}};
    stage.operations = {{Kind::kNot, {3, 0, 0}}, {Kind::kAnd, {2, 6, 0}}};  // load && !hold_q[1]
    stage.gates = {{7, 4, 8, 1e-12}, {5, GatedModule::kUnknown, 3, 1e-12}, {GatedModule::kUnknown, 4, 2, 1e-12}};
    stage.clock_gates = 3;
    Enables enables;
    enables.modules = {{"stage", stage}};
    enables.instances = {{"u_part.u_stage", "stage"}};
    return enables;
  }
  // Cycle by cycle: whether the stage has its clock, load, hold_q, and data_q behind the edge.
  struct Cycle {
    bool clocked, load;
    const char *hold, *data;
    bool reset = false;  // it falls with the clock of the cycle before
  };
  Activity activity(const std::vector<Cycle>& cycles, const Enables& enables) {
    void* const file = fstWriterCreate(path_.c_str(), 1);
    const auto var = [&](const char* name, uint32_t bits) {
      return fstWriterCreateVar(file, FST_VT_VCD_WIRE, FST_VD_IMPLICIT, bits, name, 0);
    };
    for (const char* scope : {"TOP", "u_core"}) fstWriterSetScope(file, FST_ST_VCD_MODULE, scope, nullptr);
    const fstHandle reset = var("rst_ni", 1);
    for (const char* scope : {"u_part", "u_stage"}) fstWriterSetScope(file, FST_ST_VCD_MODULE, scope, nullptr);
    const fstHandle clock = var("clk_i", 1), load = var("load", 1), data = var("data_q", 1);
    fstWriterSetScope(file, FST_ST_VCD_MODULE, "gen_part[0]", nullptr);
    const fstHandle hold = var("hold_q [1:0]", 2);
    for (int i = 0; i < 5; ++i) fstWriterSetUpscope(file);
    const auto set = [&](fstHandle handle, const char* value) { fstWriterEmitValueChange(file, handle, value); };
    uint64_t time = 0;
    for (size_t i = 0; i < cycles.size(); ++i) {
      const Cycle& cycle = cycles[i];
      fstWriterEmitTimeChange(file, time), time += 5;
      set(clock, "0"), set(load, cycle.load ? "1" : "0"), set(hold, cycle.hold);
      if (time == 5) set(data, "0"), set(reset, cycle.reset ? "0" : "1");
      fstWriterEmitTimeChange(file, time), time += 5;
      if (cycle.clocked) set(clock, "1");
      set(data, cycle.data), set(load, cycle.load ? "0" : "1");  // what follows the edge is not what it has sampled
      if (i + 1 < cycles.size()) set(reset, cycles[i + 1].reset ? "0" : "1");
    }
    fstWriterEmitTimeChange(file, time);
    fstWriterClose(file);
    return read_activity(
        path_, [](const std::string&) { return "part"; }, enables);
  }
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("pipegs_enables_" + std::to_string(getpid()) + ".fst");
};

TEST_F(EnabledWaves, CountsTheEdgesThatPass) {
  const Activity sum = activity({{true, true, "01", "1"},   // passes
                                 {true, true, "10", "1"},   // hold
                                 {false, true, "00", "1"},  // without a clock
                                 {true, false, "00", "1"},  // no load
                                 {true, true, "00", "0"}},  // passes
                                enables());
  ASSERT_EQ(sum.enabled.size(), 1u);
  const Enabled& stage = sum.enabled.at("part").at("stage");
  EXPECT_EQ(stage.edges, 4u);
  EXPECT_EQ(stage.passed, (std::vector<uint64_t>{2, 4, 4})) << "what is not seen counts as high";
  EXPECT_EQ(sum.unseen, (std::map<std::string, uint64_t>{{"part", 5}}));
}

TEST_F(EnabledWaves, FindsABitThatMovesBehindAClosedGate) {
  EXPECT_THROW(activity({{true, false, "00", "1"}, {true, false, "00", "1"}}, enables()), InputError);
  Enables other = enables();
  other.instances = {{"u_part.u_other", "stage"}};
  EXPECT_THROW(activity({{true, true, "00", "1"}}, other), InputError) << "no such instance in the waves";
}

// It moves bits past closed gates, with a clock or without one; before and behind it all is as ever.
TEST_F(EnabledWaves, LeavesOutWhatAResetDoes) {
  const auto edges = [&](const std::vector<Cycle>& cycles) {
    return activity(cycles, enables()).enabled.at("part").at("stage").edges;
  };
  const Cycle stands = {true, false, "00", "1"};
  EXPECT_EQ(edges({{true, false, "00", "1", true}, {true, false, "00", "1", true}, stands, stands}), 2u);
  EXPECT_EQ(edges({{true, true, "00", "1"}, stands, {false, false, "00", "0", true}, {true, false, "00", "0"}}), 3u);
  EXPECT_EQ(edges({{true, true, "00", "1"}, {true, false, "00", "0"}, {false, false, "00", "0", true}}), 2u);
  EXPECT_THROW(edges({{true, false, "00", "1", true}, {true, false, "00", "0"}, {true, false, "00", "0"}}), InputError);
}

class EnablesFile : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  void expect_refused(const std::string& text, const std::string& part) {
    std::ofstream(path_) << text;
    try {
      read_enables(path_, Config{});
      ADD_FAILURE() << "accepted: " << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
  static std::string file(const std::string& operations, const std::string& gates, const std::string& instances) {
    return R"({"configuration":"default","program":"0","gate_j":1e-13,"instances":{)" + instances +
           R"(},"modules":{"stage":{"leaves":[["genblk3.load",2]],"operations":[)" + operations + R"(],"gates":[)" +
           gates + R"(],"clock_gates":1,"always":[2,3e-13]}}})";
  }
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("pipegs_enables_" + std::to_string(getpid()) + ".json");
};

TEST_F(EnablesFile, IsReadOrRefused) {
  std::ofstream(path_) << file(R"(["not",2])", "[3,null,64,2e-11]", R"("u_a.genblk1.u_b":"stage")");
  const Enables enables = read_enables(path_, Config{});
  const GatedModule& stage = enables.modules.at("stage");
  EXPECT_EQ(stage.leaves.at(0).name, "load") << "waves do not show what Yosys names";
  EXPECT_EQ(enables.instances.begin()->first, "u_a.u_b");
  EXPECT_EQ(stage.gates.at(0).enable, 3);
  EXPECT_EQ(stage.gates.at(0).held, GatedModule::kUnknown);
  EXPECT_EQ(stage.gates.at(0).flipflops, 64);
  expect_refused(file(R"(["nand",2,2])", "", ""), "expected an operation");
  expect_refused(file(R"(["and",2])", "", ""), "expected an operation");
  expect_refused(file(R"(["not",3])", "", ""), "expected an integer from 0 to 2");
  expect_refused(file("", "[3,null,64,1]", ""), "expected an integer from 0 to 2");
  expect_refused(file("", "[2,null,-1,1]", ""), "found '-1'");
  expect_refused(file("", "[2,null,1]", ""), "expected what `make synth` writes");
  expect_refused(file("", "", R"("u_a":"other")"), "no module 'other'");
  expect_refused("{}", "expected what `make synth` writes");
  std::string other = file("", "", "");
  other.replace(other.find("default"), 7, "units=2");
  expect_refused(other, "found 'units=2', expected default");
  std::filesystem::remove(path_);
  EXPECT_THROW(read_enables(path_, Config{}), InputError);
}

}  // namespace
}  // namespace pipegs
