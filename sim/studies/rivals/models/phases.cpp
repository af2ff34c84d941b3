// SPDX-License-Identifier: Apache-2.0
// phases.cpp: see phases.hpp.
//
// Rule    A stage's beginnings depend on the next stage's of earlier items only, so going item by item and stage by
//         stage settles each time from times that are known.
#include "sim/studies/rivals/models/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pipegs {
namespace {

constexpr int kBlocks = 64;  // that a phase of equal items is cut into
constexpr double kBitsOfByte = 8, kPicojoule = 1e-12;
const std::string kMemory = "memory";

void check(const Phase& phase) {
  for (const UnitStage& stage : phase.stages) {
    const std::string where = "phase " + phase.name + ": " + stage.unit;
    if (stage.units < 1) throw std::invalid_argument(where + " has no unit");
    if (stage.cycles.size() != phase.shares.size())
      throw std::invalid_argument(where + " has not one time for each item");
    if (!std::ranges::all_of(stage.cycles, [](double time) { return time >= 0; }))
      throw std::invalid_argument(where + " has a negative time");
  }
}

// Each item's share of the memory's time.
UnitStage memory_stage(const Phase& phase, double cycles) {
  const double shares = std::accumulate(phase.shares.begin(), phase.shares.end(), 0.0);
  UnitStage stage{kMemory, 1, {}};
  for (const double share : phase.shares) stage.cycles.push_back(shares > 0 ? cycles * share / shares : 0);
  return stage;
}

// When each stage works, counted from the phase's begin; memory first.
std::vector<StageSpan> run_phase(const Phase& phase, double memory_cycles) {
  check(phase);
  std::vector<UnitStage> stages = {memory_stage(phase, memory_cycles)};
  stages.insert(stages.end(), phase.stages.begin(), phase.stages.end());
  std::vector<StageSpan> spans;
  std::vector<std::vector<double>> free;    // of each unit of a stage: from when on
  std::vector<std::vector<double>> begins;  // of each item in each stage
  for (const UnitStage& stage : stages) {
    spans.push_back({phase.name, stage.unit, stage.units, HUGE_VAL, 0, 0});
    free.emplace_back(static_cast<std::size_t>(stage.units));
  }
  for (std::size_t i = 0; i < phase.shares.size(); ++i) {
    begins.emplace_back();
    double end = 0;
    for (std::size_t s = 0; s < stages.size(); ++s) {
      const auto unit = std::min_element(free[s].begin(), free[s].end());
      double begin = std::max(end, *unit);
      if (i > 0) begin = std::max(begin, begins[i - 1][s]);
      const std::size_t ahead = s + 1 < stages.size() ? 2 * free[s + 1].size() : i + 1;
      if (i >= ahead) begin = std::max(begin, begins[i - ahead][s + 1]);
      *unit = end = begin + stages[s].cycles[i];
      begins[i].push_back(begin);
      spans[s].busy += stages[s].cycles[i];
      if (end > begin) spans[s].begin = std::min(spans[s].begin, begin), spans[s].end = std::max(spans[s].end, end);
    }
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
    const Traffic& traffic = memory.play(phase.flows, ghz);
    std::string busiest = kMemory;
    double most = 0, cycles = 0;
    for (StageSpan& span : run_phase(phase, traffic.cycles)) {
      if (span.busy / span.units > most) most = span.busy / span.units, busiest = span.unit;
      cycles = std::max(cycles, span.end);
      span.begin += frame.cycles, span.end += frame.cycles;
      if (span.busy > 0) frame.spans.push_back(span);
    }
    bounds[busiest] += cycles;
    for (const Flow& flow : phase.flows) frame.bytes[flow.kind] += pin_bytes(flow);
    frame.cycles += cycles;
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
