// SPDX-License-Identifier: Apache-2.0
// machine_views: how well a machine shows views on which a scene was not trained, and in how many cycles.
//
// Idea    The golden model draws each view, so the pixels are those of the RTL, bit for bit; the timing model tells the
//         cycles. They are held against what should be seen as those of the truth are (evaluate.hpp).
#pragma once

#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/studies/train/run/evaluate.hpp"

namespace pipegs {

struct MachineViews {
  std::string name;  // of the design point
  std::vector<Likeness> likeness;
  std::vector<std::uint64_t> cycles;  // of one frame, with the DRAM of the defaults
};

MachineViews machine_views(const std::string& name, const Config& config, const Scene& scene,
                           const std::vector<TrainingView>& views, const Advance& advance);

// The two machines for which a scene is trained: the paper's, with a grid of so many cells along an axis, and the
// default one, which draws in exact order.
std::vector<MachineViews> both_machines(const Scene& scene, const std::vector<TrainingView>& views, int layers,
                                        const Advance& advance);

}  // namespace pipegs
