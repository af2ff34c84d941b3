// SPDX-License-Identifier: Apache-2.0
// energy.cpp: see energy.hpp.
#include "sim/silicon/energy/energy.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/input_error.hpp"

namespace pipegs {

namespace {

// What a unit takes in a frame, all its instances, and without what units inside it take.
struct Gates {
  double switch_j = 0, kilo_nand2 = 0;  // of one instance
  int instances = 1;
};

size_t row_of(const std::string& unit) {
  static const std::map<std::string, size_t> kRow = {{"dopu", 0}, {"pu", 1}, {"su", 2}, {"ru", 3}};
  return kRow.contains(unit) ? kRow.at(unit) : 4;
}

constexpr std::array<const char*, 5> kGateRows = {"DOPU", "PU", "SU", "RU", "Other"};

// In 28 nm for one J of the library.
Range joules_of(const Synth& synth) {
  return kNand2InputFf * (kVolts * kVolts / (synth.nand2_ff * synth.volts * synth.volts));
}

// J of the library for the toggles of a unit in the samples.
double data_joules(const Gates& gates, const Activity& activity, const std::string& unit) {
  const auto found = activity.groups.find(unit);
  if (found == activity.groups.end() || found->second.bits == 0) return 0;
  const double toggles =
      static_cast<double>(found->second.toggles) / (static_cast<double>(found->second.bits) / gates.instances);
  return toggles * gates.switch_j;
}

// Of the samples, in J of the library: one for each module in each row.
std::vector<ModuleClocks> sampled_clocks(const Enables& enables, const Activity& activity) {
  std::map<std::pair<size_t, std::string>, ModuleClocks> found;
  for (const auto& [unit, modules] : activity.enabled) {
    for (const auto& [name, enabled] : modules) {
      const auto module = enables.modules.find(name);
      if (module == enables.modules.end() || module->second.gates.size() != enabled.passed.size())
        throw InputError("enables.json", "modules", "no " + name + ": it is of other RTL, run `make synth` again");
      const GatedModule& gated = module->second;
      ModuleClocks& sum = found[{row_of(unit), name}];
      const auto edges = static_cast<double>(enabled.edges);
      sum.ungated_j += edges * gated.always_joules;
      sum.gates_j += edges * gated.clock_gates * enables.gate_joules;
      for (size_t i = 0; i < gated.gates.size(); ++i) {
        sum.gated_j += static_cast<double>(enabled.passed[i]) * gated.gates[i].joules;
        sum.open_j += edges * gated.gates[i].joules;
      }
    }
  }
  for (const auto& [path, name] : enables.instances) {
    const GatedModule& gated = enables.modules.at(name);
    const auto at = found.find({row_of(unit_of(path)), name});
    if (at == found.end()) continue;
    at->second.flipflops += static_cast<uint64_t>(gated.always_flipflops);
    for (const GatedModule::Gate& gate : gated.gates) {
      at->second.flipflops += static_cast<uint64_t>(gate.flipflops);
      at->second.gated += static_cast<uint64_t>(gate.flipflops);
    }
  }
  std::vector<ModuleClocks> clocks;
  for (auto& [place, one] : found) {
    one.row = kGateRows[place.first];
    one.module = place.second;
    clocks.push_back(one);
  }
  return clocks;
}

Range sram_energy(const Synth& synth, const SramLaw& law, const Activity& activity, double cycles) {
  const double scale = cycles / static_cast<double>(activity.cycles);
  std::vector<double> by_kind;
  for (const std::string& kind : law.kinds()) {
    double sum = 0;
    for (const auto& [name, accesses] : activity.srams) {
      const auto memory = std::find_if(synth.memories.begin(), synth.memories.end(),
                                       [&, n = name](const SynthMemory& m) { return m.instance == n; });
      if (memory == synth.memories.end() || memory->width != accesses.width) {
        throw InputError("synth.json", "memories", "no " + name + ": it is of other RTL, run `make synth` again");
      }
      const SramFigures figures = law.memory(kind, memory->width, memory->words, memory->ports);
      sum += (static_cast<double>(accesses.reads) * figures.read_pj +
              static_cast<double>(accesses.writes) * figures.write_pj) *
             1e-12;
    }
    by_kind.push_back(sum * scale);
  }
  return range_of(by_kind);
}

void add_clocks(EnergyRow& row, const ModuleClocks& clocks, const Range& joules) {
  row.frame_j = row.frame_j + joules * clocks.all_j();
  row.clocks_j += joules.mid * clocks.all_j();
  row.ungated_j += joules.mid * clocks.ungated_j;
  row.gates_j += joules.mid * clocks.gates_j;
  row.open_j += joules.mid * clocks.open_j;
  row.flipflops += clocks.flipflops;
  row.gated += clocks.gated;
}

void add_row(EnergyRow& total, const EnergyRow& row) {
  total.frame_j = total.frame_j + row.frame_j;
  total.leakage_w = total.leakage_w + row.leakage_w;
  total.clocks_j += row.clocks_j;
  total.ungated_j += row.ungated_j;
  total.gates_j += row.gates_j;
  total.open_j += row.open_j;
  total.flipflops += row.flipflops;
  total.gated += row.gated;
  total.unseen += row.unseen;
}

std::vector<EnergyRow> rows_of(const Config& config, const Synth& synth, const Enables& enables, const SramLaw& law,
                               const FrameActivity& frame, const Activity& activity) {
  const auto cycles = static_cast<double>(frame.cycles);
  const Range joules = joules_of(synth) * (cycles / static_cast<double>(activity.cycles));  // of the samples' sums
  std::vector<EnergyRow> rows;
  for (const char* name : kGateRows) rows.push_back({.name = name});
  for (const ModuleClocks& clocks : sampled_clocks(enables, activity)) {
    add_clocks(*std::find_if(rows.begin(), rows.end(), [&](const EnergyRow& row) { return row.name == clocks.row; }),
               clocks, joules);
  }
  for (const auto& [unit, flipflops] : activity.unseen) rows[row_of(unit)].unseen += flipflops;
  const auto add = [&](const Gates& gates, const std::string& unit) {
    EnergyRow& row = rows[row_of(unit)];
    row.frame_j = row.frame_j + joules * data_joules(gates, activity, unit);
    if (row.name != "Other" && activity.clocks.contains(unit)) {
      row.awake =
          static_cast<double>(activity.clocks.at(unit)) / static_cast<double>(activity.cycles) / gates.instances;
    }
    row.leakage_w = row.leakage_w + kNand2LeakageNw * (gates.kilo_nand2 * gates.instances * 1e-6);
  };
  Gates rest;  // of the top, without the units
  for (const SynthUnit& unit : synth.units) {
    const Gates gates = {unit.switch_j, unit.nand2 / 1000, unit.instances};
    const double sign = unit.unit == "top" ? 1 : -unit.instances;
    rest = {rest.switch_j + sign * gates.switch_j, rest.kilo_nand2 + sign * gates.kilo_nand2, 1};
    if (unit.unit != "top") add(gates, unit.unit);
  }
  add(rest, "top");
  rows.push_back({.name = "Buffers",
                  .frame_j = sram_energy(synth, law, activity, cycles),
                  .leakage_w = sram_sum(config, law, &SramFigures::leak_mw) * 1e-3});
  EnergyRow total = {.name = "Total"};
  for (const EnergyRow& row : rows) add_row(total, row);
  rows.push_back(total);
  rows.push_back(
      {.name = "DRAM", .frame_j = kDramPjPerBit * (8e-12 * static_cast<double>(frame.bytes)), .leakage_w = {}});
  return rows;
}

}  // namespace

std::vector<EnergyRow> energy_rows(const Config& config, const Synth& synth, const Enables& enables, const SramLaw& law,
                                   const FrameActivity& activity) {
  std::vector<EnergyRow> rows = rows_of(config, synth, enables, law, activity, activity.sum());
  const std::vector<EnergyRow> one = rows_of(config, synth, enables, law, activity, activity.halves[0]),
                               two = rows_of(config, synth, enables, law, activity, activity.halves[1]);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].frame_j.mid > 0)
      rows[i].halves_differ = std::abs(one[i].frame_j.mid - two[i].frame_j.mid) / rows[i].frame_j.mid;
  }
  return rows;
}

std::vector<ModuleClocks> module_clocks(const Synth& synth, const Enables& enables, const FrameActivity& activity) {
  const Activity sum = activity.sum();
  const double joules = joules_of(synth).mid * static_cast<double>(activity.cycles) / static_cast<double>(sum.cycles);
  std::vector<ModuleClocks> clocks = sampled_clocks(enables, sum);
  for (ModuleClocks& one : clocks) {
    for (double ModuleClocks::*figure :
         {&ModuleClocks::ungated_j, &ModuleClocks::gated_j, &ModuleClocks::gates_j, &ModuleClocks::open_j})
      one.*figure *= joules;
  }
  std::stable_sort(clocks.begin(), clocks.end(),
                   [](const ModuleClocks& a, const ModuleClocks& b) { return a.all_j() > b.all_j(); });
  return clocks;
}

}  // namespace pipegs
