// SPDX-License-Identifier: Apache-2.0
// simulate_rtl.cpp: the RTL's part of simulate.hpp: scenes into memory, frames through the machine, all compared.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cpp_model/areas/frame_areas.hpp"
#include "cpp_model/control/job.hpp"
#include "scenes/atomic_file.hpp"
#include "sim/compare/sequence_check.hpp"
#include "sim/compare/simulate.hpp"
#include "sim/compare/wave_view.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

// Frames as they lie in memory, with the sizes of their areas.
struct Placed {
  std::vector<GoldenInput> inputs;
  std::vector<Areas> areas;
};

// Puts the scenes of the frames behind one another. All share one place for overflow, behind the last one, as large as
// any of them needs it: only such frames overlap in the machine. The memory ends with it.
Placed place(const Config& config, const std::vector<Simulation*>& frames, ExternalMemory& memory) {
  Placed placed;
  std::map<const PackedScene*, uint64_t> base;
  uint64_t end = 0, overflow = 0;
  for (const Simulation* one : frames) {
    GoldenInput input = one->input;
    const auto [found, fresh] = base.emplace(input.packed, end);
    if (fresh) memory.load(memory_image(*input.packed).lines, end);
    move_frame(input.frame, found->second);
    input.picture.base += found->second;
    end = std::max(end, input.frame.tables.overflow);
    placed.inputs.push_back(input);
    placed.areas.push_back(frame_areas(config, *input.packed, input.frame, input.picture));
    overflow = std::max(overflow, placed.areas.back().overflow);
  }
  for (GoldenInput& input : placed.inputs) input.frame.tables.overflow = end;
  for (Areas& areas : placed.areas) areas.overflow = overflow;
  memory.set_lines(end + overflow);
  return placed;
}

}  // namespace

SequenceRun simulate_sequence(const SimulateOptions& options, const std::vector<Simulation*>& frames) {
  const Config& config = options.config;
  if (!config.taps && (options.taps != nullptr || options.watch))
    throw ConfigError("configuration: what shows the streams needs taps = 1");
  std::unique_ptr<RtlModel> model = load_rtl(config, built_variant(options.variant, options.rtl));
  Progress progress("RTL");
  ExternalMemory memory(options.memory, config.bus_w);
  const Placed placed = place(config, frames, memory);
  std::vector<SequenceCheck::Expected> expected;
  std::vector<pipegs_job> jobs;
  uint64_t windows = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const GoldenInput& input = placed.inputs[i];
    expected.push_back({&input, &frames[i]->golden, placed.areas[i]});
    jobs.push_back(frame_job(config, input.frame, placed.areas[i], input.picture));
    windows += frame_windows(input.frame);
  }
  SequenceCheck check(expected, memory, options.taps);
  if (options.watch) check.frame(0).watch((*options.watch)[0], (*options.watch)[1]);

  RtlOptions rtl = options.rtl;
  std::optional<AtomicFile> waves;
  if (!rtl.waves.empty()) {
    waves.emplace(rtl.waves);
    rtl.waves = waves->temporary();
    waves->beside(".hier");  // the writer's, until it is done
  }
  const Stopwatch watch;
  SequenceRun run;
  const auto show_waves = [&](std::optional<int64_t> cycle) {
    if (!waves) return;
    waves->commit();
    if (rtl.sample_period > 0) return;  // nobody looks at samples
    if (rtl.wave_range) cycle = rtl.wave_range->cycle;
    const int64_t start = static_cast<int64_t>(check.wave_time) - kWaveTime * check.cycle;  // of cycle 0
    write_wave_view(options.rtl.waves, cycle ? std::optional(start + kWaveTime * *cycle) : std::nullopt);
  };
  const auto report = [&](uint64_t cycle, uint64_t windows_done) {
    progress.update(static_cast<double>(windows_done) / static_cast<double>(windows),
                    fmt::format("{:.0f} kHz", static_cast<double>(cycle) / watch.seconds() / 1000));
    return !interrupted();
  };
  try {
    run.rtl = model->run(jobs, memory, rtl, &check, report);
  } catch (RtlFault& fault) {  // what led to it is in the waves
    fault.cycle = check.cycle;
    model.reset();  // ends them
    show_waves(fault.cycle);
    throw;
  }
  check.finish(run.rtl);
  run.wall = watch.seconds();
  show_waves(check.first_cycle());
  if (check.complete() != frames.size())
    throw std::logic_error(fmt::format("RTL: {} frames given, {} complete", frames.size(), check.complete()));
  run.traffic = memory_traffic(config, memory);
  if (const Dram* dram = memory.dram())
    run.dram = {dram->statistics(), dram->achieved_gbps(), dram->timing().peak_gbps(), dram->read_latency().reads()};
  MemoryBytes before;
  for (size_t i = 0; i < frames.size(); ++i) {
    const StreamCheck& one = check.frame(i);
    const MemoryBytes moved = check.moved(i);
    run.frame_bytes.push_back({moved.read - before.read, moved.written - before.written});
    before = moved;
    frames[i]->written = check.written(i);
    frames[i]->second_written = check.second_written(i);
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
