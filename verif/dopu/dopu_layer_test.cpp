// SPDX-License-Identifier: Apache-2.0
// dopu_layer_test: rtl/dopu/dopu_layer.sv against its bit-accurate model.
#include "Vdopu_layer.h"
#include "cpp_model/dopu/dopu_layer.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

TEST(DopuLayerModel, WalksEachSlabOnceNearestFirst) {
  Config config = test_config();
  if (!config.layered) GTEST_SKIP() << "without layers no slab is nearer";
  for (const int grid : {1, 2, 4, 8}) {
    config.grid = grid;
    for (int camera = 0; camera < grid; ++camera) {
      std::vector<int> slabs;
      for (int step = 0; step < 2 * grid; ++step) {
        if (const int slab = dopu_layer_step(config, camera, step); slab >= 0) slabs.push_back(slab);
      }
      ASSERT_EQ(slabs.size(), static_cast<size_t>(grid));
      for (size_t i = 1; i < slabs.size(); ++i) ASSERT_GE(std::abs(slabs[i] - camera), std::abs(slabs[i - 1] - camera));
    }
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<int> seen(static_cast<size_t>(grid * grid * grid));
      for (int slab = 0; slab < grid; ++slab) {
        for (int n = 0; n < grid * grid; ++n) {
          const int cell = dopu_layer_cell(config, axis, slab, n);
          ++seen.at(static_cast<size_t>(cell));
          ASSERT_EQ(dopu_layer_of(config, axis, cell), slab);
        }
      }
      for (const int times : seen) ASSERT_EQ(times, 1);
    }
  }
}

TEST(DopuLayer, EqualsItsModel) {
  const Config config = test_config();
  Bench<Vdopu_layer> bench;
  auto& dut = bench.dut;
  dut.start_i = 0;
  bench.reset();
  for (int round = 0; round < 300; ++round) {
    Frame frame = random_record<Frame>(config, bench.rng);
    const int axis = round % 3;
    if (round % 2 == 0) {  // a camera near the grid, so that all slabs occur
      const int64_t size = int64_t{1} << (config.world_w - 4);
      for (int64_t* field : {&frame.grid.low.x, &frame.grid.low.y, &frame.grid.low.z, &frame.camera.position.x,
                             &frame.camera.position.y, &frame.camera.position.z}) {
        *field = static_cast<int64_t>(bench.rng() % static_cast<uint64_t>(size));
      }
      frame.grid.scale_x = frame.grid.scale_y = frame.grid.scale_z = static_cast<uint64_t>(16 * config.grid);
    }
    write_frame(config, dut, frame);
    dut.axis_i = static_cast<CData>(axis);
    dut.start_i = 1;
    bench.step();
    dut.start_i = 0;
    const uint64_t before = bench.cycle;
    ASSERT_TRUE(bench.run_until(
        [&] {
          dut.eval();
          return dut.ready_o != 0;
        },
        200));
    EXPECT_LE(bench.cycle - before, static_cast<uint64_t>(config.focal_w() + 2));
    const int camera = dopu_layer_camera(config, frame, axis);
    for (int step = 0; step < 2 * config.grid; ++step) {
      for (int n = 0; n < config.grid * config.grid; ++n) {
        dut.step_i = static_cast<CData>(step);
        dut.number_i = static_cast<CData>(n);
        dut.eval();
        const int slab = dopu_layer_step(config, camera, step);
        ASSERT_EQ(dut.inside_o, slab >= 0) << to_text(config, frame) << " axis " << axis << " step " << step;
        if (slab >= 0) {
          ASSERT_EQ(static_cast<int>(dut.cell_o), dopu_layer_cell(config, axis, slab, n))
              << "axis " << axis << " step " << step << " n " << n;
        }
      }
    }
  }
}

}  // namespace
}  // namespace pipegs
