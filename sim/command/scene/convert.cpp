// SPDX-License-Identifier: Apache-2.0
// convert.cpp: `pipegs convert IN OUT.ply`: a scene of any format that is read, as a .ply in INRIA's layout.
#include <fmt/format.h>

#include "scenes/input_error.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"

namespace pipegs {

void add_convert(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("convert", "a scene of another format as .ply in INRIA's layout");
  command->footer(footer("pipegs convert garden.sog garden.ply", "done"));
  static SceneArguments scene;
  static std::string out;
  scene.add(*command);
  command->get_option("SCENE")->required();
  command->add_option("OUT", out, "the .ply that is written")->required();
  command->callback([&run] {
    run = [] {
      if (std::filesystem::path(out).extension() != ".ply")
        throw InputError("OUT", "", fmt::format("found {}, expected a name that ends in .ply", quote(out)));
      try_file("OUT", out);
      SceneFormat format;
      const Scene loaded = scene.load(&format);
      make_folder_of(out);
      write_ply(out, loaded);
      fmt::print("{}: {} Gaussians, SH degree {}; from {}\n", out, loaded.gaussians.size(), loaded.sh_degree,
                 format.name);
      return kExitOk;
    };
  });
}

}  // namespace pipegs
