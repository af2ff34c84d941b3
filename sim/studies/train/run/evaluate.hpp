// SPDX-License-Identifier: Apache-2.0
// evaluate: how well a scene shows views on which it was not trained.
//
// Idea    The float64 truth draws each view, in exact depth order and in the order of the layers of the machine, and is
//         held against what should be seen: PSNR and SSIM (metrics.hpp). So are the pixels of the machines: the golden
//         model has those of the RTL, bit for bit, and the timing model tells the cycles.
#pragma once

#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/layers/layer_grid.hpp"
#include "sim/studies/train/photos/view.hpp"

namespace pipegs {

struct Likeness {
  double psnr = 0, ssim = 0;  // SSIM: NaN if a side of a view is below 11 pixels
};

Likeness likeness(const Image& drawn, const Image& wanted);
Likeness mean_of(const std::vector<Likeness>& views);

// Of each view, with a grid in the order of its layers. `advance` as that of a view.
std::vector<Likeness> likeness(const Parameters& parameters, const std::vector<TrainingView>& views,
                               const LayerGrid* grid, unsigned threads, const Advance& advance);

// For TruthOptions: the layers in the order in which the camera takes them, by depth inside, ties by index.
std::vector<std::uint32_t> layered_rank(const Parameters& parameters, const LayerGrid& grid, const Camera& camera);

struct MachineViews {
  std::string name;  // of the design point
  std::vector<Likeness> likeness;
  std::vector<std::uint64_t> cycles;  // of one frame, with the DRAM of the defaults
};

using TellFindings = std::function<void(const Findings&)>;  // of frames

MachineViews machine_views(const std::string& name, const Config& config, const Scene& scene,
                           const std::vector<TrainingView>& views, const TellFindings& tell, const Advance& advance);

// The two machines for which a scene is trained: the paper's, with a grid of so many cells along an axis, and the
// default one, which draws in exact order.
std::vector<MachineViews> both_machines(const Scene& scene, const std::vector<TrainingView>& views, int layers,
                                        const TellFindings& tell, const Advance& advance);

}  // namespace pipegs
