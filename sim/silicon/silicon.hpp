// SPDX-License-Identifier: Apache-2.0
// silicon.hpp: area and clock of a configuration in 28 nm: gates from `make synth`, memories from their law.
//
// Idea    synth.json counts each unit's gates in NAND2 equivalents and its longest path in FO4 delays; static_cost
//         lists the SRAMs.
//         Rows are those of the paper's Table 2, and one for what the paper does not name: lists, arbiter, counters.
// Units   mm2, ps; ranges as in process.hpp. Areas of SRAMs: the smallest, median and largest of the kinds of cells.
// Errors  InputError: synth.json is missing, broken, or of another configuration.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"
#include "sim/silicon/process.hpp"
#include "sim/silicon/area/sram_cost.hpp"

namespace pipegs {

struct SynthUnit {
  std::string unit;  // dopu, pu, su, ru, list, buf, top
  int instances = 0;
  double nand2 = 0, flipflops = 0;  // of one
  double path_ps = 0;               // of the library
  std::string from, to;
  double switch_j = 0;  // of one and of the library: a cycle in which each net toggles once
};

struct SynthMemory {
  std::string instance;  // [k] for any number
  int words = 0, width = 0, ports = 2;
};

struct Synth {
  std::string configuration, library;
  double fo4_ps = 0, nand2_ff = 0, volts = 0;
  std::vector<SynthUnit> units;
  std::vector<SynthMemory> memories;
};
Synth read_synth(const std::filesystem::path& json, const Config& config);

// The least, the median and the most.
Range range_of(std::vector<double> values);

// A figure of all SRAMs together.
Range sram_sum(const Config& config, const SramLaw& law, double SramFigures::*figure);

struct SiliconRow {
  std::string name;               // DOPU, PU, SU, RU, Other, Buffers, Total
  int count = 0;                  // of units; 0 where that says nothing
  double kilo_nand2 = 0, kb = 0;  // of all
  Range area_mm2;                 // of all
  Range path_ps;                  // the longest of one
};
std::vector<SiliconRow> silicon_rows(const Config& config, const Synth& synth, const SramLaw& law);

}  // namespace pipegs
