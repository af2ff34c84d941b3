// SPDX-License-Identifier: Apache-2.0
// pipeline.cpp: see pipeline.hpp.
//
// Rule    With `ahead` a stage's beginnings depend on the next stage's of earlier items only, so going item by item and
//         stage by stage settles each time from times that are known.
#include "sim/studies/rivals/frame/pipeline.hpp"

#include <algorithm>
#include <stdexcept>

namespace pipegs {
namespace {

void check(const std::vector<PipelineStage>& stages, const std::vector<std::vector<double>>& cycles) {
  for (const PipelineStage& stage : stages) {
    if (stage.units < 1) throw std::invalid_argument("pipeline: stage " + stage.name + " has no unit");
  }
  for (const auto& item : cycles) {
    if (item.size() != stages.size()) throw std::invalid_argument("pipeline: an item has not one time for each stage");
    for (const double time : item) {
      if (!(time >= 0)) throw std::invalid_argument("pipeline: a time is negative");
    }
  }
}

}  // namespace

PipelineRun run_pipeline(const std::vector<PipelineStage>& stages, const std::vector<std::vector<double>>& cycles) {
  check(stages, cycles);
  PipelineRun run;
  run.busy.resize(stages.size());
  std::vector<std::vector<PipelineSpan>> spans(cycles.size(), std::vector<PipelineSpan>(stages.size()));
  std::vector<std::vector<double>> free;  // of each unit of a stage: from when on
  for (const PipelineStage& stage : stages) free.emplace_back(static_cast<std::size_t>(stage.units));
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const auto unit = std::min_element(free[s].begin(), free[s].end());
      double begin = *unit;
      if (s > 0) begin = std::max(begin, spans[i][s - 1].end);
      if (i > 0) begin = std::max(begin, spans[i - 1][s].begin);
      const std::size_t ahead = stages[s].ahead;
      if (s + 1 < stages.size() && ahead > 0 && i >= ahead) begin = std::max(begin, spans[i - ahead][s + 1].begin);
      *unit = begin + cycles[i][s];
      spans[i][s] = {s, static_cast<std::size_t>(unit - free[s].begin()), i, begin, *unit};
      run.busy[s] += cycles[i][s];
      run.cycles = std::max(run.cycles, *unit);
    }
  }
  for (const auto& item : spans) run.spans.insert(run.spans.end(), item.begin(), item.end());
  return run;
}

}  // namespace pipegs
