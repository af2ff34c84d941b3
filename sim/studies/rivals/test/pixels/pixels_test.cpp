// SPDX-License-Identifier: Apache-2.0
// Against sim/studies/rivals/pixels: any order against the truth, STREAMINGGS by hand and by a literal sort of its
// graph.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "cpp_model/float/truth.hpp"
#include "sim/studies/rivals/count/voxels.hpp"
#include "sim/studies/rivals/counts.hpp"
#include "sim/studies/rivals/pixels/difference.hpp"
#include "sim/studies/rivals/pixels/streaming.hpp"
#include "verif/frame/scenes.hpp"

namespace pipegs {
namespace {

constexpr double kNear = 0.2;

Camera turned_camera(int width, int height) {
  Camera camera = test_camera(width, height, 40);
  camera.position = {0.1, -0.2, 0.05};
  camera.cx += 3.25;
  const glm::dvec3 z = glm::normalize(glm::dvec3(0.1, 0.05, 1)), x = glm::normalize(glm::cross({0, 1, 0}, z));
  camera.world_to_camera = glm::transpose(glm::dmat3(x, glm::cross(z, x), z));
  return camera;
}

void expect_same(const Image& found, const Image& wanted) {
  EXPECT_EQ(found.rgb, wanted.rgb);
  EXPECT_EQ(found.transmittance, wanted.transmittance);
  EXPECT_EQ(found.depth, wanted.depth);
  EXPECT_EQ(found.blended, wanted.blended);
}

StreamPicture stream_of(const Scene& scene, const PixelView& view, double edge, int side) {
  const VoxelScene voxels = voxel_scene(scene, view, edge, kNear, 0);
  return stream(view, voxels, coarse_circles(scene, view.camera, kNear, 0), exact_sequences(view, side, 0), 0);
}

TEST(RivalPixels, InDepthOrderAreTheTruths) {
  for (const bool antialiased : {false, true}) {
    Scene scene = random_scene(11, 1500, 2);
    scene.antialiased = antialiased;
    const Camera camera = turned_camera(131, 70);
    const PixelView view = pixel_view(scene, camera, kNear, 0);
    const Image truth = render_truth(scene, camera, {});
    for (const int side : {16, 64, 128}) {
      SCOPED_TRACE(side);
      const OrderedPicture found = blend(view, sequences_of(view, depth_order(view), side), 0);
      expect_same(found.image, truth);
      expect_same(blend(view, exact_sequences(view, side, 1), 1).image, truth);
      EXPECT_EQ(found.counts.late, 0u);
      uint64_t blends = 0;
      for (const uint32_t count : truth.blended) blends += count;
      EXPECT_EQ(found.counts.blends, blends);
    }
  }
}

TEST(RivalPixels, InAnyOrderAreTheTruthsByThatRank) {
  const Scene scene = random_scene(12, 400, 1);
  const Camera camera = turned_camera(50, 37);
  const PixelView view = pixel_view(scene, camera, kNear, 0);
  std::vector<uint32_t> order = depth_order(view), rank(scene.gaussians.size(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  std::vector<double> depths(scene.gaussians.size(), 0);
  for (uint32_t turn = 0; turn < order.size(); ++turn) {
    const SeenGaussian& s = view.seen.gaussians[order[turn]];
    rank[s.index] = turn, depths[s.index] = s.depth;
  }
  TruthOptions options;
  options.rank = &rank;
  const OrderedPicture found = blend(view, sequences_of(view, order, 32), 0);
  expect_same(found.image, render_truth(scene, camera, options));
  uint64_t late = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      double deepest = 0;
      for (const TruthStep& step : explain_truth(scene, camera, options, x, y)) {
        late += depths[step.index] < deepest;
        deepest = std::max(deepest, depths[step.index]);
      }
    }
  }
  EXPECT_EQ(found.counts.late, late);
  EXPECT_GT(late, 1000u);
}

TEST(RivalPixels, RefuseSequencesOfAnotherGrid) {
  const PixelView view = pixel_view(random_scene(1, 9, 0), test_camera(40, 40), kNear, 0);
  EXPECT_THROW(blend(view, {24, {}}, 0), std::invalid_argument);
  EXPECT_THROW(blend(view, {16, std::vector<std::vector<uint32_t>>(8)}, 0), std::invalid_argument);
}

// The camera stands in the voxel x = 0 to 2 and sees some of x = -2 to 0 behind it. `far` has its mean in the first
// one, `near` in the second, and the front one, where there is one, in the first: voxel by voxel far comes before near.
TEST(RivalPixels, OrderErrorsOfHandWorkedScenes) {
  const Gaussian far = gaussian_at({0.2f, 1, 1.5f}, 0.5f, 0.7, {1.5f, -1, 0}),
                 near = gaussian_at({-0.2f, 1, 1}, 0.4f, 0.6, {-1, 0.5f, 1}),
                 front = gaussian_at({0.4f, 1, 0.5f}, 0.1f, 0.5, {0.1f, 0.2f, 0.3f});
  Camera camera = test_camera(16, 16, 16);
  camera.position = {0.5, 1, 0};
  for (const auto& gaussians : {std::vector{far, near}, std::vector{front, near, far}}) {
    SCOPED_TRACE(gaussians.size());
    const Scene scene = scene_of(gaussians);
    const PixelView view = pixel_view(scene, camera, kNear, 0);
    const StreamPicture found = stream_of(scene, view, 2, 16);
    const Image truth = render_truth(scene, camera, {});
    uint64_t late = 0;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        glm::dvec3 color[2];
        double alpha[2] = {0, 0}, before = 1;
        for (const TruthStep& step : explain_truth(scene, camera, {}, x, y)) {
          const Gaussian& gaussian = scene.gaussians[step.index];
          if (gaussian.mean == front.mean) before = 1 - step.alpha;
          const int which = gaussian.mean == far.mean ? 0 : 1;
          color[which] = glm::max(glm::dvec3(gaussian.sh_dc) * 0.28209479177387814 + 0.5, 0.0);
          if (gaussian.mean != front.mean) alpha[which] = step.alpha;
        }
        // far + (1 - a) near, instead of near + (1 - b) far
        const glm::dvec3 wanted = before * alpha[0] * alpha[1] * (color[0] - color[1]);
        const glm::dvec3 error = found.blend.image.rgb[truth.at(x, y)] - truth.rgb[truth.at(x, y)];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(error[c], wanted[c], 1e-12) << x << " " << y;
        late += alpha[0] > 0 && alpha[1] > 0;
      }
    }
    EXPECT_GT(late, 100u);
    EXPECT_EQ(found.blend.counts.late, late);
    EXPECT_EQ(found.counts.met, 2u);
    EXPECT_EQ(found.counts.taken, 2u);
    EXPECT_EQ(found.counts.lost_voxel + found.counts.lost_coarse, 0u);
    EXPECT_EQ(found.counts.fetched, gaussians.size());
    EXPECT_EQ(found.counts.bytes(8), 24 * static_cast<double>(gaussians.size()));
    expect_same(blend(view, by_depth(found.sequences), 0).image, truth);
  }
}

// Its voxel lies before the left group alone: the right one does not know of it.
TEST(RivalPixels, AGaussianIsLostWhereItsVoxelIsNotMet) {
  const Scene scene = scene_of({gaussian_at({-0.3f, 0.01f, 2}, 0.3f, 0.9)});
  const Camera camera = test_camera(32, 16, 20);
  const PixelView view = pixel_view(scene, camera, kNear, 0);
  const StreamPicture found = stream_of(scene, view, 0.125, 16);
  EXPECT_EQ(found.counts.pairs, 2u);
  EXPECT_EQ(found.counts.lost_voxel, 1u);
  const Image truth = render_truth(scene, camera, {});
  for (int x = 8; x < 22; ++x) {
    EXPECT_GT(truth.rgb[truth.at(x, 8)].x, 0);
    EXPECT_EQ(found.blend.image.rgb[truth.at(x, 8)], x < 16 ? truth.rgb[truth.at(x, 8)] : glm::dvec3(0));
  }
}

// The paper's algorithm in its own words: lists of all rays, an adjacency table, in-degrees counted down.
class Literal {
 public:
  Literal(const Scene& scene, const Camera& camera, double edge, int side)
      : scene_(scene), camera_(camera), edge_(edge), side_(side), image_(camera.width, camera.height) {
    for (size_t i = 0; i < scene.gaussians.size(); ++i) {
      ActivatedGaussian gaussian;
      if (activate(scene, i, gaussian) != Cull::kNone) continue;
      Key key;
      for (int axis = 0; axis < 3; ++axis)
        key[static_cast<size_t>(axis)] = static_cast<int>(std::floor(gaussian.mean[axis] / edge));
      voxels_[key].push_back(static_cast<uint32_t>(i));
      projected_[static_cast<uint32_t>(i)] =
          project_truth(gaussian, scene.gaussians[i].sh_dc, sh_rest_of(scene, i), scene.sh_degree, camera,
                        {Semantics::kExact, kNear, scene.antialiased, kMaxShDegree});
    }
    const TileGrid grid(camera, side);
    for (int y = 0; y < grid.rows; ++y) {
      for (int x = 0; x < grid.columns; ++x) group(grid, x, y);
    }
  }
  const Image& image() const { return image_; }
  uint64_t fetched = 0, coarse = 0, taken = 0, stopped_early = 0;

 private:
  using Key = std::array<int, 3>;
  struct Pixel {
    int x, y;
    bool stopped = false;
  };

  std::vector<Key> along_ray(int x, int y) const {
    const glm::dvec3 ray = glm::transpose(camera_.world_to_camera) *
                           glm::dvec3((x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy, 1);
    std::vector<std::pair<double, Key>> found;
    for (const auto& [key, _] : voxels_) {
      double from = kNear, to = INFINITY;
      for (int axis = 0; axis < 3; ++axis) {
        double a = (key[static_cast<size_t>(axis)] * edge_ - camera_.position[axis]) / ray[axis],
               b = ((key[static_cast<size_t>(axis)] + 1) * edge_ - camera_.position[axis]) / ray[axis];
        from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
      }
      if (from <= to) found.push_back({from + to, key});
    }
    std::sort(found.begin(), found.end());
    std::vector<Key> keys;
    for (const auto& [_, key] : found) keys.push_back(key);
    return keys;
  }

  std::vector<Key> sorted(const std::vector<Pixel>& pixels) const {
    std::map<Key, std::set<Key>> adjacent;
    for (const Pixel& pixel : pixels) {
      const std::vector<Key> keys = along_ray(pixel.x, pixel.y);
      for (size_t k = 0; k < keys.size(); ++k) {
        adjacent[keys[k]];
        if (k + 1 < keys.size()) adjacent[keys[k]].insert(keys[k + 1]);
      }
    }
    std::map<Key, int> incoming;
    for (const auto& [key, after] : adjacent) {
      incoming[key] += 0;
      for (const Key& next : after) ++incoming[next];
    }
    std::vector<Key> order;
    while (!incoming.empty()) {
      std::vector<Key> ready;
      for (const auto& [key, count] : incoming) {
        if (count == 0) ready.push_back(key);
      }
      EXPECT_FALSE(ready.empty()) << "a cycle";
      if (ready.empty()) return order;
      for (const Key& key : ready) {
        order.push_back(key);
        incoming.erase(key);
        for (const Key& next : adjacent[key]) --incoming[next];
      }
    }
    return order;
  }

  void group(const TileGrid& grid, int gx, int gy) {
    std::vector<Pixel> pixels;
    for (int y = gy * side_; y < std::min((gy + 1) * side_, camera_.height); ++y) {
      for (int x = gx * side_; x < std::min((gx + 1) * side_, camera_.width); ++x) pixels.push_back({x, y});
    }
    for (const Key& key : sorted(pixels)) {
      if (std::all_of(pixels.begin(), pixels.end(), [](const Pixel& pixel) { return pixel.stopped; })) {
        ++stopped_early;
        continue;
      }
      ++taken;
      std::vector<std::pair<double, uint32_t>> inside;
      for (const uint32_t index : voxels_[key]) {
        ++fetched;
        if (!coarse_circle(scene_, index, camera_, kNear).touches(grid, gx, gy)) continue;
        ++coarse;
        inside.push_back({projected_[index].depth, index});
      }
      std::sort(inside.begin(), inside.end());
      for (const auto& [_, index] : inside) {
        for (Pixel& pixel : pixels) add(projected_[index], pixel);
      }
    }
  }

  void add(const TruthProjection& p, Pixel& pixel) {
    const double power = std::min(0.0, power_at(p.conic, p.mean.x - pixel.x, p.mean.y - pixel.y));
    const double alpha = std::min(0.99, p.opacity * std::exp(power));
    if (!p.visible || pixel.stopped || alpha < 1.0 / 255) return;
    const size_t at = image_.at(pixel.x, pixel.y);
    const double next = image_.transmittance[at] * (1 - alpha);
    if (next < 1e-4) {
      pixel.stopped = true;
      return;
    }
    image_.rgb[at] += alpha * image_.transmittance[at] * p.rgb;
    image_.depth[at] += alpha * image_.transmittance[at] * p.depth;
    image_.transmittance[at] = next;
    ++image_.blended[at];
  }

  const Scene& scene_;
  const Camera& camera_;
  double edge_;
  int side_;
  Image image_;
  std::map<Key, std::vector<uint32_t>> voxels_;
  std::map<uint32_t, TruthProjection> projected_;
};

TEST(RivalPixels, VoxelByVoxelAreThoseOfTheLiteralAlgorithm) {
  struct Case {
    uint64_t seed;
    int width, height, side;
    double edge;
  };
  for (const Case& one : {Case{1, 50, 40, 16, 2},
                          {2, 37, 41, 32, 0.7},
                          {3, 70, 20, 64, 1.1},
                          {4, 33, 33, 16, 0.35},
                          {5, 24, 24, 128, 3}}) {
    SCOPED_TRACE(one.seed);
    Scene scene = random_scene(one.seed, 150, 1);
    scene.gaussians[7].mean.x = std::nanf("");
    scene.gaussians[11].rotation = glm::vec4(0);
    scene.antialiased = one.seed == 2;
    for (const float z : {0.5f, 0.6f, 0.7f, 0.8f, 0.9f})  // walls that stop a part of the picture
      scene.gaussians.push_back(gaussian_at({-0.3f * z, -0.2f, z}, 0.9f * z, 0.98));
    scene.sh_rest.resize(scene.gaussians.size() * 9);
    const Camera camera = turned_camera(one.width, one.height);
    const PixelView view = pixel_view(scene, camera, kNear, 0);
    const StreamPicture found = stream_of(scene, view, one.edge, one.side);
    const Literal literal(scene, camera, one.edge, one.side);
    expect_same(found.blend.image, literal.image());
    EXPECT_EQ(found.counts.taken, literal.taken);
    EXPECT_EQ(found.counts.fetched, literal.fetched);
    EXPECT_EQ(found.counts.coarse, literal.coarse);
    EXPECT_EQ(found.counts.met - found.counts.taken, literal.stopped_early);
    EXPECT_GT(found.blend.counts.late, 0u);
    if (one.side == 16) EXPECT_GT(literal.stopped_early, 0u);  // the case is worth comparing
  }
}

// Without a pixel that stops, all that is met is fetched: what the counts of a view say.
TEST(RivalPixels, FetchWhatTheCountsSayWhereNothingStops) {
  Scene scene = random_scene(21, 300, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.opacity_logit = std::min(gaussian.opacity_logit, logit(0.02));
  const Camera camera = turned_camera(90, 60);
  const PixelView view = pixel_view(scene, camera, kNear, 0);
  for (const int side : {16, 64}) {
    const VoxelCounts wanted = count_frame(scene, camera, {.voxel = 0.9, .group = side}).voxels;
    const StreamCounts found = stream_of(scene, view, 0.9, side).counts;
    EXPECT_EQ(found.met, wanted.pairs);
    EXPECT_EQ(found.taken, wanted.pairs);
    EXPECT_EQ(found.fetched, wanted.all.fetched);
    EXPECT_EQ(found.coarse, wanted.all.coarse);
    EXPECT_EQ(found.fine, wanted.all.fine);
    EXPECT_EQ(found.pairs - found.lost_voxel - found.lost_coarse, wanted.all.fine);
    EXPECT_GT(found.lost_voxel, 0u);
  }
}

TEST(RivalPixels, OneVoxelForAllOfTheSceneIsInDepthOrder) {
  Scene scene = random_scene(22, 500, 0);
  for (Gaussian& gaussian : scene.gaussians) gaussian.mean += glm::vec3(500);
  Camera camera = turned_camera(64, 48);
  camera.position += 500;
  const PixelView view = pixel_view(scene, camera, kNear, 0);
  const StreamPicture found = stream_of(scene, view, 1000, 16);
  EXPECT_EQ(found.blend.counts.late, 0u);
  expect_same(found.blend.image, blend(view, by_depth(found.sequences), 0).image);
}

TEST(RivalPixels, DoNotDependOnThreads) {
  const Scene scene = random_scene(23, 3000, 0);
  const Camera camera = turned_camera(100, 70);
  Image images[2];
  for (const unsigned threads : {1u, 3u}) {
    const PixelView view = pixel_view(scene, camera, kNear, threads);
    const VoxelScene voxels = voxel_scene(scene, view, 0.5, kNear, threads);
    images[threads / 2] =
        stream(view, voxels, coarse_circles(scene, camera, kNear, threads), exact_sequences(view, 32, threads), threads)
            .blend.image;
  }
  expect_same(images[0], images[1]);
}

TEST(RivalPixels, DifferencesOfHandWorkedPictures) {
  Image a(2, 2), b(2, 2);
  EXPECT_EQ(difference(a, b).psnr_db, INFINITY);
  EXPECT_EQ(worst_db({difference(a, b)}), INFINITY);
  a.rgb[1].y = 0.1;
  a.rgb[2].x = 0.5 / 255;          // not to be seen
  a.rgb[3].z = 5, b.rgb[3].z = 1;  // both white
  const Difference one = difference(a, b);
  EXPECT_NEAR(one.psnr_db, -10 * std::log10((0.01 + std::pow(0.5 / 255, 2)) / 12), 1e-9);
  EXPECT_DOUBLE_EQ(one.largest, 0.1);
  EXPECT_EQ(one.visible, 0.25);
  const Difference two = together({one, difference(b, b)});
  EXPECT_NEAR(two.psnr_db, one.psnr_db + 10 * std::log10(2), 1e-9);
  EXPECT_DOUBLE_EQ(two.largest, 0.1);
  EXPECT_EQ(two.visible, 0.125);
  EXPECT_EQ(worst_db({one, difference(b, b)}), one.psnr_db);
  EXPECT_EQ(together({difference(b, b)}).psnr_db, INFINITY);
}

}  // namespace
}  // namespace pipegs
