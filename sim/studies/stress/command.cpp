// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study stress`: random hostile views through golden model, RTL and bounds, until one fails.
//
// A failure prints its seed, is shrunk, written as scene.ply and cameras.json, read back, and named by the line that
// replays it. What the file formats cannot hold exactly (a camera's last bit) would show there: the replay is tried
// before it is printed.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "scenes/atomic_file.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"
#include "sim/command/picture_size.hpp"
#include "sim/command/replay.hpp"
#include "sim/progress.hpp"
#include "sim/studies/stress/stress.hpp"

namespace pipegs {
namespace {

struct StressArguments {
  ViewArguments machine;  // its design point and settings
  std::string size, out = "stress";
  uint64_t seed = 1;
  int count = 100, gaussians = 0;
  bool no_rtl = false;
};

// Memory of another pace for every seed.
SimulateOptions paced(SimulateOptions options, uint64_t seed) {
  options.memory.latency = 20 + static_cast<int>(seed % 7) * 40;
  options.memory.jitter = static_cast<int>(seed % 3) * 30;
  options.memory.seed = options.rtl.seed = seed;
  return options;
}

std::string replay(const std::string& program, const StressArguments& arguments, const SimulateOptions& options,
                   const StressView& view) {
  std::string line =
      fmt::format("{} sim {} --cameras {} --near {} --memory ideal --latency {} --jitter {} --seed {}", program,
                  shell_word(arguments.out + "/scene.ply"), shell_word(arguments.out + "/cameras.json"),
                  view.near_plane, options.memory.latency, options.memory.jitter, options.memory.seed);
  line += " --design " + arguments.machine.design_point;
  for (const std::string& setting : arguments.machine.settings) line += " --set " + shell_word(setting);
  if (!arguments.machine.aovs.empty()) line += fmt::format(" --aovs {}", fmt::join(arguments.machine.aovs, ","));
  return line + (arguments.no_rtl ? " --no-rtl" : "");
}

void shrink_and_write(const std::string& program, const StressArguments& arguments, const SimulateOptions& options,
                      const StressView& view) {
  const StressPredicate fails = [&](const StressView& v) { return stress_check(v, options, !arguments.no_rtl); };
  Progress progress("shrinking");
  const StressShrunk small = stress_shrink(view, fails, [&](const StressShrunk& now) {
    progress.update(0, fmt::format("{} tries, {} Gaussians, {}x{}", now.tried, now.view.scene.gaussians.size(),
                                   now.view.camera.width, now.view.camera.height));
    return !interrupted();
  });
  make_folders(arguments.out);
  write_ply(arguments.out + "/scene.ply", small.view.scene);
  write_cameras(arguments.out + "/cameras.json", {small.view.camera});
  const StressView again{read_ply(arguments.out + "/scene.ply"), read_cameras(arguments.out + "/cameras.json").at(0),
                         small.view.near_plane};
  fmt::print("smallest that fails: {} Gaussians, {}x{} pixels ({} tries): {}\n", small.view.scene.gaussians.size(),
             small.view.camera.width, small.view.camera.height, small.tried, small.what);
  fmt::print("replay{}: {}\n", fails(again) ? "" : " (the files do NOT show it: the view's own numbers are needed)",
             replay(program, arguments, options, small.view));
}

int stress(const std::string& program, const StressArguments& arguments) {
  const SimulateOptions base = arguments.machine.options();
  StressShape wanted{.gaussians = arguments.gaussians};
  if (!arguments.size.empty()) {
    const PictureSize size = picture_size("--size", arguments.size);
    wanted.width = size.width, wanted.height = size.height;
  }
  try_folder("--out", arguments.out, {"scene.ply", "cameras.json"});
  check_picture_memory({.name = "--size", .width = wanted.width, .height = wanted.height}, base,
                       kGoldenPixels + kTruthPixels + kRtlPixels);
  StressFigures figures;
  Progress progress("stress");
  const Stopwatch watch;
  for (int i = 0; i < arguments.count; ++i) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const uint64_t seed = arguments.seed + static_cast<uint64_t>(i);
    const SimulateOptions options = paced(base, seed);
    const StressView view = stress_view(seed, wanted);
    progress.update(static_cast<double>(i) / arguments.count,
                    fmt::format("seed {}, {:.0f} views a minute", seed, 60 * i / std::max(watch.seconds(), 1e-3)));
    const std::optional<std::string> what = stress_check(view, options, !arguments.no_rtl, &figures);
    if (!what) continue;
    fmt::print("seed {} fails: {}\n", seed, *what);
    shrink_and_write(program, arguments, options, view);
    return kExitDiffers;
  }
  const Saturations& s = figures.saturations;
  fmt::print(
      "{} views from seed {}: {} Gaussians, {} pairs of Gaussian and pixel; {:.1f} % have a bound, all of these within "
      "it\n",
      figures.views, arguments.seed, figures.gaussians, figures.pairs,
      100 - 100 * static_cast<double>(figures.vacuous) / static_cast<double>(std::max<uint64_t>(figures.pairs, 1)));
  fmt::print("  RTL                   {}\n",
             arguments.no_rtl
                 ? "not run"
                 : fmt::format("{} beats and every pixel equal to golden, {} cycles", figures.beats, figures.cycles));
  fmt::print("  worst error           alpha {:.5f}, T {:.5f}, colour {:.5f}\n", figures.alpha, figures.t,
             figures.color);
  fmt::print("  saturations           mean {}, dead {}, colour {}, accumulated {}\n", s.mean, s.dead, s.color,
             s.accumulated);
  return kExitOk;
}

}  // namespace

void add_stress(CLI::App& app, Run& run) {
  CLI::App& command = add_command(
      app, "stress", "fuzzing with shrinking: random hostile scenes through golden model, RTL and error bounds",
      footer("pipegs study stress --seed 1 --count 500 --design exact", "all agree and lie within their bounds",
             "one fails; then its smallest form lies in --out"));
  static StressArguments arguments;
  add_integer(command, "--seed", arguments.seed, "of the first view; the next ones count up").shows_default();
  add_integer(command, "--count", arguments.count, "views", 1, 100000000).shows_default();
  add_text(command, "--design", arguments.machine.design_point, "design point: " + design_point_names())
      .shows_default();
  add_texts(command, "--set", arguments.machine.settings, "configuration entry, key=value; may be repeated");
  add_text(command, "--size", arguments.size, "image, WxH; without it up to 160x120");
  add_integer(command, "--gaussians", arguments.gaussians, "per view; 0 is 10 to 300", 0, 1000000).shows_default();
  add_text(command, "--out", arguments.out, "folder for the smallest view that fails").shows_default();
  add_flag(command, "--no-rtl", arguments.no_rtl, "golden model against its bounds only");
  when_chosen(command, run, [&command] { return stress(program_of(command), arguments); });
}

}  // namespace pipegs
