// SPDX-License-Identifier: Apache-2.0
// enables.cpp: see enables.hpp.
#include "sim/silicon/energy/enables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <regex>

#include "scenes/input_error.hpp"
#include "scenes/text/json.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::json;
using Kind = GatedModule::Kind;

struct Word {
  const char* name;
  Kind kind;
  size_t inputs;
};
constexpr Word kWords[] = {{"and", Kind::kAnd, 2},   {"or", Kind::kOr, 2},   {"xor", Kind::kXor, 2},
                           {"xnor", Kind::kXnor, 2}, {"not", Kind::kNot, 1}, {"mux", Kind::kMux, 3}};

// Blocks that Yosys names, and waves do not.
std::string without_unnamed(const std::string& name) {
  static const std::regex kUnnamed("genblk[0-9]+\\.");
  return std::regex_replace(name, kUnnamed, "");
}

GatedModule::Operation operation(const Json& json, int nodes_before) {
  const std::string name = json.at(0);
  const auto* const word =
      std::find_if(std::begin(kWords), std::end(kWords), [&](const Word& w) { return w.name == name; });
  if (word == std::end(kWords) || json.size() != 1 + word->inputs)
    throw NumberError("found " + quote(json_text(json)) + ", expected an operation and its inputs");
  GatedModule::Operation result = {word->kind, {0, 0, 0}};
  for (size_t i = 0; i < word->inputs; ++i) result.in[i] = json_integer(json.at(1 + i), 0, nodes_before - 1);
  return result;
}

GatedModule module_of(const Json& json) {
  GatedModule module;
  for (const Json& leaf : json.at("leaves"))
    module.leaves.push_back({without_unnamed(leaf.at(0)), json_integer(leaf.at(1), 0)});
  for (const Json& one : json.at("operations")) module.operations.push_back(operation(one, module.nodes()));
  const auto node = [&](const Json& value) {
    return value.is_null() ? GatedModule::kUnknown : json_integer(value, 0, module.nodes() - 1);
  };
  for (const Json& gate : json.at("gates"))
    module.gates.push_back(
        {node(gate.at(0)), node(gate.at(1)), json_integer(gate.at(2), 0), json_real(gate.at(3), kNotNegative)});
  module.clock_gates = json_integer(json.at("clock_gates"), 0);
  module.always_flipflops = json_integer(json.at("always").at(0), 0);
  module.always_joules = json_real(json.at("always").at(1), kNotNegative);
  return module;
}

}  // namespace

void GatedModule::evaluate(std::span<const uint64_t> leaf_values, std::vector<uint64_t>& nodes) const {
  nodes.assign({0, ~uint64_t{0}});
  nodes.insert(nodes.end(), leaf_values.begin(), leaf_values.end());
  for (const Operation& one : operations) {
    const uint64_t a = nodes[one.in[0]], b = nodes[one.in[1]], c = nodes[one.in[2]];
    switch (one.kind) {
      case Kind::kAnd: nodes.push_back(a & b); break;
      case Kind::kOr: nodes.push_back(a | b); break;
      case Kind::kXor: nodes.push_back(a ^ b); break;
      case Kind::kXnor: nodes.push_back(~(a ^ b)); break;
      case Kind::kNot: nodes.push_back(~a); break;
      case Kind::kMux: nodes.push_back((a & b) | (~a & c)); break;
    }
  }
}

std::vector<bool> GatedModule::known(const std::vector<bool>& leaf_known) const {
  std::vector<bool> result = {true, true};
  result.insert(result.end(), leaf_known.begin(), leaf_known.end());
  for (const Operation& one : operations)
    result.push_back(std::all_of(one.in.begin(), one.in.end(), [&](int node) { return result[node]; }));
  return result;
}

Enables read_enables(const std::filesystem::path& path, const Config& config) {
  if (!std::filesystem::exists(path)) throw InputError(path.string(), "", "not found: `make synth` writes it");
  const Json json = read_json<Json>(path, "what `make synth` writes");
  try {
    const std::string configuration = json.at("configuration");
    if (configuration != config_difference(config)) {
      throw InputError(path.string(), "configuration",
                       fmt::format("found {}, expected {}", quote(configuration), config_difference(config)));
    }
    Enables enables = {json.at("program"), json_real(json.at("gate_j"), kNotNegative), {}, {}};
    for (const auto& [name, module] : json.at("modules").items()) enables.modules[name] = module_of(module);
    for (const auto& [instance, module] : json.at("instances").items()) {
      if (!enables.modules.contains(module))
        throw InputError(path.string(), "instances", "no module " + quote(module.get<std::string>()));
      enables.instances[without_unnamed(instance)] = module;
    }
    return enables;
  } catch (const NumberError& error) {
    throw InputError(path.string(), "", error.what());
  } catch (const Json::exception& error) {
    throw InputError(path.string(), "", fmt::format("expected what `make synth` writes: {}", quote(error.what())));
  }
}

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
