// SPDX-License-Identifier: Apache-2.0
// enables.hpp: which flip-flops have a gated clock, and each gate's enable as a function of the RTL's signals.
//
// Idea    `make synth` gives flip-flops that share an enable one gated clock (synth/gating.py) and writes of each
//         module how its enables follow from signals that have a name in the RTL's waves. The functions are of single
//         bits, so 64 cycles are evaluated at once.
// Rule    Nodes of a module's functions are numbered: 0 and 1 are constants, then its leaves, then its operations, each
//         behind what it depends on. kUnknown: an enable that does not follow from named signals; it counts as high.
// Units   Energies in J of the library, for one cycle in which the clock's edges pass.
// Errors  InputError: the file is missing, is of another configuration, or is not what `make synth` writes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "cpp_model/config.hpp"

namespace pipegs {

struct GatedModule {
  static constexpr int kUnknown = -1;
  struct Leaf {
    std::string name;  // below the module's own scope, with dots
    int bit = 0;       // from the least significant
  };
  enum class Kind { kAnd, kOr, kXor, kXnor, kNot, kMux };  // kMux: in[0] ? in[1] : in[2]
  struct Operation {
    Kind kind;
    std::array<int, 3> in;
  };
  struct Gate {
    int enable = kUnknown, held = kUnknown;  // held: one bit that it clocks, which stands still while the enable is low
    int flipflops = 0;
    double joules = 0;
  };
  std::vector<Leaf> leaves;
  std::vector<Operation> operations;
  std::vector<Gate> gates;
  int clock_gates = 0;       // all of the module's own
  int always_flipflops = 0;  // without a gate
  double always_joules = 0;

  int nodes() const { return static_cast<int>(2 + leaves.size() + operations.size()); }
  // The values of all nodes; bit i of each word is cycle i.
  void evaluate(std::span<const uint64_t> leaf_values, std::vector<uint64_t>& nodes) const;
  // Those that can be said when these leaves are known.
  std::vector<bool> known(const std::vector<bool>& leaf_known) const;
};

struct Enables {
  std::string program;     // hash of the functions, whatever the library
  double gate_joules = 0;  // of a clock gate itself
  std::map<std::string, GatedModule> modules;
  std::map<std::string, std::string> instances;  // path below the top, "" for the top itself: module
};

Enables read_enables(const std::filesystem::path& json, const Config& config);

}  // namespace pipegs
