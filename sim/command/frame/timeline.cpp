// SPDX-License-Identifier: Apache-2.0
// timeline.cpp: `pipegs timeline`: what every unit did in every cycle, as a trace for ui.perfetto.dev.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "scenes/atomic_file.hpp"
#include "scenes/own_failure.hpp"
#include "sim/command/command.hpp"
#include "sim/report/timeline.hpp"

namespace pipegs {
namespace {

struct TimelineArguments {
  ViewArguments view;
  MemoryArguments memory;
  TimelineOptions timeline;
  int windows = 0;
  std::string out;
};

int timeline(TimelineArguments arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  if (arguments.windows > 0) {
    options.windows = arguments.windows;
    if (!options.window) options.window = {0, 0};
  }
  need_taps(options);
  try_file("--out", arguments.out);
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  check_picture_memory(loaded.camera, options, kGoldenPixels + kRtlPixels);
  Simulation simulation;
  simulate_golden(loaded.scene, loaded.camera, options, simulation);
  const Frame& frame = simulation.input.frame;
  arguments.timeline.columns = frame.raster.windows.last_x - frame.raster.windows.first_x + 1;
  arguments.timeline.first_x = frame.raster.windows.first_x;
  arguments.timeline.first_y = frame.raster.windows.first_y;

  make_folder_of(arguments.out);
  AtomicFile file(arguments.out);
  std::ofstream out(file.temporary(), std::ios::binary);
  Timeline trace(options.config, arguments.timeline, out);
  options.taps = &trace;
  simulate_rtl(options, simulation);
  trace.finish(simulation.rtl);
  out.close();
  if (!out) throw OwnFailure(arguments.out + ": cannot write");
  file.commit();

  fmt::print(
      "{}: view {}, windows {},{} to {},{}: {} cycles, {} mismatches\n  {} ({:.1f} MB): open it in "
      "https://ui.perfetto.dev or chrome://tracing; 1 ns is one cycle\n",
      loaded.scene.name, loaded.camera.name, frame.raster.windows.first_x, frame.raster.windows.first_y,
      frame.raster.windows.last_x, frame.raster.windows.last_y, simulation.rtl.cycles, simulation.mismatches,
      arguments.out, static_cast<double>(std::filesystem::file_size(arguments.out)) / 1e6);
  if (simulation.mismatches == 0) return kExitOk;
  fmt::print(stderr, "first mismatch: {}\n", simulation.first_mismatch->what);
  return kExitDiffers;
}

}  // namespace

void add_timeline(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("timeline", "a trace of every unit for ui.perfetto.dev: windows, layers, stalls, bandwidth");
  command->footer(footer("pipegs timeline garden.ply --cameras cameras.json --window 3,2 --windows 4 --out garden.json",
                         "every bit of the RTL agrees", "a bit differs or the RTL stops"));
  static TimelineArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_option("--out", arguments.out, "the trace")->required();
  add_integer(*command, "--windows", arguments.windows, "so many windows side by side, from --window or the first", 1,
              1024);
  add_integer(*command, "--grain", arguments.timeline.grain, "cycles of a piece of the state tracks", 1, 1000000)
      ->capture_default_str();
  add_integer(*command, "--sample", arguments.timeline.sample, "cycles between two values of a counter", 1, 1000000)
      ->capture_default_str();
  command->callback([&run] { run = [] { return timeline(arguments); }; });
}

}  // namespace pipegs
