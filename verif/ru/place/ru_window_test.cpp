// SPDX-License-Identifier: Apache-2.0
// ru_window_test: rtl/ru/place/ru_window.sv against ru_inside, ru_pixel_line and ru_raster_line.
#include "cpp_model/ru/ru.hpp"
#include "verif/ru/region_ports.hpp"
#include "verif/support/config.hpp"
#include "Vru_window.h"

namespace pipegs {
namespace {

const Config kConfig = test_config();

TEST(RuWindow, FollowsTheWindowsOfManyFrames) {
  Bench<Vru_window> bench;
  auto& dut = bench.dut;
  dut.restart_i = dut.advance_i = 0;
  bench.reset();
  const uint64_t window = kConfig.window;
  for (int i = 0; i < 200; ++i) {
    Frame frame;
    frame.raster.width = i == 0 ? 1 : i == 1 ? 10000 : 1 + bench.rng() % (6 * window);
    frame.raster.height = i == 0 ? 1 : 1 + bench.rng() % (6 * window);
    frame.raster.windows.first_x = bench.rng() % ru_windows_x(kConfig, frame);
    frame.raster.windows.last_x =
        frame.raster.windows.first_x + bench.rng() % (ru_windows_x(kConfig, frame) - frame.raster.windows.first_x);
    frame.raster.windows.first_y = bench.rng() % ru_windows_y(kConfig, frame);
    frame.raster.windows.last_y =
        frame.raster.windows.first_y + bench.rng() % (ru_windows_y(kConfig, frame) - frame.raster.windows.first_y);
    frame.tables.pixels = bench.rng() % 1000000;
    Picture picture{.format = bench.rng() % 2, .base = frame.tables.pixels, .stride = bench.rng() % 4096};
    write_port(dut.picture_i, picture_words(kConfig, picture).data());
    dut.width_i = frame.raster.width;
    dut.height_i = frame.raster.height;
    dut.first_x_i = frame.raster.windows.first_x;
    dut.first_y_i = frame.raster.windows.first_y;
    dut.last_x_i = frame.raster.windows.last_x;
    dut.restart_i = 1;
    bench.step();
    dut.restart_i = 0;
    for (uint64_t y = frame.raster.windows.first_y; y <= frame.raster.windows.last_y; ++y) {
      for (uint64_t x = frame.raster.windows.first_x; x <= frame.raster.windows.last_x; ++x) {
        for (int wait = bench.rng() % 3; wait > 0; --wait) bench.step();
        ASSERT_EQ(dut.x_o, x);
        ASSERT_EQ(dut.y_o, y);
        ASSERT_EQ(dut.columns_o, std::min(window, frame.raster.width - x * window));
        ASSERT_EQ(dut.rows_o, std::min(window, frame.raster.height - y * window));
        ASSERT_EQ(dut.line_o, picture.format != 0 ? ru_raster_line(picture, x * window, y * window)
                                                  : ru_pixel_line(kConfig, frame, x, y, 0, 0));
        RegionSet outside;
        for (int r = 0; r < kConfig.regions(); ++r) outside.add(kConfig, r, !ru_inside(kConfig, frame, x, y, r));
        ASSERT_TRUE(read_regions(kConfig, dut.outside_o) == outside)
            << frame.raster.width << "x" << frame.raster.height << " window " << x << "," << y;
        dut.advance_i = 1;
        bench.step();
        dut.advance_i = 0;
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
