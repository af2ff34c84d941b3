// SPDX-License-Identifier: Apache-2.0
// pu_deal_test: rtl/pu/pu_deal.sv: every Gaussian arrives at exactly one PU and in its layer, ends arrive at all.
#include <map>

#include "Vpu_deal.h"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

class PuDeal : public testing::Test {
 protected:
  struct Dealt {
    uint64_t cycle, index;
    int unit;
    bool operator==(const Dealt&) const = default;
  };
  // Several streams of layers, each with its own number of Gaussians, `idle` cycles after the reset; returns the cycles
  // that passed.
  uint64_t deal(Pace source_pace, Pace sink_pace, int layers, int most, int idle = 0) {
    const Config config = test_config();
    const int units = config.units, fronts = config.pu_fronts(), width = record_width<Visible>(config);
    Bench<Vpu_deal> bench;
    std::vector<std::deque<Visible>> sources(fronts);
    std::map<uint64_t, int> layer_of;  // by index
    uint64_t index = 0;
    for (int layer = 0; layer < layers; ++layer) {
      for (auto& source : sources) {
        for (int n = static_cast<int>(bench.rng() % static_cast<uint64_t>(most + 1)); n > 0; --n) {
          source.push_back(random_record<Visible>(config, bench.rng));
          source.back().kind = kData;
          source.back().index = index;
          layer_of[index++] = layer;
          if (config.eyes == 1) continue;
          source.back().eye = 0;
          source.push_back(source.back());  // as the second eye sees it
          source.back().eye = 1;
          source.back().index = index;
          layer_of[index++] = layer;
        }
        source.push_back({});
        source.back().kind = layer + 1 == layers ? kWindowEnd : kLayerEnd;
      }
    }
    dealt_ = index;
    std::vector<bool> up(fronts);
    std::vector<int> layer(units, 0);
    bench.dut.in_valid_i = 0;
    bench.dut.out_ready_i = static_cast<CData>((1 << units) - 1);  // empty queues
    bench.reset();
    for (int i = 0; i < idle; ++i) bench.step();
    order.clear();
    taken_ = 0;
    const uint64_t start = bench.cycle;
    uint32_t shown = 0;  // and not taken
    int ended = 0;
    for (; ended < units && bench.cycle < start + 200000; ++bench.cycle) {
      Words all(port_words<decltype(bench.dut.in_i)>() + 2);
      uint32_t valid = 0;
      for (int u = 0; u < fronts; ++u) {
        if (!up[u]) up[u] = !sources[u].empty() && goes(source_pace, bench.rng);
        if (!up[u]) continue;
        valid |= 1u << u;
        Words one(static_cast<size_t>(width) / 32 + 2);
        pack(config, sources[u].front(), one.data());
        for (int bit = 0; bit < width; bit += 32) {
          const int take = std::min(32, width - bit);
          put_bits(all.data(), u * width + bit, take, get_bits(one.data(), bit, take));
        }
      }
      uint32_t ready = 0;
      for (int u = 0; u < units; ++u) ready |= static_cast<uint32_t>(goes(sink_pace, bench.rng)) << u;
      bench.dut.in_valid_i = static_cast<CData>(valid);
      // A PU's queue, once it has room, keeps it until it is given something. A lazy one is ready only for what it saw.
      const bool lazy = sink_pace == Pace::kLazy;
      bench.dut.out_ready_i = static_cast<CData>(lazy ? ready & shown : ready | (bench.dut.out_ready_i & ~taken_));
      bench.dut.out_room_i = static_cast<CData>(lazy ? (1u << units) - 1 : bench.dut.out_ready_i);
      write_port(bench.dut.in_i, all.data());
      bench.dut.clk_i = 0;
      bench.dut.eval();
      const uint32_t handshakes = bench.dut.out_valid_o & bench.dut.out_ready_i;
      taken_ = static_cast<CData>(handshakes);
      EXPECT_EQ(shown & ~bench.dut.out_valid_o, 0u) << "a record was withdrawn, cycle " << bench.cycle;
      shown = bench.dut.out_valid_o & ~handshakes;
      const Visible out = read_record<Visible>(config, bench.dut.out_o);
      for (int f = 0; f < fronts; ++f)
        if ((bench.dut.in_ready_o & valid) >> f & 1) sources[f].pop_front(), up[f] = false;
      for (int u = 0; u < units; ++u) {
        if ((handshakes >> u & 1) == 0) continue;
        order.push_back({bench.cycle - start, out.kind == kData ? out.index : ~uint64_t{0}, u});
        if (out.kind != kData) {
          ++layer[u];
          ended += out.kind == kWindowEnd;
        } else {
          const auto found = layer_of.find(out.index);
          if (found == layer_of.end()) {
            ADD_FAILURE() << "Gaussian " << out.index << " came twice";
            return 0;
          }
          EXPECT_EQ(found->second, layer[u]) << "Gaussian " << out.index << " came in a wrong layer";
          layer_of.erase(found);
        }
      }
      bench.dut.clk_i = 1;
      bench.dut.eval();
    }
    EXPECT_EQ(ended, units);
    EXPECT_TRUE(layer_of.empty()) << layer_of.size() << " Gaussians were lost";
    return bench.cycle - start;
  }
  CData taken_ = 0;
  uint64_t dealt_ = 0;       // Gaussians of the last run
  std::vector<Dealt> order;  // and where they and the ends went
};

TEST_F(PuDeal, EveryGaussianArrivesOnceInItsLayerAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) deal(source, sink, 20, 30);
  }
}

// So the cycles of a frame do not depend on when it begins.
TEST_F(PuDeal, WhoIsDealtToDoesNotDependOnTheCyclesBefore) {
  for (const Pace sink : kPaces) {
    deal(Pace::kQuarter, sink, 5, 20);
    const std::vector<Dealt> first = order;
    for (int idle = 1; idle < 6; ++idle) {
      deal(Pace::kQuarter, sink, 5, 20, idle);
      EXPECT_EQ(order, first) << idle << " cycles later, PUs " << to_text(sink);
    }
  }
}

TEST_F(PuDeal, DealsOneGaussianPerCycleToPusInTurn) {
  const uint64_t cycles = deal(Pace::kAlways, Pace::kAlways, 1, 2000);
  // The last Gaussians come from fewer and fewer sources, each of which gives one per cycle; a single PU takes every
  // second.
  // So is the second one of a pair.
  const double pace = test_config().units == 1 ? 2 : test_config().eyes == 1 ? 1 : 1.5;
  EXPECT_LE(static_cast<double>(cycles), pace * static_cast<double>(dealt_) + 10);
}

TEST_F(PuDeal, BothEyesViewsOfAGaussianGoToOnePu) {
  if (test_config().eyes == 1) GTEST_SKIP() << "one eye";
  deal(Pace::kAlways, Pace::kAlways, 4, 300);
  ASSERT_GT(dealt_, 500u);
  for (size_t i = 0; i + 1 < order.size(); ++i) {
    if (order[i].index == ~uint64_t{0} || order[i].index % 2 != 0) continue;
    EXPECT_EQ(order[i + 1].index, order[i].index + 1) << "another Gaussian came between";
    EXPECT_EQ(order[i + 1].unit, order[i].unit) << "Gaussian " << order[i].index;
  }
}

}  // namespace
}  // namespace pipegs
