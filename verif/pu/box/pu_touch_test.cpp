// SPDX-License-Identifier: Apache-2.0
// pu_touch_test: rtl/pu/box/pu_touch.sv against its bit-accurate model as it is walked through squares; the model, with
// pu_axes and pu_box before it, against the box of double precision.
#include "cpp_model/pu/box/pu_touch.hpp"

#include "Vpu_touch.h"
#include "verif/pu/box/float_box.hpp"
#include "verif/pu/random_splat.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

constexpr int kSquare = 8;  // the module's parameter

// A covariance with its box, its mean near the window.
Covariance boxed(const Config& config, std::mt19937_64& rng, FloatBox* exact = nullptr) {
  static constexpr double kLongest[] = {1, 5, 30, 300, 5000};
  const Covariance in = random_splat(config, rng, kLongest[rng() % 5]).record;
  if (exact != nullptr) *exact = float_box(in);
  return pu_box(config, Frame{}, pu_axes(config, Frame{}, in));
}

// A straight box whose edge falls on the last pixels of the square that begins at (x, y): they touch.
void end_at_edge(const Config& config, std::mt19937_64& rng, int64_t x, int64_t y, Covariance& k) {
  const double half = (kSquare - 1) / 2.0;
  const auto away = static_cast<int64_t>(rng() % 512) - 256;  // of its mean from their middle, sixteenths of a pixel
  const auto at = [&](int64_t first) { return static_cast<int64_t>(std::ldexp(first + half, config.mean_f)); };
  const bool across = rng() % 2 != 0;
  const auto side = static_cast<uint64_t>(std::ldexp(std::max(0.0, std::abs(away) / 16.0 - half), kSideF));
  const uint64_t wide = uint64_t{1} << (config.side_w() - 1);
  k.tilt = 0;
  k.mean_x = at(x) + (across ? 0 : away * (int64_t{1} << (config.mean_f - 4)));
  k.mean_y = at(y) + (across ? away * (int64_t{1} << (config.mean_f - 4)) : 0);
  k.side_u = across ? wide : side, k.side_v = across ? side : wide;
}

TEST(PuTouch, EqualsItsModelSquareBySquare) {
  const Config config = test_config();
  Bench<Vpu_touch> bench;
  auto& rng = bench.rng;
  auto& dut = bench.dut;
  const auto field = [](int64_t value, int width) {
    return static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1);
  };
  const int way_w = config.mean_w() + 2;
  int touched = 0, squares = 0;
  bench.reset();
  for (int i = 0; i < 20000; ++i) {
    Covariance k = boxed(config, rng);
    if (rng() % 8 == 0) {  // far away, of any size
      k.mean_x = random_record<Covariance>(config, rng).mean_x >> (rng() % 12);
      k.mean_y = random_record<Covariance>(config, rng).mean_y >> (rng() % 12);
      k.side_u = rng() % (uint64_t{1} << config.side_w()), k.side_v = rng() % (uint64_t{1} << config.side_w());
    }
    const int64_t from_x = 8 * static_cast<int64_t>(rng() % 8), from_y = 8 * static_cast<int64_t>(rng() % 8);
    if (rng() % 8 == 0) end_at_edge(config, rng, from_x, from_y, k);
    const auto columns = static_cast<int64_t>(1 + rng() % 4), rows = static_cast<int64_t>(1 + rng() % 4);
    dut.load_i = 1, dut.step_i = 0, dut.down_i = static_cast<CData>(rng() % 2);
    dut.dx_i = field(2 * k.mean_x - ((2 * from_x + kSquare - 1) << config.mean_f), way_w);
    dut.dy_i = field(2 * k.mean_y - ((2 * from_y + kSquare - 1) << config.mean_f), way_w);
    dut.tilt_i = static_cast<IData>(field(k.tilt, config.tilt_w()));
    dut.side_u_i = static_cast<IData>(k.side_u), dut.side_v_i = static_cast<IData>(k.side_v);
    bench.step();
    dut.load_i = 0;
    dut.tilt_i = static_cast<IData>(field(static_cast<int64_t>(rng()), config.tilt_w()));
    for (int64_t row = 0; row < rows; ++row) {
      for (int64_t column = 0; column < columns; ++column) {
        dut.step_i = 0;
        if (rng() % 4 == 0) bench.step();  // stands still
        const bool wanted =
            pu_touch(config, k, from_x, from_y, from_x + kSquare * column, from_y + kSquare * row, kSquare);
        dut.eval();
        ASSERT_EQ(dut.touches_o != 0, wanted)
            << column << "," << row << ", seed " << bench.seed << ": " << to_text(config, k);
        touched += wanted, ++squares;
        dut.step_i = 1, dut.down_i = column == columns - 1;
        bench.step();
      }
    }
    dut.step_i = 0;
  }
  EXPECT_GT(touched, squares / 5);
  EXPECT_LT(touched, squares * 4 / 5);
}

// Squares that the box of double precision touches are touched, and others only if they are nearer to it than 1/32 px
// and 2^-11 of its length.
TEST(PuTouchModel, AgreesWithDouble) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  int64_t touched = 0, beyond = 0;
  for (int i = 0; i < 50000; ++i) {
    FloatBox exact;
    const Covariance k = boxed(config, rng, &exact);
    if (exact.round) continue;
    const double mean_x = std::ldexp(static_cast<double>(k.mean_x), -config.mean_f),
                 mean_y = std::ldexp(static_cast<double>(k.mean_y), -config.mean_f);
    const double more = 1.0 / 32 + std::ldexp(exact.side_long, -11);
    for (int y = 0; y < config.window; y += kSquare) {
      for (int x = 0; x < config.window; x += kSquare) {
        // The columns and rows of the extents are pu_intersect's, not pu_touch's.
        FloatBox wide = exact;
        wide.along = wide.across = 1e9;
        const bool found = pu_touch(config, k, 0, 0, x, y, kSquare),
                   is = touches(wide, mean_x, mean_y, x, y, kSquare, 0);
        if (is) { ASSERT_TRUE(found) << x << "," << y << " " << to_text(config, k); }
        if (found) {
          ASSERT_TRUE(touches(wide, mean_x, mean_y, x, y, kSquare, more)) << x << "," << y << " " << to_text(config, k);
        }
        touched += is, beyond += found && !is;
      }
    }
  }
  std::printf("pu_touch: %.3g of the squares beyond those of double precision\n",
              static_cast<double>(beyond) / static_cast<double>(touched));
  EXPECT_GT(touched, 100000);
  EXPECT_LT(static_cast<double>(beyond), 0.01 * static_cast<double>(touched)) << "of needles, most";
}

}  // namespace
}  // namespace pipegs
