// SPDX-License-Identifier: Apache-2.0
// fidelity_command.cpp: `pipegs fidelity`: what truth, golden model, timing model and RTL take for one frame, and get
// right.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "sim/command/command.hpp"
#include "sim/studies/accuracy/fidelity.hpp"

namespace pipegs {
namespace {

struct FidelityArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::vector<int> wave_window;
  bool json = false;
};

int run_fidelity(const FidelityArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  if (options.window)
    throw ConfigError("--window: fidelity compares whole frames; --wave-window chooses the window of the waves");
  arguments.memory.apply(options);
  need_taps(options);
  const LoadedView loaded = load_view(arguments.view);
  check_picture_memory(loaded.camera, options,
                       kGoldenPixels + kGoldenPixels + kImagePixels + kImagePixels + kRtlPixels);
  const int side = options.config.window;
  std::array<int, 2> window = {(loaded.camera.width - 1) / side / 2, (loaded.camera.height - 1) / side / 2};
  if (!arguments.wave_window.empty()) window = {arguments.wave_window.at(0), arguments.wave_window.at(1)};
  const std::string waves = std::filesystem::temp_directory_path() / fmt::format("pipegs_fidelity_{}.fst", getpid());
  const Fidelity result = fidelity(loaded.scene, loaded.camera, options, window, waves);
  if (arguments.json) {
    fmt::print("{}\n", fidelity_json(result).dump(2));
  } else {
    fmt::print("{}: view {} ({}x{}), memory {}, {}\n\n{}", loaded.scene.name, loaded.camera.name, loaded.camera.width,
               loaded.camera.height, arguments.memory.external.dram, config_difference(options.config),
               fidelity_text(result));
  }
  if (result.mismatches > 0) return kExitDiffers;
  return result.complete() ? kExitOk : kExitOwnFailure;
}

}  // namespace

void add_fidelity(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "fidelity", "one frame by truth, golden model, timing model and RTL: what each takes and gets right");
  command->footer(footer("pipegs fidelity garden.ply --cameras cameras.json --view 0 --design exact", "all agree",
                         "RTL and golden model differ in a bit, or RTL and timing model in a cycle or a byte",
                         "A row whose RTL does not build is named, the others run; then the exit code is 3."));
  static FidelityArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  add_place(*command, "--wave-window", arguments.wave_window,
            "window whose waves are written; without it the middle one");
  command->add_flag("--json", arguments.json, "print JSON instead of the table");
  command->callback([&run] { run = [] { return run_fidelity(arguments); }; });
}

}  // namespace pipegs
