// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs accuracy`, `pipegs study tradeoff` and `shapes`: three questions to one space, what a view costs
// and how close it is to the truth by the machine's configuration and by how much of it is drawn.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <thread>

#include "scenes/text/quote.hpp"
#include "sim/command/command.hpp"
#include "sim/command/own_tables.hpp"
#include "sim/command/page/study_output.hpp"
#include "sim/progress.hpp"
#include "sim/silicon/published.hpp"
#include "sim/studies/explore/report.hpp"
#include "sim/studies/explore/shapes.hpp"

namespace pipegs {
namespace {

// What a question is asked of.
struct Asked {
  const SimulateOptions& options;
  const LoadedView& loaded;
  const View& view;
  const FrameModel& silicon;
  const MeasurePoints& measure;
};

struct Question {
  const char *name, *what, *example, *notes;  // of its command
  const char* title;
  Measured measured;
  std::function<void(const Config&, const FrameModel&)> check;  // before a scene is read; throws ConfigError
  std::function<Answer(const Asked&)> ask;
};

struct ExploreArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::string store = PIPEGS_BUILD_DIR "/explore";
  StudyOutput output;
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
  const FrameModel silicon = own_tables(read_frame_model);
  if (question.check) question.check(options.config, silicon);
  try_folder("--store", arguments.store);
  arguments.output.check();
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  check_picture_memory(loaded.camera, options, memory_of(question));
  pack_views(loaded.scene, {loaded.camera}, options);  // says what is left out, even where all points are kept
  const Stopwatch watch;
  const View view(loaded.scene, loaded.camera, loaded.cameras, options, question.measured);
  Explorer explorer(view, {arguments.store, loaded.scene, loaded.camera, options}, silicon);
  const Answer answer = question.ask({options, loaded, view, silicon, std::ref(explorer)});

  const std::string head =
      fmt::format("{}, base {}", head_of(loaded, arguments.memory), config_difference(options.config));
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
       .note = "Points can be copied by a click: the settings go to the clipboard, the rows are marked.",
       .odd = loaded.told->all()},
      json);
  if (!arguments.output.json())
    fmt::print("  {} points measured in {:.0f} s, {} taken from the store\n", explorer.computed, watch.seconds(),
               explorer.resumed);
  return kExitOk;
}

// Its command; the options of the question alone are the caller's to add.
CLI::App& add_question(CLI::App& app, Run& run, const Question& question) {
  CLI::App& command =
      add_command(app, question.name, question.what, footer(question.example, "measured", "", question.notes));
  const auto arguments = std::make_shared<ExploreArguments>();
  arguments->view.add(command);
  arguments->memory.add(command);
  add_text(command, "--store", arguments->store, "folder of what was measured and is not measured again")
      .shows_default();
  arguments->output.add(command);
  when_chosen(command, run, [=] { return explore(*arguments, question); });
  return command;
}

// "60dB" or "60".
double target_of(const std::string& text) {
  const std::string_view number(text.data(), text.size() - (text.ends_with("dB") ? 2 : 0));
  try {
    return parse_real(number, {.low = 0, .high = 200, .above = true});
  } catch (const NumberError&) {
    throw ConfigError(fmt::format("--target: found {}, expected decibels above 0 up to 200, as 60dB", quote(text)));
  }
}

}  // namespace

void add_accuracy(CLI::App& app, Run& run) {
  static std::vector<std::string> knobs;
  static std::string target;
  static int points = 40;
  CLI::App& command = add_question(
      app, run,
      {.name = "accuracy",
       .what = "what each bit of accuracy costs on a view",
       .example = "pipegs accuracy garden.ply --cameras cameras.json --view 0 --design exact --target 60dB "
                  "--out accuracy --page",
       .notes = "Accuracy is the golden model's against float64, cycles and bytes are the timing model's.",
       .title = "What accuracy costs",
       .measured = Measured::kErrors,
       .check =
           [](const Config&, const FrameModel&) {
             find_knobs(knobs);
             if (!target.empty()) target_of(target);
           },
       .ask =
           [](const Asked& asked) {
             const AccuracySweep sweep = accuracy_sweep(
                 asked.measure, asked.options.config,
                 {.knobs = find_knobs(knobs), .points = points, .window_fixed = asked.options.window.has_value()});
             Answer answer = accuracy_answer(sweep);
             if (!target.empty()) answer.tables.push_back(target_table(sweep.all(), target_of(target)));
             return answer;
           }});
  add_names(command, "--knobs", knobs, "which, by commas; without it all");
  add_integer(command, "--points", points, "most configurations to measure with knobs turned together", 0, 1000)
      .shows_default();
  add_text(command, "--target", target, "name the cheapest configuration with so much numeric PSNR, as 60dB");
}

void add_tradeoff(CLI::App& app, Run& run) {
  static int together = 16;
  static double ghz = 1;
  CLI::App& command =
      add_question(app, run,
                   {.name = "tradeoff",
                    .what = "what accuracy costs in time: fewer pixels, Gaussians, SH degrees, other cuts and orders",
                    .example = "pipegs study tradeoff garden.ply --cameras cameras.json --view 0 --out tradeoff --page",
                    .notes = "Cycles are those of the timing model.",
                    .title = "What accuracy costs in time",
                    .measured = Measured::kPicture,
                    .check = {},
                    .ask = [](const Asked& asked) {
                      return tradeoff_answer(
                          tradeoff(asked.measure, asked.options.config, asked.loaded.scene, together), asked.view, ghz);
                    }});
  add_real(command, "--ghz", ghz, "clock that turns cycles into time", {.low = 0.1, .high = 10}).shows_default();
  add_integer(command, "--together", together, "most points with less of several things at once", 0, 1000)
      .shows_default();
}

void add_shapes(CLI::App& app, Run& run) {
  static ShapeOptions shapes{.mm2 = kPipegsTable2.back().area_mm2};
  CLI::App& command = add_question(
      app, run,
      {.name = "shapes",
       .what = "time and area by the machine's shape at equal pixels, and the best within an area",
       .example = "pipegs study shapes garden.ply --cameras cameras.json --area 3.283 --out shapes --page",
       .notes = "Cycles are the timing model's, areas and clocks are interpolated between synthesised machines.",
       .title = "Time and area by the machine's shape",
       .measured = Measured::kCycles,
       .check = check_shapes,
       .ask = [](const Asked& asked) {
         return shapes_answer(sweep_shapes(asked.measure, asked.silicon, asked.options.config, shapes), shapes.mm2);
       }});
  add_real(command, "--area", shapes.mm2, "the wanted area, mm2 in 28 nm", {.low = 0.1, .high = 100}).shows_default();
  add_integer(command, "--runs", shapes.runs, "most shapes that are measured", 1, 10000).shows_default();
}

}  // namespace pipegs
