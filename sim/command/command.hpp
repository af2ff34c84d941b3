// command.hpp: the subcommands of `pipegs`. Each adds its options to the parser and runs when it was chosen.
//
// Exit codes: 0 all is well, 1 the RTL differs from the golden model (or hangs), 2 bad input; 130 interrupted.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/scene.hpp"
#include "sim/chart.hpp"
#include "sim/rung.hpp"
#include "sim/simulate.hpp"

namespace pipegs {

inline constexpr int kExitOk = 0, kExitMismatch = 1, kExitBadInput = 2, kExitInterrupted = 130;

// A subcommand that was chosen sets `run`.
using Run = std::function<int()>;

// Which rungs of the ladder a subcommand runs: --rung, --rungs (all of them without it), or either.
enum class Rungs { kOne, kSeveral, kOneOrSeveral };

// What every subcommand that renders a view takes.
struct ViewArguments {
  std::string scene, cameras, rung, config;
  int view = 0;
  std::vector<int> window;
  std::vector<std::string> settings, rungs;
  double near_plane = 0.2;

  void add(CLI::App& app, Rungs which = Rungs::kOne);
  // The configuration is the rung, then the lines of --config, then the settings. Throws ConfigError.
  SimulateOptions options() const;
  // The same on another rung; the settings must leave alone what makes a rung.
  SimulateOptions options(const Rung& rung) const;
  std::vector<SimulateOptions> each() const;  // of --rungs, or the one of --rung
};

// External memory and seed, for the subcommands that run the RTL.
struct MemoryArguments {
  ExternalMemoryOptions external;
  uint64_t seed = 1;

  void add(CLI::App& app, bool with_bandwidth = true);
  void apply(SimulateOptions& options) const;
};

// The scene and camera that the arguments name; our own without a scene. Throws InputError.
struct LoadedView {
  Scene scene;
  Camera camera;
};
LoadedView load_view(const ViewArguments& arguments);

// Switches on what the scene cannot do without: the compensation of an antialiased one.
void follow_scene(const Scene& scene, SimulateOptions& options);

// Writes frame.exr and frame.png; nothing is left half-written.
void write_images(const std::string& folder, const Image& image);
void write_text(const std::string& path, const std::string& text);
void write_charts(const std::string& path, const std::vector<Chart>& charts);  // nothing without a path

void add_info(CLI::App& app, Run& run);
void add_sim(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_explain(CLI::App& app, Run& run);
void add_ladder(CLI::App& app, Run& run);
void add_profile(CLI::App& app, Run& run);
void add_timeline(CLI::App& app, Run& run);
void add_sweep(CLI::App& app, Run& run);
void add_dram(CLI::App& app, Run& run);
void add_model(CLI::App& app, Run& run);
void add_accuracy(CLI::App& app, Run& run);
void add_fidelity(CLI::App& app, Run& run);
void add_stress(CLI::App& app, Run& run);
void add_budget(CLI::App& app, Run& run);
void add_effects(CLI::App& app, Run& run);
void add_silicon(CLI::App& app, Run& run);

}  // namespace pipegs
