// SPDX-License-Identifier: Apache-2.0
// external_memory_test: what the memory of the harness refuses: lines that it does not have, and a write of a line of
// which a read is not answered. What it holds where nobody has written is noise.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "sim/memory/external_memory.hpp"

namespace pipegs {
namespace {

constexpr uint32_t kLine[16] = {7};

TEST(ExternalMemory, RefusesWhatLiesBehindItsEnd) {
  ExternalMemory memory({.latency = 3});
  memory.set_lines(100);
  memory.step();
  EXPECT_NO_THROW(memory.request(true, 99, 1, kLine));
  EXPECT_THROW(memory.request(true, 100, 1, kLine), MemoryFault);
  EXPECT_THROW(memory.request(false, 100, 1, nullptr), MemoryFault);
  EXPECT_THROW(memory.request(false, uint64_t{1} << 33, 1, nullptr), MemoryFault);
  try {
    memory.request(true, 123, 5, kLine);
  } catch (const MemoryFault& fault) {
    EXPECT_STREQ(fault.what(), "external memory: tag 5 writes line 123, but there are 100 lines");
  }
}

TEST(ExternalMemory, RefusesAWriteOfALineThatIsBeingRead) {
  ExternalMemory memory({.latency = 10});
  memory.step();
  memory.request(false, 4, 2, nullptr);
  memory.request(false, 4, 3, nullptr);
  int answers = 0;
  for (int cycle = 0; cycle < 40; ++cycle) {
    if (answers < 2) {
      EXPECT_THROW(memory.request(true, 4, 1, kLine), MemoryFault) << "cycle " << cycle;
    } else {
      EXPECT_NO_THROW(memory.request(true, 4, 1, kLine)) << "cycle " << cycle;
    }
    EXPECT_NO_THROW(memory.request(true, 5, 1, kLine));
    memory.step();
    answers += memory.answer() != nullptr;
  }
  EXPECT_EQ(answers, 2);
}

TEST(ExternalMemory, AReadOfHalfALineGivesThatHalfAndCountsAsOne) {
  ExternalMemory memory({.latency = 3});
  std::iota(memory.line(9).begin(), memory.line(9).end(), 1u);
  for (const int halves : {1, 2, 3}) {
    memory.step();
    memory.request(false, 9, 2, nullptr, 1, halves);
    while (memory.answer() == nullptr) memory.step();
    const MemoryLine& line = memory.answer()->data;
    for (uint32_t i = 0; i < 16; ++i) EXPECT_EQ(line[i] == i + 1, (halves >> i / 8 & 1) != 0) << halves;
  }
  EXPECT_EQ(memory.traffic()[2].halves_read, 4u);
}

TEST(ExternalMemory, HoldsNoiseWhereNobodyHasWritten) {
  for (const int bus : {0, 128}) {
    const ExternalMemory seen({}, bus);
    ExternalMemory written({}, bus);
    written.line(7000) = {1};
    std::set<uint32_t> words;
    for (const uint64_t line : {0, 6999, 7001, 1 << 30}) {
      EXPECT_EQ(seen.line(line), written.line(line)) << line;  // in every run the same
      words.insert(seen.line(line).begin(), seen.line(line).end());
    }
    EXPECT_GT(words.size(), 60u);
    EXPECT_EQ(written.line(7000), MemoryLine{1});
  }
}

}  // namespace
}  // namespace pipegs
