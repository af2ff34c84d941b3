// SPDX-License-Identifier: Apache-2.0
// info.cpp: `pipegs info SCENE`: what is in a scene and what in it looks wrong.
#include <fmt/format.h>

#include "scenes/generate/generate.hpp"
#include "scenes/info.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"

namespace pipegs {

void add_info(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("info", "counts, SH degree, bounds and suspicious values of a scene");
  command->footer(footer("pipegs info garden.ply --json", "done"));
  static std::string scene, save;
  static bool json = false;
  command->add_option("SCENE", scene, "scene as .ply; without it our own scene");
  command->add_option("--save", save, "write the scene as a .ply (our own scene for other viewers)");
  command->add_flag("--json", json, "as JSON");
  command->callback([&run] {
    run = [] {
      try_file("--save", save);
      const Scene loaded = scene.empty() ? generate_scene(1) : read_ply(scene);
      const SceneInfo info = inspect(loaded);
      fmt::print("{}\n", json ? to_json(info) : to_text(info));
      if (save.empty()) return kExitOk;
      make_folder_of(save);
      write_ply(save, loaded);
      return kExitOk;
    };
  });
}

}  // namespace pipegs
