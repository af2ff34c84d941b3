// SPDX-License-Identifier: Apache-2.0
// evaluate: see evaluate.hpp.
#include "sim/studies/train/run/evaluate.hpp"

#include <algorithm>
#include <numeric>

#include "cpp_model/float/metrics.hpp"
#include "cpp_model/float/truth.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"
#include "sim/timing/timing_model.hpp"

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

Likeness likeness(const Image& drawn, const Image& wanted) { return {psnr(drawn, wanted), ssim(drawn, wanted)}; }

Likeness mean_of(const std::vector<Likeness>& views) {
  Likeness mean;
  for (const Likeness& view : views) {
    mean.psnr += view.psnr / static_cast<double>(views.size());
    mean.ssim += view.ssim / static_cast<double>(views.size());
  }
  return mean;
}

std::vector<Likeness> likeness(const Parameters& parameters, const std::vector<TrainingView>& views,
                               const LayerGrid* grid, unsigned threads, const Advance& advance) {
  const Scene scene = scene_of(parameters, "");
  std::vector<Likeness> each;
  for (const TrainingView& view : views) {
    TruthOptions options;
    options.near_plane = view.near_plane;
    options.threads = threads;
    options.progress = [&](double share) {
      advance((static_cast<double>(each.size()) + share) / static_cast<double>(views.size()));
    };
    std::vector<std::uint32_t> rank;
    if (grid != nullptr) {
      rank = layered_rank(parameters, *grid, view.camera);
      options.rank = &rank;
    }
    each.push_back(likeness(render_truth(scene, view.camera, options), view.image()));
  }
  return each;
}

MachineViews machine_views(const std::string& name, const Config& config, const Scene& scene,
                           const std::vector<TrainingView>& views, const TellFindings& tell, const Advance& advance) {
  SimulateOptions options;
  options.found = tell;
  options.config = config;
  options.memory.dram = kDefaultDram;
  if (!views.empty()) options.near_plane = views.front().near_plane;  // one for all
  std::vector<Camera> cameras;
  for (const TrainingView& view : views) cameras.push_back(view.camera);
  const PackedScene packed = pack_views(scene, cameras, options);
  MachineViews seen{name, {}, {}};
  for (std::size_t i = 0; i < views.size(); ++i) {
    advance(static_cast<double>(i) / static_cast<double>(views.size()));
    Simulation simulation;
    simulate_frame(packed, views[i].camera, options, simulation);
    simulate_golden(options, simulation);
    seen.likeness.push_back(likeness(simulation.golden.image, views[i].image()));
    seen.cycles.push_back(timing_run(timing_trace(simulation.input), config, options.memory).cycles);
  }
  return seen;
}

std::vector<MachineViews> both_machines(const Scene& scene, const std::vector<TrainingView>& views, int layers,
                                        const TellFindings& tell, const Advance& advance) {
  Config paper = find_design_point("dop").config;
  paper.grid = layers;
  const auto half = [&](double from) { return [&advance, from](double share) { advance(from + share / 2); }; };
  return {machine_views("dop", paper, scene, views, tell, half(0)),
          machine_views(std::string(kDefaultDesignPoint), find_design_point(kDefaultDesignPoint).config, scene, views,
                        tell, half(0.5))};
}

}  // namespace pipegs
