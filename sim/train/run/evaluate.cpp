// SPDX-License-Identifier: Apache-2.0
// evaluate: see evaluate.hpp.
#include "sim/train/run/evaluate.hpp"

#include <algorithm>
#include <numeric>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"

namespace pipegs {

std::vector<std::uint32_t> layered_rank(const Parameters& parameters, const LayerGrid& grid, const Camera& camera) {
  const int axis = principal_axis(camera);
  const std::vector<int> layers = layers_of_slabs(grid, camera);
  struct Place {
    int layer;
    double depth;
  };
  std::vector<Place> places(parameters.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 mean = parameters.mean[i];
    places[i] = {layers[static_cast<std::size_t>(grid.slab(axis, mean[axis]))],
                 (camera.world_to_camera * (mean - camera.position)).z};
  }
  std::vector<std::uint32_t> order(places.size()), rank(places.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (places[a].layer != places[b].layer) return places[a].layer < places[b].layer;
    return places[a].depth < places[b].depth || (places[a].depth == places[b].depth && a < b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = static_cast<std::uint32_t>(i);
  return rank;
}

Likeness likeness(const Parameters& parameters, const std::vector<TrainingView>& views, const LayerGrid* grid,
                  unsigned threads, const Advance& advance) {
  const Scene scene = scene_of(parameters, "");
  const auto count = static_cast<double>(views.size());
  Likeness mean;
  for (std::size_t i = 0; i < views.size(); ++i) {
    TruthOptions options;
    options.threads = threads;
    options.progress = [&](double share) { advance((static_cast<double>(i) + share) / count); };
    std::vector<std::uint32_t> rank;
    if (grid != nullptr) {
      rank = layered_rank(parameters, *grid, views[i].camera);
      options.rank = &rank;
    }
    const Image drawn = render_truth(scene, views[i].camera, options), wanted = views[i].image();
    mean.psnr += psnr(drawn, wanted) / count;
    mean.ssim += ssim(drawn, wanted) / count;
  }
  return mean;
}

}  // namespace pipegs
