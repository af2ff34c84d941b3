// SPDX-License-Identifier: Apache-2.0
// phases.cpp: see phases.hpp.
#include "sim/studies/rivals/models/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "sim/studies/rivals/frame/pipeline.hpp"

namespace pipegs {
namespace {

constexpr int kBlocks = 64;  // that a phase of equal items is cut into
constexpr double kBitsOfByte = 8, kPicojoule = 1e-12;
const std::string kMemory = "memory";

void check(const Phase& phase) {
  for (const UnitStage& stage : phase.stages) {
    if (stage.cycles.size() != phase.shares.size())
      throw std::invalid_argument("phase " + phase.name + ": " + stage.unit + " has not one time for each item");
  }
}

std::vector<PipelineStage> stages_of(const Phase& phase) {
  std::vector<PipelineStage> stages = {{.name = kMemory}};
  for (const UnitStage& stage : phase.stages) {
    stages.back().ahead = 2 * static_cast<std::size_t>(std::max(stage.units, 1));
    stages.push_back({.name = stage.unit, .units = stage.units});
  }
  return stages;
}

std::vector<std::vector<double>> cycles_of(const Phase& phase, double memory_cycles) {
  const double shares = std::accumulate(phase.shares.begin(), phase.shares.end(), 0.0);
  std::vector<std::vector<double>> cycles(phase.shares.size());
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    cycles[i].push_back(shares > 0 ? memory_cycles * phase.shares[i] / shares : 0);
    for (const UnitStage& stage : phase.stages) cycles[i].push_back(stage.cycles[i]);
  }
  return cycles;
}

// The frame's spans of this phase, memory first.
std::vector<StageSpan> spans_of(const std::string& phase, const std::vector<PipelineStage>& stages,
                                const PipelineRun& run, double begin) {
  std::vector<StageSpan> spans;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    StageSpan span{phase, stages[s].name, stages[s].units, begin + run.cycles, begin, run.busy[s]};
    for (const PipelineSpan& one : run.spans) {
      if (one.stage != s || one.end == one.begin) continue;
      span.begin = std::min(span.begin, begin + one.begin), span.end = std::max(span.end, begin + one.end);
    }
    if (span.busy > 0) spans.push_back(span);
  }
  return spans;
}

}  // namespace

const Traffic& PlayedMemory::play(const std::vector<Flow>& flows, double ghz) {
  std::string key = fmt::format("{}", ghz);
  for (const Flow& flow : flows)
    key += fmt::format("|{},{},{},{}", flow.write ? "w" : "r", flow.bytes, flow.run, flow.table);
  const auto found = played_.find(key);
  return found != played_.end() ? found->second : played_[key] = play_traffic(flows, dram_, ghz);
}

double MachineFrame::all_bytes() const {
  return std::accumulate(bytes.begin(), bytes.end(), 0.0,
                         [](double sum, const auto& kind) { return sum + kind.second; });
}

double MachineFrame::busy(const std::string& unit) const {
  double sum = 0;
  for (const StageSpan& span : spans) sum += span.unit == unit ? span.busy : 0;
  return sum;
}

Phase even_phase(const std::string& name, const std::vector<Flow>& flows, double gaussians, const std::string& unit,
                 int units, double per_cycle) {
  return {name,
          flows,
          std::vector<double>(kBlocks, 1),
          {{unit, units, std::vector<double>(kBlocks, gaussians / kBlocks / per_cycle)}}};
}

MachineFrame run_phases(const std::vector<Phase>& phases, double ghz, double watts, PlayedMemory& memory) {
  MachineFrame frame{.ghz = ghz};
  std::map<std::string, double> bounds;
  for (const Phase& phase : phases) {
    check(phase);
    const Traffic& traffic = memory.play(phase.flows, ghz);
    const std::vector<PipelineStage> stages = stages_of(phase);
    PipelineRun run = run_pipeline(stages, cycles_of(phase, traffic.cycles));
    if (phase.shares.empty()) run.cycles = traffic.cycles, run.busy[0] = traffic.cycles;
    std::string busiest = kMemory;
    double most = 0;
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const double busy = run.busy[s] / stages[s].units;
      if (busy > most) most = busy, busiest = stages[s].name;
    }
    bounds[busiest] += run.cycles;
    for (const StageSpan& span : spans_of(phase.name, stages, run, frame.cycles)) frame.spans.push_back(span);
    for (const Flow& flow : phase.flows) frame.bytes[flow.kind] += pin_bytes(flow);
    frame.cycles += run.cycles;
    frame.memory_cycles += traffic.cycles;
  }
  for (const auto& [unit, cycles] : bounds) {
    if (frame.bound.empty() || cycles > bounds[frame.bound]) frame.bound = unit;
  }
  if (frame.cycles > 0) frame.bound_share = bounds[frame.bound] / frame.cycles;
  frame.chip_joules = watts * frame.seconds();
  frame.dram_joules = kDramPjPerBit * (frame.all_bytes() * kBitsOfByte * kPicojoule);
  return frame;
}

int split_levels(double n, double chunk, double ways) {
  int levels = 0;
  for (double reach = chunk; reach < n; reach *= ways) ++levels;
  return levels;
}

double ceil_div(double n, double by) { return std::ceil(n / by); }

}  // namespace pipegs
