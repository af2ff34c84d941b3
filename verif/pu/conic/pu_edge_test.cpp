// SPDX-License-Identifier: Apache-2.0
// pu_edge_test: rtl/pu/conic/pu_edge.sv against its bit-accurate model. The verdicts themselves are held against all
// pixels in pu_intersect_test.
#include "cpp_model/pu/conic/pu_edge.hpp"

#include "cpp_model/fixed.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "Vpu_edge.h"

namespace pipegs {
namespace {

// P around zero and gradients that bend within an edge, so that every branch of the verdict is taken.
TEST(PuEdge, EqualsItsModelWithHoldsInBetween) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  Bench<Vpu_edge> bench;
  auto& dut = bench.dut;
  auto field = [](int64_t value, int width) { return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1); };
  auto draw = [&](int bits) {
    return static_cast<int64_t>(rng() & ((uint64_t{1} << bits) - 1)) >> (rng() % static_cast<uint64_t>(bits));
  };
  dut.valid_i = 0, dut.hold_i = 0;
  bench.reset();
  int kept = 0;
  const int columns = config.part_regions_x(), count = 60000;
  for (int i = 0; i < count; ++i) {
    Coeff q;
    const int curve_w = config.coeff_f + 2 - static_cast<int>(rng() % 12);
    q.d = -draw(curve_w), q.e = -draw(curve_w), q.f = (rng() % 2 == 0 ? 1 : -1) * draw(curve_w);
    const int column = static_cast<int>(rng() % static_cast<uint64_t>(columns)),
              row = static_cast<int>(rng() % static_cast<uint64_t>(columns));
    const int64_t around = int64_t{24} << config.mean_f;
    q.mean_x = (int64_t{8 * column - 8} << config.mean_f) + static_cast<int64_t>(rng() % static_cast<uint64_t>(around));
    q.mean_y = (int64_t{8 * row - 8} << config.mean_f) + static_cast<int64_t>(rng() % static_cast<uint64_t>(around));
    PuEdgeStart p{-draw(config.coeff_f + 7), -7 * q.d * static_cast<int64_t>(rng() % 4) + draw(curve_w) - draw(curve_w),
                  -7 * q.e * static_cast<int64_t>(rng() % 4) + draw(curve_w) - draw(curve_w)};
    if (i % 2 == 0) {  // the peak of the left edge within one unit of the deficit around the cut
      q.mean_x = (int64_t{8 * column} << config.mean_f) - 1, q.mean_y = int64_t{8 * row + 3} << config.mean_f;
      q.e = -(int64_t{1} << config.coeff_f) - draw(config.coeff_f), q.d = -draw(config.coeff_f), q.f = 0;
      p.gy = -q.e * 7 + draw(config.coeff_f + 2) - draw(config.coeff_f + 2), p.gx = -(int64_t{1} << config.coeff_f);
      p.power = static_cast<int64_t>(-(Int128{p.gy} * p.gy) / (-4 * Int128{q.e})) + (draw(config.coeff_f - 11)) -
                (int64_t{1} << (config.coeff_f - 12));
    }
    dut.column_i = static_cast<CData>(column), dut.row_i = static_cast<CData>(row);
    dut.mean_x_i = field(q.mean_x, config.mean_w()), dut.mean_y_i = field(q.mean_y, config.mean_w());
    dut.d_i = field(q.d, config.def_w()), dut.e_i = field(q.e, config.def_w()), dut.f_i = field(q.f, config.def_w());
    dut.power_i = field(p.power, config.a_w() + 4);
    dut.gx_i = field(p.gx, config.bc_w() + 1), dut.gy_i = field(p.gy, config.bc_w() + 1);
    dut.valid_i = 1, dut.last_i = static_cast<CData>(i & 1);
    bench.step();
    dut.valid_i = 0;
    for (int stage = 0; stage < 2;) {
      dut.hold_i = rng() % 4 == 0;
      stage += !dut.hold_i;
      bench.step();
      dut.hold_i = 0;
    }
    dut.eval();
    const bool keep = pu_edge(config, q, column, row, p);
    ASSERT_EQ(dut.keep_o != 0, keep) << to_text(config, q) << " power " << p.power << " gx " << p.gx << " gy " << p.gy;
    ASSERT_EQ(dut.region_o, row * columns + column);
    ASSERT_EQ(dut.last_o, i & 1);
    bench.step();
    ASSERT_EQ(dut.keep_o, 0);
    kept += keep;
  }
  EXPECT_GT(kept, count / 10);
  EXPECT_LT(kept, count * 9 / 10);
}

}  // namespace
}  // namespace pipegs
