// sim.cpp: `pipegs sim`: golden model, truth and RTL of one view, compared bit for bit.
#include <fmt/format.h>

#include <sstream>

#include "sim/command/command.hpp"
#include "sim/effects/run.hpp"
#include "sim/report.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string out = "out", waves;
  std::string effects = "all";
  bool netlist = false, json = false, no_truth = false, no_rtl = false;
};

// The command that replays the window of the first mismatch with waves.
std::string replay(const Arguments& arguments, const Mismatch& mismatch) {
  std::string command = "build/pipegs sim";
  if (!arguments.view.scene.empty()) command += fmt::format(" '{}'", arguments.view.scene);
  if (!arguments.view.cameras.empty()) command += fmt::format(" --cameras '{}'", arguments.view.cameras);
  command += fmt::format(" --view {} --window {},{} --seed {} --memory {} --latency {} --bandwidth {} --jitter {} --no-truth --waves window.fst",
                         arguments.view.view, mismatch.window_x, mismatch.window_y, arguments.memory.seed, arguments.memory.external.dram, arguments.memory.external.latency,
                         arguments.memory.external.bytes_per_cycle, arguments.memory.external.jitter);
  if (!arguments.view.rung.empty()) command += " --rung " + arguments.view.rung;
  for (const std::string& setting : arguments.view.settings) command += " --set " + setting;
  return command;
}

// What --effects asks for without a look at the view.
EffectPlan named_effects(const Arguments& arguments, const SimulateOptions& options) {
  if (arguments.effects == "all" || arguments.effects == "auto") return {options, {"all"}, {}};
  std::vector<std::string> names;
  std::istringstream list(arguments.effects);
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  return plan_effects(options, names);
}

int simulate(const Arguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  options.rtl.waves = arguments.waves;
  options.variant.netlist = arguments.netlist;
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  EffectPlan plan = named_effects(arguments, options);

  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  if (!arguments.no_truth) simulate_truth(loaded.scene, loaded.camera, options, simulation);
  if (arguments.effects == "auto") plan = plan_effects(options, find_effects(effect_facts(loaded.scene, options, simulation, false)));
  std::string wrong;
  if (!arguments.no_rtl) wrong = simulate_effects(loaded.scene, loaded.camera, options, plan, simulation);

  auto report = report_json(loaded.scene, loaded.camera, wrong.empty() ? plan.options : options, simulation);
  report["effects"] = {{"simulated", plan.simulated}, {"left_out", plan.left_out}};
  write_images(arguments.out, crop_window(simulation.golden.image, options));
  write_text(arguments.out + "/report.json", report.dump(2) + "\n");
  if (arguments.json) {
    fmt::print("{}\n", report.dump(2));
  } else {
    fmt::print("{}  picture {}/frame.png, {}/frame.exr; figures {}/report.json\n", report_text(report), arguments.out, arguments.out, arguments.out);
  }
  if (!wrong.empty()) fmt::print(stderr, "pipegs: {}\n", wrong);
  if (simulation.mismatches == 0) return wrong.empty() ? kExitOk : kExitMismatch;
  fmt::print(stderr, "first mismatch, window {},{}: {}\nreplay with waves: {}\n", simulation.first_mismatch->window_x,
             simulation.first_mismatch->window_y, simulation.first_mismatch->what, replay(arguments, *simulation.first_mismatch));
  return kExitMismatch;
}

}  // namespace

void add_sim(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("sim", "one view through golden model, truth and RTL, every bit compared");
  command->footer("Example: pipegs sim garden.ply --cameras cameras.json --view 0 --set units=2 --out garden\n"
                  "Exit code 0 only when every bit agrees, 1 on a mismatch, 2 on bad input.");
  static Arguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_option("--out", arguments.out, "folder for frame.exr, frame.png, report.json")->capture_default_str();
  command->add_option("--waves", arguments.waves, "write waves to this .fst file (use with --window)");
  command->add_option("--effects", arguments.effects, "what to simulate: all; auto, what the view calls for; or names by commas (pipegs effects lists them)")
      ->capture_default_str();
  command->add_flag("--netlist", arguments.netlist, "DOPU, PUs, SUs and RUs as gates (use with --window; builds for many minutes)");
  command->add_flag("--no-truth", arguments.no_truth, "leave out the float64 renders and the PSNR");
  command->add_flag("--no-rtl", arguments.no_rtl, "leave out the RTL: accuracy and work counts only");
  command->add_flag("--json", arguments.json, "print report.json instead of the table");
  command->callback([&run] { run = [] { return simulate(arguments); }; });
}

}  // namespace pipegs
