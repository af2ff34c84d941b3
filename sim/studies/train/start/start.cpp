// SPDX-License-Identifier: Apache-2.0
// start: see start.hpp.
//
// Idea    The neighbours come from a k-d tree (nanoflann), which is exact, as INRIA's simple-knn is.
#include "sim/studies/train/start/start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>

#include "cpp_model/float/parallel.hpp"
#include "cpp_model/float/projection.hpp"
#include "scenes/input_error.hpp"

namespace pipegs {
namespace {

constexpr double kLeastSquare = 1e-7;  // of a distance, scene units: points may lie on each other
constexpr double kStartOpacity = 0.1;
constexpr float kLargestLogit = 13.8f;  // 1e-6 from 0 and from 1
constexpr std::size_t kNeighbours = 3, kBlock = 1024;

// Points as nanoflann asks for them.
struct Cloud {
  const std::vector<glm::dvec3>& points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;  // it finds the box itself
  }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3>;

}  // namespace

std::vector<double> mean_squared_distances(const std::vector<glm::dvec3>& points, unsigned threads) {
  const Cloud cloud{points};
  const Tree tree(3, cloud);
  std::vector<double> means(points.size());
  parallel_for((points.size() + kBlock - 1) / kBlock, threads, [&](std::size_t block) {
    for (std::size_t i = block * kBlock; i < std::min(points.size(), (block + 1) * kBlock); ++i) {
      std::array<std::uint32_t, kNeighbours + 1> places;
      std::array<double, kNeighbours + 1> squares;  // ascending; the first is 0, of the point itself or one on it
      const std::size_t others = tree.knnSearch(&points[i][0], places.size(), places.data(), squares.data()) - 1;
      for (std::size_t k = 1; k <= others; ++k) means[i] += squares[k];
      if (others > 0) means[i] /= static_cast<double>(others);
    }
  });
  return means;
}

Parameters start_of_points(const std::vector<ScenePoint>& points, int sh_degree, std::size_t most, unsigned threads) {
  const std::size_t count = std::min(points.size(), most);
  std::vector<glm::dvec3> positions;
  Scene scene;
  scene.sh_degree = sh_degree;
  scene.gaussians.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ScenePoint& point = points[i * points.size() / count];
    positions.push_back(point.position);
    Gaussian& gaussian = scene.gaussians[i];
    gaussian.mean = point.position;
    gaussian.rotation = {1, 0, 0, 0};
    gaussian.opacity_logit = static_cast<float>(std::log(kStartOpacity / (1 - kStartOpacity)));
    gaussian.sh_dc = (glm::dvec3(point.color) / 255.0 - 0.5) / kSh0;
  }
  const std::vector<double> squares = mean_squared_distances(positions, threads);
  for (std::size_t i = 0; i < count; ++i)
    scene.gaussians[i].log_scale = glm::vec3(static_cast<float>(0.5 * std::log(std::max(squares[i], kLeastSquare))));
  scene.sh_rest.assign(count * 3 * static_cast<std::size_t>(sh_rest_count(sh_degree)), 0.0f);
  return parameters_of(scene);
}

Parameters start_of_scene(const std::string& file, const Scene& scene, double extent) {
  if (scene.antialiased)
    throw InputError(file, "", "found an antialiased scene, expected one without the compensation of opacity");
  Scene kept;
  kept.name = scene.name;
  kept.sh_degree = scene.sh_degree;
  const auto rest = static_cast<std::size_t>(3 * sh_rest_count(scene.sh_degree));
  const auto thinnest = static_cast<float>(std::log(1e-7 * extent));
  for (std::size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian activated;
    if (activate(scene, i, activated) != Cull::kNone) continue;
    Gaussian gaussian = scene.gaussians[i];
    gaussian.log_scale = glm::max(gaussian.log_scale, thinnest);
    gaussian.opacity_logit = std::clamp(gaussian.opacity_logit, -kLargestLogit, kLargestLogit);
    kept.gaussians.push_back(gaussian);
    const float* coefficients = sh_rest_of(scene, i);
    kept.sh_rest.insert(kept.sh_rest.end(), coefficients, coefficients + rest);
  }
  if (kept.gaussians.empty()) throw InputError(file, "", "found no Gaussian that can be drawn, expected at least one");
  return parameters_of(kept);
}

}  // namespace pipegs
