// SPDX-License-Identifier: Apache-2.0
// Against the timing rules of docs/cycles/memory_timing.md: every expected cycle is computed from DramTiming.
// Other distances are left to dram_check: a cycle more or less of tRAS, tFAW, tRRD, tCCD, tWTR, tRTW, tWR, tRTP, tRFC
// or WCK is seen in its 126 runs of Ramulator 2.
//
// Idea    A channel is stepped cycle by cycle. Reads show when their last beat arrives, so the cycle of their column
//         command is known; counters show when writes, activations and refreshes are issued. A burst accepted in cycle
//         c can cause a command from c + 1 on.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

#include "sim/memory/dram/dram_channel.hpp"

namespace pipegs {
namespace {

class Bench {
 public:
  explicit Bench(const DramTiming& timing) : timing_(timing), channel_(timing) {}

  DramCycle now() const { return now_; }
  void accept(bool write, uint32_t bank, uint32_t row, uint32_t column, uint32_t tag = 0) {
    ASSERT_TRUE(channel_.accepts(write));
    channel_.accept(now_, write, {0, bank, row, column}, tag);
  }
  void step() {
    ++now_;
    uint32_t tag;
    while (channel_.finished(now_, tag)) arrived_[tag] = now_;
    channel_.tick(now_);
  }
  void step_to(DramCycle cycle) {
    while (now_ < cycle) step();
  }
  // When the last beat of a read arrives.
  DramCycle arrival(uint32_t tag) {
    for (int i = 0; i < 100000 && !arrived_.contains(tag); ++i) step();
    return arrived_.contains(tag) ? arrived_[tag] : -1;
  }
  // When its column command was given.
  DramCycle read_command(uint32_t tag) { return arrival(tag) - timing_.rl - timing_.t_burst; }
  DramCycle activation(uint64_t count) {
    for (int i = 0; i < 100000 && channel_.counters().activates < count; ++i) step();
    return now_;
  }
  // Opens a row of a bank and leaves the bank alone until no rule of the past holds.
  void open(uint32_t bank, uint32_t row) {
    accept(false, bank, row, 63, 1000 + bank);
    arrival(1000 + bank);
    step_to(now_ + timing_.t_rc);
  }
  const DramChannel& channel() const { return channel_; }

 private:
  DramTiming timing_;
  DramChannel channel_;
  DramCycle now_ = 0;
  std::map<uint32_t, DramCycle> arrived_;
};

// WCK that never stops: no CAS command comes between.
DramTiming without_sync(DramTiming timing) {
  timing.t_wckpst = -1;
  return timing;
}

class Rules : public testing::TestWithParam<std::string> {
 protected:
  const DramTiming full_ = *dram_preset(GetParam());
  const DramTiming t_ = without_sync(full_);
};

TEST_P(Rules, AClosedBankCostsActivationAndRead) {
  Bench bench(t_);
  bench.accept(false, 0, 5, 0);
  EXPECT_EQ(bench.arrival(0), 1 + t_.t_rcd + t_.rl + t_.t_burst);
  EXPECT_EQ(bench.channel().counters().row_misses, 1u);
}

TEST_P(Rules, AnOpenRowCostsTheReadAlone) {
  Bench bench(t_);
  bench.open(0, 5);
  const DramCycle now = bench.now();
  bench.accept(false, 0, 5, 1);
  EXPECT_EQ(bench.arrival(0), now + 1 + t_.rl + t_.t_burst);
  EXPECT_EQ(bench.channel().counters().row_hits, 1u);
}

TEST_P(Rules, AnotherRowCostsAPrecharge) {
  Bench bench(t_);
  bench.open(0, 5);
  const DramCycle now = bench.now();
  bench.accept(false, 0, 6, 1);
  EXPECT_EQ(bench.arrival(0), now + 1 + t_.t_rp + t_.t_rcd + t_.rl + t_.t_burst);
  EXPECT_EQ(bench.channel().counters().row_conflicts, 1u);
  EXPECT_EQ(bench.channel().counters().precharges, 1u);
}

TEST_P(Rules, ActivationsOfABankAreTRcApart) {
  DramTiming slow = t_;
  slow.t_rc = t_.t_ras + t_.t_rp + 20;
  Bench bench(slow);
  bench.accept(false, 0, 5, 0, 0);
  bench.accept(false, 0, 6, 0, 1);
  EXPECT_EQ(bench.read_command(1), 1 + slow.t_rc + slow.t_rcd);
}

TEST_P(Rules, ARefreshClosesOpenRows) {
  Bench bench(t_);
  bench.open(0, 5);
  bench.step_to(t_.t_refi);
  EXPECT_EQ(bench.channel().counters().precharges, 1u);
  bench.accept(false, 0, 5, 0);
  EXPECT_EQ(bench.read_command(0), t_.t_refi + t_.t_rp + t_.t_rfc + t_.t_rcd);
  EXPECT_EQ(bench.channel().counters().refreshes, 1u);
}

TEST_P(Rules, RefreshesComeEveryTRefi) {
  Bench bench(t_);
  bench.step_to(20 * DramCycle{t_.t_refi});
  EXPECT_EQ(bench.channel().counters().refreshes, 20u);
}

// With t_rfcpb: bank by bank, in the order of their numbers.
class BankRefresh : public Rules {
 protected:
  static DramTiming by_bank(DramTiming timing) {
    timing.t_rfcpb = 96;
    return timing;
  }
  const DramTiming one_ = by_bank(t_);
  const DramCycle every_ = one_.t_refi / one_.banks_per_channel();
};

TEST_P(BankRefresh, ComesOnceInTRefiForEachBank) {
  Bench bench(one_);
  for (uint64_t n = 1; n <= 40; ++n) {
    bench.step_to(static_cast<DramCycle>(n) * every_ - 1);
    EXPECT_EQ(bench.channel().counters().refreshes, n - 1);
    bench.step();
    EXPECT_EQ(bench.channel().counters().refreshes, n);
  }
}

TEST_P(BankRefresh, BlocksItsBankForTRfcpb) {
  Bench bench(one_);
  bench.step_to(every_);
  bench.accept(false, 0, 5, 0);
  EXPECT_EQ(bench.read_command(0), every_ + one_.t_rfcpb + one_.t_rcd);
}

TEST_P(BankRefresh, ClosesTheRowOfItsBank) {
  Bench bench(one_);
  bench.open(0, 5);
  bench.step_to(every_);
  EXPECT_EQ(bench.channel().counters().precharges, 1u);
  bench.accept(false, 0, 5, 0);
  EXPECT_EQ(bench.read_command(0), every_ + one_.t_rp + one_.t_rfcpb + one_.t_rcd);
  EXPECT_EQ(bench.channel().counters().refreshes, 1u);
}

TEST_P(BankRefresh, LetsTheOtherBanksGoOn) {
  Bench bench(one_);
  bench.open(1, 5);
  bench.step_to(every_);  // the refresh of bank 0
  bench.accept(false, 1, 5, 1, 1);
  bench.accept(false, 2, 5, 0, 2);
  EXPECT_EQ(bench.read_command(1), every_ + 1);
  EXPECT_EQ(bench.read_command(2), every_ + one_.t_pbr2act + one_.t_rcd);
  EXPECT_EQ(bench.channel().counters().refreshes, 1u);
}

TEST_P(Rules, AnActivationInTwoCommandsHoldsUpTheNext) {
  DramTiming close = t_;
  close.t_rrd_s = close.t_rrd_l = 1;
  close.ca_act = 1;
  Bench bench(close);
  bench.accept(false, 0, 5, 0, 0);
  bench.accept(false, 1, 5, 0, 1);
  const DramCycle first = bench.activation(1);
  EXPECT_EQ(bench.activation(2) - first, close.t_aad > 0 ? 2 : 1);
}

TEST_P(Rules, OneCommandAtATime) {
  DramTiming wide = t_;
  wide.t_rrd_s = wide.t_rrd_l = 1;
  wide.t_aad = 0;
  wide.ca_act = 5;
  Bench bench(wide);
  bench.accept(false, 0, 5, 0, 0);
  bench.accept(false, 1, 5, 0, 1);
  const DramCycle first = bench.activation(1);
  EXPECT_EQ(bench.activation(2) - first, wide.ca_act);
}

TEST_P(Rules, AHitOvertakesAConflictThatCannotStart) {
  Bench bench(t_);
  bench.accept(false, 0, 5, 0, 0);
  bench.accept(false, 0, 6, 0, 1);
  bench.accept(false, 0, 5, 1, 2);
  EXPECT_LT(bench.arrival(2), bench.arrival(1));
}

TEST_P(Rules, OtherwiseTheOldestGoesFirst) {
  Bench bench(t_);
  bench.open(0, 5);
  bench.accept(false, 0, 6, 0, 1);
  bench.accept(false, 0, 5, 1, 2);
  EXPECT_LT(bench.arrival(1), bench.arrival(2));
}

TEST_P(Rules, WithHitsFirstARowStaysOpenWhileItsBurstsWait) {
  DramTiming hits = t_;
  hits.hits_first = true;
  constexpr uint64_t kHits = 10;
  Bench bench(hits);
  bench.open(0, 5);
  bench.accept(false, 0, 6, 0, 1);  // the oldest, for another row
  for (uint32_t i = 0; i < kHits; ++i) bench.accept(false, 0, 5, i, 2 + i);
  while (bench.channel().counters().bursts_read < 1 + kHits && bench.now() < 1000) {
    EXPECT_EQ(bench.channel().counters().precharges, 0u);
    bench.step();
  }
  const DramCycle last = bench.now();
  EXPECT_EQ(bench.read_command(1), last + hits.t_rtp + hits.t_rp + hits.t_rcd);
  EXPECT_EQ(bench.channel().counters().row_hits, kHits);
}

// Reads and writes take turns, so a write that must wait anyway keeps no row open.
TEST_P(Rules, WithHitsFirstAWriteKeepsNoRowOpenForReads) {
  DramTiming hits = t_;
  hits.hits_first = true;
  Bench bench(hits);
  bench.open(0, 5);
  const DramCycle now = bench.now();
  bench.accept(true, 0, 5, 1);
  bench.accept(false, 0, 6, 0, 1);
  EXPECT_EQ(bench.read_command(1), now + 1 + hits.t_rp + hits.t_rcd);
}

TEST_P(Rules, WritesWaitForTheHighWatermark) {
  Bench bench(t_);
  bench.open(0, 5);
  const int high = static_cast<int>(t_.write_high * t_.write_queue);
  const int low = static_cast<int>(t_.write_low * t_.write_queue);
  uint32_t tag = 0, column = 0;
  const auto keep_reading = [&] {
    for (; bench.channel().accepts(false); ++tag) bench.accept(false, 0, 5, tag % 60, tag);
    bench.step();
  };
  keep_reading();
  for (int i = 0; i < high; ++i) bench.accept(true, 0, 5, 100 + column++);
  for (int i = 0; i < 40; ++i) keep_reading();
  EXPECT_EQ(bench.channel().counters().bursts_written, 0u);
  bench.accept(true, 0, 5, 100 + column++);
  for (int i = 0; i < 800; ++i) keep_reading();
  EXPECT_EQ(bench.channel().counters().bursts_written, static_cast<uint64_t>(high + 1 - low));
}

TEST_P(Rules, AReadOfAWaitingWriteIsAnswered) {
  Bench bench(t_);
  bench.accept(true, 0, 5, 7);
  bench.accept(true, 0, 5, 7);
  bench.accept(false, 0, 5, 7, 1);
  EXPECT_EQ(bench.arrival(1), 1);
  bench.step_to(200);
  EXPECT_EQ(bench.channel().counters().bursts_written, 1u);
  EXPECT_EQ(bench.channel().counters().writes_merged, 1u);
  EXPECT_EQ(bench.channel().counters().reads_forwarded, 1u);
  EXPECT_EQ(bench.channel().counters().bursts_read, 0u);
}

TEST_P(Rules, ChangingTheRankCostsTCs) {
  DramTiming two = t_;
  two.ranks = 2;
  two.t_cs = 5;
  const uint32_t other = static_cast<uint32_t>(two.banks_per_channel() / 2);
  Bench bench(two);
  bench.open(0, 5);
  bench.open(other, 5);
  bench.accept(false, 0, 5, 1, 1);
  bench.accept(false, other, 5, 1, 2);
  EXPECT_EQ(bench.read_command(2) - bench.read_command(1), two.t_burst + two.t_cs);
}

// Times and ages are kept in 31 bits and start again long before they overflow.
TEST_P(Rules, LongRunsChangeNothing) {
  DramChannel channel(t_);
  uint32_t tag;
  DramCycle now = 0;
  const auto run = [&](DramCycle to) {
    for (now = channel.next(); now < to; now = channel.next()) {
      while (channel.finished(now, tag)) {}
      channel.tick(now);
    }
    now = to;
  };
  const auto latency = [&] {
    channel.accept(now, false, {0, 0, 5, 0}, 0);
    const DramCycle start = now;
    while (!channel.finished(now, tag)) channel.tick(++now);
    return now - start;
  };
  run(t_.t_refi / 2);
  const DramCycle early = latency();
  run((DramCycle{1} << 30) / t_.t_refi * t_.t_refi + 40 * t_.t_refi + t_.t_refi / 2);
  EXPECT_EQ(latency(), early);
  const auto refreshes = static_cast<uint64_t>(now / t_.t_refi);
  const DramCycle due = static_cast<DramCycle>(refreshes + 1) * t_.t_refi + t_.t_rp;  // the open row is closed first
  run(due);
  EXPECT_EQ(channel.counters().refreshes, refreshes);
  run(due + 1);
  EXPECT_EQ(channel.counters().refreshes, refreshes + 1);
}

TEST_P(Rules, NoBurstIsLost) {
  for (const int seed : {1, 2, 3, 4}) {
    DramTiming two = full_;
    if (seed == 4) two.ranks = 2;
    DramChannel channel(two);
    std::mt19937 random(static_cast<unsigned>(seed));
    std::vector<int> seen(20000);
    uint32_t given = 0, tag;
    uint64_t reads = 0;
    for (DramCycle now = 0; given < seen.size() || !channel.idle(); ++now) {
      ASSERT_LT(now, 4000000);
      channel.tick(now);
      while (channel.finished(now, tag)) ++seen[tag];
      const bool write = random() % 3 == 0;
      if (given == seen.size() || random() % 4 == 0 || !channel.accepts(write)) continue;
      const uint32_t bank = random() % static_cast<uint32_t>(seed == 2 ? 2 : two.banks_per_channel());
      const auto row = static_cast<uint32_t>(random() % 3), column = static_cast<uint32_t>(random() % 8);
      channel.accept(now, write, {0, bank, row, column}, given);
      if (write) ++seen[given];
      if (!write) ++reads;
      ++given;
    }
    for (std::size_t i = 0; i < seen.size(); ++i) ASSERT_EQ(seen[i], 1) << "burst " << i << " seed " << seed;
    const auto& c = channel.counters();
    EXPECT_EQ(c.bursts_read + c.reads_forwarded, reads);
    EXPECT_EQ(c.bursts_written + c.writes_merged, seen.size() - reads);
    EXPECT_EQ(c.row_hits + c.row_misses + c.row_conflicts, c.bursts_read + c.bursts_written);
  }
}

// Consecutive lines: channel after channel, after group_bytes of each the next bank group, after all columns the next
// bank.
TEST(Places, LinesGoRoundChannelsThenGroups) {
  DramTiming t = *dram_preset("lpddr5-6400x4");
  t.mapping = DramMapping::kRoBaCoGrCh;
  t.interleave_bytes = 64;
  const DramPlaces places(t);
  const auto bursts_per_line = static_cast<uint64_t>(64 / t.burst_bytes());
  const uint64_t lines_of_group = 4 * static_cast<uint64_t>(t.group_bytes) / 64;  // in all channels
  const uint64_t lines_of_bank = 4 * static_cast<uint64_t>(t.columns * t.channel_width / 8) / 64 * 4;  // in all groups
  for (uint64_t line = 0; line < 20 * lines_of_bank; ++line) {
    const DramPlace place = places(line * bursts_per_line), second = places(line * bursts_per_line + 1);
    EXPECT_EQ(place.channel, line % 4);
    const auto row = static_cast<uint32_t>(line / lines_of_bank / 4);
    ASSERT_EQ(place.row, row);
    EXPECT_EQ(place.bank / 4, (line / lines_of_group % 4) ^ (row >> 2 & 3)) << "group of line " << line;
    EXPECT_EQ(place.bank % 4, (line / lines_of_bank % 4) ^ (row & 3)) << "bank of line " << line;
    EXPECT_EQ(std::tie(second.channel, second.bank, second.row), std::tie(place.channel, place.bank, place.row))
        << "a line opens one row";
    EXPECT_EQ(second.column, place.column + 1);
  }
}

TEST(Places, NoTwoBurstsShareAPlace) {
  for (const char* name : {"lpddr5-6400x1", "lpddr5-6400x4", "lpddr4-3200", "ddr4-3200x2"}) {
    for (const DramMapping mapping : {DramMapping::kRoBaRaCoCh, DramMapping::kRoBaCoGrCh, DramMapping::kMop4ClXor}) {
      for (const int ranks : {1, 2}) {
        for (const int interleave : {0, 64, 256}) {
          DramTiming t = *dram_preset(name);
          t.mapping = mapping, t.ranks = ranks, t.interleave_bytes = interleave, t.rows = 8;
          const DramPlaces places(t);
          const auto bursts =
              static_cast<uint64_t>(t.channels * t.banks_per_channel() * t.rows * (t.columns / t.burst_length));
          std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> seen;
          for (uint64_t burst = 0; burst < bursts; ++burst) {
            const DramPlace p = places(burst);
            ASSERT_TRUE(p.channel < static_cast<uint32_t>(t.channels) &&
                        p.bank < static_cast<uint32_t>(t.banks_per_channel()) && p.row < 8 &&
                        p.column < static_cast<uint32_t>(t.columns / t.burst_length));
            seen.emplace(p.channel, p.bank, p.row, p.column);
          }
          EXPECT_EQ(seen.size(), bursts) << name << ", mapping " << static_cast<int>(mapping) << ", ranks " << ranks
                                         << ", interleave " << interleave;
        }
      }
    }
  }
}

const auto kPresets = testing::Values("lpddr5-6400x1", "ddr4-3200x1", "lpddr4-3200");
std::string preset_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Presets, Rules, kPresets, preset_name);
INSTANTIATE_TEST_SUITE_P(Presets, BankRefresh, kPresets, preset_name);

}  // namespace
}  // namespace pipegs
