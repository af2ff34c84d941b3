// SPDX-License-Identifier: Apache-2.0
// activity_test: waves that are written by hand, of which every toggle, edge and access is known.
#include "sim/silicon/energy/activity.hpp"

#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>
#include <unistd.h>

#include <fstream>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

class ActivityTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  fstHandle var(const char* name, uint32_t bits, fstHandle alias = 0) {
    return fstWriterCreateVar(file_, FST_VT_VCD_WIRE, FST_VD_IMPLICIT, bits, name, alias);
  }
  void scope(const char* name) { fstWriterSetScope(file_, FST_ST_VCD_MODULE, name, nullptr); }
  void up() { fstWriterSetUpscope(file_); }
  void set(fstHandle handle, const char* value) { fstWriterEmitValueChange(file_, handle, value); }
  // Two units with a counter of two bits; the first has an SRAM behind a gated clock.
  void write() {
    file_ = fstWriterCreate(path_.c_str(), 1);
    scope("TOP"), scope("host");
    const fstHandle clock = var("clk_i", 1), enable = var("start", 1);
    scope("u_core");
    var("clk_i", 1, clock), var("enable", 1, enable);
    scope("u_gate");
    const fstHandle gated = var("clk_o", 1);
    up();
    scope("u_one");
    const fstHandle count = var("count_q [1:0]", 2);
    scope("u_store");
    var("clk_i", 1, gated), var("write_i", 1, enable);
    const fstHandle read = var("read_i", 1), data = var("rdata_o [3:0]", 4);
    up(), up();
    scope("u_two");
    var("count_i [1:0]", 2, count);
    const fstHandle own = var("own_q", 1);
    up(), up();
    scope("u_border");
    const fstHandle outside = var("outside_q", 1);
    up(), up(), up();
    const char* counts[] = {"00", "01", "10", "11"};
    for (int cycle = 0; cycle < 4; ++cycle) {  // the gated clock ticks in cycles 1 to 3
      fstWriterEmitTimeChange(file_, static_cast<uint64_t>(10 * cycle));
      set(clock, "0"), set(gated, "0"), set(enable, cycle == 2 ? "1" : "0");
      if (cycle == 0) set(read, "1"), set(count, "00"), set(own, "0"), set(data, "0000");
      fstWriterEmitTimeChange(file_, static_cast<uint64_t>(10 * cycle + 5));
      set(clock, "1");
      set(outside, cycle % 2 == 0 ? "1" : "0");
      if (cycle > 0) set(gated, "1");
      if (cycle > 0) set(count, counts[cycle]);  // 1, 2 and 1 bits toggle
      if (cycle == 2) set(read, "0");            // after the edge that has still read
      if (cycle == 3) set(data, "1010"), set(own, "1");
    }
    fstWriterEmitTimeChange(file_, 40);
    fstWriterClose(file_);
  }
  const std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / ("pipegs_activity_" + std::to_string(getpid()) + ".fst");
  void* file_ = nullptr;
};

std::string unit(const std::string& scope) {
  if (scope.starts_with("u_core.u_one")) return "one";
  if (scope.starts_with("u_core.u_two")) return "two";
  return scope == "u_core" ? "top" : "";
}

TEST_F(ActivityTest, CountsTogglesOnceEdgesAndAccesses) {
  write();
  const Activity activity = read_activity(path_, unit, {});
  EXPECT_EQ(activity.cycles, 4u);
  ASSERT_EQ(activity.groups.size(), 3u);
  EXPECT_EQ(activity.groups.at("top").bits, 2u) << "clock and enable are the core's, though both come from outside";
  EXPECT_EQ(activity.groups.at("top").toggles, 7u + 2);
  EXPECT_EQ(activity.groups.at("one").bits, 2u) << "what stands in the SRAM is none of the unit's";
  EXPECT_EQ(activity.groups.at("one").toggles, 4u);
  EXPECT_EQ(activity.groups.at("two").bits, 1u) << "count_i is the other unit's";
  EXPECT_EQ(activity.groups.at("two").toggles, 1u);
  EXPECT_EQ(activity.clocks, (std::map<std::string, uint64_t>{{"u_core.u_gate", 3}}));
  ASSERT_EQ(activity.srams.size(), 1u);
  const SramAccesses& store = activity.srams.at("u_core.u_one.u_store");
  EXPECT_EQ(store.width, 4);
  EXPECT_EQ(store.reads, 2u) << "the edges of cycles 1 and 2; read_i falls after the latter";
  EXPECT_EQ(store.writes, 1u);
}

// Cycles 1 and 5 are left out: two samples, and what changes in the gaps is in neither.
TEST_F(ActivityTest, SamplesDoNotSeeWhatChangesInGaps) {
  file_ = fstWriterCreate(path_.c_str(), 1);
  scope("u_core"), scope("u_one");
  const fstHandle clock = var("clk_o", 1), count = var("count_q [3:0]", 4);
  up(), up();
  const auto at = [&](uint64_t time, const char* value) {
    fstWriterEmitTimeChange(file_, time);
    set(clock, time % 10 == 5 ? "1" : "0");
    set(count, value);
  };
  at(5, "0000"), at(10, "0000"), at(15, "0001"), at(20, "0001"), at(25, "0011");  // two cycles behind their base
  at(45, "1100"), at(50, "1100"), at(55, "1101");
  fstWriterClose(file_);
  std::vector<Activity> samples;
  read_samples(path_, unit, {}, [&](const Activity& sample) { samples.push_back(sample); });
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].cycles, 2u);
  EXPECT_EQ(samples[1].cycles, 1u);
  EXPECT_EQ(samples[0].groups.at("one").toggles, 4u + 2) << "clock and count";
  EXPECT_EQ(samples[1].groups.at("one").toggles, 2u + 1);
  EXPECT_EQ(samples[0].clocks.at("u_core.u_one"), 2u);
  EXPECT_EQ(samples[1].clocks.at("u_core.u_one"), 1u);
  const Activity sum = read_activity(path_, unit, {});
  EXPECT_EQ(sum.cycles, 3u);
  EXPECT_EQ(sum.groups.at("one").toggles, 9u);
}

TEST_F(ActivityTest, RefusesWhatIsNoWaves) {
  EXPECT_THROW(read_activity("/nowhere.fst", unit, {}), InputError);
  std::ofstream(path_) << "no waves";
  EXPECT_THROW(read_activity(path_, unit, {}), InputError);
  file_ = fstWriterCreate(path_.c_str(), 1);
  scope("another"), set(var("clk_i", 1), "0"), up();
  fstWriterClose(file_);
  EXPECT_THROW(read_activity(path_, unit, {}), InputError) << "no core";
}

}  // namespace
}  // namespace pipegs
