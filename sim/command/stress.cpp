// stress.cpp: `pipegs stress`: random hostile views through golden model, RTL and bounds, until one fails.
//
// A failure prints its seed, is shrunk, written as scene.ply and cameras.json, read back, and named by the line that replays
// it. What the file formats cannot hold exactly (a camera's last bit) would show there: the replay is tried before it is printed.
#include <fmt/format.h>

#include <filesystem>

#include "scenes/ply.hpp"
#include "sim/command/command.hpp"
#include "sim/progress.hpp"
#include "sim/stress/stress.hpp"

namespace pipegs {
namespace {

struct Arguments {
  std::string rung, size, out = "stress";
  std::vector<std::string> settings;
  uint64_t seed = 1;
  int count = 100, gaussians = 0;
  bool no_rtl = false;
};

SimulateOptions machine(const Arguments& arguments) {
  ViewArguments view;
  view.rung = arguments.rung, view.settings = arguments.settings;
  return view.options();
}

StressShape shape(const Arguments& arguments) {
  StressShape shape{.gaussians = arguments.gaussians};
  if (arguments.size.empty()) return shape;
  char rest = 0;
  if (std::sscanf(arguments.size.c_str(), "%dx%d%c", &shape.width, &shape.height, &rest) != 2 || shape.width < 1 || shape.height < 1 ||
      shape.width > kMaxImageSide || shape.height > kMaxImageSide) {
    throw ConfigError(fmt::format("--size: found '{}', expected WxH such as 160x120", arguments.size));
  }
  return shape;
}

// Memory of another pace for every seed.
SimulateOptions paced(SimulateOptions options, uint64_t seed) {
  options.memory.latency = 20 + static_cast<int>(seed % 7) * 40;
  options.memory.jitter = static_cast<int>(seed % 3) * 30;
  options.memory.seed = options.rtl.seed = seed;
  return options;
}

std::string replay(const Arguments& arguments, const SimulateOptions& options, const StressView& view) {
  std::string line = fmt::format("build/pipegs sim '{0}/scene.ply' --cameras '{0}/cameras.json' --near {1} --memory ideal --latency {2} --jitter {3} --seed {4}",
                                 arguments.out, view.near_plane, options.memory.latency, options.memory.jitter, options.memory.seed);
  if (!arguments.rung.empty()) line += " --rung " + arguments.rung;
  for (const std::string& setting : arguments.settings) line += " --set " + setting;
  return line + (arguments.no_rtl ? " --no-rtl" : "");
}

void shrink_and_write(const Arguments& arguments, const SimulateOptions& options, const StressView& view) {
  const StressPredicate fails = [&](const StressView& v) { return stress_check(v, options, !arguments.no_rtl); };
  Progress progress("shrinking");
  const StressShrunk small = stress_shrink(view, fails, [&](const StressShrunk& now) {
    progress.update(0, fmt::format("{} tries, {} Gaussians, {}x{}", now.tried, now.view.scene.gaussians.size(), now.view.camera.width, now.view.camera.height));
    return !interrupted();
  });
  std::filesystem::create_directories(arguments.out);
  write_ply(arguments.out + "/scene.ply", small.view.scene);
  write_cameras(arguments.out + "/cameras.json", {small.view.camera});
  const StressView again{read_ply(arguments.out + "/scene.ply"), read_cameras(arguments.out + "/cameras.json").at(0), small.view.near_plane};
  fmt::print("smallest that fails: {} Gaussians, {}x{} pixels ({} tries): {}\n", small.view.scene.gaussians.size(), small.view.camera.width,
             small.view.camera.height, small.tried, small.what);
  fmt::print("replay{}: {}\n", fails(again) ? "" : " (the files do NOT show it: the view's own numbers are needed)", replay(arguments, options, small.view));
}

int stress(const Arguments& arguments) {
  const SimulateOptions base = machine(arguments);
  const StressShape wanted = shape(arguments);
  StressFigures figures;
  Progress progress("stress");
  const Stopwatch watch;
  for (int i = 0; i < arguments.count; ++i) {
    if (interrupted()) throw std::runtime_error("interrupted");
    const uint64_t seed = arguments.seed + static_cast<uint64_t>(i);
    const SimulateOptions options = paced(base, seed);
    const StressView view = stress_view(seed, wanted);
    progress.update(static_cast<double>(i) / arguments.count, fmt::format("seed {}, {:.0f} views a minute", seed, 60 * i / std::max(watch.seconds(), 1e-3)));
    const std::optional<std::string> what = stress_check(view, options, !arguments.no_rtl, &figures);
    if (!what) continue;
    fmt::print("seed {} fails: {}\n", seed, *what);
    shrink_and_write(arguments, options, view);
    return kExitMismatch;
  }
  const Saturations& s = figures.saturations;
  fmt::print("{} views from seed {}: {} Gaussians, {} pairs of Gaussian and pixel, all within their bounds ({} pairs have none)\n", figures.views,
             arguments.seed, figures.gaussians, figures.pairs, figures.vacuous);
  fmt::print("  RTL                   {}\n", arguments.no_rtl ? "not run" : fmt::format("{} beats and every pixel equal to golden, {} cycles", figures.beats, figures.cycles));
  fmt::print("  worst error           alpha {:.5f}, T {:.5f}, colour {:.5f}\n", figures.alpha, figures.t, figures.color);
  fmt::print("  saturations           mean {}, dead {}, colour {}, accumulated {}\n", s.mean, s.dead, s.color, s.accumulated);
  return kExitOk;
}

}  // namespace

void add_stress(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("stress", "random hostile scenes through golden model, RTL and error bounds; shrinks a failure");
  command->footer("Example: pipegs stress --seed 1 --count 500 --rung exact\n"
                  "Exit code 0 when all agree, 1 when one fails; then its smallest form lies in --out.");
  static Arguments arguments;
  command->add_option("--seed", arguments.seed, "of the first view; the next ones count up")->capture_default_str();
  command->add_option("--count", arguments.count, "views")->capture_default_str()->check(CLI::Range(1, 100000000));
  command->add_option("--rung", arguments.rung, "rung of the ladder: " + rung_names());
  command->add_option("--set", arguments.settings, "configuration entry, key=value; may be repeated")->allow_extra_args(false);
  command->add_option("--size", arguments.size, "image, WxH; without it up to 160x120");
  command->add_option("--gaussians", arguments.gaussians, "per view; 0 is 10 to 300")->capture_default_str()->check(CLI::Range(0, 1000000));
  command->add_option("--out", arguments.out, "folder for the smallest view that fails")->capture_default_str();
  command->add_flag("--no-rtl", arguments.no_rtl, "golden model against its bounds only");
  command->callback([&run] { run = [] { return stress(arguments); }; });
}

}  // namespace pipegs
