// SPDX-License-Identifier: Apache-2.0
// Against runs of Ramulator 2 and DRAMsim3 (references.csv): the same traces, bandwidth by bandwidth.
//
// Idea    Streams within 5 %, random reads within 10 %; against Ramulator 2 the same number of cycles in every run.
#include "sim/memory/dram/check/dram_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pipegs {
namespace {

std::vector<DramReference> references(const std::string& source) {
  std::vector<DramReference> all = read_dram_references(PIPEGS_SOURCE_DIR "/verif/dram/references.csv");
  std::erase_if(all, [&](const DramReference& reference) { return reference.source != source; });
  return all;
}

void expect_close(const DramCheck& check) { EXPECT_TRUE(check.agrees()) << dram_check_table({&check, 1}); }

// What is not of the reference's bandwidth, bursts or cycles does not agree.
TEST(DramCheck, SeesADifference) {
  const DramCheck check = check_dram(std::vector{references("ramulator2").front()}).front();
  ASSERT_TRUE(check.agrees());
  const auto changed = [&](auto&& change) {
    DramCheck other = check;
    change(other);
    return other.agrees();
  };
  EXPECT_FALSE(changed([](DramCheck& c) { c.play.cycles += 1; }));
  EXPECT_FALSE(changed([](DramCheck& c) { c.play.bursts += 1; }));
  EXPECT_FALSE(changed([](DramCheck& c) { c.play.gbps *= 1.2; }));
}

// The channels follow the rules of Ramulator 2, so not only bandwidths but cycles are the same.
TEST(DramCheck, BandwidthsAndCyclesAreThoseOfRamulator2) {
  const auto all = references("ramulator2");
  EXPECT_EQ(all.size(), 126u);
  for (const DramCheck& check : check_dram(all)) {
    expect_close(check);
    EXPECT_EQ(check.play.cycles, check.reference.cycles) << dram_check_table({&check, 1});
    EXPECT_NEAR(check.play.latency_ns, check.reference.latency_ns, 0.11) << dram_check_table({&check, 1});
  }
}

TEST(DramCheck, BandwidthsAreThoseOfDramsim3) {
  const auto all = references("dramsim3");
  EXPECT_EQ(all.size(), 24u);
  for (const DramCheck& check : check_dram(all)) expect_close(check);
}

// Printed by Python: random.Random(1) and the order of draws of the trace script.
TEST(DramTrace, RandomNumbersAreThoseOfPython) {
  const auto lines = dram_trace("random_rd64");
  ASSERT_EQ(lines.size(), 100000u);
  EXPECT_EQ(lines[0].address / 64, 4508515u);
  EXPECT_EQ(lines[4].address / 64, 16624042u);
  EXPECT_EQ(dram_trace("random_rd256")[2].address / 256, 1430601u);
  EXPECT_EQ(dram_trace("random_rd4k")[2].address / 4096, 75290u);
}

TEST(DramTrace, HasTheLengthsOfTheReferenceRuns) {
  for (const std::string_view name : kDramTraces) {
    uint64_t bytes = 0;
    for (const DramTransfer& transfer : dram_trace(name)) bytes += transfer.bytes;
    EXPECT_EQ(bytes, name == "random_rd4k" ? 1562u * 4096u : 6400000u) << name;
  }
  EXPECT_THROW(dram_trace("nothing"), std::invalid_argument);
}

}  // namespace
}  // namespace pipegs
