// command_model.cpp: `pipegs model`: the cycles of one view by the timing model, and against the RTL.
#include <ctime>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cpp_model/frame_setup.hpp"
#include "sim/command.hpp"
#include "sim/progress.hpp"
#include "sim/timing_check.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  MemoryArguments memory;
  bool json = false, check = false, every_cycle = false, windows = false;
};

// Seconds that this thread has computed: other work on the machine does not count.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

nlohmann::ordered_json units_json(const std::vector<UnitCycles>& units) {
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const UnitCycles& unit : units) result.push_back({{"busy", unit.busy}, {"starved", unit.starved}, {"blocked", unit.blocked}, {"memory", unit.memory}});
  return result;
}

std::string units_text(const char* name, const std::vector<UnitCycles>& units, uint64_t cycles) {
  UnitCycles sum;
  for (const UnitCycles& unit : units) sum.busy += unit.busy, sum.starved += unit.starved, sum.blocked += unit.blocked, sum.memory += unit.memory;
  const double all = static_cast<double>(cycles) * static_cast<double>(units.size()) / 100;
  return fmt::format("  {:<5} busy {:5.1f} %  starved {:5.1f} %  blocked {:5.1f} %  memory {:5.1f} %\n", name, static_cast<double>(sum.busy) / all,
                     static_cast<double>(sum.starved) / all, static_cast<double>(sum.blocked) / all, static_cast<double>(sum.memory) / all);
}

int model(const Arguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  const LoadedView loaded = load_view(arguments.view);
  Simulation simulation;
  simulate_pack(loaded.scene, loaded.camera, options, simulation);

  const Stopwatch trace_watch;
  const TimingTrace trace = timing_trace(simulation.input);
  const double trace_seconds = trace_watch.seconds();
  const Stopwatch watch;
  const double before = thread_seconds();
  const TimingResult result = timing_run(trace, options.config, options.memory, {.every_cycle = arguments.every_cycle});
  const double cpu_seconds = thread_seconds() - before, seconds = watch.seconds();
  const double cycles = static_cast<double>(result.cycles);

  nlohmann::ordered_json report = {{"config", config_difference(options.config)},
                                   {"memory", {{"dram", options.memory.dram}, {"latency", options.memory.latency}, {"bytes_per_cycle", options.memory.bytes_per_cycle}, {"jitter", options.memory.jitter}, {"seed", options.memory.seed}}},
                                   {"cycles", result.cycles},
                                   {"overflow_lines", result.overflow_lines},
                                   {"wall_seconds", {{"trace", trace_seconds}, {"model", seconds}, {"model_cpu", cpu_seconds}}},
                                   {"model_mhz", cycles / cpu_seconds * 1e-6},
                                   {"units", {{"dopu", units_json(result.dopu)}, {"pu", units_json(result.pu)}, {"su", units_json(result.su)}, {"ru", units_json(result.ru)}}}};
  for (const TimingResult::Stream& stream : result.streams) report["bytes"][stream.name] = {{"read", stream.bytes_read}, {"written", stream.bytes_written}};
  if (arguments.windows) report["window_ends"] = result.window_ends;
  std::string text = fmt::format("timing model, {}: {} cycles; trace {:.2f} s, model {:.3f} s of one core: {:.1f} M cycles/s\n",
                                 config_difference(options.config), result.cycles, trace_seconds, cpu_seconds, cycles / cpu_seconds * 1e-6);
  text += units_text("dopu", result.dopu, result.cycles) + units_text("pu", result.pu, result.cycles) + units_text("su", result.su, result.cycles) +
          units_text("ru", result.ru, result.cycles);
  for (const TimingResult::Stream& stream : result.streams) {
    text += fmt::format("  {:<22} read {:8.2f} MB  written {:8.2f} MB\n", stream.name, static_cast<double>(stream.bytes_read) * 1e-6, static_cast<double>(stream.bytes_written) * 1e-6);
  }

  if (arguments.check) {
    const RtlTiming rtl = rtl_timing(simulation.input, options.config, options.memory, options.rtl.seed);
    const TimingErrors errors = timing_errors(result, rtl);
    const double rtl_speed = static_cast<double>(rtl.rtl.cycles) / rtl.wall, model_speed = cycles / seconds;
    report["rtl"] = {{"cycles", rtl.rtl.cycles}, {"overflow_lines", rtl.rtl.overflow_lines}, {"wall_seconds", rtl.wall}, {"khz", rtl_speed * 1e-3},
                     {"units", {{"dopu", units_json(rtl.rtl.dopu)}, {"pu", units_json(rtl.rtl.pu)}, {"su", units_json(rtl.rtl.su)}, {"ru", units_json(rtl.rtl.ru)}}}};
    if (arguments.windows) report["rtl"]["window_ends"] = rtl.window_ends;
    report["error"] = {{"frame", errors.frame}, {"worst_window", errors.worst_window}, {"windows", errors.windows}};
    report["speed_ratio"] = model_speed / rtl_speed;
    text += fmt::format("RTL: {} cycles at {:.0f} kHz\n", rtl.rtl.cycles, rtl_speed * 1e-3);
    text += units_text("dopu", rtl.rtl.dopu, rtl.rtl.cycles) + units_text("pu", rtl.rtl.pu, rtl.rtl.cycles) + units_text("su", rtl.rtl.su, rtl.rtl.cycles) +
            units_text("ru", rtl.rtl.ru, rtl.rtl.cycles);
    text += fmt::format("error: frame {:+.4f} %, worst of {} windows above {} cycles {:+.4f} %; {:.0f} times the RTL's speed\n", 100 * errors.frame, errors.windows,
                        kWindowCycles, 100 * errors.worst_window, model_speed / rtl_speed);
  }
  fmt::print("{}", arguments.json ? report.dump(2) + "\n" : text);
  return kExitOk;
}

}  // namespace

void add_model(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("model", "cycles of one view by the timing model, without pixels; with --check also by the RTL");
  command->footer("Example: pipegs model garden.ply --cameras cameras.json --view 0 --set units=2 --check");
  static Arguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  command->add_flag("--check", arguments.check, "run the RTL, too, and compare cycles");
  command->add_flag("--windows", arguments.windows, "with --json: when the end of each window leaves the merge");
  command->add_flag("--every-cycle", arguments.every_cycle, "step every unit in every cycle: slow, must change nothing");
  command->add_flag("--json", arguments.json, "print JSON instead of the table");
  command->callback([&run] { run = [] { return model(arguments); }; });
}

}  // namespace pipegs
