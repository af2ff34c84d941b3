// SPDX-License-Identifier: Apache-2.0
// info.cpp: `pipegs info SCENE`: what is in a scene, what its format has lost and what in it looks wrong.
#include <fmt/format.h>

#include "scenes/info.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"

namespace pipegs {

void add_info(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("info", "counts, SH degree, bounds, format and suspicious values of a scene");
  command->footer(footer("pipegs info garden.ply --json", "done"));
  static SceneArguments scene;
  static std::string save;
  static bool json = false;
  scene.add(*command);
  command->add_option("--save", save, "write the scene as a .ply (our own scene for other viewers)");
  command->add_flag("--json", json, "as JSON");
  command->callback([&run] {
    run = [] {
      try_file("--save", save);
      SceneFormat format;
      const Scene loaded = scene.load(&format);
      SceneInfo info = inspect(loaded);
      info.format = format;
      fmt::print("{}\n", json ? to_json(info) : to_text(info));
      if (save.empty()) return kExitOk;
      make_folder_of(save);
      write_ply(save, loaded);
      return kExitOk;
    };
  });
}

}  // namespace pipegs
