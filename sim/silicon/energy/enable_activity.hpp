// SPDX-License-Identifier: Apache-2.0
// enable_activity.hpp: in how many cycles of waves each clock gate behind an enable lets its clock pass.
//
// Idea    At each rising edge of a module's clk_i the leaves of its enables are sampled as they were before it; 64
//         edges or fewer are evaluated together (enables.hpp).
// Check   One bit behind each gate is watched: it must not change over an edge at which the gate's enable was low. So
//         functions of other RTL, or wrong ones, are found in the waves. Edges in a reset are left out.
// Rule    An enable that the waves do not show counts as high in every cycle; `unseen` counts the flip-flops that
//         concerns.
// Errors  InputError: an instance is not in the waves, or a bit changes while its enable is low.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/silicon/energy/enables.hpp"

namespace pipegs {

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
