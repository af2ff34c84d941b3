// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs shapes`: time and area of a machine by its shape, at equal pixels; the front, and the best
// within an area.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/command/page/page_argument.hpp"
#include "sim/studies/accuracy/report.hpp"
#include "sim/studies/shapes/measure.hpp"
#include "sim/studies/shapes/report.hpp"
#include "sim/silicon/published.hpp"

namespace pipegs {
namespace {

struct ShapesArguments {
  ViewArguments view;
  MemoryArguments memory;
  ShapeOptions shapes = {.mm2 = kPipegsTable2.back().area_mm2};
  std::string keep = PIPEGS_BUILD_DIR "/shapes";
  PageArgument page;
  bool json = false;
};

int run_shapes(const ShapesArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: shapes have windows of several sizes, expected the whole frame");
  arguments.memory.apply(options);
  const FrameModel silicon = read_frame_model();
  arguments.page.check();
  try_folder("--keep", arguments.keep);
  check_shapes(options.config, silicon);
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  const MeasurementStore store(arguments.keep, loaded.scene, loaded.camera, options, {{"study", "shapes"}});
  const std::vector<Shape> shapes = sweep_shapes(
      options.config, silicon, measure_shapes(loaded.scene, loaded.camera, options, store), arguments.shapes);
  const double mm2 = arguments.shapes.mm2;
  const std::string title = fmt::format("{}: view {} ({}x{})", loaded.scene.name, loaded.camera.name,
                                        loaded.camera.width, loaded.camera.height);
  const Chart chart = shapes_chart(title, shapes);
  const std::vector<Table> tables = shapes_tables(shapes, mm2);
  const std::string head =
      fmt::format("{}, memory {}, base {}", title, arguments.memory.external.dram, config_difference(options.config));
  NamedMachines machines;
  for (const Shape& shape : shapes) machines.emplace_back(difference(shape.config, options.config), shape.config);
  arguments.page.write({.title = "Time and area by the machine's shape",
                        .head = head,
                        .charts = {chart},
                        .tables = tables,
                        .machines = machines});
  if (arguments.json) {
    nlohmann::ordered_json json = {
        {"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"memory", arguments.memory.external.dram}};
    json.update(shapes_json(shapes, mm2));
    json["charts"] = charts_json({chart});
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}\n\n{}", head, tables_text(tables));
  }
  return kExitOk;
}

}  // namespace

void add_shapes(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("shapes", "time and area by the machine's shape at equal pixels, and the best within an area");
  command->footer(footer("pipegs shapes garden.ply --cameras cameras.json --area 3.283 --page shapes.html", "measured",
                         "",
                         "Cycles are the timing model's, areas and clocks are interpolated between synthesised "
                         "machines. What was measured is kept\nand not measured again."));
  static ShapesArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  add_real(*command, "--area", arguments.shapes.mm2, "the wanted area, mm2 in 28 nm", {.low = 0.1, .high = 100})
      ->capture_default_str();
  add_integer(*command, "--runs", arguments.shapes.runs, "most shapes that are measured", 1, 10000)
      ->capture_default_str();
  command->add_option("--keep", arguments.keep, "folder for what was measured");
  arguments.page.add(*command);
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return run_shapes(arguments); }; });
}

}  // namespace pipegs
