// SPDX-License-Identifier: Apache-2.0
// silicon.cpp: `pipegs silicon`: area, clock and energy in 28 nm unit by unit, beside the paper's Table 2 and
// GSCore's; frames per mm2 and joule.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "scenes/text/number.hpp"
#include "sim/command/command.hpp"
#include "sim/command/own_tables.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/timing/cycle_engine.hpp"
#include "sim/report/measurement_store.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

struct SiliconArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string library = "osu018", folder = PIPEGS_BUILD_DIR "/synth", keep = PIPEGS_BUILD_DIR "/silicon";
  StudyOutput output;
  bool no_energy = false;
};

// What `make synth` wrote of a configuration.
std::filesystem::path synth_folder(const SiliconArguments& arguments, const Config& config) {
  return std::filesystem::path(arguments.folder) / config_difference(config) / arguments.library;
}

Synth synth_of(const SiliconArguments& arguments, const Config& config) {
  return read_synth(synth_folder(arguments, config) / "synth.json", config);
}

// What was kept of this frame, or a run of the RTL.
FrameActivity frame_activity(const LoadedView& loaded, const SimulateOptions& options, const Enables& enables,
                             uint64_t cycles, const std::string& folder) {
  const MeasurementStore store(folder, loaded.scene, loaded.camera, options,
                               {{"rtl", hash_of_files(PIPEGS_SOURCE_DIR "/rtl", ".sv")},
                                {"samples", {kSamples, kSampleCycles}},
                                {"enables", enables.program}});
  if (const std::optional<FrameActivity> kept = store.load(options.config, frame_activity_from_json)) return *kept;
  const FrameActivity activity = measure_activity(loaded.scene, loaded.camera, options, enables, cycles, folder);
  store.save(options.config, to_json(activity));
  return activity;
}

int silicon(const SiliconArguments& arguments) {
  std::vector<SimulateOptions> options = arguments.view.each();
  arguments.output.check();
  if (!arguments.no_energy) try_folder("--store", arguments.keep);
  const LoadedView loaded = load_view(arguments.view);
  for (SimulateOptions& one : options) {
    arguments.memory.apply(one);
    follow_scene(loaded, one);
    if (arguments.no_energy) continue;
    need_taps(one);
    check_picture_memory(loaded.camera, one, kGoldenPixels + kRtlPixels);
  }
  const SramLaw law = own_tables([] { return SramLaw(PIPEGS_SOURCE_DIR "/synth/data/sram.csv"); });
  std::vector<SiliconPoint> design_points;
  std::vector<Enables> enables;  // of each, where energy is asked for
  for (const SimulateOptions& one : options) {
    const std::string name = config_difference(one.config), design_point = design_point_name(one.config);
    const Synth synth = synth_of(arguments, one.config);
    if (!arguments.no_energy)
      enables.push_back(read_enables(synth_folder(arguments, one.config) / "enables.json", one.config));
    design_points.push_back({design_point.empty() ? name : design_point, synth, silicon_rows(one.config, synth, law)});
  }
  for (size_t i = 0; i < design_points.size(); ++i) {
    const Config& config = options[i].config;
    {
      const Progress stage("timing model of " + design_points[i].name);
      const CycleEngine engine = model_engine(loaded.scene, loaded.camera, options[i]);
      design_points[i].cycles = engine(config, options[i].memory).cycles;
    }
    if (arguments.no_energy) continue;
    const Progress stage("what switches in " + design_points[i].name);
    const FrameActivity activity =
        frame_activity(loaded, options[i], enables[i], design_points[i].cycles, arguments.keep);
    design_points[i].cycles = activity.cycles;
    design_points[i].energy = energy_rows(config, design_points[i].synth, enables[i], law, activity);
    design_points[i].clocks = module_clocks(design_points[i].synth, enables[i], activity);
  }
  const std::vector<Chart> charts = silicon_charts(design_points);
  const std::vector<Table> tables = silicon_tables(design_points);
  NamedMachines machines;
  for (size_t i = 0; i < design_points.size(); ++i) machines.emplace_back(design_points[i].name, options[i].config);
  nlohmann::ordered_json json = {
      {"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"memory", arguments.memory.external.dram}};
  json.update(to_json(design_points));
  arguments.output.write({.title = "Area, clock and energy in 28 nm",
                          .head = head_of(loaded, arguments.memory),
                          .charts = charts,
                          .tables = tables,
                          .machines = machines,
                          .note = "Energy is not validated: nothing here was held against silicon or a layout.",
                          .odd = loaded.told->all()},
                         json);
  return kExitOk;
}

}  // namespace

void add_silicon(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "silicon", "area, clock and energy of a view in 28 nm",
                  footer("pipegs silicon garden.ply --cameras cameras.json --designs dop,exact --out silicon --page",
                         "measured, every bit of the RTL agrees", "a bit differs or the RTL stops",
                         "Needs what `make synth` writes for each configuration. Energy needs a run of the RTL, which "
                         "is kept: each frame "
                         "is measured\n"
                         "once. Ranges are what 28 nm may be: docs/silicon/silicon.md, docs/silicon/energy.md."));
  static SiliconArguments arguments;
  arguments.view.add(command, DesignPoints::kOneOrSeveral);
  arguments.memory.add(command);
  add_text(command, "--library", arguments.library, "library whose gates were counted").shows_default();
  add_text(command, "--synth", arguments.folder, "folder that `make synth` has written to");
  add_text(command, "--store", arguments.keep, "folder of what was measured and is not measured again");
  add_flag(command, "--no-energy", arguments.no_energy, "area and clock only, without the RTL");
  arguments.output.add(command);
  when_chosen(command, run, [] { return silicon(arguments); });
}

}  // namespace pipegs
