// SPDX-License-Identifier: Apache-2.0
// Against sim/memory/dram/dram_references: each run of the table can be played, or its line and column are named.
#include "sim/memory/dram/check/dram_references.hpp"

#include <gtest/gtest.h>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

const std::string kHeader = "# runs\nsource,configuration,trace,max_out,bursts,cycles,gbps,latency_ns\n";
const std::string kRun = "ramulator2,lpddr5_1ch_mop4,random_rd64,16,200000,762043,6.719,75.0\n";

std::string refused(const std::string& text) {
  try {
    parse_dram_references("runs.csv", text);
  } catch (const InputError& error) { return error.what(); }
  return "accepted";
}

std::string with(const std::string& from, const std::string& to) {
  std::string run = kRun;
  return kHeader + run.replace(run.find(from), from.size(), to);
}

TEST(DramReferences, AreReadFieldByField) {
  const std::vector<DramReference> runs = parse_dram_references("runs.csv", kHeader + kRun);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].source, "ramulator2");
  EXPECT_EQ(runs[0].trace, "random_rd64");
  EXPECT_EQ(runs[0].max_out, 16);
  EXPECT_EQ(runs[0].cycles, 762043);
  EXPECT_EQ(runs[0].gbps, 6.719);
}

TEST(DramReferences, NumbersAreWholeAndInRange) {
  for (const char* number : {"0", "-1", "1.5", "16x", " 16", "", "+-16", "1048577", "4294967312"})
    EXPECT_NE(refused(with(",16,", "," + std::string(number) + ",")).find("line 3, max_out: found"), std::string::npos)
        << number;
  for (const char* number : {"-200000", "0", "2e5", "18446744073709551616"})
    EXPECT_NE(refused(with("200000", number)).find("line 3, bursts: found"), std::string::npos) << number;
  for (const char* number : {"-762043", "0", "9223372036854775808"})
    EXPECT_NE(refused(with("762043", number)).find("line 3, cycles: found"), std::string::npos) << number;
  for (const char* number : {"nan", "inf", "0", "-6.7", "6.7 19", "0x6"})
    EXPECT_NE(refused(with("6.719", number)).find("line 3, gbps: found"), std::string::npos) << number;
}

TEST(DramReferences, RowsAreThoseOfTheHeader) {
  EXPECT_NE(refused(kRun).find("line 1: found"), std::string::npos);
  EXPECT_NE(refused(kHeader + kHeader).find("line 3: found 1 fields"), std::string::npos);
  EXPECT_NE(refused(with(",75.0", "")).find("line 3: found 7 fields, expected 8"), std::string::npos);
  EXPECT_NE(refused(with(",75.0", ",75.0,1")).find("line 3: found 9 fields"), std::string::npos);
  EXPECT_NE(refused(kHeader + kRun + kRun).find("line 4, trace: found a second run"), std::string::npos);
  EXPECT_NE(refused("").find("found no header"), std::string::npos);
}

TEST(DramReferences, OnlyWhatCanBePlayedIsRead) {
  EXPECT_NE(refused(with("random_rd64", "random_rd65")).find("line 3, trace: found 'random_rd65'"), std::string::npos);
  EXPECT_NE(refused(with("lpddr5_1ch_mop4", "hbm")).find("line 3, configuration: found 'hbm'"), std::string::npos);
  EXPECT_THROW(read_dram_references("/nowhere.csv"), InputError);
  EXPECT_THROW(read_dram_references("/tmp"), InputError);
  EXPECT_THROW(read_dram_references("/dev/zero"), InputError);
}

}  // namespace
}  // namespace pipegs
