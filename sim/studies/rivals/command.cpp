// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study rivals`: what a view asks of any renderer by tiles, and models of other accelerators on it
// beside two machines of our own.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/studies/rivals/compare/report.hpp"
#include "sim/studies/rivals/report.hpp"

namespace pipegs {
namespace {

struct RivalsArguments {
  ViewArguments view;
  MemoryArguments memory;
  CountOptions counts{.group = 64};
  StudyOutput output;
  bool only_counts = false;
};

constexpr double kFinestVoxel = 1.0 / 16;  // of --voxel, by halves: the edges between which STREAMINGGS is modelled

std::vector<double> finer_voxels(double voxel) {
  std::vector<double> edges;
  for (double part = 0.5; part >= kFinestVoxel; part /= 2) edges.push_back(voxel * part);
  return edges;
}

FrameCounts count(RivalsArguments& arguments, const LoadedView& view) {
  Progress progress("counting");
  arguments.counts.near_plane = arguments.view.near_plane;
  arguments.counts.progress = [&](double share) { progress.update(share); };
  if (!arguments.only_counts) arguments.counts.other_voxels = finer_voxels(arguments.counts.voxel);
  return count_frame(view.scene, view.camera, arguments.counts);
}

std::vector<OwnMachine> own_machines(const LoadedView& loaded, const RivalsArguments& arguments) {
  const FrameModel model = read_frame_model();
  std::vector<OwnMachine> own;
  for (SimulateOptions one : arguments.view.paper_and_own()) {
    arguments.memory.apply(one);
    follow_scene(loaded.scene, one);
    const CycleEngine engine = model_engine(loaded.scene, loaded.camera, one);
    own.push_back(own_machine(machine_name(one.config), one.config, engine(one.config, one.memory), model));
  }
  return own;
}

int run_rivals(RivalsArguments& arguments) {
  const SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: the whole view is counted, expected none");
  if (arguments.counts.group % kTileSide != 0)
    throw ConfigError(fmt::format("--group: found {}, expected a multiple of {}", arguments.counts.group, kTileSide));
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  check_picture_memory(loaded.camera, options, kCountPixels);
  const FrameCounts counts = count(arguments, loaded);
  std::optional<Comparison> comparison;
  if (!arguments.only_counts) {
    PlayedMemory memory(arguments.memory.external.dram);
    comparison = compare(counts, memory, own_machines(loaded, arguments));
  }
  std::string head =
      fmt::format("{}: view {} ({}x{}), ", loaded.scene.name, loaded.camera.name, counts.width, counts.height);
  head += comparison ? "memory " + arguments.memory.external.dram : "float64, depth order";
  const std::vector<Table> tables =
      comparison ? comparison_tables(*comparison) : counts_tables(counts, arguments.counts);
  NamedMachines machines;
  for (const SimulateOptions& one : arguments.view.paper_and_own())
    machines.emplace_back(machine_name(one.config), one.config);
  nlohmann::ordered_json json = {
      {"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"width", counts.width}, {"height", counts.height}};
  if (comparison) json["memory"] = arguments.memory.external.dram;
  json.update(counts_json(counts, arguments.counts));
  if (comparison) json.update(comparison_json(*comparison));
  arguments.output.write({.title = "Other accelerators on this view",
                          .head = head,
                          .charts = comparison ? comparison_charts(*comparison) : std::vector<Chart>{},
                          .tables = tables,
                          .machines = comparison ? machines : NamedMachines{}},
                         json);
  return kExitOk;
}

}  // namespace

void add_rivals(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "rivals", "other accelerators on this view, modelled from what it asks of any renderer by tiles, beside ours");
  command->footer(footer(
      "pipegs study rivals garden.ply --cameras cameras.json --view 0 --out rivals --page", "done", "",
      "GSCore, GS-TG, STREAMINGGS, GSAcc, Neo and FLICKER as their papers describe them, driven by counts of the "
      "float64\nprojection and blending, with the same memory; what is not published is a parameter with a range, and "
      "every figure\ncomes as low..mid..high. Beside them `dop` and the machine of --design and --set, by timing model "
      "and frame model.\n--counts prints the counts alone. docs/rivals/rivals.md says what each model stands on."));
  static RivalsArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command, false);
  add_real(*command, "--voxel", arguments.counts.voxel, "edge of a voxel, scene units", {.low = 0.001, .high = 1e6})
      ->capture_default_str();
  add_integer(*command, "--group", arguments.counts.group,
              "side of a group of pixels that streams voxels, a multiple of 16", 16, 4096)
      ->capture_default_str();
  command->add_flag("--counts", arguments.only_counts, "the counts alone, without machines");
  arguments.output.add(*command);
  command->callback([&run] { run = [] { return run_rivals(arguments); }; });
}

}  // namespace pipegs
