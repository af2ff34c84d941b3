// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs accuracy`: what accuracy costs, knob by knob and together, on one view.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <thread>

#include "scenes/text/quote.hpp"
#include "sim/studies/accuracy/sweep/page.hpp"
#include "sim/command/command.hpp"
#include "sim/command/page/page_argument.hpp"
#include "scenes/own_failure.hpp"
#include "sim/progress.hpp"
#include "sim/timing/timing_check.hpp"

namespace pipegs {
namespace {

struct AccuracyArguments {
  ViewArguments view;
  MemoryArguments memory;
  std::vector<std::string> knobs;
  int points = 40;
  std::string out = "accuracy", target;
  bool resume = false, json = false, csv = false, rtl = false;
};

// "60dB" or "60".
double parse_target(const std::string& text) {
  const std::string_view number(text.data(), text.size() - (text.ends_with("dB") ? 2 : 0));
  try {
    return parse_real(number, {.low = 0, .high = 200, .above = true});
  } catch (const NumberError&) {
    throw ConfigError(fmt::format("--target: found {}, expected decibels above 0 up to 200, as 60dB", quote(text)));
  }
}

std::string describe(const MeasuredPoint& point, const Config& base) {
  const Accuracy& a = point.figures;
  return fmt::format("{} dB numeric, {} dB order, {} cycles, {:.1f} MB, {:.1f} KB of buffers, {} mm2, {} mJ: {}",
                     decibels(a.numeric.psnr), decibels(a.order.psnr), a.cycles, static_cast<double>(a.bytes) / 1e6,
                     a.buffer_kb(), area_text(point), energy_text(point), difference(point.config, base));
}

// The text on --target; writes target.cfg when it is reached.
std::string answer_target(const AccuracyArguments& arguments, const std::vector<MeasuredPoint>& points, double target) {
  const MeasuredPoint* point = cheapest(points, target);
  if (point == nullptr) {
    const std::vector<const MeasuredPoint*> front = pareto_front(points, Cost::kCycles);
    return fmt::format("target {:g} dB numeric: not reached; the most accurate point has {} dB\n", target,
                       front.empty() ? "no" : decibels(front.back()->figures.numeric.psnr));
  }
  const std::string file = arguments.out + "/target.cfg";
  write_text(file, config_file(point->config, fmt::format("cheapest with {:g} dB numeric PSNR: {}", target,
                                                          describe(*point, Config{}))));
  return fmt::format("target {:g} dB numeric: {}\n  use it with --config {}\n", target,
                     describe(*point, points.front().config), file);
}

// The cheapest points at five levels in RTL: every bit and every cycle. False when one differs.
bool check_in_rtl(const AccuracyView& view, const LoadedView& loaded, const std::vector<MeasuredPoint>& points,
                  nlohmann::ordered_json& json, std::string& text) {
  bool good = true;
  text += fmt::format("\n  {:<6}{:>9}{:>12}{:>12}{:>9}{:>12}{:>12}  configuration\n", "level", "numeric", "model",
                      "RTL", "error", "beats", "mismatches");
  for (const int level : {40, 50, 60, 70, 80}) {
    const MeasuredPoint* point = cheapest(points, level);
    std::string name = fmt::format("{} dB", level);
    if (point == nullptr) {  // the nearest that is reachable
      const std::vector<const MeasuredPoint*> front = pareto_front(points, Cost::kCycles);
      if (front.empty()) continue;
      point = front.back();
      name += "*";
    }
    const SimulateOptions options = view.options(point->config);
    Simulation simulation;
    simulate_golden(loaded.scene, loaded.camera, options, simulation);
    simulate_rtl(options, simulation);
    const double error = static_cast<double>(point->figures.cycles) / static_cast<double>(simulation.rtl.cycles) - 1;
    good = good && simulation.mismatches == 0 && point->figures.cycles == simulation.rtl.cycles;
    text +=
        fmt::format("  {:<6}{:>9}{:>12}{:>12}{:>+8.3f}%{:>12}{:>12}  {}\n", name, decibels(point->figures.numeric.psnr),
                    point->figures.cycles, simulation.rtl.cycles, 100 * error, simulation.beats, simulation.mismatches,
                    difference(point->config, points.front().config));
    json.push_back({{"level_db", level},
                    {"reached", name.back() != '*'},
                    {"configuration", config_difference(point->config)},
                    {"numeric_db", point->figures.numeric.psnr},
                    {"model_cycles", point->figures.cycles},
                    {"rtl_cycles", simulation.rtl.cycles},
                    {"beats", simulation.beats},
                    {"mismatches", simulation.mismatches}});
  }
  text += "  * not reached: the most accurate point instead\n";
  return good;
}

// The view's truths, and a golden frame with a truth in its order on each core.
PixelBytes memory_of(const AccuracyArguments& arguments) {
  PixelBytes bytes = kTruthPixels;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    bytes = bytes + kGoldenPixels + kImagePixels + kImagePixels;
  return arguments.rtl ? bytes + kRtlPixels : bytes;
}

// A sweep without its page is worth having; it is told before the sweep.
bool can_make_page() {
  try {
    try_page();
    return true;
  } catch (const OwnFailure& failure) {
    fmt::print(stderr, "accuracy.html is left out: {}\n", failure.what());
    return false;
  }
}

StudyPage page_of(const CLI::App& command, const std::string& title, const AccuracyView& view,
                  const AccuracySweep& sweep) {
  StudyPage page = study_page("What accuracy costs", command, {"--json", "--csv", "--resume"});
  page.lead(title);
  add_accuracy(page, sweep, error_pictures(view, sweep));
  return page;
}

int accuracy(const AccuracyArguments& arguments, const CLI::App& command) {
  SimulateOptions options = arguments.view.options();
  arguments.memory.apply(options);
  const SweepOptions sweep_options{
      .knobs = find_knobs(arguments.knobs), .points = arguments.points, .resume = arguments.resume};
  const double target = arguments.target.empty() ? 0 : parse_target(arguments.target);
  const FrameModel silicon = read_frame_model();
  try_folder("--out", arguments.out, {"accuracy.csv", "accuracy.html", "accuracy.json", "accuracy.txt", "target.cfg"});
  try_folder("--out", arguments.out + "/points");
  const LoadedView loaded = load_view(arguments.view);
  check_picture_memory(loaded.camera, options, memory_of(arguments));
  const bool with_page = can_make_page();
  const std::filesystem::path out = arguments.out;
  const AccuracyView view(loaded.scene, loaded.camera, options);
  const MeasurementStore store(out / "points", loaded.scene, loaded.camera, options);
  const AccuracySweep sweep = accuracy_sweep(view, store, silicon, options.config, sweep_options);
  const std::vector<MeasuredPoint> points = sweep.all();

  const std::string title =
      fmt::format("{}: view {} ({}x{}), memory {}, base {}", loaded.scene.name, loaded.camera.name, loaded.camera.width,
                  loaded.camera.height, arguments.memory.external.dram, config_difference(options.config));
  std::string text = title + "\n\n" + accuracy_text(sweep);
  nlohmann::ordered_json json = {
      {"scene", loaded.scene.name}, {"camera", loaded.camera.name}, {"memory", arguments.memory.external.dram}};
  json.update(accuracy_json(sweep));
  write_text(out / "accuracy.csv", accuracy_csv(sweep));
  std::vector<Chart> charts = front_charts(sweep);
  for (const SweptKnob& knob : sweep.knobs) charts.push_back(knob_chart(knob));
  json["charts"] = charts_json(charts);
  std::string more;  // besides the sweep
  if (target > 0) more += "\n" + answer_target(arguments, points, target);
  bool good = true;
  if (arguments.rtl) {
    json["rtl"] = nlohmann::ordered_json::array();
    good = check_in_rtl(view, loaded, points, json["rtl"], more);
  }
  text += more;
  if (with_page) {
    StudyPage page = page_of(command, title, view, sweep);
    if (!more.empty()) page.section("What was asked for");
    page.printed(more);
    write_page(out / "accuracy.html", page);
  }
  write_text(out / "accuracy.json", json.dump(2) + "\n");
  write_text(out / "accuracy.txt", text);
  if (arguments.json) fmt::print("{}\n", json.dump(2));
  else if (arguments.csv) fmt::print("{}", accuracy_csv(sweep));
  else
    fmt::print("{}  {}{}/accuracy.json, accuracy.csv\n", text,
               with_page ? fmt::format("page {}/accuracy.html; also ", arguments.out) : "", arguments.out);
  return good ? kExitOk : kExitDiffers;
}

}  // namespace

void add_accuracy(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "accuracy", "what accuracy costs on a view: knobs alone and together, and the configurations worth having");
  command->footer(footer(
      "pipegs accuracy garden.ply --cameras cameras.json --view 0 --design exact --target 60dB --out accuracy",
      "measured (--rtl: and every bit and cycle agrees)", "--rtl: a bit or a frame's cycles differ, or the RTL stops",
      "Accuracy is the golden model's against float64, cycles and bytes are the timing model's. --rtl runs five "
      "points in RTL."));
  static AccuracyArguments arguments;
  arguments.view.add(*command);
  arguments.memory.add(*command);
  add_names(*command, "--knobs", arguments.knobs, "which, by commas; without it all");
  add_integer(*command, "--points", arguments.points, "most configurations to measure with knobs turned together", 0,
              1000)
      ->capture_default_str();
  command->add_option("--out", arguments.out, "folder for accuracy.html, .json, .csv, and points/ to resume from")
      ->capture_default_str();
  command->add_flag("--resume", arguments.resume, "take the points that the folder holds of this view");
  command->add_option("--target", arguments.target,
                      "cheapest configuration with so much numeric PSNR, as 60dB; written to target.cfg");
  command->add_flag("--rtl", arguments.rtl,
                    "run the cheapest points at 40, 50, 60, 70, 80 dB in RTL, with all comparisons");
  command->add_flag("--json", arguments.json, "print accuracy.json instead of the table");
  command->add_flag("--csv", arguments.csv, "print accuracy.csv instead of the table");
  command->callback([&run, command] { run = [command] { return accuracy(arguments, *command); }; });
}

}  // namespace pipegs
