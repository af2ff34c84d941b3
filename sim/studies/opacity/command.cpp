// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs study opacity`: how many Gaussians of a scene have which opacity.
//
// Idea    The scene alone, no view: tenths of the opacity, and what lies below 1/255, which no machine draws.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sim/command/command.hpp"
#include "sim/command/page/study_output.hpp"

namespace pipegs {
namespace {

constexpr int kParts = 10;
constexpr double kLeast = 1.0 / 255;

struct OpacityArguments {
  SceneArguments scene;
  StudyOutput output;
};

struct OpacityCounts {
  size_t culled = 0, unseen = 0;  // no Gaussians at all; below kLeast
  std::array<size_t, kParts> parts{};
};

OpacityCounts count_opacities(const Scene& scene) {
  OpacityCounts counts;
  for (size_t i = 0; i < scene.gaussians.size(); ++i) {
    ActivatedGaussian gaussian;
    if (activate(scene, i, gaussian) != Cull::kNone) {
      ++counts.culled;
      continue;
    }
    counts.unseen += gaussian.opacity < kLeast;
    ++counts.parts[static_cast<size_t>(std::clamp(static_cast<int>(kParts * gaussian.opacity), 0, kParts - 1))];
  }
  return counts;
}

int opacity(const OpacityArguments& arguments) {
  arguments.output.check();
  SceneFormat format;
  const Scene scene = arguments.scene.load(format);
  arguments.scene.tell(format.findings);
  const OpacityCounts counts = count_opacities(scene);
  Table table{.columns = {{.key = "from", .heading = "opacity from", .digits = 1},
                          {.key = "to", .heading = "to", .digits = 1},
                          {.key = "gaussians", .heading = "Gaussians"}},
              .notes = {fmt::format("{} below 1/255, {} culled", counts.unseen, counts.culled)}};
  for (size_t part = 0; part < kParts; ++part) {
    table.rows.push_back({number_cell(static_cast<double>(part) / kParts),
                          number_cell(static_cast<double>(part + 1) / kParts),
                          number_cell(static_cast<double>(counts.parts[part]))});
  }
  arguments.output.write({.title = "Opacity of a scene's Gaussians",
                          .head = fmt::format("{}: {} Gaussians", scene.name, scene.gaussians.size()),
                          .charts = {},
                          .tables = {table},
                          .machines = {},
                          .note = {},
                          .odd = format.findings},
                         {{"scene", scene.name},
                          {"gaussians", scene.gaussians.size()},
                          {"parts", counts.parts},
                          {"below_1_255", counts.unseen},
                          {"culled", counts.culled}});
  return kExitOk;
}

}  // namespace

void add_opacity(CLI::App& app, Run& run) {
  CLI::App& command = add_command(app, "opacity", "how many Gaussians of a scene have which opacity",
                                  footer("pipegs study opacity garden.ply --out opacity --page", "counted"));
  static OpacityArguments arguments;
  arguments.scene.add(command);
  arguments.output.add(command);
  when_chosen(command, run, [] { return opacity(arguments); });
}

}  // namespace pipegs
