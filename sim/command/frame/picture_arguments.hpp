// SPDX-License-Identifier: Apache-2.0
// picture_arguments.hpp: what of a frame becomes its 8-bit picture, and over which background.
//
// Rule    --crop runs the windows that hold its pixels, of the whole frame, and cuts these out: each pixel is the one
//         of the whole picture. --background lets the machine write T (pixel_w = 64) and blends on the host; EXR files
//         have colour and T as they are.
// Errors  ConfigError: a crop that is not inside the picture, a background for pixels without T.
#pragma once

#include <optional>
#include <vector>

#include "sim/command/command.hpp"
#include "sim/compare/background.hpp"

namespace pipegs {

struct PictureArguments {
  std::vector<int> background, crop;

  void add(CLI::App& app);
  // `machine`: the pixels come from one, in float64 they need no T of its.
  void apply(const ViewArguments& view, bool machine, SimulateOptions& options) const;
  // The background; black without one.
  Background color() const;
  // The 8-bit picture of a simulated frame.
  Rgb8 picture(const Simulation& simulation, const SimulateOptions& options) const;

 private:
  bool is_black() const;
};

}  // namespace pipegs
