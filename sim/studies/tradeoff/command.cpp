// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs tradeoff`: what accuracy costs in time, one view with less of everything.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/command/page/page_argument.hpp"
#include "sim/studies/tradeoff/report.hpp"
#include "sim/studies/tradeoff/tradeoff.hpp"

namespace pipegs {
namespace {

struct TradeoffArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string keep = PIPEGS_BUILD_DIR "/tradeoff";
  PageArgument page;
  int together = 16;
  double ghz = 1;
  bool json = false;
};

int run_tradeoff(const TradeoffArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: pictures of other sizes are compared as a whole, expected none");
  arguments.memory.apply(options);
  arguments.page.check();
  try_folder("--keep", arguments.keep);
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  check_picture_memory(loaded.camera, options, kTruthPixels + kGoldenPixels + kImagePixels + kImagePixels);
  const std::vector<TradeoffPoint> points =
      tradeoff({loaded.scene, loaded.camera, loaded.cameras, options, arguments.keep}, arguments.together);
  const std::string title = fmt::format("{}: view {} ({}x{})", loaded.scene.name, loaded.camera.name,
                                        loaded.camera.width, loaded.camera.height);
  const std::vector<Chart> charts = {tradeoff_chart(title, points, arguments.ghz)};
  const std::string head =
      fmt::format("{}, memory {}, {}; contributions of {} cameras", title, arguments.memory.external.dram,
                  config_difference(options.config), loaded.cameras.size());
  arguments.page.write({.title = "What accuracy costs in time",
                        .head = head,
                        .charts = charts,
                        .tables = {to_table(points, arguments.ghz)},
                        .machines = {{machine_name(options.config), options.config}}});
  if (arguments.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"scene", loaded.scene.name},
                                              {"camera", loaded.camera.name},
                                              {"cameras", loaded.cameras.size()},
                                              {"memory", arguments.memory.external.dram},
                                              {"ghz", arguments.ghz},
                                              {"points", to_json(points, arguments.ghz)},
                                              {"price", to_json(price(points, arguments.ghz))},
                                              {"charts", charts_json(charts)}}
                           .dump(2));
  } else {
    fmt::print("{}\n\n{}", head, table_text(to_table(points, arguments.ghz)));
  }
  return kExitOk;
}

}  // namespace

void add_tradeoff(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "tradeoff", "what accuracy costs in time: fewer pixels, Gaussians, SH degrees, other cuts and orders");
  command->footer(footer("pipegs tradeoff garden.ply --cameras cameras.json --view 0 --page tradeoff.html", "measured",
                         "",
                         "Cycles are those of the timing model. What was measured is kept and not measured again."));
  static TradeoffArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  add_real(*command, "--ghz", arguments.ghz, "clock that turns cycles into time", {.low = 0.1, .high = 10})
      ->capture_default_str();
  add_integer(*command, "--together", arguments.together, "most points with less of several things at once", 0, 1000)
      ->capture_default_str();
  command->add_option("--keep", arguments.keep, "folder for what was measured");
  arguments.page.add(*command);
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return run_tradeoff(arguments); }; });
}

}  // namespace pipegs
