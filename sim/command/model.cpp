// SPDX-License-Identifier: Apache-2.0
// model.cpp: `pipegs model`: the cycles of one view by the timing model, design point by design point, and against the
// RTL.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"
#include "sim/report/report.hpp"
#include "sim/timing/timing_check.hpp"

namespace pipegs {
namespace {

struct ModelArguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false, check = false, windows = false;
};

struct ModelRow {
  std::string name;
  double trace_seconds = 0, seconds = 0;  // of all threads' wall, of one core
  size_t visible = 0;                     // (Gaussian, window) pairs that pu_cull keeps
  TimingResult result;
  RtlTiming rtl;
  std::vector<std::string> differences;     // of --check
  std::optional<TimingDifference> parting;  // where RTL and model part

  double error() const { return static_cast<double>(result.cycles) / static_cast<double>(rtl.cycles) - 1; }
  double mega_cycles() const { return static_cast<double>(result.cycles) / seconds * 1e-6; }
  double rtl_khz() const { return static_cast<double>(rtl.cycles) / rtl.seconds * 1e-3; }
  double speed() const { return 1e3 * mega_cycles() / rtl_khz(); }
};

ModelRow model_row(const LoadedView& loaded, const SimulateOptions& options, bool check) {
  ModelRow row{.name = machine_name(options.config)};
  Simulation simulation;
  simulate_pack(loaded.scene, loaded.camera, options, simulation);
  const Progress stage("timing model of " + row.name);
  const Stopwatch watch;
  const TimingTrace trace = timing_trace(simulation.input);
  row.trace_seconds = watch.seconds();
  row.visible = trace.slot.size();
  const double before = thread_seconds();
  row.result = timing_run(trace, options.config, options.memory);
  row.seconds = thread_seconds() - before;
  if (!check) return row;
  const Progress checked("RTL of " + row.name);
  row.rtl = rtl_timing(simulation.input, options.config, options.memory, options.rtl.seed);
  row.differences = timing_differences(row.result, row.rtl);
  if (row.differences.empty() || options.config.taps == 0) return row;
  Lockstep lockstep(trace, options.config, options.memory);
  rtl_timing(simulation.input, options.config, options.memory, options.rtl.seed, &lockstep);
  row.parting = lockstep.first();
  return row;
}

nlohmann::ordered_json to_json(const ModelRow& row, bool check, bool windows) {
  nlohmann::ordered_json json = {{"name", row.name},
                                 {"cycles", row.result.cycles},
                                 {"visible", row.visible},
                                 {"overflow_lines", row.result.overflow_lines},
                                 {"seconds", {{"trace", row.trace_seconds}, {"model", row.seconds}}},
                                 {"model_mhz", row.mega_cycles()}};
  json["bytes"] = traffic_json(row.result.streams)["by_stream"];
  if (windows) json["window_ends"] = row.result.window_ends;
  if (!check) return json;
  json["rtl"] = {{"cycles", row.rtl.cycles}, {"overflow_lines", row.rtl.overflow_lines}, {"khz", row.rtl_khz()}};
  if (windows) json["rtl"]["window_ends"] = row.rtl.window_ends;
  json["speed_ratio"] = row.speed();
  json["differences"] = row.differences;
  json["first_difference"] = nullptr;
  if (row.parting) {
    json["first_difference"] = {{"cycle", row.parting->cycle},
                                {"unit", row.parting->unit},
                                {"rtl", row.parting->rtl},
                                {"model", row.parting->model}};
  }
  return json;
}

std::string to_text(const ModelRow& row, bool check) {
  std::string text = fmt::format("  {:<13}{:>12}{:>9.2f}{:>9.3f}{:>9.1f}", row.name, row.result.cycles,
                                 row.trace_seconds, row.seconds, row.mega_cycles());
  if (!check) return text + "\n";
  text += fmt::format("{:>12}{:>9.0f}{:>+10.3f} %{:>8.0f}{:>9}\n", row.rtl.cycles, row.rtl_khz(), 100 * row.error(),
                      row.speed(), row.differences.empty() ? "exact" : "differs");
  for (const std::string& line : row.differences) text += fmt::format("    {}\n", line);
  if (row.parting) text += fmt::format("    they part in {}\n", row.parting->text());
  return text;
}

int model(const ModelArguments& arguments) {
  std::vector<SimulateOptions> options = arguments.view.each();
  const LoadedView loaded = load_view(arguments.view);
  for (SimulateOptions& one : options) {
    follow_scene(loaded, one);
    if (arguments.check) check_picture_memory(loaded.camera, one, kRtlPixels);
  }
  if (!arguments.json) {
    fmt::print("{}\n\n  {:<13}{:>12}{:>9}{:>9}{:>9}{}\n", head_of(loaded, arguments.memory), "design point", "model",
               "trace s", "model s", "Mcycle/s",
               arguments.check ? fmt::format("{:>12}{:>9}{:>12}{:>8}", "RTL", "kHz", "error", "speed") : "");
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  bool differs = false;
  for (SimulateOptions& one : options) {
    arguments.memory.apply(one);
    const ModelRow row = model_row(loaded, one, arguments.check);
    differs = differs || !row.differences.empty();
    if (arguments.json) {
      list.push_back(to_json(row, arguments.check, arguments.windows));
    } else {
      fmt::print("{}", to_text(row, arguments.check));
      std::fflush(stdout);
    }
  }
  if (arguments.json)
    fmt::print("{}\n",
               nlohmann::ordered_json{
                   {"scene", loaded.scene.name},
                   {"camera", loaded.camera.name},
                   {"gaussians", loaded.scene.gaussians.size()},
                   {"host", {{"cpu_seconds", process_seconds()}, {"peak_memory_bytes", peak_memory_bytes()}}},
                   {"designs", list}}
                   .dump(2));
  return differs ? kExitDiffers : kExitOk;
}

}  // namespace

void add_model(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "model", "cycles of a view by the timing model, no pixels",
      footer("pipegs model garden.ply --cameras cameras.json --view 0 --designs late,exact --check",
             "counted (--check: cycles of frame and windows and bytes of each stream equal the RTL's)",
             "--check: one of them differs, or the RTL stops",
             "--check compares cycles of the frame and of each window, and bytes of each stream: exact, or it differs, "
             "and the cycle\nand unit in which RTL and model part are named.\n"
             "Seconds of the model and kHz of the RTL (no pixel compared) are of one core; speed is their ratio."));
  static ModelArguments arguments;
  arguments.view.add(command, DesignPoints::kOneOrSeveral);
  arguments.memory.add(command);
  add_flag(command, "--check", arguments.check, "run the RTL, too, and compare cycles and bytes");
  add_flag(command, "--windows", arguments.windows, "with --json: when the end of each window leaves the merge");
  add_flag(command, "--json", arguments.json, "print JSON instead of the table");
  when_chosen(command, run, [] { return model(arguments); });
}

}  // namespace pipegs
