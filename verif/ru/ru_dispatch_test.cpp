// SPDX-License-Identifier: Apache-2.0
// ru_dispatch_test: rtl/ru/ru_dispatch.sv against ru_own_mask.
#include "cpp_model/ru/ru_walk.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vru_dispatch.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();

// The RUs: each takes the one record when its own valid is up.
class Takers : public Endpoint {
 public:
  Takers(Bench<Vru_dispatch>& bench, Pace pace) : taken(kConfig.units), bench_(bench), pace_(pace) {
    bench.dut.out_ready_i = 0;
    bench.add(*this);
  }
  void drive() override {
    bench_.dut.out_ready_i = 0;
    for (int i = 0; i < kConfig.units; ++i) bench_.dut.out_ready_i |= goes(pace_, bench_.rng) << i;
  }
  void observe() override {
    auto& dut = bench_.dut;
    if (waiting_ != 0) {
      EXPECT_EQ(dut.out_valid_o & waiting_, waiting_) << "valid fell, cycle " << bench_.cycle;
      EXPECT_EQ((read_record<Sorted>(kConfig, dut.out_o)), last_) << "the beat changed, cycle " << bench_.cycle;
    }
    last_ = read_record<Sorted>(kConfig, dut.out_o);
    waiting_ = dut.out_valid_o & ~dut.out_ready_i;
    for (int i = 0; i < kConfig.units; ++i) {
      if ((dut.out_valid_o & dut.out_ready_i) >> i & 1) taken[i].push_back(last_);
    }
    EXPECT_TRUE(dut.active_o || (!dut.in_valid_i && dut.out_valid_o == 0));
  }
  std::vector<std::vector<Sorted>> taken;

 private:
  Bench<Vru_dispatch>& bench_;
  Pace pace_;
  Sorted last_;
  int waiting_ = 0;
};

Sorted random_splat(std::mt19937_64& rng) {
  Sorted splat = random_record<Sorted>(kConfig, rng);
  splat.kind = rng() % 8 == 0 ? 1 + rng() % 2 : 0;
  if (rng() % 2) splat.mask &= rng() & rng();
  if (rng() % 4 == 0) splat.mask = uint64_t{1} << rng() % kConfig.regions();
  return splat;
}

TEST(RuDispatch, EveryRuGetsTheSplatsOfItsRegionsAndAllEnds) {
  for (const Pace source_pace : kPaces) {
    for (const Pace sink_pace : kPaces) {
      Bench<Vru_dispatch> bench;
      RecordSource<Sorted, decltype(bench.dut.in_i)> in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o,
                                                        bench.dut.in_i, source_pace);
      Takers takers(bench, sink_pace);
      bench.reset();
      std::vector<std::vector<Sorted>> expected(kConfig.units);
      for (int i = 0; i < 1000; ++i) {
        const Sorted splat = random_splat(bench.rng);
        in.push(splat);
        for (int unit = 0; unit < kConfig.units; ++unit) {
          if (splat.kind != kData || (splat.mask & ru_own_mask(kConfig, unit)) != 0) expected[unit].push_back(splat);
        }
      }
      bench.run_until([&] { return in.empty() && bench.dut.out_valid_o == 0; });
      for (int unit = 0; unit < kConfig.units; ++unit) {
        ASSERT_EQ(takers.taken[unit].size(), expected[unit].size()) << "unit " << unit;
        for (size_t i = 0; i < expected[unit].size(); ++i) {
          ASSERT_EQ(first_difference(kConfig, expected[unit][i], takers.taken[unit][i]), "")
              << "unit " << unit << " beat " << i;
        }
      }
    }
  }
}

TEST(RuDispatch, MovesOneSplatPerCycle) {
  Bench<Vru_dispatch> bench;
  RecordSource<Sorted, decltype(bench.dut.in_i)> in(bench, kConfig, bench.dut.in_valid_i, bench.dut.in_ready_o,
                                                    bench.dut.in_i);
  Takers takers(bench, Pace::kAlways);
  bench.reset();
  for (int i = 0; i < 100; ++i) in.push(random_splat(bench.rng));
  const uint64_t start = bench.cycle;
  bench.run_until([&] { return in.empty(); });
  EXPECT_EQ(bench.cycle - start, 100u);
}

}  // namespace
}  // namespace pipegs
