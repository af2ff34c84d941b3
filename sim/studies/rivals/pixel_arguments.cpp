// SPDX-License-Identifier: Apache-2.0
// pixel_arguments.cpp: see pixel_arguments.hpp.
#include "sim/studies/rivals/pixel_arguments.hpp"

#include <fmt/format.h>

#include "sim/progress.hpp"
#include "sim/studies/rivals/counts.hpp"

namespace pipegs {

void PixelArguments::add(CLI::App& app) {
  CLI::Option* flag = app.add_flag("--pixels", wanted, "render the orders of STREAMINGGS, GSAcc and Neo, too");
  const RealRange lengths{.low = 0.001, .high = 1e6}, speeds{.low = 0.01, .high = 1000},
      degrees{.low = 1e-6, .high = 90}, bytes{.low = 0, .high = 1000};
  CLI::Option* const all[] = {
      add_reals(app, "--voxels", options.voxels, "edges of voxels to render, scene units", lengths),
      add_integers(app, "--groups", options.groups, "sides of groups to render, multiples of 16", 16, 4096),
      add_reals(app, "--speeds", options.speeds, "speeds of the camera, times the step", speeds),
      add_real(app, "--step", options.step, "degrees of the path from a frame to the next at 1x", degrees),
      add_integer(app, "--path-frames", options.frames, "frames of the path to render", 1, 10000),
      add_real(app, "--index-bytes", options.index_bytes, "of what STREAMINGGS fetches behind its coarse filter",
               bytes),
  };
  for (CLI::Option* option : all) option->needs(flag)->capture_default_str();
}

void PixelArguments::check() const {
  for (const int side : options.groups) {
    if (side % kTileSide != 0)
      throw ConfigError(fmt::format("--groups: found {}, expected multiples of {}", side, kTileSide));
  }
}

PixelStudy PixelArguments::run(const LoadedView& view, double near_plane) {
  Progress progress("rendering");
  options.near_plane = near_plane;
  options.progress = [&](double share) { progress.update(share); };
  return study_pixels(view.scene, view.camera, view.cameras, options);
}

}  // namespace pipegs
