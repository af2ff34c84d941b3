// model.cpp: `pipegs model`: the cycles of one view by the timing model, rung by rung, and against the RTL.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/progress.hpp"
#include "sim/timing_check.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false, check = false, windows = false;
};

struct ModelRow {
  std::string name;
  double trace_seconds = 0, seconds = 0;  // of all threads' wall, of one core
  TimingResult result;
  RtlTiming rtl;
  TimingErrors errors;

  double mega_cycles() const { return static_cast<double>(result.cycles) / seconds * 1e-6; }
  double rtl_khz() const { return static_cast<double>(rtl.cycles) / rtl.seconds * 1e-3; }
  double speed() const { return 1e3 * mega_cycles() / rtl_khz(); }
};

// The rung alone, or all that is set.
std::string name(const Config& config) {
  const std::string rung = rung_name(config);
  Config pure;
  if (!rung.empty()) apply_rung(find_rung(rung), pure);
  return pure == config ? rung : config_difference(config);
}

ModelRow model_row(const LoadedView& loaded, const SimulateOptions& options, bool check) {
  ModelRow row{.name = name(options.config)};
  Simulation simulation;
  simulate_pack(loaded.scene, loaded.camera, options, simulation);
  const Stopwatch watch;
  const TimingTrace trace = timing_trace(simulation.input);
  row.trace_seconds = watch.seconds();
  const double before = thread_seconds();
  row.result = timing_run(trace, options.config, options.memory);
  row.seconds = thread_seconds() - before;
  if (!check) return row;
  row.rtl = rtl_timing(simulation.input, options.config, options.memory, options.rtl.seed);
  row.errors = timing_errors(row.result, row.rtl);
  return row;
}

nlohmann::ordered_json to_json(const ModelRow& row, bool check, bool windows) {
  nlohmann::ordered_json json = {{"name", row.name}, {"cycles", row.result.cycles}, {"overflow_lines", row.result.overflow_lines},
                                 {"seconds", {{"trace", row.trace_seconds}, {"model", row.seconds}}}, {"model_mhz", row.mega_cycles()}};
  for (const TimingResult::Stream& stream : row.result.streams) json["bytes"][stream.name] = {{"read", stream.bytes_read}, {"written", stream.bytes_written}};
  if (windows) json["window_ends"] = row.result.window_ends;
  if (!check) return json;
  json["rtl"] = {{"cycles", row.rtl.cycles}, {"overflow_lines", row.rtl.overflow_lines}, {"khz", row.rtl_khz()}};
  if (windows) json["rtl"]["window_ends"] = row.rtl.window_ends;
  json["error"] = {{"frame", row.errors.frame}, {"worst_window", row.errors.worst_window}, {"windows", row.errors.windows}};
  json["speed_ratio"] = row.speed();
  return json;
}

std::string to_text(const ModelRow& row, bool check) {
  std::string text = fmt::format("  {:<10}{:>12}{:>9.2f}{:>9.3f}{:>9.1f}", row.name, row.result.cycles, row.trace_seconds, row.seconds, row.mega_cycles());
  if (!check) return text + "\n";
  const std::string window = row.errors.windows == 0 ? "none" : fmt::format("{:+.3f} %", 100 * row.errors.worst_window);
  return text + fmt::format("{:>12}{:>9.0f}{:>+10.3f} %{:>12}{:>9}{:>8.0f}\n", row.rtl.cycles, row.rtl_khz(), 100 * row.errors.frame, window,
                            row.errors.windows, row.speed());
}

int model(const Arguments& arguments) {
  std::vector<SimulateOptions> options = arguments.view.each();
  const LoadedView loaded = load_view(arguments.view);
  for (SimulateOptions& one : options) follow_scene(loaded.scene, one);
  if (!arguments.json) {
    fmt::print("{}: view {} ({}x{}), memory {}\n\n  {:<10}{:>12}{:>9}{:>9}{:>9}{}\n", loaded.scene.name, loaded.camera.name, loaded.camera.width, loaded.camera.height,
               arguments.memory.external.dram, "rung", "model", "trace s", "model s", "Mcycle/s",
               arguments.check ? fmt::format("{:>12}{:>9}{:>12}{:>12}{:>9}{:>8}", "RTL", "kHz", "error", "window", "windows", "speed") : "");
  }
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (SimulateOptions& one : options) {
    arguments.memory.apply(one);
    const ModelRow row = model_row(loaded, one, arguments.check);
    if (arguments.json) {
      list.push_back(to_json(row, arguments.check, arguments.windows));
    } else {
      fmt::print("{}", to_text(row, arguments.check));
      std::fflush(stdout);
    }
  }
  if (arguments.json) fmt::print("{}\n", nlohmann::ordered_json{{"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"rungs", list}}.dump(2));
  return kExitOk;
}

}  // namespace

void add_model(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("model", "cycles of one view by the timing model, without pixels; with --check also by the RTL");
  command->footer("Example: pipegs model garden.ply --cameras cameras.json --view 0 --rungs late,exact --check\n"
                  "error: cycles of the frame, window: the worst window of 20000 cycles or more; both against the RTL.\n"
                  "Seconds of the model and kHz of the RTL (nothing compared) are of one core; speed is their ratio.");
  static Arguments arguments;
  arguments.view.add(*command, Rungs::kOneOrSeveral);
  arguments.memory.add(*command);
  command->add_flag("--check", arguments.check, "run the RTL, too, and compare cycles");
  command->add_flag("--windows", arguments.windows, "with --json: when the end of each window leaves the merge");
  command->add_flag("--json", arguments.json, "print JSON instead of the table");
  command->callback([&run] { run = [] { return model(arguments); }; });
}

}  // namespace pipegs
