// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.hpp: `pipegs sim --page`: the frame as one HTML page.
//
// Errors  InputError: --page cannot be written, --against is no picture of the camera's size; both before anything is
//         computed.
#pragma once

#include <optional>
#include <string>

#include "sim/command/command.hpp"
#include "sim/report/html/frame/frame_page.hpp"

namespace pipegs {

class FramePageArgument {
 public:
  void add(CLI::App& app);
  bool wanted() const { return !file_.empty(); }
  void check() const;  // tries the file, then makes the template
  // The pixels of --against that were asked for; nothing without it.
  std::optional<Rgb8> read(const Camera& camera, const SimulateOptions& options) const;
  // The rest of the page is what `command` was given.
  void write(const CLI::App& command, FramePage page, const Simulation& simulation,
             const SimulateOptions& options) const;

 private:
  std::string file_, against_;
};

}  // namespace pipegs
