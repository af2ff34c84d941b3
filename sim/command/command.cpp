// command.cpp: what the subcommands share: arguments of a view, loading, writing.
#include "sim/command/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>

#include "cpp_model/float/image.hpp"
#include "scenes/atomic_file.hpp"
#include "scenes/generate.hpp"
#include "scenes/input_error.hpp"
#include "scenes/ply.hpp"
#include "sim/config_file.hpp"
#include "sim/dram_memory.hpp"

namespace pipegs {

void ViewArguments::add(CLI::App& app, Rungs which) {
  app.add_option("SCENE", scene, "scene as .ply (INRIA layout); without it our own scene");
  app.add_option("--cameras", cameras, "cameras.json (INRIA layout); needed with SCENE");
  app.add_option("--view", view, "which camera of the file, counted from 0")->capture_default_str();
  app.add_option("--window", window, "only this window: column,row")->delimiter(',')->expected(2);
  if (which != Rungs::kSeveral) app.add_option("--rung", rung, fmt::format("rung of the ladder: {} (--set comes after it)", rung_names()));
  if (which != Rungs::kOne) {
    const char* otherwise = which == Rungs::kSeveral ? "all of them without it" : "instead of --rung";
    app.add_option("--rungs", rungs, fmt::format("which, by commas, {}: {}", otherwise, rung_names()))->delimiter(',');
  }
  app.add_option("--config", config, "file with a configuration entry in each line, key=value; # begins a comment");
  app.add_option("--set", settings, "configuration entry, key=value; may be repeated")->allow_extra_args(false);
  app.add_option("--near", near_plane, "near plane, scene units")->capture_default_str();
}

SimulateOptions ViewArguments::options(const Rung& on) const {
  const auto leave_alone = [](const std::string& place, const std::string& setting) {
    const std::string key = setting.substr(0, setting.find('='));
    if (key == "late" || key == "order" || key == "quadratic") throw ConfigError(fmt::format("{} {}: the rungs set {}", place, setting, key));
  };
  if (!config.empty()) {
    for (const ConfigLine& line : read_config_file(config)) leave_alone(line.place + ":", line.setting);
  }
  for (const std::string& setting : settings) leave_alone("--set", setting);
  ViewArguments same = *this;
  same.rung = on.name;
  return same.options();
}

SimulateOptions ViewArguments::options() const {
  SimulateOptions options;
  if (!rung.empty()) apply_rung(find_rung(rung), options.config);
  if (!config.empty()) apply_config_file(config, options.config);
  for (const std::string& setting : settings) config_set(options.config, setting);
  config_check(options.config);
  if (!window.empty()) options.window = {window.at(0), window.at(1)};
  if (!(near_plane > 0)) throw ConfigError(fmt::format("--near: found {}, expected a positive number", near_plane));
  options.near_plane = near_plane;
  return options;
}

std::vector<SimulateOptions> ViewArguments::each() const {
  if (rungs.empty()) return {options()};
  std::vector<SimulateOptions> each;
  for (const Rung* one : find_rungs(rungs)) each.push_back(options(*one));
  return each;
}

void MemoryArguments::add(CLI::App& app, bool with_bandwidth) {
  external.dram = "lpddr5-6400x4";
  app.add_option("--memory", external.dram, "external memory: a DRAM (" + fmt::format("{}", fmt::join(dram_memory_names(), ", ")) + ") or ideal")
      ->capture_default_str();
  app.add_option("--latency", external.latency, "ideal memory: cycles to an answer")->capture_default_str()->check(CLI::Range(1, 100000));
  if (with_bandwidth) {
    app.add_option("--bandwidth", external.bytes_per_cycle, "ideal memory: bytes per cycle")->capture_default_str()->check(CLI::Range(0.1, 64.0));
  }
  app.add_option("--jitter", external.jitter, "ideal memory: largest random extra latency, cycles")->default_val(20)->check(CLI::Range(0, 100000));
  app.add_option("--seed", seed, "seed of the jitter and of the registers' initial values")->capture_default_str();
}

void MemoryArguments::apply(SimulateOptions& options) const {
  if (external.dram != "ideal") dram_memory_timing(external.dram);  // throws for an unknown name
  options.memory = external;
  options.memory.seed = seed;
  options.rtl.seed = seed;
}

LoadedView load_view(const ViewArguments& arguments) {
  LoadedView loaded;
  std::vector<Camera> cameras;
  if (arguments.scene.empty()) {
    loaded.scene = generate_scene(1);
    cameras = arguments.cameras.empty() ? generated_cameras() : read_cameras(arguments.cameras);
  } else {
    if (arguments.cameras.empty()) throw ConfigError(fmt::format("{}: --cameras FILE is needed with a scene", arguments.scene));
    cameras = read_cameras(arguments.cameras);
    loaded.scene = read_ply(arguments.scene);
  }
  if (arguments.view < 0 || arguments.view >= static_cast<int>(cameras.size())) {
    throw ConfigError(fmt::format("--view: found {}, expected 0 to {}", arguments.view, static_cast<int>(cameras.size()) - 1));
  }
  loaded.camera = cameras[arguments.view];
  return loaded;
}

void follow_scene(const Scene& scene, SimulateOptions& options) {
  if (scene.antialiased) options.config.antialias = 1;
}

void write_images(const std::string& folder, const Image& image) {
  std::filesystem::create_directories(folder);
  write_exr(std::filesystem::path(folder) / "frame.exr", image);
  write_png(std::filesystem::path(folder) / "frame.png", image, glm::dvec3(0));
}

void write_text(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw InputError(path, "", "cannot be written");
  file.commit();
}

void write_charts(const std::string& path, const std::vector<Chart>& charts) {
  if (path.empty()) return;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder);
  write_text(path, charts_svg(charts));
}

}  // namespace pipegs
