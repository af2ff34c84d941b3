// SPDX-License-Identifier: Apache-2.0
// pipeline.hpp: items through the stages of a machine, and when each was where: a frame's time and its timeline.
//
// Idea    An item (a tile, a layer, a group of pixels) goes through all stages in order. A stage has `units`, each
//         with one item at a time; items enter a stage in order, each at the unit that is free first.
//         `ahead` is what lies between a stage and the next: the stage begins item i only when the next one has begun
//         item i - ahead (2: double buffers). 0: without limit.
// Units   Cycles of the machine; fractions stay.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pipegs {

struct PipelineStage {
  std::string name;
  int units = 1;          // at least 1
  std::size_t ahead = 0;  // of the last stage: no meaning
};

struct PipelineSpan {
  std::size_t stage = 0, unit = 0, item = 0;
  double begin = 0, end = 0;
};

struct PipelineRun {
  double cycles = 0;                     // until the last item has left the last stage
  std::vector<PipelineSpan> spans = {};  // item by item, stage by stage
  std::vector<double> busy = {};         // of each stage, summed over its units
};

// cycles[item][stage], none negative. Throws std::invalid_argument when a size does not fit or a stage has no unit.
PipelineRun run_pipeline(const std::vector<PipelineStage>& stages, const std::vector<std::vector<double>>& cycles);

}  // namespace pipegs
