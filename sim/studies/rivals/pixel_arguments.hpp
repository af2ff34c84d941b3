// SPDX-License-Identifier: Apache-2.0
// pixel_arguments.hpp: what `pipegs rivals --pixels` takes: which orders are rendered, and of what.
#pragma once

#include "sim/command/command.hpp"
#include "sim/studies/rivals/pixels/pixels.hpp"

namespace pipegs {

struct PixelArguments {
  bool wanted = false;
  PixelOptions options;

  void add(CLI::App& app);
  void check() const;  // throws ConfigError
  PixelStudy run(const LoadedView& view, double near_plane);
};

}  // namespace pipegs
