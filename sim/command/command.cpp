// SPDX-License-Identifier: Apache-2.0
// command.cpp: what the subcommands share: arguments of a view, loading, writing.
#include "sim/command/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scenes/check/scene_check.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/formats/axes.hpp"
#include "scenes/formats/read_scene.hpp"
#include "scenes/generate/generate.hpp"
#include "scenes/input_error.hpp"
#include "sim/design/config_file.hpp"
#include "sim/memory/dram_memory.hpp"
#include "sim/progress.hpp"

namespace pipegs {

void SceneArguments::add(CLI::App& app, const std::string& what) {
  add_text(app, "SCENE", file, what);
  add_integer(app, "--lod", read.lod, "level of detail of a streamed SOG; 0 is the finest", 0, 63).shows_default();
  add_text(app, "--axes", read.axes,
           "axes of the scene, where x, y, z point, such as RUB (right, up, back); otherwise as the file or its "
           "format says")
      .checked([](const std::string& axes) {
        return are_axes(axes)
                   ? std::string()
                   : fmt::format("found {}, expected R or L, U or D, F or B, such as RDF or RUB", quote(axes));
      });
  add_flag(app, "--strict", strict, "refuse a scene, cameras, a view or a frame of which there is a warning");
}

Scene SceneArguments::load(SceneFormat& format) const {
  const Progress stage("reading the scene");
  Scene scene = file.empty() ? generate_scene(1) : read_scene(file, read, &format);
  const Findings found = check_scene(scene);
  format.findings.insert(format.findings.end(), found.begin(), found.end());
  return scene;
}

void SceneArguments::tell(const Findings& findings) const {
  const std::string about = file.empty() ? "our own scene" : file;
  for (const Finding& finding : findings) {
    const Severity severity = finding.kind->severity;
    const std::string line = finding_line(finding);
    if (severity == Severity::kError) throw InputError(about, "", line);
    if (strict && severity == Severity::kWarning) throw ConfigError(fmt::format("--strict: {}: {}", about, line));
    if (finding.kind->told) fmt::print(stderr, "pipegs: {}\n", one_line(fmt::format("{}: {}", about, line)));
  }
}

void Told::tell(const Findings& findings) {
  scene_.tell(findings);
  const std::lock_guard lock(mutex_);
  all_.insert(all_.end(), findings.begin(), findings.end());
}

void Told::tell_frame(const Findings& findings) {
  const std::lock_guard lock(mutex_);
  for (const Finding& finding : findings) {
    const bool known = std::any_of(all_.begin(), all_.end(), [&](const Finding& other) {
      return other.kind == finding.kind || (finding.kind->key == "empty_frame" && other.kind->shows_nothing);
    });
    if (known) continue;
    scene_.tell({finding});
    all_.push_back(finding);
  }
}

Findings Told::all() const {
  const std::lock_guard lock(mutex_);
  return all_;
}

void ViewArguments::add(CLI::App& app, DesignPoints which) {
  scene.add(app);
  cameras.add(app);
  add_integer(app, "--view", view, "which camera of the file or of the orbit, counted from 0", 0).shows_default();
  add_place(app, "--window", window,
            "only this window (pixels of fast and wide 128x128, of gscore 16x16, of the others 64x64)");
  if (which != DesignPoints::kSeveral) add_design(app);
  if (which == DesignPoints::kSeveral || which == DesignPoints::kOneOrSeveral) {
    const char* otherwise = which == DesignPoints::kSeveral ? "all of them without it" : "instead of --design";
    add_names(app, "--designs", design_points,
              fmt::format("which design points, by commas, {}: {}", otherwise, design_point_names()));
  }
  add_file(app);
  if (which != DesignPoints::kBase) add_settings(app);
  add_read(
      app, "--walk-most",
      "a window of `fast` with more Gaussians at about one depth is walked part by part, 0: none is; the "
      "picture is the same",
      "INT", [this](const std::string& text) { walk_most = parse_integer<uint64_t>(text, 0, (uint64_t{1} << 24) - 1); },
      [] { return fmt::to_string(SimulateOptions{}.walk_most); })
      .shows_default();
  add_real(app, "--rest", rest,
           "a pixel with less transmittance left gives all of it to its next Gaussian and stops, 0: INRIA's rule, at "
           "1/10000 (--set t_cut)",
           {.low = 0, .high = 0.999})
      .shows_default();
  add_real(app, "--lod-pixels", lod_pixels,
           "proxies stand for the Gaussians of a group where these differ from them by less than so many pixels, 0: "
           "nowhere (--set lod=1)",
           {.low = 0, .high = 1024})
      .shows_default();
  add_real(app, "--near", near_plane, "near plane, scene units", kPositive).shows_default();
}

SimulateOptions ViewArguments::on(const DesignPoint& other) const {
  const auto leave_alone = [](const std::string& place, const std::string& setting) {
    const std::string key = setting.substr(0, setting.find('='));
    if (key == "late" || key == "order" || key == "quadratic")
      throw ConfigError(fmt::format("{} {}: the design points set {}", place, setting, key));
  };
  if (!config.empty()) {
    for (const ConfigLine& line : read_config_file(config)) leave_alone(line.place + ":", line.setting);
  }
  for (const std::string& setting : settings) leave_alone("--set", setting);
  ViewArguments same = *this;
  same.design_point = other.name;
  return same.one_of_several();
}

SimulateOptions ViewArguments::options() const {
  const SimulateOptions options = one_of_several();
  check_fields({options});
  return options;
}

void ViewArguments::check_fields(const std::vector<SimulateOptions>& machines) const {
  const auto walks = [](const SimulateOptions& one) { return one.config.has_walks(); };
  if (walk_most && std::none_of(machines.begin(), machines.end(), walks))
    throw ConfigError(
        "--walk-most: found no machine that walks windows part by part, expected one with order=2 and "
        "windows of 128 pixels, such as `fast`");
  const auto stops = [](const SimulateOptions& one) { return one.config.early_stop != 0; };
  if (rest != 0 && std::none_of(machines.begin(), machines.end(), stops))
    throw ConfigError("--rest: found no machine whose pixels stop, expected one with early_stop=1");
  const auto has_proxies = [](const SimulateOptions& one) { return one.config.lod != 0; };
  if (lod_pixels != 0 && std::none_of(machines.begin(), machines.end(), has_proxies))
    throw ConfigError("--lod-pixels: found no machine with levels of detail, expected one with lod=1");
}

SimulateOptions ViewArguments::one_of_several() const {
  SimulateOptions options;
  options.config = machine();
  if (!window.empty()) options.window = {window.at(0), window.at(1)};
  options.walk_most = walk_most.value_or(options.walk_most);
  options.near_plane = near_plane;
  options.rest = rest;
  options.lod_pixels = lod_pixels;
  return options;
}

std::vector<SimulateOptions> ViewArguments::paper_and_own() const {
  ViewArguments paper = *this;
  paper.design_point = "dop", paper.config.clear(), paper.settings.clear();
  std::vector<SimulateOptions> both = {paper.one_of_several(), options()};
  if (both[0].config == both[1].config) both.pop_back();
  return both;
}

std::vector<SimulateOptions> ViewArguments::each() const {
  return design_points.empty() ? std::vector{options()} : options(find_design_points(design_points));
}

std::vector<SimulateOptions> ViewArguments::options(const std::vector<const DesignPoint*>& several) const {
  std::vector<SimulateOptions> each;
  for (const DesignPoint* one : several) {
    each.push_back(on(*one));
    const int first = each.front().config.window, side = each.back().config.window;
    if (!window.empty() && side != first) {
      throw ConfigError(fmt::format("--window: found design points with windows of {} and {} pixels, expected one size",
                                    first, side));
    }
  }
  check_fields(each);
  return each;
}

void MemoryArguments::add(CLI::App& app, bool with_bandwidth) {
  external.dram = kDefaultDram;
  external.jitter = 20;
  std::vector<std::string> names = dram_memory_names();
  names.push_back("ideal");
  add_text(app, "--memory", external.dram, fmt::format("external memory, a DRAM or ideal: {}", fmt::join(names, ", ")))
      .shows_default()
      .one_of(names, true);
  add_integer(app, "--latency", external.latency, "ideal memory: cycles to an answer", 1, 100000).shows_default();
  if (with_bandwidth) {
    add_real(app, "--bandwidth", external.bytes_per_cycle, "ideal memory: bytes per cycle", {.low = 0.1, .high = 64})
        .shows_default();
  }
  add_integer(app, "--jitter", external.jitter, "ideal memory: largest random extra latency, cycles", 0, 100000)
      .shows_default();
  add_integer(app, "--seed", seed, "seed of the jitter and of the registers' initial values").shows_default();
}

void MemoryArguments::apply(SimulateOptions& options) const {
  options.memory = external;
  options.memory.seed = seed;
  options.rtl.seed = seed;
}

LoadedView load_view(const ViewArguments& arguments) {
  LoadedView loaded;
  std::vector<Camera>& cameras = loaded.cameras;
  Findings of_cameras;
  const std::optional<std::vector<Camera>> given = arguments.cameras.read(of_cameras);
  SceneFormat format;
  loaded.scene = arguments.scene.load(format);
  cameras = arguments.cameras.views(given, loaded.scene, arguments.scene.file.empty(), format.origin);
  if (arguments.view < 0 || arguments.view >= static_cast<int>(cameras.size())) {
    throw ConfigError(
        fmt::format("--view: found {}, expected 0 to {}", arguments.view, static_cast<int>(cameras.size()) - 1));
  }
  loaded.camera = cameras[arguments.view];
  loaded.told = std::make_shared<Told>(arguments.scene);
  loaded.told->tell(format.findings);
  loaded.told->tell(of_cameras);
  loaded.told->tell(check_views(loaded.scene, {&loaded.camera, 1}, arguments.near_plane));
  return loaded;
}

std::string head_of(const LoadedView& loaded, const MemoryArguments& memory) {
  return fmt::format("{}: view {} ({}x{}), memory {}", loaded.scene.name, loaded.camera.name, loaded.camera.width,
                     loaded.camera.height, memory.external.dram);
}

void follow_scene(const LoadedView& loaded, SimulateOptions& options) {
  if (loaded.scene.antialiased) options.config.antialias = 1;
  options.found = [told = loaded.told](const Findings& findings) { told->tell_frame(findings); };
}

void need_taps(const SimulateOptions& options) {
  if (!options.config.taps) throw ConfigError("--set taps=0: this command looks at the streams, which need taps=1");
}

std::string footer(const std::string& example, const std::string& agrees, const std::string& differs,
                   const std::string& notes) {
  return fmt::format("Example: {}\n{}{}Exit codes: 0 {},{} 2 bad input or bad use, 3 our own failure.", example, notes,
                     notes.empty() ? "" : "\n", agrees, differs.empty() ? "" : fmt::format(" 1 {},", differs));
}

}  // namespace pipegs
