// SPDX-License-Identifier: Apache-2.0
// rivals.cpp: `pipegs rivals`: what a view asks of any renderer by tiles, in counts; what other orders do to pixels.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/command/command.hpp"
#include "sim/command/study/pixel_arguments.hpp"
#include "sim/progress.hpp"
#include "sim/study/rivals/pixels_report.hpp"
#include "sim/study/rivals/report.hpp"

namespace pipegs {
namespace {

struct RivalsArguments {
  ViewArguments view;
  CountOptions counts;
  PixelArguments pixels;
  bool json = false;
};

FrameCounts count(RivalsArguments& arguments, const LoadedView& view) {
  Progress progress("counting");
  arguments.counts.near_plane = arguments.view.near_plane;
  arguments.counts.progress = [&](double share) { progress.update(share); };
  return count_frame(view.scene, view.camera, arguments.counts);
}

int run_rivals(RivalsArguments& arguments) {
  const SimulateOptions options = arguments.view.options();
  if (options.window) throw ConfigError("--window: the whole view is counted, expected none");
  if (arguments.counts.group % kTileSide != 0)
    throw ConfigError(fmt::format("--group: found {}, expected a multiple of {}", arguments.counts.group, kTileSide));
  arguments.pixels.check();
  const LoadedView loaded = load_view(arguments.view);
  check_picture_memory(loaded.camera, options, arguments.pixels.wanted ? kOrderPixels : kCountPixels);
  const FrameCounts counts = count(arguments, loaded);
  PixelStudy pixels;
  if (arguments.pixels.wanted) pixels = arguments.pixels.run(loaded, arguments.view.near_plane);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"scene", loaded.scene.name},
                                   {"camera", loaded.camera.name},
                                   {"width", counts.width},
                                   {"height", counts.height}};
    json.update(counts_json(counts, arguments.counts));
    if (arguments.pixels.wanted) json["pixels"] = pixels_json(pixels, arguments.pixels.options);
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: view {} ({}x{}), float64, depth order\n\n{}", loaded.scene.name, loaded.camera.name, counts.width,
               counts.height, counts_text(counts, arguments.counts));
    if (arguments.pixels.wanted) fmt::print("\n{}", pixels_text(pixels, arguments.pixels.options));
  }
  return kExitOk;
}

}  // namespace

void add_rivals(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "rivals", "what a view asks of any renderer by tiles: Gaussians, pairs, keys, pixels, rows, voxels, counted");
  command->footer(footer(
      "pipegs rivals garden.ply --cameras cameras.json --view 0", "counted", "",
      "By the float64 projection and blending, all of the picture. Gaussians in the frustum and visible; (Gaussian, "
      "tile)\npairs by 3-sigma square, axis box, oriented box and alpha >= 1/255, tiles of 16 to 128 pixels; those "
      "before a tile\nis opaque; parts of 8x8 and 4x4, rows, pixels; lengths of lists as sorters need them; 64-px "
      "groups with masks;\ntiles that neighbours in depth share; voxels that groups of pixels meet, and what their "
      "filters leave. Each line\nof the table says what it counts. The machine (--rung, --set) does not change it.\n"
      "--pixels: pictures of the view in the order of STREAMINGGS, and of a camera that moves through all views of the "
      "file\nthat was given in the orders which GSAcc and Neo have from the frame before, against exact order."));
  static RivalsArguments arguments;
  arguments.view.add(*command);
  add_real(*command, "--voxel", arguments.counts.voxel, "edge of a voxel, scene units", {.low = 0.001, .high = 1e6})
      ->capture_default_str();
  add_integer(*command, "--group", arguments.counts.group,
              "side of a group of pixels that streams voxels, a multiple of 16", 16, 4096)
      ->capture_default_str();
  arguments.pixels.add(*command);
  command->add_flag("--json", arguments.json, "as JSON");
  command->callback([&run] { run = [] { return run_rivals(arguments); }; });
}

}  // namespace pipegs
