// SPDX-License-Identifier: Apache-2.0
// point.cpp: `pipegs point`, and point.hpp.
#include "sim/command/campaign/point.hpp"

#include <fmt/format.h>

#include "cpp_model/float/parallel.hpp"
#include "scenes/input_error.hpp"
#include "scenes/text/text_file.hpp"
#include "sim/command/replay.hpp"
#include "sim/host_use.hpp"
#include "sim/progress.hpp"
#include "sim/report/report.hpp"
#include "sim/timing/timing_model.hpp"

namespace pipegs {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint64_t kMostFileBytes = uint64_t{1} << 32;

const std::string& hash_of_program() {
  static const std::string hash =
      hash_of_text(read_text_file(std::filesystem::read_symlink("/proc/self/exe"), "this program", kMostFileBytes));
  return hash;
}

Json view_key(const PointArguments& point) {
  Json key = {{"program", hash_of_program()}, {"engine", point.engine}, {"truth", point.truth}};
  if (point.engine != "rtl") return key;
  key["rtl"] = hash_of_files(PIPEGS_SOURCE_DIR "/rtl", ".sv");
  key["seed"] = point.memory.seed;
  return key;
}

// The figures of the timing model under the names of report.json.
Json timing_json(const TimingResult& timing) {
  return {{"cycles", timing.cycles},
          {"memory", traffic_json(timing.streams)},
          {"work", {{"overflow_lines", timing.overflow_lines}}}};
}

// What golden model, truth and RTL say, without what another computer would say otherwise.
Json frame_json(const LoadedView& loaded, const SimulateOptions& options, const Simulation& simulation) {
  Json report = report_json(loaded.scene, loaded.camera, options, simulation, loaded.told->all());
  for (const char* of_the_computer : {"wall_seconds", "host", "rtl_khz"}) report.erase(of_the_computer);
  return report;
}

// Measures the point and keeps it.
Json measure(const PointArguments& point, const LoadedView& loaded, const SimulateOptions& options,
             const MeasurementStore& store, const Stopwatch& watch) {
  Json cost = {{"read_seconds", process_seconds()}};
  Simulation simulation;
  simulate_pack(loaded.scene, loaded.camera, options, simulation);
  cost["pack_seconds"] = simulation.cpu_pack;
  Json result;
  if (point.engine == "model") {
    result = timing_json(timing_run(timing_trace(simulation.input), options.config, options.memory));
  } else {
    simulate_golden(options, simulation);
    if (point.truth) simulate_truth(loaded.scene, loaded.camera, options, simulation);
    if (point.engine == "rtl") simulate_rtl(options, simulation);
    cost["golden_seconds"] = simulation.cpu_golden;
    result = frame_json(loaded, options, simulation);
  }
  cost["cpu_seconds"] = process_seconds();
  cost["wall_seconds"] = watch.seconds();
  cost["peak_memory_bytes"] = peak_memory_bytes();
  Json kept = {{"result", std::move(result)}, {"cost", std::move(cost)}};
  store.save(options.config, kept);
  return kept;
}

int run_point(const PointArguments& point) {
  const Stopwatch watch;
  most_threads(1);
  point.options();  // refuses before the scene is read
  try_folder("--store", point.keep);
  const LoadedView loaded = load_view(point.view);
  const SimulateOptions options = point_options(point, loaded);
  if (point.engine != "model") {
    check_picture_memory(loaded.camera, options,
                         kGoldenPixels + (point.truth ? kTruthPixels : PixelBytes{}) +
                             (point.engine == "rtl" ? kRtlPixels : PixelBytes{}));
  }
  const MeasurementStore store = point_store(point, loaded.scene, loaded.camera);
  const std::filesystem::path file = store.path(options.config);
  std::optional<Json> kept = kept_point(store, options.config);
  const bool found = kept.has_value();
  if (!found) kept = measure(point, loaded, options, store, watch);
  fmt::print("{} {}\n", found ? "kept" : "measured", file.string());
  const Json result = (*kept)["result"];
  return result.value("mismatches", Json(nullptr)).is_null() || result["mismatches"] == 0 ? kExitOk : kExitDiffers;
}

std::string absolute(const std::string& path) { return std::filesystem::absolute(path).lexically_normal().string(); }

}  // namespace

void PointArguments::add(CLI::App& app) {
  view.add(app);
  memory.add(app);
  add_text(app, "--engine", engine,
           "who measures: model (timing model: cycles, bytes), golden (work, pixels), rtl (all, compared)")
      .shows_default()
      .one_of(kPointEngines, true);
  add_flag(app, "--truth", truth, "golden, rtl: the float64 renders and the PSNR, too");
  add_text(app, "--store", keep, "folder for what was measured").required();
}

SimulateOptions PointArguments::options() const {
  SimulateOptions result = view.options();
  memory.apply(result);
  if (truth && engine == "model")
    throw ConfigError("--truth: found --engine model, expected golden or rtl (it makes no pixels)");
  return result;
}

std::string PointArguments::line() const {
  std::string line = shell_word(std::filesystem::read_symlink("/proc/self/exe").string()) + " point";
  const auto say = [&line](const char* option, const std::string& value) {
    line += fmt::format(" {} {}", option, shell_word(value));
  };
  if (!view.scene.file.empty()) line += " " + shell_word(absolute(view.scene.file));
  if (view.scene.read.lod != 0) say("--lod", fmt::to_string(view.scene.read.lod));
  if (!view.scene.read.axes.empty()) say("--axes", view.scene.read.axes);
  if (!view.cameras.file.empty()) say("--cameras", absolute(view.cameras.file));
  if (!view.cameras.size.empty()) say("--size", view.cameras.size);
  if (view.cameras.orbit > 0) say("--orbit", fmt::to_string(view.cameras.orbit));
  say("--view", fmt::to_string(view.view));
  say("--design", view.design_point);
  for (const std::string& setting : view.settings) say("--set", setting);
  say("--memory", memory.external.dram);
  say("--seed", fmt::to_string(memory.seed));
  say("--engine", engine);
  if (truth) line += " --truth";
  say("--store", absolute(keep));
  if (!is_one_line(line))
    throw InputError("campaign", "",
                     fmt::format("found a line break or a control character in the names of {}, "
                                 "which no line of commands can hold",
                                 message_line(line)));
  return line;
}

MeasurementStore point_store(const PointArguments& point, const Scene& scene, const Camera& camera) {
  return {point.keep, scene, camera, point.options(), view_key(point)};
}

SimulateOptions point_options(const PointArguments& point, const LoadedView& loaded) {
  SimulateOptions options = point.options();
  follow_scene(loaded, options);
  return options;
}

std::optional<Json> kept_point(const MeasurementStore& store, const Config& config) {
  return store.load(config, [](const Json& kept) {
    kept.at("result").get_ref<const Json::object_t&>();
    for (const char* figure : {"read_seconds", "pack_seconds", "cpu_seconds", "wall_seconds", "peak_memory_bytes"})
      kept.at("cost").at(figure).get<double>();
    return kept;
  });
}

void add_point(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "point", "one point of a campaign: measured on one core, once, and kept",
                  footer("pipegs point garden.ply --cameras cameras.json --view 0 --design exact --store points",
                         "kept (--engine rtl: and every bit agrees)", "--engine rtl: a bit differs or the RTL stops",
                         "The lines that `pipegs campaign` writes. What is kept already is not measured again."));
  hide(command);  // lines of a campaign call it, nobody types it
  static PointArguments arguments;
  arguments.add(command);
  when_chosen(command, run, [] { return run_point(arguments); });
}

}  // namespace pipegs
