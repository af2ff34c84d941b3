// SPDX-License-Identifier: Apache-2.0
// option_groups.cpp: see option_groups.hpp.
#include "sim/command/option_groups.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

namespace pipegs {
namespace {

struct OptionGroup {
  std::string name;
  std::vector<std::string> options;
};
const OptionGroup kGroups[] = {
    {"Scene", {"--lod", "--axes", "--strict"}},
    {"Camera",
     {"--cameras", "--view", "--views", "--path", "--gaze", "--budget", "--size", "--scale", "--window", "--crop",
      "--ignore-distortion", "--orbit", "--from", "--look-at", "--up", "--fov", "--near", "--background"}},
    {"Machine",
     {"--design", "--designs", "--config", "--set", "--walk-most", "--rest", "--lod-pixels", "--picture", "--effects",
      "--netlist", "--gates"}},
    {"Memory", {"--memory", "--latency", "--bandwidth", "--jitter"}},
    {"Output",
     {"--out", "--json", "--page", "--against", "--viewer", "--frames", "--waves", "--waves-around", "--store",
      "--no-rtl", "--no-truth"}}};

}  // namespace

void group_options(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    for (const OptionGroup& group : kGroups) {
      if (std::find(group.options.begin(), group.options.end(), option->get_name()) != group.options.end())
        option->group(group.name);
    }
  }
  for (CLI::App* command : app.get_subcommands(nullptr)) group_options(*command);
}

}  // namespace pipegs
