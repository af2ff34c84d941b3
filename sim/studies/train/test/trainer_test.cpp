// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/train/run/trainer: a scene is found again from its own pictures, training in layers helps the
// picture in layers, and every bit is the seed's.
#include "sim/studies/train/run/trainer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cpp_model/float/truth.hpp"
#include "sim/studies/train/run/evaluate.hpp"
#include "sim/studies/train/test/small_world.hpp"

namespace pipegs {
namespace {

void nothing(double) {}

TrainState trained(const TrainOptions& options, const TrainingViews& views, Parameters start) {
  Trainer trainer(options, views, Trainer::begin(std::move(start)));
  while (!trainer.done()) trainer.step();
  return trainer.state();
}

double held_out_psnr(const Parameters& parameters, const TrainingViews& views, const LayerGrid* grid = nullptr) {
  return mean_of(likeness(parameters, views.held_out, grid, 0, nothing)).psnr;
}

// Every field of every Gaussian is knocked out of its place; then it is trained, and trained to rest. Measured on views
// that it never saw.
TEST(Trainer, FindsASceneAgainFromItsPictures) {
  const Scene scene = small_scene();
  const TrainingViews views = views_of_scene(scene, small_cameras(17), 1, 0, nothing);
  ASSERT_EQ(views.held_out.size(), 3u);
  const Parameters first = start_of_scene("", knocked(scene, 0.15), 1);
  TrainOptions options;
  options.schedule.steps = 2000;
  options.most_gaussians = scene.gaussians.size();
  const TrainState rough = trained(options, views, first);
  options.schedule = {1500, true};
  const TrainState fine = trained(options, views, rough.parameters);
  EXPECT_LT(held_out_psnr(first, views), 32);
  EXPECT_GT(held_out_psnr(rough.parameters, views), 40);
  EXPECT_GT(held_out_psnr(fine.parameters, views), 45);
  EXPECT_EQ(fine.parameters.size(), scene.gaussians.size());
}

// From points alone, with room to grow.
TEST(Trainer, BeginsWithPointsAndGrows) {
  const Scene scene = small_scene();
  const TrainingViews views = views_of_scene(scene, small_cameras(17), 1, 0, nothing);
  const Parameters first = start_of_points(small_points(scene), 1, 1000, 0);
  TrainOptions options;
  options.schedule.steps = 1200;
  options.most_gaussians = 260;
  const TrainState state = trained(options, views, first);
  EXPECT_GT(held_out_psnr(state.parameters, views), held_out_psnr(first, views) + 6);
  EXPECT_GT(state.parameters.size(), scene.gaussians.size());
  EXPECT_LE(state.parameters.size(), 260u);
  EXPECT_EQ(state.parameters.sh_degree, 1);
}

// The scene itself, fine-tuned on its pictures in exact order for a machine that draws in layers: the order matters
// less than before. With the loss that keeps Gaussians inside their layer fewer reach out of it, which costs likeness.
TEST(Trainer, FineTuningMakesTheOrderMatterLess) {
  const Scene scene = small_scene();
  const TrainingViews views = views_of_scene(scene, small_cameras(17), 1, 0, nothing);
  const Parameters first = start_of_scene("", scene, 1);
  TrainOptions options;
  options.layers = 4;
  const auto crossing = [&](const Parameters& parameters) {
    return cldr_loss(parameters, layer_grid(parameters, 4), options.cldr, nullptr);
  };
  const auto layered_psnr = [&](const Parameters& parameters) {
    const LayerGrid grid = layer_grid(parameters, 4);
    return held_out_psnr(parameters, views, &grid);
  };
  const double layered = layered_psnr(first), gap = held_out_psnr(first, views) - layered;
  for (const bool regularised : {false, true}) {
    SCOPED_TRACE(regularised);
    options.regularised = regularised;
    options.schedule = {regularised ? 1600 : 300, true};  // each step moves a scale by a little at most
    const Parameters now = trained(options, views, first).parameters;
    const double gap_now = held_out_psnr(now, views) - layered_psnr(now);
    EXPECT_EQ(now.size(), first.size());
    EXPECT_LT(gap_now, gap / 2);
    if (regularised) {
      EXPECT_LT(crossing(now), crossing(first) * 2 / 3);
    } else {
      EXPECT_GT(layered_psnr(now), layered - 4);
    }
  }
}

// Until they begin a run with layers is the run without them, to the bit.
TEST(Trainer, LayersBeginWhereTheyAreTold) {
  const Scene scene = small_scene();
  const TrainingViews views = views_of_scene(scene, small_cameras(9), 1, 0, nothing);
  TrainOptions plain, layered;
  plain.schedule = layered.schedule = {20, true};
  layered.layers = 4;
  layered.layers_begin = 0.5;
  Trainer one(plain, views, Trainer::begin(start_of_scene("", scene, 1)));
  Trainer other(layered, views, Trainer::begin(start_of_scene("", scene, 1)));
  for (int step = 1; step <= 11; ++step) {
    one.step();
    other.step();
    EXPECT_EQ(one.state().parameters.mean == other.state().parameters.mean, step <= 10) << step;
  }
}

// The rank is by layer, then by depth: pictures of the truth in it are those of the drawing that is trained.
TEST(Trainer, TheTruthDrawsLayersAsTheTrainingDoes) {
  const Scene scene = small_scene();
  const Parameters parameters = start_of_scene("", scene, 1);
  const LayerGrid grid = layer_grid(parameters, 4);
  for (const Camera& camera : small_cameras(5)) {
    DrawOptions draw;
    draw.layers = &grid;
    const Drawing drawing(parameters, camera, draw);
    const std::vector<std::uint32_t> rank = layered_rank(parameters, grid, camera);
    TruthOptions truth;
    truth.rank = &rank;
    const Image image = render_truth(scene_of(parameters, ""), camera, truth);
    double largest = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
      largest = std::max(largest, glm::length(image.rgb[i] - glm::dvec3(drawing.picture()[i])));
    EXPECT_LT(largest, 0.01);
  }
}

TEST(Trainer, ThreadsChangeNoBitAndTheSeedDoes) {
  const Scene scene = small_scene();
  const TrainingViews views = views_of_scene(scene, small_cameras(9), 1, 0, nothing);
  const Parameters first = start_of_points(small_points(scene), 0, 1000, 0);
  TrainOptions options;
  options.schedule.steps = 230;
  options.layers = 4;
  options.threads = 1;
  const TrainState one = trained(options, views, first);
  options.threads = 3;
  const TrainState three = trained(options, views, first);
  EXPECT_GT(one.parameters.size(), first.size()) << "some were split by chance";
  EXPECT_EQ(one.parameters.mean, three.parameters.mean);
  EXPECT_EQ(one.parameters.opacity_logit, three.parameters.opacity_logit);
  EXPECT_EQ(one.parameters.sh_dc, three.parameters.sh_dc);
  EXPECT_EQ(one.moments.second.rotation, three.moments.second.rotation);
  options.seed = 2;
  EXPECT_NE(trained(options, views, first).parameters.mean, one.parameters.mean);
}

// In a round of as many steps as there are views each view is taken once.
TEST(Trainer, EveryViewHasItsTurn) {
  const Scene scene = small_scene(20);
  TrainingViews views = views_of_scene(scene, small_cameras(9), 1, 0, nothing);
  // Views of an empty world, each of another brightness: the loss of the first drawing tells which one it was.
  Parameters dark = start_of_scene("", scene, 1);
  for (float& value : dark.opacity_logit) value = -13;
  for (std::size_t i = 0; i < views.trained.size(); ++i)
    views.trained[i].computed.assign(views.trained[i].computed.size(), glm::vec3(0.1f * static_cast<float>(i + 1)));
  TrainOptions options;
  options.schedule.steps = 1000;
  Trainer trainer(options, views, Trainer::begin(dark));
  std::set<int> seen;
  for (std::size_t i = 0; i < views.trained.size(); ++i)
    seen.insert(static_cast<int>(std::lround(trainer.step() * 1e3)));
  EXPECT_EQ(seen.size(), views.trained.size());
}

TEST(Views, EveryEighthIsHeldOutInTheOrderOfNames) {
  std::vector<Camera> cameras = small_cameras(10, 16, 12);
  std::reverse(cameras.begin(), cameras.end());
  const TrainingViews views = views_of_scene(small_scene(10), cameras, 2, 0, nothing);
  ASSERT_EQ(views.held_out.size(), 2u);
  EXPECT_EQ(views.held_out[0].camera.name, "view100");
  EXPECT_EQ(views.held_out[1].camera.name, "view108");
  EXPECT_EQ(views.trained.size(), 8u);
  EXPECT_EQ(views.trained[0].camera.width, 8);
  EXPECT_EQ(views.trained[0].picture().size(), 8u * 6);
  EXPECT_GT(views.extent, 3);
  EXPECT_LT(views.extent, 4.5);
}

}  // namespace
}  // namespace pipegs
