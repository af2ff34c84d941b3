// SPDX-License-Identifier: Apache-2.0
// dopu_depth_test: rtl/dopu/nearest/dopu_depth.sv against its bit-accurate model; the model's bound against every
// Gaussian of random scenes.
#include "Vdopu_depth.h"
#include "cpp_model/dopu/nearest/dopu_depth.hpp"
#include "cpp_model/dopu/nearest/dopu_nearest.hpp"
#include "cpp_model/golden.hpp"
#include "cpp_model/pu/front/pu_cull.hpp"
#include "cpp_model/pu/project/pu_project.hpp"
#include "verif/dopu/dopu_world.hpp"
#include "verif/support/bench.hpp"
#include "verif/support/config.hpp"

namespace pipegs {
namespace {

TEST(DopuDepth, EqualsItsModel) {
  Bench<Vdopu_depth> bench;
  const int bits = 2 * test_config().test_w() + 2;
  for (int i = 0; i < 200000; ++i) {
    int64_t value = static_cast<int64_t>(bench.rng() << (64 - bits)) >> (64 - bits);
    value >>= bench.rng() % static_cast<uint64_t>(bits);
    if (i % 3 == 0)
      value =
          (int64_t{1} << (bench.rng() % static_cast<uint64_t>(bits - 1))) + static_cast<int64_t>(bench.rng() % 3) - 1;
    const int exponent = static_cast<int>(bench.rng() % 27);
    bench.dut.value_i = static_cast<QData>(value) & ((QData{1} << bits) - 1);
    bench.dut.exponent_i = static_cast<CData>(exponent);
    bench.dut.eval();
    ASSERT_EQ(bench.dut.step_o, dopu_depth_step(test_config(), value, exponent - kNormalF))
        << value << " * 2^" << exponent << ", seed " << bench.seed;
  }
}

// Every Gaussian that the PU keeps: its depth against the bound of each of its nodes, its key against their edges.
struct Bounds {
  const Config& config;
  const Frame& frame;
  const PackedScene& packed;
  uint64_t kept = 0;
  double least = 1e9,
         slack = 0;  // the smallest distance from a bound, and what the bounds give away, in the test's units

  void check(const Planes& planes, const Node& node, const Visible& visible, uint64_t key, const char* what) {
    const Corners box = dopu_test_corners(config, frame, node, dopu_depth_near(config, frame));
    const double bound =
        std::ldexp(static_cast<double>(dopu_depth_bound(config, box, planes[kNear])), box.exponent - kNormalF);
    const double depth = std::ldexp(static_cast<double>(visible.view_z), static_cast<int>(visible.view_exp));
    ASSERT_GE(depth, bound) << what << " " << to_text(config, node) << " slot " << visible.slot;
    ASSERT_GE(key, dopu_depth_key(config, frame, dopu_depth(config, frame, planes, node, 0)))
        << what << " " << to_text(config, node);
    const double distance = std::ldexp(depth - bound, -box.exponent);
    if (distance < least)
      least = distance, slack = std::ldexp(static_cast<double>(dopu_depth_slack(config)), -kNormalF);
  }
  void window(int x, int y) {
    const Planes planes = dopu_planes(config, frame, x, y);
    for (const Node& cell : packed.cells) {
      for (uint64_t g = cell.first; g < cell.first + cell.count; ++g) {
        const Node& group = packed.groups[g];
        for (uint64_t i = group.first; i < group.first + group.count; ++i) {
          const Node& node = packed.chunks[i];
          const Chunk chunk = dopu_origin(config, frame, node, x, y);
          for (uint64_t slot = chunk.slot; slot < chunk.slot + chunk.count; ++slot) {
            Fetched fetched = golden_fetched(chunk, packed.gaussians[slot], slot);
            fetched.opacity = 0;  // reaches farthest
            const std::optional<Visible> visible = pu_cull(config, frame, fetched);
            if (!visible) continue;
            ++kept;
            const uint64_t key = pu_project(config, frame, *visible).payload.depth;
            check(planes, node, *visible, key, "chunk");
            check(planes, group, *visible, key, "group");
            check(planes, cell, *visible, key, "cell");
          }
        }
      }
    }
  }
};

// Random scenes and cameras, near planes from nothing to far, in configurations with coarse view coordinates and fine
// offsets.
TEST(DopuDepth, NoGaussianIsNearerThanItsNodes) {
  std::mt19937_64 rng(test_seed());
  for (const auto& [view_w, pos_w, world_w] : {std::tuple{28, 20, 40}, {22, 24, 44}, {30, 12, 32}, {22, 12, 32}}) {
    Config config = test_config();
    config.view_w = view_w, config.pos_w = pos_w, config.world_w = world_w;
    uint64_t kept = 0;
    double least = 1e9, slack = 0;
    for (int round = 0; round < 12; ++round) {
      Scene scene = random_scene(rng, 4000);
      // Some clouds are flat sheets across the view or one dense point: there the box adds nothing, only roundings are
      // left.
      const float thin[] = {1, 1e-2f, 1e-4f, 1e-6f};
      for (Gaussian& g : scene.gaussians) g.mean *= thin[round % 4];
      const Camera camera = random_camera(rng, 256, 192);
      const double near_planes[] = {0.2, 0.01, 2, 0};
      const PackedScene packed = pack_scene(config, scene, camera_bound(camera));
      const Frame frame = frame_setup(config, packed, camera, {}, near_planes[(round / 4 + round) % 4]);
      Bounds bounds{config, frame, packed};
      for (int y = 0; y <= static_cast<int>(frame.raster.windows.last_y); y += 2) {
        for (int x = 0; x <= static_cast<int>(frame.raster.windows.last_x); x += 2) {
          bounds.window(x, y);
          if (HasFatalFailure()) return;
        }
      }
      kept += bounds.kept;
      if (bounds.least < least) least = bounds.least, slack = bounds.slack;
    }
    std::printf(
        "dopu_depth: view_w %d pos_w %d world_w %d: %llu Gaussians, least distance from a bound %.3f units of %.3f "
        "given away\n",
        view_w, pos_w, world_w, static_cast<unsigned long long>(kept), least, slack);
    EXPECT_GT(kept, 5000u);
    EXPECT_LT(least, slack) << "no case came near the bound: the test proves little";
  }
}

TEST(DopuDepth, StepsRiseWithTheNumber) {
  std::mt19937_64 rng(test_seed());
  for (int i = 0; i < 100000; ++i) {
    const int64_t a = static_cast<int64_t>(rng() >> (23 + rng() % 41)),
                  b = static_cast<int64_t>(rng() >> (23 + rng() % 41));
    const int e = static_cast<int>(rng() % 27) - kNormalF;
    ASSERT_LE(dopu_depth_step(test_config(), std::min(a, b), e), dopu_depth_step(test_config(), std::max(a, b), e));
  }
}

}  // namespace
}  // namespace pipegs
