// SPDX-License-Identifier: Apache-2.0
// split.cpp: `pipegs split`: a scene of many more Gaussians that shows about the same picture, with cameras.
#include <fmt/format.h>

#include "scenes/generate/generate.hpp"
#include "scenes/input_error.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"
#include "sim/command/picture_size.hpp"

namespace pipegs {
namespace {

constexpr std::size_t kMostGaussians = std::size_t{1} << 24;  // of the machine's index

struct SplitArguments {
  SceneArguments scene;
  std::string cameras, out = "split";
  std::size_t gaussians = 1000000;
  int sh_degree = kMaxShDegree;
  uint64_t seed = 1;
  std::vector<std::string> sizes;
};

// All views at the first size, then all at the second; without sizes as they are.
std::vector<Camera> cameras_of(const SplitArguments& arguments) {
  const auto cameras = arguments.cameras.empty() ? generated_cameras() : read_cameras(arguments.cameras);
  if (arguments.sizes.empty()) return cameras;
  std::vector<Camera> all;
  for (const std::string& size : arguments.sizes) {
    for (const Camera& camera : cameras) {
      const PictureSize wanted = picture_size("--sizes", size);
      all.push_back(resized(camera, wanted.width, wanted.height));
      all.back().name += fmt::format("_{}x{}", wanted.width, wanted.height);
      all.back().id = static_cast<int>(all.size()) - 1;
    }
  }
  return all;
}

int split(const SplitArguments& arguments) {
  if (arguments.scene.file.empty() != arguments.cameras.empty())
    throw ConfigError("SCENE, --cameras: expected both, or neither for our own scene");
  try_folder("--out", arguments.out, {"scene.ply", "cameras.json"});
  const std::vector<Camera> cameras = cameras_of(arguments);
  const Scene whole = arguments.scene.load();
  if (whole.gaussians.empty() || arguments.gaussians < whole.gaussians.size()) {
    throw ConfigError(
        fmt::format("--gaussians: found {}, expected at least the {} of scene '{}', which must not be "
                    "empty",
                    arguments.gaussians, whole.gaussians.size(), whole.name));
  }
  const Scene parts = split_scene(whole, arguments.gaussians, arguments.sh_degree, arguments.seed);
  make_folder_of(arguments.out + "/scene.ply");
  write_ply(arguments.out + "/scene.ply", parts);
  write_cameras(arguments.out + "/cameras.json", cameras);
  fmt::print("{}/scene.ply: {} Gaussians, SH degree {}; {}/cameras.json: {} views\n", arguments.out,
             parts.gaussians.size(), parts.sh_degree, arguments.out, cameras.size());
  return kExitOk;
}

}  // namespace

void add_split(CLI::App& app, Run& run) {
  CLI::App* command =
      app.add_subcommand("split", "a larger scene of a smaller one: each Gaussian becomes several smaller ones");
  command->footer(footer("pipegs split --gaussians 4000000 --sh-degree 1 --sizes 1296x840,3840x2160 --out large",
                         "done", "",
                         "What a scene of millions of Gaussians takes can be measured without one: the parts of a "
                         "Gaussian are\ndrawn from it, and cover the area that it covers."));
  static SplitArguments arguments;
  arguments.scene.add(*command);
  command->add_option("--cameras", arguments.cameras, "cameras in any format that says its size; needed with SCENE");
  add_integer(*command, "--gaussians", arguments.gaussians, "how many the new scene has", std::size_t{1},
              kMostGaussians)
      ->capture_default_str();
  add_integer(*command, "--sh-degree", arguments.sh_degree, "highest degree of SH that it keeps", 0, kMaxShDegree)
      ->capture_default_str();
  add_integer(*command, "--seed", arguments.seed, "of where the parts lie")->capture_default_str();
  add_names(*command, "--sizes", arguments.sizes,
            "write the views at these sizes, WxH by commas; as wide an angle as before");
  command->add_option("--out", arguments.out, "folder for scene.ply and cameras.json")->capture_default_str();
  command->callback([&run] { run = [] { return split(arguments); }; });
}

}  // namespace pipegs
