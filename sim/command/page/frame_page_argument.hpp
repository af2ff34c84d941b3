// SPDX-License-Identifier: Apache-2.0
// frame_page_argument.hpp: `pipegs sim --page`: the frame as one HTML page.
//
#pragma once

#include <string>

#include "sim/command/command.hpp"
#include "sim/report/html/frame/frame_page.hpp"

namespace pipegs {

class FramePageArgument {
 public:
  void add(CLI::App& app);
  bool wanted() const { return wanted_; }
  void check() const;  // makes the template
  // Whether a page can hold the pixels that were asked for.
  void check(const Camera& camera, const SimulateOptions& options) const;
  // page.html in the folder `out`. The rest of the page is what `command` was given.
  void write(const CLI::App& command, const std::string& out, FramePage page, const Simulation& simulation,
             const SimulateOptions& options) const;

 private:
  bool wanted_ = false;
};

}  // namespace pipegs
