// SPDX-License-Identifier: Apache-2.0
// energy.cpp: see energy.hpp.
#include "sim/study/silicon/energy/energy.hpp"

#include <algorithm>
#include <cmath>

#include "scenes/input_error.hpp"

namespace pipegs {

namespace {

// What a unit takes in a frame, all its instances, and without what units inside it take.
struct Gates {
  double clock_j = 0, switch_j = 0, kilo_nand2 = 0;  // of one instance
  int instances = 1;
};

struct LibraryJoules {
  double clocks = 0, data = 0;
};

LibraryJoules library_joules(const Gates& gates, const Activity& activity, const std::string& unit, double cycles) {
  const auto found = activity.groups.find(unit);
  const auto clock = activity.clocks.find(unit);
  if (found == activity.groups.end() || found->second.bits == 0) return {};
  const double scale = cycles / static_cast<double>(activity.cycles);  // of the samples to the frame
  const double clocked =
      clock == activity.clocks.end() ? static_cast<double>(activity.cycles) : static_cast<double>(clock->second);
  const double toggles =
      static_cast<double>(found->second.toggles) / (static_cast<double>(found->second.bits) / gates.instances);
  return {clocked * gates.clock_j * scale, toggles * gates.switch_j * scale};
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
      const SramFigures figures = law.memory(kind, memory->width, memory->words);
      sum += (static_cast<double>(accesses.reads) * figures.read_pj +
              static_cast<double>(accesses.writes) * figures.write_pj) *
             1e-12;
    }
    by_kind.push_back(sum * scale);
  }
  return range_of(by_kind);
}

std::vector<EnergyRow> rows_of(const Config& config, const Synth& synth, const SramLaw& law, const FrameActivity& frame,
                               const Activity& activity) {
  const auto cycles = static_cast<double>(frame.cycles);
  const Range joules =
      kNand2InputFf *
      (kVolts * kVolts / (synth.nand2_ff * synth.volts * synth.volts));  // in 28 nm for one of the library
  std::vector<EnergyRow> rows = {{.name = "DOPU"}, {.name = "PU"}, {.name = "SU"}, {.name = "RU"}, {.name = "Other"}};
  const auto add = [&](const Gates& gates, const std::string& unit) {
    static const std::map<std::string, size_t> kRow = {{"dopu", 0}, {"pu", 1}, {"su", 2}, {"ru", 3}};
    EnergyRow& row = rows[kRow.contains(unit) ? kRow.at(unit) : 4];
    const LibraryJoules taken = library_joules(gates, activity, unit, cycles);
    row.frame_j = row.frame_j + joules * (taken.clocks + taken.data);
    row.clocks_j += joules.mid * taken.clocks;
    if (kRow.contains(unit) && activity.clocks.contains(unit)) {
      row.awake =
          static_cast<double>(activity.clocks.at(unit)) / static_cast<double>(activity.cycles) / gates.instances;
    }
    row.leakage_w = row.leakage_w + kNand2LeakageNw * (gates.kilo_nand2 * gates.instances * 1e-6);
  };
  Gates rest;  // of the top, without the units
  for (const SynthUnit& unit : synth.units) {
    const Gates gates = {unit.clock_j, unit.switch_j, unit.nand2 / 1000, unit.instances};
    const double sign = unit.unit == "top" ? 1 : -unit.instances;
    rest = {rest.clock_j + sign * gates.clock_j, rest.switch_j + sign * gates.switch_j,
            rest.kilo_nand2 + sign * gates.kilo_nand2, 1};
    if (unit.unit != "top") add(gates, unit.unit);
  }
  add(rest, "top");
  rows.push_back({.name = "Buffers",
                  .frame_j = sram_energy(synth, law, activity, cycles),
                  .leakage_w = sram_sum(config, law, &SramFigures::leak_mw) * 1e-3});
  EnergyRow total = {.name = "Total"};
  for (const EnergyRow& row : rows) {
    total.frame_j = total.frame_j + row.frame_j;
    total.leakage_w = total.leakage_w + row.leakage_w;
    total.clocks_j += row.clocks_j;
  }
  rows.push_back(total);
  rows.push_back(
      {.name = "DRAM", .frame_j = kDramPjPerBit * (8e-12 * static_cast<double>(frame.bytes)), .leakage_w = {}});
  return rows;
}

}  // namespace

std::vector<EnergyRow> energy_rows(const Config& config, const Synth& synth, const SramLaw& law,
                                   const FrameActivity& activity) {
  std::vector<EnergyRow> rows = rows_of(config, synth, law, activity, activity.sum());
  const std::vector<EnergyRow> one = rows_of(config, synth, law, activity, activity.halves[0]),
                               two = rows_of(config, synth, law, activity, activity.halves[1]);
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].frame_j.mid > 0)
      rows[i].halves_differ = std::abs(one[i].frame_j.mid - two[i].frame_j.mid) / rows[i].frame_j.mid;
  }
  return rows;
}

}  // namespace pipegs
