// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs terms`: the ladder in the paper's own terms instead of the RTL's.
#include "sim/command/command.hpp"

#include <fmt/format.h>

#include "sim/progress.hpp"
#include "sim/studies/terms/report.hpp"

namespace pipegs {
namespace {

struct TermsArguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false;
};

int terms(const TermsArguments& arguments) {
  const ViewArguments& view = arguments.view;
  const MemoryArguments& memory = arguments.memory;
  const SimulateOptions options = view.options();
  if (options.window) throw ConfigError("--window: terms counts the whole view, expected none");
  if (memory.external.dram == "ideal") throw ConfigError("--memory: found ideal, terms expects a DRAM");
  const LoadedView loaded = load_view(view);
  check_picture_memory(loaded.camera, options, kCountPixels);
  Progress progress("counting");
  CountOptions counted{.near_plane = view.near_plane, .grids = {4, 8}};
  counted.progress = [&](double share) { progress.update(share); };
  const TermsView work = terms_view(count_frame(loaded.scene, loaded.camera, counted));
  const TermsReport report = terms_report(work, memory_rates(work, memory.external.dram, 1.0));
  if (arguments.json) {
    nlohmann::ordered_json all = {{"scene", loaded.scene.name}, {"camera", loaded.camera.name}};
    all.update(terms_json(report));
    fmt::print("{}\n", all.dump(2));
  } else {
    fmt::print("{}: {} Gaussians; view {} ({}x{}); the paper's ladder by counts of the view\n\n{}", loaded.scene.name,
               loaded.scene.gaussians.size(), loaded.camera.name, loaded.camera.width, loaded.camera.height,
               terms_text(report));
  }
  return kExitOk;
}

}  // namespace

void add_terms(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("terms", "the paper's ladder by counts of a view, in the paper's own terms");
  command->footer(footer("pipegs terms garden.ply --cameras cameras.json", "counted"));
  static TermsArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return terms(arguments); }; });
}

}  // namespace pipegs
