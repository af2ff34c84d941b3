// SPDX-License-Identifier: Apache-2.0
// viewer_argument.hpp: `pipegs sim --viewer`: the page of the frames that were simulated.
//
// Idea    What stands in the page is sim/report/html/viewer.hpp's; here is when it is made.
// Use     begin() before anything is computed, add() for each frame in its order,
//         write() at the end. Without the option all of them do nothing.
#pragma once

#include <string>
#include <vector>

#include "sim/command/command.hpp"
#include "sim/report/html/viewer.hpp"

namespace pipegs {

class ViewerArgument {
 public:
  void add_option(CLI::App& app);
  bool wanted() const { return wanted_; }
  // The command line is that of `command`.
  void begin(const LoadedView& loaded, const std::vector<Camera>& cameras, const SimulateOptions& options,
             const Background& background, const CLI::App& command);
  void add(const Rgb8& picture);
  // viewer.html in the folder `out`. A line for the user; empty without the option.
  std::string write(const std::string& out);

 private:
  bool wanted_ = false;
  std::string template_;
  ViewerPage page_;
  std::size_t added_ = 0;
};

}  // namespace pipegs
