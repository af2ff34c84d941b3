// SPDX-License-Identifier: Apache-2.0
// dopu_planes_test: rtl/dopu/dopu_planes.sv against its bit-accurate model; the model against double
// precision.
#include "Vdopu_planes.h"
#include "cpp_model/dopu/dopu_planes.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"
#include "verif/support/random_open.hpp"

namespace pipegs {
namespace {

Frame random_frame(const Config& config, std::mt19937_64& rng) {
  const Camera camera = random_camera(rng, 200 + static_cast<int>(rng() % 800), 200 + static_cast<int>(rng() % 800));
  return frame_setup(config, pack_scene(config, random_scene(rng, 20), camera_bound(camera)), camera);
}

// Of the whole window, or of a part of it with a pixel.
uint64_t random_walk(const Config& config, const Frame& frame, uint64_t x, uint64_t y, std::mt19937_64& rng) {
  if (!config.has_walks() || rng() % 3 == 0) return kWholeWalk;
  const uint64_t walk = walk_of(config, rng() % static_cast<uint64_t>(config.parts()));
  const WalkSquare square = walk_square(config, walk);
  const auto side = static_cast<uint64_t>(config.window);
  const bool inside = x * side + static_cast<uint64_t>(square.x) < frame.raster.width &&
                      y * side + static_cast<uint64_t>(square.y) < frame.raster.height;
  return inside ? walk : kWholeWalk;
}

TEST(DopuPlanesModel, PassesThroughTheEdgesOfTheWindow) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    const Frame f = random_frame(config, rng);
    const int wx = static_cast<int>(rng() % (f.raster.windows.last_x + 1)),
              wy = static_cast<int>(rng() % (f.raster.windows.last_y + 1));
    const uint64_t walk = random_walk(config, f, static_cast<uint64_t>(wx), static_cast<uint64_t>(wy), rng);
    const Plane left = dopu_planes(config, f, wx, wy, walk)[kLeft];
    // A point on the left edge at depth 1, two pixels outside, lies in the plane: distance zero, here in pixels.
    const double fx = std::ldexp(static_cast<double>(f.lens.focal_x), -config.focal_f()),
                 cx = std::ldexp(static_cast<double>(f.lens.center_x), -config.center_f());
    const double x =
        (static_cast<double>(wx * config.window + walk_square(config, walk).x - config.reach_margin()) - cx) / fx;
    const double w[9] = {
        double(f.camera.rotation.w00), double(f.camera.rotation.w01), double(f.camera.rotation.w02), 0, 0, 0,
        double(f.camera.rotation.w20), double(f.camera.rotation.w21), double(f.camera.rotation.w22)};
    double distance = 0, unit = 0;
    const double n[3] = {double(left.nx), double(left.ny), double(left.nz)};
    for (int k = 0; k < 3; ++k) {
      distance += n[k] * std::ldexp(w[k] * x + w[6 + k], -config.rot_f());
      unit += n[k] * std::ldexp(w[k], -config.rot_f()) / fx;  // a step of one pixel
    }
    worst = std::max(worst, std::abs(distance / unit));
  }
  RecordProperty("largest_error_pixels", std::to_string(worst));
  std::printf("dopu_planes: largest error of an edge %.4f px\n", worst);
  EXPECT_LT(worst, 0.25);
}

TEST(DopuPlanes, EqualsItsModelAtEveryPace) {
  const Config config = test_config();
  Bench<Vdopu_planes> bench;
  auto& dut = bench.dut;
  WordSource<decltype(dut.window_i)> in(bench, dut.window_valid_i, dut.window_ready_o, dut.window_i);
  std::deque<Closed> closed;  // of the windows that are not taken yet
  const Beside sides(
      bench,
      [&] {
        if (dut.window_valid_i && dut.window_ready_o) closed.pop_front();
      },
      [&] { write_record(config, dut.closed_i, closed.empty() ? Closed{} : closed.front()); });
  WordSink<decltype(dut.planes_o)> out(bench, dut.planes_valid_o, dut.planes_ready_i, dut.planes_o);
  bench.reset();
  for (int round = 0; round < 60; ++round) {
    in.pace = kPaces[round % 3];
    out.pace = kPaces[round / 3 % 3];
    const Frame frame = random_frame(config, bench.rng);
    write_frame(config, dut, frame);
    std::vector<Planes> expected;
    const size_t first = out.beats.size();
    for (int i = 0; i < 20; ++i) {
      const uint32_t x = static_cast<uint32_t>(bench.rng() % (frame.raster.windows.last_x + 1)),
                     y = static_cast<uint32_t>(bench.rng() % (frame.raster.windows.last_y + 1));
      const uint64_t walk = random_walk(config, frame, x, y, bench.rng);
      in.push({static_cast<uint32_t>(walk << 2 * config.window_w() | y << config.window_w() | x)});
      closed.push_back(config.has_lists() || i % 3 == 0 ? Closed{} : random_closed(config, walk, bench.rng));
      // Of a rectangle beyond the picture nothing is asked for.
      const uint64_t left = x * static_cast<uint64_t>(config.window), top = y * static_cast<uint64_t>(config.window);
      if (left + static_cast<uint64_t>(walk_square(config, walk).x) + 8 * closed.back().left >= frame.raster.width)
        closed.back().left = 0;
      if (top + static_cast<uint64_t>(walk_square(config, walk).y) + 8 * closed.back().top >= frame.raster.height)
        closed.back().top = 0;
      expected.push_back(dopu_planes(config, frame, static_cast<int>(x), static_cast<int>(y), walk, closed.back()));
    }
    ASSERT_TRUE(bench.run_until([&] { return out.beats.size() == first + expected.size(); }));
    const int width = record_width<Plane>(config);
    for (size_t i = 0; i < expected.size(); ++i) {
      for (int side = 0; side < kPlanes; ++side) {
        Words words(4);
        for (int bit = 0; bit < width; ++bit)
          put_bits(words.data(), bit, 1, get_bits(out.beats[first + i].data(), side * width + bit, 1));
        ASSERT_EQ(first_difference(config, expected[i][static_cast<size_t>(side)], unpack<Plane>(config, words.data())),
                  "")
            << "side " << side << " " << to_text(config, frame);
      }
    }
    if (round == 0) { EXPECT_LE(out.cycles.back() - out.cycles[first], 19u * 54) << "pace: 54 cycles a window"; }
  }
}

}  // namespace
}  // namespace pipegs
