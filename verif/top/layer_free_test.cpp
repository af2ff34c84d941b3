// SPDX-License-Identifier: Apache-2.0
// layer_free_test: rtl/pipegs_layer_free.sv against counts: one pulse per layer, as soon as all RUs have finished it.
#include <algorithm>

#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpipegs_layer_free.h"

namespace pipegs {
namespace {

TEST(LayerFree, FreesEachLayerOnceWhenEveryRuHasFinishedIt) {
  const Config config = test_config();
  const size_t units = static_cast<size_t>(config.units);
  for (const Pace pace : kPaces) {
    Bench<Vpipegs_layer_free> bench;
    auto& dut = bench.dut;
    dut.done_i = 0;
    bench.reset();
    std::vector<uint64_t> finished(units);
    uint64_t freed = 0, drift = 0;
    size_t slow = 0;
    for (int cycle = 0; cycle < 10000; ++cycle) {
      if (cycle % 50 == 0) slow = bench.rng() % (units + 1);  // one RU, or none, lags
      const auto [least, most] = std::minmax_element(finished.begin(), finished.end());
      drift = std::max(drift, *most - *least);
      // Registered: what was finished before this cycle and is not free yet is freed now.
      const bool expected = *least > freed;
      unsigned done = 0;
      for (size_t i = 0; i < units; ++i) {
        // AlphaLayers live. A layer freed in this cycle makes room for a pulse in the next one.
        const bool may = finished[i] - freed < static_cast<uint64_t>(config.alpha_layers);
        if (may && goes(pace, bench.rng) && (i != slow || bench.rng() % 16 == 0)) done |= 1u << i;
      }
      dut.done_i = static_cast<CData>(done);
      dut.clk_i = 0;
      dut.eval();
      ASSERT_EQ(dut.free_o, expected) << "cycle " << bench.cycle << ", pace " << to_text(pace) << ", seed "
                                      << bench.seed;
      freed += dut.free_o;
      for (size_t i = 0; i < units; ++i) finished[i] += (done >> i) & 1;
      bench.step();
    }
    dut.done_i = 0;
    bench.step();
    bench.step();
    EXPECT_GT(freed, 100u);
    EXPECT_EQ(drift, units > 1 ? static_cast<uint64_t>(config.alpha_layers) : 0u)
        << "the RUs never drifted apart by all layers that live";
  }
}

}  // namespace
}  // namespace pipegs
