// SPDX-License-Identifier: Apache-2.0
// Against runs of Ramulator 2 and DRAMsim3 (references.csv): the same traces, bandwidth by bandwidth.
//
// Idea    Streams within 5 %, random reads within 10 %; against Ramulator 2, whose rules these are, the same number of
//         cycles in every run.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "scenes/text/csv.hpp"
#include "verif/dram/dram_play.hpp"

namespace pipegs {
namespace {

constexpr std::string_view kHeader = "source,configuration,trace,max_out,bursts,cycles,gbps,latency_ns";

// The configuration files of DRAMsim3 in our terms. Its 32 transactions and 8 commands for each bank become one queue
// of 48 bursts: a stream works on one or two banks. Its DDR4 channel of 16 GB has two ranks.
DramTiming lpddr4_2400_dramsim3() {
  DramTiming t;
  t.name = "lpddr4-2400";
  t.bank_groups = 2, t.banks = 4, t.rows = 65536;
  t.t_ck_ps = 830;
  t.rl = 17, t.wl = 14, t.t_burst = 8, t.t_burst_l = 8;
  t.t_rcd = 15, t.t_rp = 15, t.t_rpab = 15, t.t_ras = 32, t.t_rc = 47;
  t.t_rrd_s = 8, t.t_rrd_l = 8, t.t_faw = 32;
  t.t_ccd_s = 4, t.t_ccd_l = 6;
  t.t_rtp = 12, t.t_wr = 30, t.t_wtr_s = 8, t.t_wtr_l = 16, t.t_rtw = 13;
  t.t_cs = 1, t.t_ppd = 2;
  t.t_refi = 8660, t.t_rfc = 392;
  t.read_queue = 48;
  return t;
}

DramTiming ddr4_3200_dramsim3() {
  DramTiming t = *dram_preset("ddr4-3200x1");
  t.ranks = 2;
  t.t_ck_ps = 630;
  t.t_rtw = 12;
  t.t_cs = 1;
  t.t_rfc = 560;
  t.read_queue = 48;
  return t;
}

DramTiming preset(const char* name, DramMapping mapping) {
  DramTiming timing = *dram_preset(name);
  timing.mapping = mapping;
  return timing;
}

// By the name of a reference configuration.
std::map<std::string, DramTiming> timings() {
  constexpr DramMapping kRo = DramMapping::kRoBaRaCoCh, kMop4 = DramMapping::kMop4ClXor;
  return {{"lpddr5_1ch_robaraco", preset("lpddr5-6400x1", kRo)}, {"lpddr5_1ch_mop4", preset("lpddr5-6400x1", kMop4)},
          {"lpddr5_2ch_robaraco", preset("lpddr5-6400x2", kRo)}, {"lpddr5_4ch_robaraco", preset("lpddr5-6400x4", kRo)},
          {"lpddr5_4ch_mop4", preset("lpddr5-6400x4", kMop4)},   {"ddr4_3200_1ch_robaraco", preset("ddr4-3200x1", kRo)},
          {"ddr4_3200_1ch_mop4", preset("ddr4-3200x1", kMop4)},  {"ddr4_3200_2ch_robaraco", preset("ddr4-3200x2", kRo)},
          {"lpddr4_2400_16b", lpddr4_2400_dramsim3()},           {"DDR4_8Gb_x8_3200", ddr4_3200_dramsim3()}};
}

// Plays each run of a simulator again and gives it and what came of it to `look`; returns the number of runs.
int play_again(const std::string& source, const std::function<void(const CsvRow&, const DramPlay&)>& look) {
  const std::map<std::string, DramTiming> known = timings();
  std::map<std::string, std::vector<DramTransfer>> traces;
  for (const std::string_view name : kDramTraces) traces[std::string(name)] = dram_trace(name);
  int runs = 0;
  read_csv(PIPEGS_SOURCE_DIR "/verif/dram/references.csv", kHeader, [&](const CsvRow& run) {
    if (run.text("source") != source) return;
    const std::string &configuration = run.text("configuration"), &trace = run.text("trace");
    const int max_out = run.integer<int>("max_out", 1);
    SCOPED_TRACE(configuration + " " + trace + ", in flight " + std::to_string(max_out));
    const DramPlay play = play_dram(known.at(configuration), traces.at(trace), max_out, source == "ramulator2");
    EXPECT_EQ(play.bursts, run.integer<uint64_t>("bursts"));
    look(run, play);
    ++runs;
  });
  return runs;
}

void expect_close(const CsvRow& run, const DramPlay& play) {
  const double reference = run.real("gbps");
  EXPECT_NEAR(play.gbps, reference, (run.text("trace").starts_with("random") ? 0.10 : 0.05) * reference);
}

// The channels follow the rules of Ramulator 2, so not only bandwidths but cycles are the same.
TEST(DramCheck, BandwidthsAndCyclesAreThoseOfRamulator2) {
  EXPECT_EQ(play_again("ramulator2",
                       [](const CsvRow& run, const DramPlay& play) {
                         expect_close(run, play);
                         EXPECT_EQ(play.cycles, run.integer<int64_t>("cycles"));
                         EXPECT_NEAR(play.latency_ns, run.real("latency_ns"), 0.11);
                       }),
            126);
}

// DRAMsim3 keeps eight commands for each bank and serves the banks in turn: two streams that meet in one bank lose more
// there than here.
TEST(DramCheck, BandwidthsAreThoseOfDramsim3) {
  EXPECT_EQ(play_again("dramsim3",
                       [](const CsvRow& run, const DramPlay& play) {
                         const bool meet = run.text("configuration") == "DDR4_8Gb_x8_3200" &&
                                           run.text("trace") == "two_streams_1k" && run.text("max_out") == "64";
                         if (!meet) expect_close(run, play);
                       }),
            24);
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

}  // namespace
}  // namespace pipegs
