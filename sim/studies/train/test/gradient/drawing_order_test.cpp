// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/gradient: with a grid the order of blending is that of the machine with layers.
//
// Idea    The golden model gives each Gaussian its place {layer, depth key, index}. With the finest depths that it can
//         have, only Gaussians whose depths round to nearly the same may change places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cpp_model/frame_setup.hpp"
#include "cpp_model/golden.hpp"
#include "scenes/generate/generate.hpp"
#include "sim/studies/train/gradient/raster/splats.hpp"

namespace pipegs {
namespace {

constexpr double kNearlySame = 1e-6;  // relative, of depths that may be ordered either way

// 64x48 pixels: one window.
Camera small_view(int number) {
  Camera camera = generated_cameras()[static_cast<std::size_t>(number)];
  camera.width /= 16;
  camera.height /= 16;
  camera.fx /= 16;
  camera.fy /= 16;
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = (camera.height - 1) / 2.0;
  return camera;
}

GoldenFrame golden_of(const Scene& scene, const Camera& camera, int cells) {
  Config config;
  config.grid = cells;
  config.depth_w = 30;
  config.view_w = 30;
  config.pos_w = 24;
  config_check(config);
  const double bound =
      std::max({std::abs(camera.position.x), std::abs(camera.position.y), std::abs(camera.position.z)});
  const PackedScene packed = pack_scene(config, scene, bound);
  GoldenInput input;
  input.packed = &packed;
  input.frame = frame_setup(config, packed, camera);
  return golden_frame(input, {});
}

class DrawingOrder : public testing::TestWithParam<std::tuple<int, int>> {};

TEST_P(DrawingOrder, IsTheGoldenModelsWithLayers) {
  const auto [view, cells] = GetParam();
  const Scene scene = generate_scene(11, 5000);
  const Parameters p = parameters_of(scene);
  const Camera camera = small_view(view);
  const LayerGrid grid = layer_grid(p, cells);
  const GoldenFrame golden = golden_of(scene, camera, cells);
  auto splats = splats_of<double>(p, camera, {.layers = &grid}).splats;
  std::sort(splats.begin(), splats.end(),
            [&](const auto& a, const auto& b) { return golden.rank[a.index] < golden.rank[b.index]; });
  // Those without a region come last in golden's rank; with one window there are as many others as records.
  ASSERT_EQ(golden.work.windows, 1u);
  std::size_t compared = 0, several = 0;
  for (std::size_t i = 1; i < splats.size(); ++i) {
    if (golden.rank[splats[i].index] >= golden.work.records) break;
    ASSERT_GE(splats[i].layer, splats[i - 1].layer) << "Gaussians " << splats[i - 1].index << ", " << splats[i].index;
    several += splats[i].layer != splats[i - 1].layer;
    if (splats[i].layer != splats[i - 1].layer) continue;
    ++compared;
    EXPECT_GE(splats[i].depth, splats[i - 1].depth * (1 - kNearlySame)) << splats[i].index;
  }
  EXPECT_GT(compared, 500u);
  EXPECT_GE(several, 1u) << "the view must have several layers to say anything";
}

INSTANTIATE_TEST_SUITE_P(Views, DrawingOrder, testing::Combine(testing::Values(0, 1, 2), testing::Values(4, 8)));

TEST(DrawingOrder, LayersAreTakenOutwardFromTheCamerasOwn) {
  LayerGrid grid{4, glm::dvec3(0), glm::dvec3(1)};
  Camera camera;
  camera.world_to_camera = glm::dmat3(1);
  camera.position = {9, 9, 2.5};
  EXPECT_EQ(principal_axis(camera), 2);
  EXPECT_EQ(layers_of_slabs(grid, camera), (std::vector<int>{3, 2, 0, 1}));  // 2, then 3, 1, and 0
  camera.position.z = -7;
  EXPECT_EQ(layers_of_slabs(grid, camera), (std::vector<int>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace pipegs
