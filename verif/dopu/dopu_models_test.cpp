// SPDX-License-Identifier: Apache-2.0
// dopu_models_test: the walk through the slabs, and the origins of chunks against double precision. Their RTL, whose
// every bit leaves the DOPU, is compared in dopu_test.
#include "cpp_model/dopu/dopu_layer.hpp"
#include "cpp_model/dopu/dopu_origin.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/bench.hpp"

namespace pipegs {
namespace {

TEST(DopuModels, TheWalkTakesEachSlabOnceNearestFirst) {
  Config config;
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

TEST(DopuModels, AnOriginIsNearestAndLeavesRoomForEveryOffset) {
  const Config config;
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

}  // namespace
}  // namespace pipegs
