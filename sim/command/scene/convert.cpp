// SPDX-License-Identifier: Apache-2.0
// convert.cpp: `pipegs convert`: a scene of any format that is read, or our own, as a .ply in INRIA's layout.
#include <fmt/format.h>

#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"

namespace pipegs {

void add_convert(CLI::App& app, Run& run) {
  CLI::App& command = add_command(app, "convert", "a scene of another format as INRIA's .ply",
                                  footer("pipegs convert garden.sog --out garden", "done"));
  static SceneArguments scene;
  static std::string out = "converted";
  scene.add(command);
  add_text(command, "--out", out, "folder for scene.ply").shows_default();
  when_chosen(command, run, [] {
    try_folder("--out", out, {"scene.ply"});
    SceneFormat format;
    const Scene loaded = scene.load(format);
    scene.tell(format.findings);
    const std::filesystem::path file = std::filesystem::path(out) / "scene.ply";
    make_folder_of(file);
    const std::size_t left_out = write_ply(file, loaded, format.origin);
    if (left_out > 0)
      scene.tell(
          {{"not_written", fmt::format("{} Gaussians with values that are no numbers are not written", left_out)}});
    fmt::print("{}: {} Gaussians, SH degree {}; from {}\n", file.string(), loaded.gaussians.size() - left_out,
               loaded.sh_degree, format.name.empty() ? "the generator" : format.name);
    return kExitOk;
  });
}

}  // namespace pipegs
