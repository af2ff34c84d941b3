// SPDX-License-Identifier: Apache-2.0
// Against the promises of sim/memory/dram/dram.hpp: lines, clocks, bandwidths, statistics.
#include "sim/memory/dram/dram.hpp"

#include <gtest/gtest.h>

#include <random>

#include "verif/dram/dram_play.hpp"

namespace pipegs {
namespace {

struct Result {
  int64_t cycles;
  double gbps;
  std::vector<uint32_t> order;  // of completion
};

// Gives the lines of a trace as fast as they are taken and waits for the last.
Result play(Dram& dram, const std::vector<DramTransfer>& transfers) {
  std::vector<DramTransfer> trace;
  for (const DramTransfer& transfer : transfers) {
    for (uint32_t byte = 0; byte < transfer.bytes; byte += 64) {
      trace.push_back({transfer.address + byte, transfer.write, 64});
    }
  }
  Result result;
  std::size_t next = 0;
  uint32_t id;
  while (next < trace.size() || !dram.idle()) {
    for (; next < trace.size() && dram.ready(); ++next) {
      dram.request(trace[next].write, trace[next].address / 64, static_cast<uint32_t>(next));
    }
    dram.step();
    while (dram.done(id)) result.order.push_back(id);
  }
  result.cycles = dram.cycles();
  result.gbps = dram.achieved_gbps();
  return result;
}

TEST(Dram, PresetsHaveTheBandwidthOfTheirPins) {
  EXPECT_NEAR(dram_preset("lpddr5-6400x4")->peak_gbps(), 51.2, 1e-9);
  EXPECT_NEAR(dram_preset("lpddr5-6400x1")->peak_gbps(), 12.8, 1e-9);
  EXPECT_NEAR(dram_preset("lpddr4-3200")->peak_gbps(), 51.2, 1e-9);
  EXPECT_NEAR(dram_preset("ddr4-3200x1")->peak_gbps(), 25.6, 1e-9);
  EXPECT_NEAR(dram_preset("ddr4-3200x2")->peak_gbps(), 51.2, 1e-9);
  EXPECT_EQ(dram_preset("ddr9"), nullptr);
  for (const std::string& name : dram_memory_names()) EXPECT_NO_THROW(check_dram(*dram_preset(name))) << name;
}

TEST(Dram, ScalesByTheNumberOfChannels) {
  double last = 0;
  for (const int channels : {1, 2, 4, 8}) {
    Dram dram(*dram_preset("lpddr5-6400x" + std::to_string(channels)));
    const double gbps = 12.8 * channels;
    EXPECT_NEAR(dram.timing().peak_gbps(), gbps, 1e-9);
    const double achieved = play(dram, dram_trace("random_rd4k")).gbps;
    EXPECT_GT(achieved, 1.6 * last);
    EXPECT_LT(achieved, gbps);
    last = achieved;
  }
}

// The reference runs offer bursts to the channels; lines through the front come to the same.
TEST(Dram, LinesReachTheBandwidthOfTheChannels) {
  for (const char* name : {"lpddr5-6400x4", "lpddr5-6400x1", "ddr4-3200x2"}) {
    for (const char* trace : {"stream_rd64", "random_rd64", "two_streams_1k"}) {
      const auto lines = dram_trace(trace);
      Dram dram(*dram_preset(name));
      const double channels = play_dram(*dram_preset(name), lines, 256).gbps;
      EXPECT_NEAR(play(dram, lines).gbps / channels, 1, 0.05) << name << " " << trace;
    }
  }
}

TEST(Dram, TheMachinesClockChangesCyclesNotTime) {
  const auto trace = dram_trace("random_rd256");
  Dram one(*dram_preset("lpddr5-6400x4"), 1.0), fast(*dram_preset("lpddr5-6400x4"), 1.7);
  const Result slow = play(one, trace), quick = play(fast, trace);
  EXPECT_NEAR(slow.gbps / quick.gbps, 1, 0.01);
  EXPECT_NEAR(static_cast<double>(quick.cycles) / static_cast<double>(slow.cycles), 1.7, 0.02);
}

TEST(Dram, OneReadTakesTheTimeOfTheRules) {
  const DramTiming& t = *dram_preset("ddr4-3200x1");
  const double ghz = 1000.0 / t.t_ck_ps;  // one cycle of the machine is one of the DRAM
  Dram dram(t, ghz);
  dram.request(false, 12345, 7);
  uint32_t id = 0;
  while (!dram.done(id)) dram.step();
  EXPECT_EQ(id, 7u);
  EXPECT_EQ(dram.cycles(), 1 + t.t_rcd + t.rl + t.t_burst);
  EXPECT_EQ(dram.read_latency().max(), dram.cycles());
}

TEST(Dram, EveryReadComesBackOnce) {
  for (const std::string& name : dram_memory_names()) {
    std::mt19937 random(3);
    std::vector<DramTransfer> trace;
    for (int i = 0; i < 30000; ++i) trace.push_back({random() % (1u << 20) * uint64_t{64}, random() % 3 == 0, 64});
    Dram dram(*dram_preset(name));
    std::vector<int> seen(trace.size());
    for (const uint32_t id : play(dram, trace).order) ++seen[id];
    for (std::size_t i = 0; i < trace.size(); ++i) ASSERT_EQ(seen[i], trace[i].write ? 0 : 1) << name << " line " << i;
    const Dram::Statistics s = dram.statistics();
    EXPECT_EQ(s.reads + s.writes, trace.size());
    EXPECT_EQ(dram.read_latency().count(), s.reads);
  }
}

TEST(Dram, RunsAreRepeatable) {
  const auto trace = dram_trace("stream_rdwr64");
  Dram a(*dram_preset("lpddr5-6400x4")), b(*dram_preset("lpddr5-6400x4"));
  EXPECT_EQ(play(a, trace).order, play(b, trace).order);
  EXPECT_EQ(a.cycles(), b.cycles());
}

TEST(Dram, AReadAfterAWriteOfTheSameLineIsAnsweredFromIt) {
  Dram dram(*dram_preset("lpddr5-6400x4"));
  dram.request(true, 99, 0);
  dram.request(false, 99, 1);
  uint32_t id;
  for (int i = 0; i < 10; ++i) dram.step();
  EXPECT_TRUE(dram.done(id));
  EXPECT_EQ(dram.statistics().reads_forwarded, 2u);  // bursts
}

TEST(Dram, IsNotReadyWhileTheFrontIsFull) {
  DramTiming timing = *dram_preset("lpddr5-6400x4");
  Dram dram(timing);
  int taken = 0;
  for (; dram.ready() && taken < 10000; ++taken) dram.request(false, static_cast<uint64_t>(taken), 0);
  const int bursts_per_line = 64 / timing.burst_bytes();
  EXPECT_EQ(taken, timing.channels * timing.read_queue / bursts_per_line + timing.front_queue);
  EXPECT_THROW(dram.request(false, 0, 0), std::logic_error);
}

TEST(Dram, ReadsThatNobodyTakesStopItWithoutLoss) {
  Dram dram(*dram_preset("ddr4-3200x2"));
  uint32_t given = 0, id;
  for (int i = 0; i < 100000; ++i) {
    if (dram.ready()) dram.request(false, given, given), ++given;
    dram.step();
  }
  EXPECT_FALSE(dram.ready());
  uint32_t taken = 0;
  while (dram.done(id)) ++taken;
  EXPECT_EQ(taken, given);
}

TEST(Dram, CountsWhatHappens) {
  Dram dram(*dram_preset("lpddr5-6400x1"));
  play(dram, dram_trace("stream_rdwr64"));
  const Dram::Statistics s = dram.statistics();
  EXPECT_EQ(s.reads, 66666u);
  EXPECT_EQ(s.writes, 33334u);
  EXPECT_EQ(s.bursts_read, 2 * s.reads);
  EXPECT_EQ(s.bursts_written, 2 * s.writes);
  EXPECT_EQ(s.row_hits + s.row_misses + s.row_conflicts, s.bursts_read + s.bursts_written);
  EXPECT_GT(s.row_hits, 9 * (s.row_misses + s.row_conflicts));
  EXPECT_EQ(s.data_bus_busy, 2 * (s.bursts_read + s.bursts_written));
  EXPECT_NEAR(s.data_bus_share, dram.achieved_gbps() / dram.timing().peak_gbps(), 1e-3);
  EXPECT_NEAR(static_cast<double>(s.refreshes), dram.seconds() / (3125 * 1.25e-9), 1.5);
  EXPECT_LE(1, s.latency_p50);
  EXPECT_LE(s.latency_p50, s.latency_p90);
  EXPECT_LE(s.latency_p90, s.latency_p99);
  EXPECT_LE(s.latency_p99, s.latency_max);
  EXPECT_LT(s.latency_mean, static_cast<double>(s.latency_max));
}

TEST(Dram, PercentilesAreRanks) {
  LatencyHistogram latency;
  for (int64_t i = 1; i <= 100; ++i) latency.add(i);
  EXPECT_EQ(latency.percentile(50), 50);
  EXPECT_EQ(latency.percentile(99), 99);
  EXPECT_EQ(latency.percentile(100), 100);
  EXPECT_DOUBLE_EQ(latency.mean(), 50.5);
  latency.add(100000);
  EXPECT_EQ(latency.percentile(100), 100000);
}

TEST(Dram, RefusesWhatItCannotModel) {
  DramTiming timing = *dram_preset("lpddr5-6400x4");
  timing.channels = 3;
  EXPECT_THROW(Dram{timing}, std::invalid_argument);
  EXPECT_THROW(Dram(*dram_preset("lpddr5-6400x4"), 0), std::invalid_argument);
}

// More bursts than an age has numbers.
TEST(Dram, NumbersOfBurstsMayWrapAround) {
  Dram dram(*dram_preset("ddr4-3200x1"));
  uint32_t id;
  uint64_t given = 0, taken = 0;
  constexpr uint64_t kLines = (uint64_t{1} << 24) + 100000;
  while (taken < kLines) {
    for (; given < kLines && dram.ready(); ++given) dram.request(false, given, static_cast<uint32_t>(given));
    dram.step();
    for (; dram.done(id); ++taken) ASSERT_LT(given - id, 400u);
    ASSERT_LT(dram.cycles(), int64_t{100000000});
  }
  EXPECT_EQ(taken, kLines);
}

}  // namespace
}  // namespace pipegs
