// SPDX-License-Identifier: Apache-2.0
// simulate_rtl.cpp: the RTL's part of simulate.hpp: scenes into memory, frames through the machine, all compared.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cpp_model/frame_setup.hpp"
#include "sim/compare/sequence_check.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/job.hpp"

namespace pipegs {
namespace {

uint64_t windows_of(const Frame& frame) {
  const Windows& windows = frame.raster.windows;
  return (windows.last_x - windows.first_x + 1) * (windows.last_y - windows.first_y + 1);
}

// Puts the scenes of the frames behind one another and returns the frames as they lie there. All share one place for
// overflow, behind the last one: only such frames overlap in the machine.
std::vector<GoldenInput> place(const std::vector<Simulation*>& frames, ExternalMemory& memory) {
  std::vector<GoldenInput> placed;
  std::map<const PackedScene*, uint64_t> base;
  uint64_t end = 0;
  for (const Simulation* one : frames) {
    GoldenInput input = one->input;
    const auto [found, fresh] = base.emplace(input.packed, end);
    if (fresh) {
      const MemoryImage image = memory_image(*input.packed);
      for (size_t i = 0; i < image.lines.size(); ++i) memory.line(end + i) = image.lines[i];
    }
    Tables& tables = input.frame.tables;
    for (uint64_t* at : {&tables.cells, &tables.groups, &tables.chunks, &tables.gaussians, &tables.colors,
                         &tables.pixels, &tables.overflow, &input.picture.base})
      *at += found->second;
    end = std::max(end, tables.overflow);
    placed.push_back(input);
  }
  for (GoldenInput& input : placed) input.frame.tables.overflow = end;
  return placed;
}

}  // namespace

SequenceRun simulate_sequence(const SimulateOptions& options, const std::vector<Simulation*>& frames) {
  const Config& config = options.config;
  if (!config.taps && (options.taps != nullptr || options.watch))
    throw ConfigError("configuration: what shows the streams needs taps = 1");
  const std::unique_ptr<RtlModel> model = load_rtl(config, built_variant(options.variant, options.rtl));
  ExternalMemory memory(options.memory, config.bus_w);
  const std::vector<GoldenInput> placed = place(frames, memory);
  std::vector<SequenceCheck::Expected> expected;
  std::vector<pipegs_job> jobs;
  uint64_t windows = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    expected.push_back({&placed[i], &frames[i]->golden.pixels});
    jobs.push_back(frame_job(config, placed[i].frame, placed[i].picture));
    windows += windows_of(placed[i].frame);
  }
  SequenceCheck check(expected, memory, options.taps);
  if (options.watch) check.frame(0).watch((*options.watch)[0], (*options.watch)[1]);

  Progress progress("rtl");
  const Stopwatch watch;
  SequenceRun run;
  run.rtl = model->run(jobs, memory, options.rtl, &check, [&](uint64_t cycle, uint64_t windows_done) {
    progress.update(static_cast<double>(windows_done) / static_cast<double>(windows),
                    fmt::format("{:.0f} kHz", static_cast<double>(cycle) / watch.seconds() / 1000));
    return !interrupted();
  });
  run.wall = watch.seconds();
  if (check.complete() != frames.size())
    throw std::logic_error(fmt::format("RTL: {} frames given, {} complete", frames.size(), check.complete()));
  run.traffic = memory_traffic(config, memory);
  if (const Dram* dram = memory.dram())
    run.dram = {dram->statistics(), dram->achieved_gbps(), dram->timing().peak_gbps()};
  for (size_t i = 0; i < frames.size(); ++i) {
    const StreamCheck& one = check.frame(i);
    frames[i]->picture = check.picture(i);
    frames[i]->seen = one.seen();
    frames[i]->beats = one.beats();
    frames[i]->mismatches = one.mismatches();
    frames[i]->first_mismatch = one.first();
  }
  return run;
}

void simulate_rtl(const SimulateOptions& options, Simulation& result) {
  SequenceRun run = simulate_sequence(options, {&result});
  result.rtl = std::move(run.rtl);
  result.traffic = std::move(run.traffic);
  result.dram = run.dram;
  result.wall_rtl = run.wall;
}

}  // namespace pipegs
