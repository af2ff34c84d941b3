// SPDX-License-Identifier: Apache-2.0
// info.cpp: `pipegs info SCENE`: what is in a scene, what its format has lost and what in it looks wrong.
#include <fmt/format.h>

#include "scenes/info.hpp"
#include "sim/command/command.hpp"
#include "scenes/text/json.hpp"
#include "sim/layers/cldr.hpp"

namespace pipegs {
namespace {

// None of a scene of which nothing can be drawn.
std::vector<Margin> margins_of(const Scene& scene, const SceneInfo& info) {
  std::vector<Margin> margins;
  for (const int grid : kMarginGrids)
    if (info.usable > 0) margins.push_back(margin(scene, layer_grid(scene, grid)));
  return margins;
}

nlohmann::ordered_json json_of(const std::vector<Margin>& margins) {
  auto json = nlohmann::ordered_json::array();
  for (const Margin& m : margins) { json.push_back({{"grid", m.grid}, {"violators_share", m.share}}); }
  return json;
}

std::string text_of(const std::vector<Margin>& margins) {
  std::string out;
  for (const Margin& m : margins) {
    out += fmt::format("  {} layers: reach over a plane along x, y, z:", m.grid);
    for (const double share : m.share) out += fmt::format(" {:.2f} %", 100 * share);
    out += "\n";
  }
  return out;
}

}  // namespace

void add_info(CLI::App& app, Run& run) {
  CLI::App& command = add_command(app, "info", "what a scene holds and what looks wrong in it",
                                  footer("pipegs info garden.ply --json", "done"));
  static SceneArguments scene;
  static bool json = false;
  scene.add(command);
  add_flag(command, "--json", json, "as JSON");
  when_chosen(command, run, [] {
    SceneFormat format;
    const Scene loaded = scene.load(format);
    SceneInfo info = inspect(loaded, format.findings);
    info.format = format;
    const std::vector<Margin> margins = margins_of(loaded, info);
    if (json) {
      auto all = nlohmann::ordered_json::parse(to_json(info));
      all["layers"] = json_of(margins);
      fmt::print("{}\n", json_text(all, 1));
    } else {
      fmt::print("{}{}\n", to_text(info), text_of(margins));
    }
    for (const Finding& finding : info.findings) {
      const Severity severity = finding.kind->severity;
      if (severity == Severity::kError || (scene.strict && severity == Severity::kWarning)) scene.tell({finding});
    }
    return kExitOk;
  });
}

}  // namespace pipegs
