// SPDX-License-Identifier: Apache-2.0
// effects.cpp: `pipegs effects`: which parts of the machine and of its simulation a view calls for.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/effects/effects.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

struct EffectsArguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false;
};

Json table(const Scene& scene, const SimulateOptions& options, const Simulation& simulation) {
  Json list = Json::array();
  for (const EffectFinding& finding : find_effects(effect_facts(scene, options, simulation, true))) {
    list.push_back({{"name", finding.effect->name},
                    {"called_for", finding.verdict.called_for},
                    {"evidence", finding.verdict.evidence},
                    {"what", finding.effect->what},
                    {"cost", effect_cost(*finding.effect, options)},
                    {"without", finding.effect->without}});
  }
  return list;
}

int effects(const EffectsArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  check_picture_memory(loaded.camera, options, kGoldenPixels);
  Json json = {{"scene", loaded.scene.name},
               {"camera", loaded.camera.name},
               {"configuration", config_difference(options.config)}};
  {
    Simulation simulation;
    simulate_golden(loaded.scene, loaded.camera, options, simulation);
    const Progress stage("timing model");
    json["effects"] = table(loaded.scene, options, simulation);
  }
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: view {} ({}x{})\n\n", loaded.scene.name, loaded.camera.name, loaded.camera.width,
               loaded.camera.height);
    for (const Json& row : json["effects"]) {
      const auto text = [&](const char* key) { return row[key].get<std::string>(); };
      fmt::print("  {:<14}{:<12}{}\n", text("name"), row["called_for"].get<bool>() ? "called for" : "not",
                 text("evidence"));
      fmt::print("  {:<26}{}; without: {}{}\n", "", text("what"), text("without"),
                 text("cost").empty() ? "" : ", saves " + text("cost"));
    }
  }
  return kExitOk;
}

}  // namespace

void add_effects(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "effects", "what of the machine a view calls for, with proof",
      footer("pipegs effects garden.ply --cameras cameras.json --view 0", "listed", "",
             "`pipegs sim --effects auto` leaves out what is not called for; every pixel is compared all the same."));
  static EffectsArguments arguments;
  arguments.view.add(command);
  arguments.memory.add(command);
  add_flag(command, "--json", arguments.json, "print JSON instead of the table");
  when_chosen(command, run, [] { return effects(arguments); });
}

}  // namespace pipegs
