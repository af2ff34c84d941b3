// SPDX-License-Identifier: Apache-2.0
// pipelines.cpp: see pipelines.hpp.
#include "sim/studies/rivals/pipelines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/studies/rivals/models/rival.hpp"
#include "sim/studies/rivals/models/tiles.hpp"

namespace pipegs {

MachinePipeline machine_pipeline(const std::string& machine, const std::string& note, const MachineFrame& frame) {
  const auto us = [&](double cycles) { return cycles / frame.ghz / 1e3; };
  MachinePipeline pipeline{machine, note, us(frame.cycles), {}};
  for (const StageSpan& span : frame.spans) {
    auto row = std::find_if(pipeline.rows.begin(), pipeline.rows.end(),
                            [&](const PipelineRow& one) { return one.unit == span.unit; });
    if (row == pipeline.rows.end()) row = pipeline.rows.insert(row, {span.unit, {}});
    const double share = span.busy / (span.units * (span.end - span.begin));
    row->bars.push_back({us(span.begin), us(span.end), share,
                         fmt::format("{}, {}: {:.0f} us to {:.0f} us, works {:.0f} % of it", span.phase, span.unit,
                                     us(span.begin), us(span.end), 100 * share)});
  }
  return pipeline;
}

MachineFrame gpu_order(const FrameCounts& counts, PlayedMemory& memory) {
  const Values values = values_of(gscore());
  const int cores = static_cast<int>(value(values, "cores"));
  const std::vector<uint32_t>& lengths = counts.lists[kLists16].lengths.square;
  Phase sort{"all lists", {}, {}, {{"QSU", cores, {}}, {"BSU", cores, {}}}};
  Phase raster{"all tiles", {}, {}, {{"VRU", cores, {}}}};
  double pairs = 0, lists = 0, fetches = 0;
  for (size_t t = 0; t < lengths.size(); ++t) {
    const double n = lengths[t], open = static_cast<double>(counts.tiles[t].walk.square.open);
    sort.shares.push_back(n);
    sort.stages[0].cycles.push_back(n * split_levels(n) / value(values, "splitters"));
    sort.stages[1].cycles.push_back(ceil_div(n, 16) * value(values, "chunk_cycles"));
    raster.shares.push_back(open * value(values, "fetch_bytes") + kPixelBytes * kTilePixels);
    raster.stages[0].cycles.push_back(open * kTilePixels / value(values, "lanes"));
    pairs += n, lists += n > 0, fetches += open;
  }
  const double visible = static_cast<double>(counts.gaussians.listed.square);
  for (const Flow& flow : sort_and_fetch(counts, values, pairs, lists, fetches, visible))
    (flow.kind == "sort" ? sort : raster).flows.push_back(flow);
  return run_phases({project(counts, values, visible, pairs, "CCU"), sort, raster}, 1, value(values, "watts"), memory);
}

std::vector<MachinePipeline> rival_pipelines(const FrameCounts& counts, PlayedMemory& memory) {
  return {machine_pipeline("GPU", "its order of work on GSCore's units: all Gaussians, all lists, all tiles",
                           gpu_order(counts, memory)),
          machine_pipeline("GSCore", "preprocessing first; then sorting and rasterization side by side",
                           frame_of(gscore(), counts, memory)),
          machine_pipeline("GSAcc", "the order of the frame before, so that nothing waits for a sort; 500 MHz",
                           frame_of(gsacc(), counts, memory))};
}

}  // namespace pipegs
