// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.hpp: `pipegs sim --page`: the frame as one HTML page.
//
// Errors  InputError: --against does not fit the camera, before anything is computed.
#pragma once

#include <optional>
#include <string>

#include "sim/command/command.hpp"
#include "sim/report/html/frame/frame_page.hpp"

namespace pipegs {

class FramePageArgument {
 public:
  void add(CLI::App& app);
  bool wanted() const { return wanted_; }
  void check() const;  // makes the template
  // The pixels of --against that were asked for; nothing without it. What was done to read them is told.
  std::optional<Rgb8> read(const LoadedView& loaded, const SimulateOptions& options) const;
  // page.html in the folder `out`. The rest of the page is what `command` was given.
  void write(const CLI::App& command, const std::string& out, FramePage page, const Simulation& simulation,
             const SimulateOptions& options) const;

 private:
  bool wanted_ = false;
  std::string against_;
};

}  // namespace pipegs
