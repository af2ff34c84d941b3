// SPDX-License-Identifier: Apache-2.0
// dopu_origin_test: rtl/dopu/dopu_origin.sv against its bit-accurate model; the model against double
// precision.
#include "Vdopu_origin.h"
#include "cpp_model/dopu/dopu_origin.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"
#include "verif/support/frame_ports.hpp"

namespace pipegs {
namespace {

Frame random_frame(const Config& config, std::mt19937_64& rng) {
  const Camera camera = random_camera(rng, 300, 200);
  return frame_setup(config, pack_scene(config, random_scene(rng, 20), camera_bound(camera)), camera);
}

// A node at any distance from the camera, with offsets of any size.
template <class Rng>
Node random_node(const Config& config, const Frame& frame, Rng& rng) {
  Node node = random_record<Node>(config, rng);
  const int shift = static_cast<int>(rng() % static_cast<uint64_t>(config.world_w));
  const auto near = [&](int64_t& center, int64_t camera) {
    center = saturate(camera + shift_floor(center, shift), config.world_w);
  };
  near(node.center_x, frame.camera.position.x);
  near(node.center_y, frame.camera.position.y);
  near(node.center_z, frame.camera.position.z);
  node.offset_exp = rng() % (1 + rng() % static_cast<uint64_t>(config.world_w - config.pos_w));
  return node;
}

TEST(DopuOriginModel, IsNearestAndLeavesRoomForEveryOffset) {
  const Config config = test_config();
  std::mt19937_64 rng(test_seed());
  double worst = 0;
  for (int round = 0; round < 100; ++round) {
    const Frame f = random_frame(config, rng);
    for (int i = 0; i < 200; ++i) {
      const Node node = random_node(config, f, rng);
      const Chunk chunk = dopu_origin(config, f, node, 0, 0);
      const long double dx = static_cast<long double>(node.center_x - f.camera.position.x),
                        dy = static_cast<long double>(node.center_y - f.camera.position.y),
                        dz = static_cast<long double>(node.center_z - f.camera.position.z);
      const long double z =
          std::ldexp((f.camera.rotation.w20 * dx + f.camera.rotation.w21 * dy + f.camera.rotation.w22 * dz),
                     -config.rot_f() - static_cast<int>(chunk.view_exp));
      worst = std::max(worst, static_cast<double>(std::abs(z - static_cast<long double>(chunk.origin_z))));
      const double offset = std::sqrt(3.0) * std::ldexp(1.0, config.pos_w - 1 + static_cast<int>(node.offset_exp) -
                                                                 static_cast<int>(chunk.view_exp));
      for (const int64_t o : {chunk.origin_x, chunk.origin_y, chunk.origin_z}) {
        ASSERT_LT(std::abs(static_cast<double>(o)) + offset * 1.0001 + 1, std::ldexp(1.0, config.view_w - 1))
            << to_text(config, chunk);
      }
    }
  }
  std::printf("dopu_origin: largest error %.6f units of 2^view_exp\n", worst);
  EXPECT_LE(worst, 0.5001);
}

void compare(Pace source, Pace sink) {
  const Config config = test_config();
  Bench<Vdopu_origin> bench;
  auto& dut = bench.dut;
  WordSource<decltype(dut.node_i)> in(bench, dut.node_valid_i, dut.node_ready_o, dut.node_i, source);
  RecordSink<Chunk, decltype(dut.chunk_o)> out(bench, config, dut.chunk_valid_o, dut.chunk_ready_i, dut.chunk_o, sink);
  struct Side : Endpoint {  // what travels beside the node
    Bench<Vdopu_origin>& bench;
    std::deque<Chunk> sides;
    explicit Side(Bench<Vdopu_origin>& b) : bench(b) { b.add(*this); }
    void drive() override {
      if (sides.empty()) return;
      bench.dut.kind_i = static_cast<CData>(sides.front().kind);
      bench.dut.window_x_i = static_cast<SData>(sides.front().window_x);
      bench.dut.window_y_i = static_cast<SData>(sides.front().window_y);
    }
    void observe() override {
      if (bench.dut.node_valid_i && bench.dut.node_ready_o) sides.pop_front();
    }
  } side(bench);
  bench.reset();
  for (int round = 0; round < 12; ++round) {
    const Frame frame = random_frame(config, bench.rng);
    write_frame(config, dut, frame);
    const size_t first = out.size();
    std::vector<Chunk> expected;
    for (int i = 0; i < 100; ++i) {
      const Node node = random_node(config, frame, bench.rng);
      Chunk chunk =
          dopu_origin(config, frame, node, static_cast<int>(bench.rng() % 1024), static_cast<int>(bench.rng() % 1024));
      if (round != 0 && bench.rng() % 5 == 0) {
        Chunk end;
        end.kind = 1 + bench.rng() % 2;
        end.window_x = chunk.window_x;
        end.window_y = chunk.window_y;
        chunk = end;
      }
      Words words(static_cast<size_t>(record_words<Node>(config)) + 1);
      pack(config, node, words.data());
      in.push(words);
      side.sides.push_back(chunk);
      expected.push_back(chunk);
    }
    ASSERT_TRUE(bench.run_until([&] { return out.size() == first + expected.size(); }));
    for (size_t i = 0; i < expected.size(); ++i)
      ASSERT_EQ(first_difference(config, expected[i], out.at(first + i)), "")
          << "beat " << first + i << " cycle " << out.cycles[first + i];
    if (round == 0 && source == Pace::kAlways && sink == Pace::kAlways) {
      EXPECT_EQ(out.cycles.back() - out.cycles.front(), 99u * 10) << "pace";
    }
  }
}

TEST(DopuOrigin, EqualsItsModelAtEveryPace) {
  for (const Pace source : kPaces) {
    for (const Pace sink : kPaces) compare(source, sink);
  }
}

}  // namespace
}  // namespace pipegs
