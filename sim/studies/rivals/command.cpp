// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study rivals`: what a view asks of any renderer by tiles, and models of other accelerators on it
// beside two machines of our own.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/command/own_tables.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/studies/rivals/compare/report.hpp"

namespace pipegs {
namespace {

struct RivalsArguments {
  ViewArguments view;
  MemoryArguments memory;
  double voxel = 2;
  StudyOutput output;
};

constexpr double kFinestVoxel = 1.0 / 16;  // of --voxel, by halves: the edges between which STREAMINGGS is modelled

FrameCounts count(const RivalsArguments& arguments, const LoadedView& view) {
  Progress progress("counting");
  CountOptions options{
      .near_plane = arguments.view.near_plane, .voxels = {}, .progress = [&](double share) { progress.update(share); }};
  for (double part = 1; part >= kFinestVoxel; part /= 2) options.voxels.push_back(part * arguments.voxel);
  return count_frame(view.scene, view.camera, options);
}

std::vector<OwnMachine> own_machines(const LoadedView& loaded, const RivalsArguments& arguments) {
  const FrameModel model = own_tables(read_frame_model);
  std::vector<OwnMachine> own;
  for (SimulateOptions one : arguments.view.paper_and_own()) {
    arguments.memory.apply(one);
    follow_scene(loaded, one);
    const Progress stage("timing model of " + machine_name(one.config));
    const CycleEngine engine = model_engine(loaded.scene, loaded.camera, one);
    own.push_back(own_machine(machine_name(one.config), one.config, engine(one.config, one.memory), model));
  }
  return own;
}

int run_rivals(RivalsArguments& arguments) {
  const SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: the whole view is counted, expected none");
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  check_picture_memory(loaded.camera, options, kCountPixels);
  const FrameCounts counts = count(arguments, loaded);
  PlayedMemory memory(arguments.memory.external.dram);
  const Comparison comparison = compare(counts, memory, own_machines(loaded, arguments));
  NamedMachines machines;
  for (const SimulateOptions& one : arguments.view.paper_and_own())
    machines.emplace_back(machine_name(one.config), one.config);
  nlohmann::ordered_json json = {{"scene", loaded.scene.name},
                                 {"camera", loaded.camera.name},
                                 {"width", counts.width},
                                 {"height", counts.height},
                                 {"memory", arguments.memory.external.dram},
                                 {"near", arguments.view.near_plane},
                                 {"voxel", arguments.voxel}};
  json.update(comparison_json(comparison));
  arguments.output.write({.title = "Other accelerators on this view",
                          .head = fmt::format("{}: view {} ({}x{}), memory {}", loaded.scene.name, loaded.camera.name,
                                              counts.width, counts.height, arguments.memory.external.dram),
                          .charts = comparison_charts(comparison),
                          .tables = comparison_tables(comparison),
                          .machines = machines,
                          .odd = loaded.told->all()},
                         json);
  return kExitOk;
}

}  // namespace

void add_rivals(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "rivals",
      "other accelerators on this view, modelled from what it asks of any renderer by tiles, beside ours",
      footer(
          "pipegs study rivals garden.ply --cameras cameras.json --view 0 --out rivals --page", "done", "",
          "GSCore, GS-TG, STREAMINGGS, GSAcc, Neo and FLICKER as their papers describe them, driven by counts of the "
          "float64\nprojection and blending, with the same memory; what is not published is a parameter with a range, "
          "and every figure\ncomes as low..mid..high. Beside them `dop` and the machine of --design and --set, by "
          "timing model and frame model.\ndocs/rivals/rivals.md says what each model stands on."));
  static RivalsArguments arguments;
  arguments.view.add(command);
  arguments.memory.add(command, false);
  add_real(command, "--voxel", arguments.voxel, "edge of a voxel, scene units", {.low = 0.001, .high = 1e6})
      .shows_default();
  arguments.output.add(command);
  when_chosen(command, run, [] { return run_rivals(arguments); });
}

}  // namespace pipegs
