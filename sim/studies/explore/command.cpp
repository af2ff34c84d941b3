// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs accuracy`, `pipegs study tradeoff` and `shapes`: three questions to one space, what a view costs
// and how close it is to the truth by the machine's configuration and by how much of it is drawn.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <thread>

#include "scenes/text/quote.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/silicon/published.hpp"
#include "sim/studies/explore/report.hpp"
#include "sim/studies/explore/shapes.hpp"

namespace pipegs {
namespace {

struct ExploreArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string store = PIPEGS_BUILD_DIR "/explore";
  StudyOutput output;

  void add(CLI::App& command) {
    view.add(command);
    memory.add(command);
    command.add_option("--store", store, "folder of what was measured and is not measured again")
        ->capture_default_str();
    output.add(command);
  }
};

// What a question is asked of.
struct Asked {
  const SimulateOptions& options;
  const LoadedView& loaded;
  const View& view;
  const FrameModel& silicon;
  const MeasurePoints& measure;
};

struct Question {
  const CLI::App* command;
  const char* title;
  Measured measured;
  bool areas;  // must be known
  std::function<Answer(const Asked&)> ask;
};

// The view's truths, and a golden frame with a truth in its order on each core.
PixelBytes memory_of(const Question& question) {
  if (question.measured == Measured::kCycles) return {};
  PixelBytes bytes = kTruthPixels;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    bytes = bytes + kGoldenPixels + kImagePixels + kImagePixels;
  return bytes;
}

int explore(const ExploreArguments& arguments, const Question& question) {
  SimulateOptions options = arguments.view.options();
  if (options.window && question.measured != Measured::kErrors)
    throw ConfigError("--window: pictures or windows of other sizes are compared as a whole, expected none");
  arguments.memory.apply(options);
  const FrameModel silicon = read_frame_model();
  if (question.areas) check_shapes(options.config, silicon);
  try_folder("--store", arguments.store);
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded.scene, options);
  check_picture_memory(loaded.camera, options, memory_of(question));
  const Stopwatch watch;
  const View view(loaded.scene, loaded.camera, loaded.cameras, options, question.measured);
  Explorer explorer(view, {arguments.store, loaded.scene, loaded.camera, options}, silicon);
  const Answer answer = question.ask({options, loaded, view, silicon, std::ref(explorer)});

  const std::string head =
      fmt::format("{}: view {} ({}x{}), memory {}, base {}", loaded.scene.name, loaded.camera.name, loaded.camera.width,
                  loaded.camera.height, arguments.memory.external.dram, config_difference(options.config));
  nlohmann::ordered_json json = {{"scene", loaded.scene.name},
                                 {"camera", loaded.camera.name},
                                 {"cameras", loaded.cameras.size()},
                                 {"memory", arguments.memory.external.dram}};
  json.update(answer.json);
  arguments.output.write(
      {.title = question.title,
       .head = head,
       .charts = answer.charts,
       .tables = answer.tables,
       .note = "Points can be copied by a click: the settings go to the clipboard, the rows are marked."},
      json);
  if (!arguments.output.json())
    fmt::print("  {} points measured in {:.0f} s, {} taken from the store\n", explorer.computed, watch.seconds(),
               explorer.resumed);
  return kExitOk;
}

// "60dB" or "60".
double parse_target(const std::string& text) {
  const std::string_view number(text.data(), text.size() - (text.ends_with("dB") ? 2 : 0));
  try {
    return parse_real(number, {.low = 0, .high = 200, .above = true});
  } catch (const NumberError&) {
    throw ConfigError(fmt::format("--target: found {}, expected decibels above 0 up to 200, as 60dB", quote(text)));
  }
}

Table target_table(const std::vector<Point>& points, double target) {
  if (const Point* point = cheapest(points, target))
    return {.notes = {fmt::format("target {:g} dB numeric: {}", target, point_text(*point, points.front().config)),
                      "use it with " + machine_words(point->config)}};
  const std::vector<const Point*> front = accuracy_front(points, costs().front());
  return {.notes = {fmt::format("target {:g} dB numeric: not reached; the most accurate point has {} dB", target,
                                front.empty() ? "no" : decibels(front.back()->figures.numeric.psnr))}};
}

struct AccuracyArguments {
  ExploreArguments common;
  std::vector<std::string> knobs;
  int points = 40;
  std::string target;
};

int accuracy(const AccuracyArguments& arguments, const CLI::App* command) {
  const std::vector<const Knob*> knobs = find_knobs(arguments.knobs);
  const double target = arguments.target.empty() ? 0 : parse_target(arguments.target);
  const auto ask = [&](const Asked& asked) {
    const AccuracySweep sweep =
        accuracy_sweep(asked.measure, asked.options.config,
                       {.knobs = knobs, .points = arguments.points, .window_fixed = asked.options.window.has_value()});
    Answer answer = accuracy_answer(sweep);
    if (target > 0) answer.tables.push_back(target_table(sweep.all(), target));
    return answer;
  };
  return explore(
      arguments.common,
      {.command = command, .title = "What accuracy costs", .measured = Measured::kErrors, .areas = false, .ask = ask});
}

}  // namespace

void add_accuracy(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("accuracy", "what each bit of accuracy costs on a view");
  command->footer(footer(
      "pipegs accuracy garden.ply --cameras cameras.json --view 0 --design exact --target 60dB --out accuracy --page",
      "measured", "", "Accuracy is the golden model's against float64, cycles and bytes are the timing model's."));
  static AccuracyArguments arguments;
  arguments.common.add(*command);
  add_names(*command, "--knobs", arguments.knobs, "which, by commas; without it all");
  add_integer(*command, "--points", arguments.points, "most configurations to measure with knobs turned together", 0,
              1000)
      ->capture_default_str();
  command->add_option("--target", arguments.target,
                      "name the cheapest configuration with so much numeric PSNR, as 60dB");
  command->callback([&run, command] { run = [command] { return accuracy(arguments, command); }; });
}

namespace {

struct TradeoffArguments {
  ExploreArguments common;
  int together = 16;
  double ghz = 1;
};

int run_tradeoff(const TradeoffArguments& arguments, const CLI::App* command) {
  const auto ask = [&](const Asked& asked) {
    return tradeoff_answer(tradeoff(asked.measure, asked.options.config, asked.loaded.scene, arguments.together),
                           asked.view, arguments.ghz);
  };
  return explore(arguments.common, {.command = command,
                                    .title = "What accuracy costs in time",
                                    .measured = Measured::kPicture,
                                    .areas = false,
                                    .ask = ask});
}

}  // namespace

void add_tradeoff(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "tradeoff", "what accuracy costs in time: fewer pixels, Gaussians, SH degrees, other cuts and orders");
  command->footer(footer("pipegs study tradeoff garden.ply --cameras cameras.json --view 0 --out tradeoff --page",
                         "measured", "", "Cycles are those of the timing model."));
  static TradeoffArguments arguments;
  arguments.common.add(*command);
  add_real(*command, "--ghz", arguments.ghz, "clock that turns cycles into time", {.low = 0.1, .high = 10})
      ->capture_default_str();
  add_integer(*command, "--together", arguments.together, "most points with less of several things at once", 0, 1000)
      ->capture_default_str();
  command->callback([&run, command] { run = [command] { return run_tradeoff(arguments, command); }; });
}

namespace {

struct ShapesArguments {
  ExploreArguments common;
  ShapeOptions shapes = {.mm2 = kPipegsTable2.back().area_mm2};
};

int run_shapes(const ShapesArguments& arguments, const CLI::App* command) {
  const auto ask = [&](const Asked& asked) {
    return shapes_answer(sweep_shapes(asked.measure, asked.silicon, asked.options.config, arguments.shapes),
                         arguments.shapes.mm2);
  };
  return explore(arguments.common, {.command = command,
                                    .title = "Time and area by the machine's shape",
                                    .measured = Measured::kCycles,
                                    .areas = true,
                                    .ask = ask});
}

}  // namespace

void add_shapes(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("shapes", "time and area by the machine's shape at equal pixels, and the best within an area");
  command->footer(footer("pipegs study shapes garden.ply --cameras cameras.json --area 3.283 --out shapes --page",
                         "measured", "",
                         "Cycles are the timing model's, areas and clocks are interpolated between synthesised "
                         "machines."));
  static ShapesArguments arguments;
  arguments.common.add(*command);
  add_real(*command, "--area", arguments.shapes.mm2, "the wanted area, mm2 in 28 nm", {.low = 0.1, .high = 100})
      ->capture_default_str();
  add_integer(*command, "--runs", arguments.shapes.runs, "most shapes that are measured", 1, 10000)
      ->capture_default_str();
  command->callback([&run, command] { run = [command] { return run_shapes(arguments, command); }; });
}

}  // namespace pipegs
