// timeline.cpp: `pipegs timeline`: what every unit did in every cycle, as a trace for ui.perfetto.dev.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "scenes/atomic_file.hpp"
#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/timeline.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  TimelineOptions timeline;
  int windows = 0;
  std::string out;
};

int timeline(Arguments arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  if (arguments.windows > 0) {
    options.windows = arguments.windows;
    if (!options.window) options.window = {0, 0};
  }
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  const Frame& frame = simulation.input.frame;
  arguments.timeline.columns = frame.last_x - frame.first_x + 1;
  arguments.timeline.first_x = frame.first_x;
  arguments.timeline.first_y = frame.first_y;

  AtomicFile file(arguments.out);
  std::ofstream out(file.temporary(), std::ios::binary);
  Timeline trace(options.config, arguments.timeline, out);
  options.taps = &trace;
  simulate_rtl(options, simulation);
  trace.finish(simulation.rtl);
  out.close();
  if (!out) throw InputError(arguments.out + ": cannot be written");
  file.commit();

  fmt::print("{}: view {}, windows {},{} to {},{}: {} cycles, {} mismatches\n  {} ({:.1f} MB): open it in https://ui.perfetto.dev or chrome://tracing; 1 ns is one cycle\n",
             loaded.scene.name, loaded.camera.name, frame.first_x, frame.first_y, frame.last_x, frame.last_y, simulation.rtl.cycles,
             simulation.mismatches, arguments.out, static_cast<double>(std::filesystem::file_size(arguments.out)) / 1e6);
  if (simulation.mismatches == 0) return kExitOk;
  fmt::print(stderr, "first mismatch: {}\n", simulation.first_mismatch->what);
  return kExitMismatch;
}

}  // namespace

void add_timeline(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("timeline", "a trace of every unit for ui.perfetto.dev: windows, layers, stalls, bandwidth");
  command->footer("Example: pipegs timeline garden.ply --cameras cameras.json --window 3,2 --windows 4 --out garden.json");
  static Arguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_option("--out", arguments.out, "the trace")->required();
  command->add_option("--windows", arguments.windows, "so many windows side by side, from --window or the first")->check(CLI::Range(1, 1024));
  command->add_option("--grain", arguments.timeline.grain, "cycles of a piece of the state tracks")->capture_default_str()->check(CLI::Range(1, 1000000));
  command->add_option("--sample", arguments.timeline.sample, "cycles between two values of a counter")->capture_default_str()->check(CLI::Range(1, 1000000));
  command->callback([&run] { run = [] { return timeline(arguments); }; });
}

}  // namespace pipegs
