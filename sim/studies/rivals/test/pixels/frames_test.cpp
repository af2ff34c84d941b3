// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/pixels: orders of the frame before by hand, the camera's path, the study as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cpp_model/float/truth.hpp"
#include "sim/studies/rivals/pixels/frames.hpp"
#include "sim/studies/rivals/pixels/path.hpp"
#include "sim/studies/rivals/pixels/pixels.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr double kNear = 0.2;

PixelView view_of(const Scene& scene, const Camera& camera = test_camera(32, 32, 30)) {
  return pixel_view(scene, camera, kNear, 0);
}

std::vector<uint32_t> indices(const PixelView& view, const std::vector<uint32_t>& places) {
  std::vector<uint32_t> found;
  for (const uint32_t place : places) found.push_back(view.seen.gaussians[place].index);
  return found;
}

// In the middle of the picture, one behind the other at these depths.
Scene row_of(const std::vector<float>& depths) {
  Scene scene = scene_of({});
  for (const float z : depths) scene.gaussians.push_back(gaussian_at({0, 0, z}, 0.05f * z));
  return scene;
}

using Order = std::vector<uint32_t>;

TEST(RivalFrames, TheSameCameraTwiceIsInDepthOrder) {
  const Scene scene = random_scene(31, 800, 0);
  const PixelView view = view_of(scene);
  for (const Newcomers rule : {Newcomers::kAll, Newcomers::kSeen})
    EXPECT_EQ(stale_order(scene, view, view, rule), depth_order(view));
  EXPECT_EQ(newcomers(view, view, scene.gaussians.size()), 0);
}

// 0 lies before 1 now; the last camera looked along x, where 1 is nearer. 2 stands before the camera now and was behind
// the last one: by all depths it comes first, by those seen it comes last, 3 likewise and behind it.
TEST(RivalFrames, AnOrderIsThatOfTheLastCamera) {
  Scene scene = scene_of({gaussian_at({0.5f, 0, 2}), gaussian_at({0, 0, 3}), gaussian_at({-1.2f, 0, 4}, 0.2f),
                          gaussian_at({-1.1f, 0, 5}, 0.2f)});
  Camera last = test_camera(64, 64, 20);
  last.position = {-1, 0, 2.5};
  last.world_to_camera = glm::transpose(glm::dmat3({0, 0, -1}, {0, 1, 0}, {1, 0, 0}));
  const PixelView now = view_of(scene, test_camera(64, 64, 30)), before = view_of(scene, last);
  EXPECT_EQ(indices(now, depth_order(now)), (Order{0, 1, 2, 3}));
  EXPECT_EQ(indices(now, stale_order(scene, now, before, Newcomers::kAll)), (Order{2, 3, 1, 0}));
  EXPECT_EQ(indices(now, stale_order(scene, now, before, Newcomers::kSeen)), (Order{1, 0, 2, 3}));
  EXPECT_EQ(newcomers(now, before, scene.gaussians.size()), 0.5);

  const OrderedPicture found = blend(now, sequences_of(now, stale_order(scene, now, before, Newcomers::kSeen), 64), 0);
  std::vector<uint32_t> rank = {1, 0, 2, 3};
  TruthOptions options;
  options.rank = &rank;
  EXPECT_EQ(found.image.rgb, render_truth(scene, now.camera, options).rgb);
}

class Tables {
 public:
  explicit Tables(size_t chunk) : tables_(empty_, Ages::kMixed, chunk) {}
  Order next(const Scene& scene) {
    const PixelView view = view_of(scene);
    return indices(view, tables_.next(view, exact_sequences(view, kTableSide, 0), 0).places.at(0));
  }

 private:
  const Scene empty_ = {};
  SortedTables tables_;
};

// Chunks of four, in even frames two first. The depths turn round in frame 1, whose sort still has those of frame 0.
TEST(RivalFrames, TablesAreSortedChunkByChunk) {
  Tables tables(4);
  const Scene up = row_of({1, 2, 3, 4, 5, 6}), down = row_of({6, 5, 4, 3, 2, 1});
  EXPECT_EQ(tables.next(up), (Order{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(tables.next(down), (Order{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(tables.next(down), (Order{1, 0, 5, 4, 3, 2}));
  EXPECT_EQ(tables.next(down), (Order{5, 4, 1, 0, 3, 2}));
  EXPECT_EQ(tables.next(down), (Order{5, 4, 3, 2, 1, 0}));
}

// 2 leaves and comes back; by then 0 and 1 have changed places, which their table does not know yet.
TEST(RivalFrames, TablesTakeWhatEntersByItsPresentDepth) {
  Tables tables(4);
  EXPECT_EQ(tables.next(row_of({2, 4, 3})), (Order{0, 2, 1}));
  EXPECT_EQ(tables.next(row_of({2, 4, -3})), (Order{0, 1}));
  EXPECT_EQ(tables.next(row_of({4, 2, 3})), (Order{0, 2, 1}));
  EXPECT_EQ(tables.next(row_of({4, 2, 3})), (Order{1, 2, 0}));
}

TEST(RivalFrames, TablesOfOneChunkHaveTheOrderOfTheFrameBefore) {
  Tables tables(1 << 20);
  tables.next(row_of({1, 2, 3, 4, 5}));
  EXPECT_EQ(tables.next(row_of({5, 3, 4, 1, 2})), (Order{0, 1, 2, 3, 4}));
  EXPECT_EQ(tables.next(row_of({1, 2, 3, 4, 5})), (Order{3, 4, 1, 2, 0}));
}

// The camera goes forward: 0 stays in the picture, 1 enters it, and lies before 0 in both frames. Its depth of now is
// less than 0's of the frame before in any case; 2 lies behind 0, but its depth of now is less than 0's of before.
TEST(RivalFrames, TablesCompareAnOldDepthWithAPresentOne) {
  const Scene scene =
      scene_of({gaussian_at({0, 0, 4}, 0.2f), gaussian_at({3, 0, 3.5f}, 0.2f), gaussian_at({5, 0, 4.5f}, 0.2f)});
  Camera first = test_camera(64, 64, 20), second = first;
  first.position = {-4, 0, 0};
  second.position = {1, 0, 1};
  const PixelView before = view_of(scene, first), now = view_of(scene, second);
  for (const Ages ages : {Ages::kMixed, Ages::kEven}) {
    SortedTables tables(scene, ages);
    tables.next(before, exact_sequences(before, kTableSide, 0), 0);
    const Order found = indices(now, tables.next(now, exact_sequences(now, kTableSide, 0), 0).places.at(0));
    EXPECT_EQ(found, ages == Ages::kEven ? (Order{1, 0, 2}) : (Order{1, 2, 0}));
  }
  EXPECT_EQ(indices(now, depth_order(now)), (Order{1, 0, 2}));
}

TEST(RivalFrames, TablesWantTheirOwnTiles) {
  const PixelView view = view_of(row_of({1}));
  const Scene scene = row_of({1});
  SortedTables tables(scene);
  EXPECT_THROW(tables.next(view, exact_sequences(view, 16, 0), 0), std::invalid_argument);
}

double degrees_between(const Camera& a, const Camera& b) {
  const glm::dmat3 turn = b.world_to_camera * glm::transpose(a.world_to_camera);
  return std::acos(std::min(1.0, (turn[0][0] + turn[1][1] + turn[2][2] - 1) / 2)) * 180 / std::numbers::pi;
}

TEST(RivalPath, GoesEvenlyThroughItsViews) {
  const Scene scene = row_of({1, 4, 9});  // median depth 4
  const double radians = std::numbers::pi / 180;
  Camera first = test_camera(64, 48), second = first, third = first;
  second.position = {0.1, 0, 0};
  second.world_to_camera = glm::transpose(glm::dmat3({std::cos(40 * radians), 0, -std::sin(40 * radians)}, {0, 1, 0},
                                                     {std::sin(40 * radians), 0, std::cos(40 * radians)}));
  third = second;
  third.position = second.position + glm::dvec3(0, 0, 3);
  Camera shown = test_camera(32, 32, 77);
  const CameraPath path(scene, shown, {first, first, second, third}, kNear);
  EXPECT_FALSE(path.arc());
  EXPECT_EQ(path.legs(), 2);
  // The second view shows none of the means: a unit is a radian.
  EXPECT_NEAR(path.length(), 40 + 3 / radians, 1e-9);
  EXPECT_NEAR(path.rotation(), 40, 1e-9);
  EXPECT_NEAR(path.distance(), 3.1, 1e-12);
  EXPECT_NEAR(path.parallax(), (0.1 / 4 + 3) / radians, 1e-9);
  EXPECT_NEAR(glm::length(path.at(0).position - first.position), 0, 1e-12);
  EXPECT_NEAR(glm::length(path.at(40).position - second.position), 0, 1e-12);
  EXPECT_NEAR(degrees_between(path.at(40), second), 0, 1e-5);
  EXPECT_NEAR(glm::length(path.at(path.length()).position - third.position), 0, 1e-12);
  for (const double at : {-3.0, 0.0, 17.5, 38.5})
    EXPECT_NEAR(degrees_between(path.at(at), path.at(at + 1.5)), 1.5, 1e-6);
  EXPECT_NEAR(path.at(50).position.z, 10 * radians, 1e-12);
  EXPECT_EQ(path.at(50).width, 32);
  EXPECT_EQ(path.at(50).fx, 77);
}

TEST(RivalPath, GoesAroundALoneView) {
  const Scene scene = row_of({1, 4, 9});
  Camera view = test_camera(64, 48);
  view.position = {0.01, 0, 0};
  for (const std::vector<Camera>& cameras : {std::vector<Camera>{view}, {view, view}}) {
    const CameraPath path(scene, view, cameras, kNear);
    EXPECT_TRUE(path.arc());
    EXPECT_EQ(path.length(), 30);
    const glm::dvec3 pivot = {0.01, 0, 4};
    EXPECT_NEAR(glm::length(path.at(15).position - view.position), 0, 1e-12);
    for (const double at : {-2.0, 0.0, 15.0, 30.0}) {
      const Camera camera = path.at(at);
      const glm::dvec3 seen = camera.world_to_camera * (pivot - camera.position);
      EXPECT_NEAR(seen.x, 0, 1e-12);
      EXPECT_NEAR(seen.y, 0, 1e-12);
      EXPECT_NEAR(seen.z, 4, 1e-12);
      EXPECT_NEAR(degrees_between(camera, view), std::abs(at - 15), 1e-5);
    }
  }
}

TEST(RivalStudy, HasARowForEachAndSaysWhatIsEqual) {
  Scene scene = random_scene(41, 400, 1);
  const Camera view = test_camera(48, 40, 30);
  PixelOptions options;
  options.voxels = {0.5, 1e5};
  options.groups = {16, 32};
  options.speeds = {1e-9, 4};
  options.frames = 2;
  double last = 0;
  options.progress = [&](double share) {
    EXPECT_GT(share, last);
    last = share;
  };
  const PixelStudy study = study_pixels(scene, view, {view}, options);
  EXPECT_EQ(last, 1);
  ASSERT_EQ(study.streams.size(), (2 + std::size(kExtentParts)) * 2);
  for (const StreamRow& row : study.streams) {
    EXPECT_LE(row.order.largest, 1);
    EXPECT_NEAR(row.bytes,
                16.0 * static_cast<double>(row.counts.fetched) + 8.0 * static_cast<double>(row.counts.coarse), 1e-6);
    if (row.part > 0) EXPECT_DOUBLE_EQ(row.edge * row.part, study.extent);
  }
  EXPECT_EQ(study.streams[0].edge, 0.5);
  EXPECT_GT(study.streams[0].counts.lost_voxel, study.streams[1].counts.lost_voxel);
  EXPECT_LE(study.streams[2].occupied, 8u);  // around the origin
  ASSERT_EQ(study.paths.size(), 8u);
  for (int m = 0; m < 4; ++m) {  // a camera that stands still
    EXPECT_EQ(study.paths[static_cast<size_t>(m)].speed, 1e-9);
    EXPECT_EQ(study.paths[static_cast<size_t>(m)].mean.psnr_db, INFINITY);
    EXPECT_EQ(study.paths[static_cast<size_t>(m)].late, 0);
  }
  EXPECT_EQ(study.paths[4].machine, "gsacc_all");
  EXPECT_GT(study.paths[4].late, 0);
  EXPECT_LE(study.paths[4].worst_db, study.paths[4].mean.psnr_db);
  EXPECT_TRUE(study.arc);
}

TEST(RivalStudy, OfNothingIsEqual) {
  PixelOptions options;
  options.frames = 1;
  options.speeds = {1};
  const PixelStudy study = study_pixels(scene_of({}), test_camera(20, 20), {test_camera(20, 20)}, options);
  EXPECT_EQ(study.extent, 0);
  ASSERT_EQ(study.streams.size(), 12u);  // no part of no extent
  for (const StreamRow& row : study.streams) EXPECT_EQ(row.whole.psnr_db, INFINITY);
  for (const PathRow& row : study.paths) EXPECT_EQ(row.mean.psnr_db, INFINITY);
}

TEST(RivalStudy, RefusesOptionsWithoutMeaning) {
  const auto refused = [](auto&& change) {
    PixelOptions options;
    change(options);
    EXPECT_THROW(study_pixels(row_of({1}), test_camera(16, 16), {}, options), std::invalid_argument);
  };
  refused([](PixelOptions& o) { o.voxels = {1, 0}; });
  refused([](PixelOptions& o) { o.voxels = {std::nan("")}; });
  refused([](PixelOptions& o) { o.groups = {24}; });
  refused([](PixelOptions& o) { o.groups = {0}; });
  refused([](PixelOptions& o) { o.speeds = {-1}; });
  refused([](PixelOptions& o) { o.step = 0; });
  refused([](PixelOptions& o) { o.frames = 0; });
  refused([](PixelOptions& o) { o.index_bytes = -1; });
}

}  // namespace
}  // namespace pipegs
