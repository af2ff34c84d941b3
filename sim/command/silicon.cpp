// silicon.cpp: `pipegs silicon`: area, clock and energy in 28 nm unit by unit, beside the paper's Table 2 and GSCore's; frames per mm2 and joule.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/cycle_engine.hpp"
#include "sim/measurement_store.hpp"
#include "sim/silicon/frame_model.hpp"
#include "sim/silicon/report.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string library = "osu018", folder = PIPEGS_BUILD_DIR "/synth", keep = PIPEGS_BUILD_DIR "/silicon", table, svg;
  bool json = false, no_energy = false;
};

// What was kept of this frame, or a run of the RTL.
FrameActivity frame_activity(const LoadedView& loaded, const SimulateOptions& options, uint64_t cycles, const std::string& folder) {
  const MeasurementStore store(folder, loaded.scene, loaded.camera, options,
                               {{"rtl", hash_of_files(PIPEGS_SOURCE_DIR "/rtl", ".sv")}, {"samples", {kSamples, kSampleCycles}}});
  if (const auto kept = store.load(options.config)) {
    try {
      return frame_activity_from_json(*kept);
    } catch (const nlohmann::json::exception&) {  // as good as none
    }
  }
  const FrameActivity activity = measure_activity(loaded.scene, loaded.camera, options, cycles, folder);
  store.save(options.config, to_json(activity));
  return activity;
}

// Into the table in place of what it holds of the same scene and configuration.
void keep_frame(const std::string& table, const MeasuredFrame& frame) {
  std::vector<MeasuredFrame> frames = std::filesystem::exists(table) ? read_frames(table) : std::vector<MeasuredFrame>{};
  std::erase_if(frames, [&](const MeasuredFrame& old) { return old.scene == frame.scene && old.config == frame.config; });
  frames.push_back(frame);
  write_text(table, frames_csv(frames));
}

int silicon(const Arguments& arguments) {
  std::vector<SimulateOptions> options = arguments.view.each();
  const LoadedView loaded = load_view(arguments.view);
  for (SimulateOptions& one : options) {
    arguments.memory.apply(one);
    follow_scene(loaded.scene, one);
  }
  const SramLaw law(PIPEGS_SOURCE_DIR "/synth/sram.csv");
  std::vector<SiliconRung> rungs;
  for (const SimulateOptions& one : options) {
    const std::string name = config_difference(one.config), rung = rung_name(one.config);
    const Synth synth = read_synth(std::filesystem::path(arguments.folder) / name / arguments.library / "synth.json", one.config);
    rungs.push_back({rung.empty() ? name : rung, synth, silicon_rows(one.config, synth, law)});
  }
  for (size_t i = 0; i < rungs.size(); ++i) {
    const Config& config = options[i].config;
    rungs[i].cycles = model_engine(loaded.scene, loaded.camera, options[i])(config, options[i].memory).cycles;
    if (arguments.no_energy) continue;
    const FrameActivity activity = frame_activity(loaded, options[i], rungs[i].cycles, arguments.keep);
    rungs[i].cycles = activity.cycles;
    rungs[i].energy = energy_rows(config, rungs[i].synth, law, activity);
    if (!arguments.table.empty()) keep_frame(arguments.table, measured_frame(loaded.scene.name, config, activity, rungs[i].rows, rungs[i].energy));
  }
  write_charts(arguments.svg, silicon_charts(rungs));
  if (arguments.json) {
    nlohmann::ordered_json json = {{"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"memory", arguments.memory.external.dram}};
    json.update(to_json(rungs));
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: view {} ({}x{}), memory {}\n\n{}", loaded.scene.name, loaded.camera.name, loaded.camera.width, loaded.camera.height,
               arguments.memory.external.dram, to_text(rungs));
  }
  return kExitOk;
}

}  // namespace

void add_silicon(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("silicon", "area, clock and energy in 28 nm, beside the paper's Table 2; frames per mm2 and joule");
  command->footer("Example: pipegs silicon garden.ply --cameras cameras.json --rungs dop,exact --svg silicon.svg\n"
                  "Needs what `make synth` writes for each configuration. Energy needs a run of the RTL, which is kept: each frame is measured\n"
                  "once. Ranges are what 28 nm may be: docs/silicon.md, docs/energy.md.");
  static Arguments arguments;
  arguments.view.add(*command, Rungs::kOneOrSeveral);
  arguments.memory.add(*command);
  command->add_option("--library", arguments.library, "library whose gates were counted")->capture_default_str();
  command->add_option("--synth", arguments.folder, "folder that `make synth` has written to");
  command->add_option("--keep", arguments.keep, "folder for what switched in the frames that were measured");
  command->add_option("--table", arguments.table, "add the frames' energies to this table; `pipegs accuracy` interpolates between those of synth/energy.csv");
  command->add_flag("--no-energy", arguments.no_energy, "area and clock only, without the RTL");
  command->add_option("--svg", arguments.svg, "charts");
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return silicon(arguments); }; });
}

}  // namespace pipegs
