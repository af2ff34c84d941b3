// SPDX-License-Identifier: Apache-2.0
// sram_cost_test: the law meets the table it was fitted to, grows the way it must, and refuses broken tables.
#include "sim/silicon/area/sram_cost.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr const char* kTable = PIPEGS_SOURCE_DIR "/synth/data/sram.csv";

TEST(SramLaw, MeetsTheTable) {
  const SramLaw law(kTable);
  EXPECT_EQ(law.kinds(), (std::vector<std::string>{"itrs-hp/itrs-hp", "itrs-lop/itrs-lop", "itrs-lstp/itrs-hp",
                                                   "itrs-lstp/itrs-lstp"}));
  for (const std::string& kind : law.kinds()) {
    for (size_t figure = 0; figure < 6; ++figure) {
      EXPECT_LT(law.worst(kind)[figure], 0.36) << kind << ", figure " << figure;
      EXPECT_LT(law.mean(kind)[figure], 0.15) << kind << ", figure " << figure;
    }
    EXPECT_LT(law.worst(kind)[0], 0.16) << kind << ", area";
    EXPECT_LT(law.mean(kind)[0], 0.07) << kind << ", area";
  }
}

TEST(SramLaw, LargerAndWiderCostsMore) {
  const SramLaw law(kTable);
  for (const std::string& kind : law.kinds()) {
    EXPECT_GT(law.memory(kind, 64, 1024, 2).area_mm2, law.memory(kind, 64, 512, 2).area_mm2);
    EXPECT_GT(law.memory(kind, 128, 512, 2).read_pj, law.memory(kind, 64, 512, 2).read_pj);
    EXPECT_GT(law.macro(kind, 8192, 64, true).area_mm2, law.macro(kind, 8192, 64, false).area_mm2);
    // Two columns of 256 bits.
    EXPECT_DOUBLE_EQ(law.memory(kind, 512, 1024, 2).area_mm2, 2 * law.memory(kind, 256, 1024, 2).area_mm2);
    EXPECT_DOUBLE_EQ(law.memory(kind, 512, 1024, 2).access_ns, law.memory(kind, 256, 1024, 2).access_ns);
  }
}

TEST(SramLaw, RefusesBrokenTables) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("pipegs_sram_" + std::to_string(getpid()) + ".csv");
  std::ifstream file(kTable);
  std::string header, row;
  std::getline(file, header), std::getline(file, row);
  const auto refused = [&](const std::string& text) {
    std::ofstream(path) << text;
    try {
      SramLaw law(path);
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string("accepted");
  };
  EXPECT_NE(refused("").find("no header, expected tech_um"), std::string::npos);
  EXPECT_NE(refused(header + "\n").find("no rows of 28 nm"), std::string::npos);
  EXPECT_NE(refused(header + "\n1,2\n").find("line 2: found 2 fields, expected 12"), std::string::npos);
  EXPECT_NE(refused(header + "\n0.028,a,b,0,64,1RW,1,1,1,1,1,1\n")
                .find("line 2, size_B: found '0', expected a number above 0"),
            std::string::npos);
  EXPECT_NE(refused(header + "\n0.028,a,b,8192,64,2RW,1,1,1,1,1,1\n")
                .find("line 2, ports: found '2RW', expected 1RW or 1R1W"),
            std::string::npos);
  EXPECT_NE(refused(header + "\n" + row + "\n").find("too few"), std::string::npos);
  EXPECT_THROW(SramLaw("/nowhere.csv"), InputError);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace pipegs
