// SPDX-License-Identifier: Apache-2.0
// command.hpp: the subcommands of `pipegs`. Each adds its options to the parser and runs when it was chosen.
//
// Exit codes: 0 agrees or done, 1 differs (what is held against each other is not equal, or the RTL hangs), 2 bad input
// or bad use, 3 our own failure; 130 interrupted. main.cpp says which exception is which.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "scenes/camera.hpp"
#include "scenes/formats/format.hpp"
#include "scenes/scene.hpp"
#include "sim/command/camera_arguments.hpp"
#include "sim/command/machine_arguments.hpp"
#include "sim/command/options.hpp"
#include "sim/command/outputs.hpp"
#include "sim/command/picture_memory.hpp"
#include "sim/compare/simulate.hpp"

namespace pipegs {

inline constexpr int kExitOk = 0, kExitDiffers = 1, kExitBadInput = 2, kExitOwnFailure = 3, kExitInterrupted = 130;

// What stands below a subcommand's options: an example, notes, and what its exit codes 0 and 1 mean (without `differs`
// it compares nothing).
std::string footer(const std::string& example, const std::string& agrees, const std::string& differs = "",
                   const std::string& notes = "");

// Which design points a subcommand runs: --design, --designs (all of them without it), or either; or that of --design
// as a base, and what --set changes of it is the subcommand's to add.
enum class DesignPoints { kOne, kSeveral, kOneOrSeveral, kBase };

// A scene of a file, and how it is read.
struct SceneArguments {
  std::string file;
  ReadOptions read;
  bool strict = false;

  void add(CLI::App& app, const std::string& what =
                              "scene: .ply, .splat, .ksplat, .spz, .sog, meta.json, lod-meta.json, .glb, .gltf; "
                              "without it our own");
  // Our own without a file. Throws InputError. `format` says what the file was, and holds all findings of the scene.
  Scene load(SceneFormat& format) const;
  // A line on stderr for each finding that every command tells. InputError for an error; ConfigError for a warning of
  // --strict.
  void tell(const Findings& findings) const;
};

// What is odd in a scene, its cameras, its views and their frames: told, and kept for reports and pages.
class Told {
 public:
  explicit Told(SceneArguments scene) : scene_(std::move(scene)) {}
  void tell(const Findings& findings);
  // Of frames, from any thread: each kind once, and no frame is said to be empty whose view or scene is.
  void tell_frame(const Findings& findings);
  Findings all() const;

 private:
  const SceneArguments scene_;
  mutable std::mutex mutex_;
  Findings all_;
};

// What every subcommand that renders a view takes.
struct ViewArguments : MachineArguments {
  SceneArguments scene;
  CameraArguments cameras;
  int view = 0;
  std::vector<int> window;
  std::vector<std::string> design_points;
  std::optional<uint64_t> walk_most = {};  // where it is given
  double near_plane = 0.2;
  double rest = 0;        // transmittance, SimulateOptions::rest
  double lod_pixels = 0;  // SimulateOptions::lod_pixels

  void add(CLI::App& app, DesignPoints which = DesignPoints::kOne);
  // ConfigError where a field of a frame is given that no machine has, as all below.
  SimulateOptions options() const;
  // For who has several of one kind or another: without that check, and the check.
  SimulateOptions one_of_several() const;
  void check_fields(const std::vector<SimulateOptions>& machines) const;
  // On other design points; the settings must leave alone what makes one, and with --window their windows must be of
  // one size.
  std::vector<SimulateOptions> options(const std::vector<const DesignPoint*>& several) const;
  std::vector<SimulateOptions> each() const;  // of --designs, or the one of --design
  // The paper's machine, `dop` as it is, and behind it that of --design, --config and --set where it is another one.
  std::vector<SimulateOptions> paper_and_own() const;

 private:
  SimulateOptions on(const DesignPoint& design_point) const;
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
  std::vector<Camera> cameras;  // all of the file or the framing
  std::shared_ptr<Told> told;
};
LoadedView load_view(const ViewArguments& arguments);
// Scene, view and memory, as the first line of what a command prints.
std::string head_of(const LoadedView& loaded, const MemoryArguments& memory);

// Switches on what the scene cannot do without: the compensation of an antialiased one. What is odd in frames is told.
void follow_scene(const LoadedView& loaded, SimulateOptions& options);

// Throws ConfigError when the machine shows no streams, before anything is computed for those who look at them.
void need_taps(const SimulateOptions& options);

void add_info(CLI::App& app, Run& run);
void add_convert(CLI::App& app, Run& run);
void add_pack(CLI::App& app, Run& run);
void add_sim(CLI::App& app, Run& run);
void add_render(CLI::App& app, Run& run);
void add_explain(CLI::App& app, Run& run);
void add_ladder(CLI::App& app, Run& run);
void add_model(CLI::App& app, Run& run);
void add_what_if(CLI::App& app, Run& run);
void add_config(CLI::App& app, Run& run);
void add_effects(CLI::App& app, Run& run);
void add_silicon(CLI::App& app, Run& run);
void add_campaign(CLI::App& app, Run& run);
void add_point(CLI::App& app, Run& run);
void add_report(CLI::App& app, Run& run);
// Those of sim/studies: commands of their own, and those below `study`.
void add_studies(CLI::App& app, CLI::App& study, Run& run);

}  // namespace pipegs
