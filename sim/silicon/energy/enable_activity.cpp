// SPDX-License-Identifier: Apache-2.0
// enable_activity.cpp: see enable_activity.hpp.
#include "sim/silicon/energy/enable_activity.hpp"

#include <bit>

#include "scenes/input_error.hpp"

namespace pipegs {

EnableSampler::EnableSampler(const Enables& enables, const Group& group, EnabledByUnit& sums) {
  for (const auto& [name, module] : enables.instances) {
    const std::string unit = group(name), scope = name.empty() ? "" : name + ".";
    const GatedModule& gated = enables.modules.at(module);
    if (gated.gates.empty() && gated.always_flipflops == 0) continue;
    Enabled& sum = sums[unit][module];
    sum.passed.resize(gated.gates.size());
    uses_.emplace(scope + "clk_i", Use{instances_.size(), kClock});
    for (size_t leaf = 0; leaf < gated.leaves.size(); ++leaf)
      uses_.emplace(scope + gated.leaves[leaf].name, Use{instances_.size(), leaf});
    instances_.push_back({name,
                          unit,
                          &gated,
                          &sum,
                          0,
                          std::vector<Place>(gated.leaves.size()),
                          std::vector<uint64_t>(gated.leaves.size()),
                          {},
                          0});
  }
}

bool EnableSampler::declare(const std::string& name, uint32_t handle, uint32_t width) {
  const auto [begin, end] = uses_.equal_range(name);
  for (auto use = begin; use != end; ++use) {
    Instance& instance = instances_[use->second.instance];
    if (use->second.leaf == kClock) {
      instance.clock = handle;
      continue;
    }
    const auto bit = static_cast<uint32_t>(instance.module->leaves[use->second.leaf].bit);
    if (bit < width) instance.places[use->second.leaf] = {handle, width - 1 - bit};
  }
  return begin != end;
}

std::vector<uint32_t> EnableSampler::clocks() const {
  std::vector<uint32_t> found;
  for (const Instance& instance : instances_) {
    if (instance.clock == 0) throw InputError("enables.json", "instances", "no " + instance.name + " in the waves");
    found.push_back(instance.clock);
  }
  return found;
}

std::map<std::string, uint64_t> EnableSampler::unseen() {
  std::map<std::string, uint64_t> flipflops;
  for (size_t i = 0; i < instances_.size(); ++i) {
    Instance& instance = instances_[i];
    instances_of_[instance.clock].push_back(i);
    std::vector<bool> leaves;
    for (const Place& place : instance.places) leaves.push_back(place.handle != 0);
    instance.known = instance.module->known(leaves);
    for (const GatedModule::Gate& gate : instance.module->gates) {
      if (gate.enable == GatedModule::kUnknown || !instance.known[gate.enable])
        flipflops[instance.unit] += static_cast<uint64_t>(gate.flipflops);
    }
  }
  return flipflops;
}

void EnableSampler::finish() {
  for (Instance& instance : instances_) flush(instance);
}

void EnableSampler::flush(Instance& instance) {
  if (instance.cycles == 0) return;
  const GatedModule& module = *instance.module;
  module.evaluate(instance.values, nodes_);
  const uint64_t all = ~uint64_t{0} >> (64 - instance.cycles), followed = all >> 1;  // edges, and those before another
  instance.sum->edges += static_cast<uint64_t>(instance.cycles);
  for (size_t i = 0; i < module.gates.size(); ++i) {
    const GatedModule::Gate& gate = module.gates[i];
    const bool seen = gate.enable != GatedModule::kUnknown && instance.known[gate.enable];
    const uint64_t enable = seen ? nodes_[gate.enable] : all;
    instance.sum->passed[i] += static_cast<uint64_t>(std::popcount(enable & all));
    if (!seen || gate.held == GatedModule::kUnknown || !instance.known[gate.held]) continue;
    const uint64_t held = nodes_[gate.held];
    if ((~enable & (held ^ (held >> 1)) & followed) != 0) {
      throw InputError("enables.json", instance.name,
                       "gate " + std::to_string(i) + " is closed and its flip-flops change: it is of other RTL");
    }
  }
  std::fill(instance.values.begin(), instance.values.end(), 0);
  instance.cycles = 0;
}

}  // namespace pipegs
