// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study profile`: where a view's time goes and what could be reused: the paper's Fig. 3, 4 and 5b.
#include <fmt/format.h>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/studies/profile/profile.hpp"

namespace pipegs {
namespace {

struct ProfileArguments {
  ViewArguments view;
  MemoryArguments memory;
  StudyOutput output;
  bool no_rtl = false;
};

int profile(const ProfileArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  if (!arguments.no_rtl) need_taps(options);
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  check_picture_memory(loaded.camera, options, kGoldenPixels + kRtlPixels);
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  FigureWatch watch(options.config);
  options.taps = &watch;
  if (!arguments.no_rtl) simulate_rtl(options, simulation);
  const ViewProfile found = view_profile(simulation, options, arguments.no_rtl ? nullptr : &watch);

  const std::string head = fmt::format("{}: {} Gaussians; view {} ({}x{}); design point {}", loaded.scene.name,
                                       loaded.scene.gaussians.size(), loaded.camera.name, loaded.camera.width,
                                       loaded.camera.height, arguments.view.design_point);
  nlohmann::ordered_json json = {{"scene", loaded.scene.name},
                                 {"camera", loaded.camera.name},
                                 {"design", arguments.view.design_point},
                                 {"mismatches", nullptr}};
  if (!arguments.no_rtl) json["mismatches"] = simulation.mismatches;
  json.update(profile_json(found));
  arguments.output.write({.title = "Where a view's time goes",
                          .head = head,
                          .charts = profile_charts(found),
                          .tables = profile_tables(found),
                          .machines = {{machine_name(options.config), options.config}}},
                         json);
  if (simulation.mismatches == 0) return kExitOk;
  fmt::print(stderr, "first mismatch: {}\n", simulation.first_mismatch->what);
  return kExitDiffers;
}

}  // namespace

void add_profile(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("profile", "where a view's time goes, and how often its Gaussians could be reused");
  command->footer(
      footer("pipegs study profile garden.ply --cameras cameras.json --design baseline --out profile --page",
             "every bit of the RTL agrees (or --no-rtl: nothing compared)", "a bit differs or the RTL stops",
             "Without --design the baseline, as in the paper. With --no-rtl any design point can be counted."));
  static ProfileArguments arguments;
  arguments.view.design_point = "baseline";  // the paper's Fig. 3 is of it
  arguments.view.add(*command);
  arguments.memory.add(*command);
  arguments.output.add(*command);
  command->add_flag("--no-rtl", arguments.no_rtl, "counts only, times at full rate");
  command->callback([&run] { run = [] { return profile(arguments); }; });
}

}  // namespace pipegs
