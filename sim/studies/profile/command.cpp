// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study profile`: what of a view could be reused: the paper's Fig. 3b, 4 and 5b.
#include <fmt/format.h>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/studies/profile/profile.hpp"

namespace pipegs {
namespace {

struct ProfileArguments {
  ViewArguments view;
  StudyOutput output;
};

int profile(const ProfileArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  check_picture_memory(loaded.camera, options, kGoldenPixels);
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  const ViewProfile found = view_profile(simulation, options);

  const std::string head = fmt::format("{}: {} Gaussians; view {} ({}x{}); design point {}", loaded.scene.name,
                                       loaded.scene.gaussians.size(), loaded.camera.name, loaded.camera.width,
                                       loaded.camera.height, arguments.view.design_point);
  nlohmann::ordered_json json = {
      {"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"design", arguments.view.design_point}};
  json.update(profile_json(found));
  arguments.output.write({.title = "What of a view could be reused",
                          .head = head,
                          .charts = profile_charts(found),
                          .tables = profile_tables(found),
                          .machines = {{machine_name(options.config), options.config}},
                          .odd = loaded.told->all()},
                         json);
  return kExitOk;
}

}  // namespace

void add_profile(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "profile", "how often the Gaussians of a view could be reused",
      footer("pipegs study profile garden.ply --cameras cameras.json --design baseline --out profile --page", "counted",
             "", "Without --design the baseline, as in the paper."));
  static ProfileArguments arguments;
  arguments.view.design_point = "baseline";  // the paper's Fig. 3b is of it
  arguments.view.add(command);
  arguments.output.add(command);
  when_chosen(command, run, [] { return profile(arguments); });
}

}  // namespace pipegs
