// SPDX-License-Identifier: Apache-2.0
// enables.hpp: which flip-flops have a gated clock, each gate's enable as a function of the RTL's signals, and in how
// many cycles of waves it lets its clock pass.
//
// Idea    `make synth` gives flip-flops that share an enable one gated clock (synth/gating.py) and writes of each
//         module how its enables follow from signals that have a name in the RTL's waves. The functions are of single
//         bits, so 64 cycles are evaluated at once.
// Waves   At each rising edge of a module's clk_i the leaves of its enables are sampled as they were before it; 64
//         edges or fewer are evaluated together.
// Check   One bit behind each gate is watched: it must not change over an edge at which the gate's enable was low. So
//         functions of other RTL, or wrong ones, are found in the waves. Edges in a reset are left out.
// Rule    An enable that the waves do not show counts as high in every cycle; `unseen` counts the flip-flops that
//         concerns.
// Rule    Nodes of a module's functions are numbered: 0 and 1 are constants, then its leaves, then its operations, each
//         behind what it depends on. kUnknown: an enable that does not follow from named signals; it counts as high.
// Units   Energies in J of the library, for one cycle in which the clock's edges pass.
// Errors  InputError: the file is missing, is of another configuration, or is not what `make synth` writes; an instance
//         is not in the waves, or a bit changes while its enable is low.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
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

struct Enabled {
  uint64_t edges = 0;            // of clk_i, all instances
  std::vector<uint64_t> passed;  // of these, by gate
};
using EnabledByUnit = std::map<std::string, std::map<std::string, Enabled>>;  // by unit and module

class EnableSampler {
 public:
  using Group = std::function<std::string(const std::string& scope)>;
  // Results are added to `sums`, under the name that `group` gives to the path of an instance.
  EnableSampler(const Enables& enables, const Group& group, EnabledByUnit& sums);

  // A signal of the waves, by its name below the machine; whether anything depends on it.
  bool declare(const std::string& name, uint32_t handle, uint32_t width);
  // All are declared: the clocks' handles. Flip-flops whose enables are not among them, by unit.
  std::vector<uint32_t> clocks() const;
  std::map<std::string, uint64_t> unseen();

  // A clock has risen; `before(handle)` is a signal's text as the edge has sampled it.
  template <class Before>
  void rise(uint32_t clock, const Before& before) {
    const auto found = instances_of_.find(clock);
    if (found == instances_of_.end()) return;
    for (const size_t i : found->second) {
      Instance& instance = instances_[i];
      for (size_t leaf = 0; leaf < instance.places.size(); ++leaf) {
        const Place& place = instance.places[leaf];
        if (place.handle == 0) continue;
        const std::string& text = before(place.handle);
        const uint64_t one = place.at < text.size() && text[place.at] == '1';
        instance.values[leaf] |= one << instance.cycles;
      }
      if (++instance.cycles == 64) flush(instance);
    }
  }
  void finish();  // the sample is over

 private:
  struct Place {
    uint32_t handle = 0, at = 0;  // 0: not in the waves; place in the text
  };
  struct Instance {
    std::string name, unit;
    const GatedModule* module = nullptr;
    Enabled* sum = nullptr;
    uint32_t clock = 0;
    std::vector<Place> places;     // of the leaves
    std::vector<uint64_t> values;  // of the leaves, bit i of cycle i
    std::vector<bool> known;       // nodes
    int cycles = 0;
  };
  void flush(Instance& instance);

  std::vector<Instance> instances_;
  struct Use {
    size_t instance, leaf;  // kClock: its clk_i
  };
  static constexpr size_t kClock = ~size_t{0};
  std::unordered_multimap<std::string, Use> uses_;
  std::unordered_map<uint32_t, std::vector<size_t>> instances_of_;
  std::vector<uint64_t> nodes_;
};

}  // namespace pipegs
