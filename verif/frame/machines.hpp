// SPDX-License-Identifier: Apache-2.0
// machines.hpp: the machines that whole frames are tested on; verif/frame/CMakeLists.txt builds them.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "sim/compare/simulate.hpp"
#include "sim/design/design_point.hpp"

namespace pipegs {

// A design point and what is changed in it.
struct Machine {
  const char* design_point;
  std::vector<std::string> settings = {};
};

// The machine of Table 2, then half of it, with the second cull, and a quarter, with PUs of four cycles and stores so
// small that every one of them overflows; then the other design points of the ladder, and `exact` that leaves out what
// is hidden, with a pool so small that it spills, and with the numbers of sim/fine.cfg and lanes that blend living
// quads; then `late` with coarse numbers, without some parts, and PUs of four cycles; and `fast` with PUs of eight and
// proxies that leaves out nothing of what is hidden, and with codes, proxies, pools that spill and the shortest queue;
// and `wide`. Buses of all
// widths are among them, and a machine without one; clocks that never stop, too.
inline const std::vector<Machine> kMachines = {
    {"dop"},
    {"dop", {"units=2", "fronts=1", "pixels_per_row=1", "grid=8", "tight_cull=1", "bus_w=256", "clock_gates=0"}},
    {"dop", {"units=1", "pace=4", "alpha_lines=64", "records=16"}},
    {"late"},
    {"tspp"},
    {"dpc"},
    {"baseline"},
    {"gscore"},
    {"exact"},
    {"exact", {"units=2", "occlusion=1", "records=16", "bucket_bits=3", "bus_w=128", "clock_gates=0"}},
    {"exact", {"quads=1", "pos_w=18", "base_w=14", "mantissa_w=22", "coeff_f=24", "alpha_w=10"}},
    {"fast"},
    {"late",
     {"antialias=1", "alpha_cut=128", "tile_test=0", "pace=4", "exp_linear=0", "t_cut=1000", "guard_band=0",
      "early_stop=0", "bus_w=0", "taps=0"}},
    {"fast", {"occlusion=0", "pace=8", "lod=1"}},
    {"fast", {"records=48", "nearest_nodes=128", "record=48", "lod=1"}},
    {"wide"}};

// Their numbers.
enum Numbered : size_t {
  kDop,
  kHalf,
  kTiny,
  kLate,
  kTspp,
  kDpc,
  kBaseline,
  kGscore,
  kExact,
  kTinyExact,
  kFine,
  kFast,
  kOdd,
  kHidden,
  kCrowded,
  kWide
};

inline SimulateOptions machine(size_t number) {
  SimulateOptions options;
  options.config = find_design_point(kMachines[number].design_point).config;
  for (const std::string& setting : kMachines[number].settings) config_set(options.config, setting);
  options.memory.jitter = 20;
  return options;
}

// Whether the RTL of a machine is there today: PIPEGS_MACHINES names those that ctest's build has, as
// config_difference() does; without it, by hand, all count, and what is missing is built.
inline bool there_today(const Config& config) {
  const char* today = std::getenv("PIPEGS_MACHINES");
  std::istringstream names(today == nullptr ? "" : today);
  const std::string difference = config_difference(config), name = difference.empty() ? "default" : difference;
  return today == nullptr ||
         std::find(std::istream_iterator<std::string>(names), {}, name) != std::istream_iterator<std::string>();
}

// Of these numbers, or of all, those of machines that are there today.
inline std::vector<size_t> todays(std::vector<size_t> numbers = {}) {
  if (numbers.empty()) {
    numbers.resize(kMachines.size());
    std::iota(numbers.begin(), numbers.end(), size_t{0});
  }
  std::erase_if(numbers, [](size_t number) { return !there_today(machine(number).config); });
  return numbers;
}

}  // namespace pipegs
