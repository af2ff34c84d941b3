// command_render.cpp: `pipegs render`: the pictures without the RTL.
#include <fmt/format.h>

#include "cpp_model/float/truth.hpp"
#include "sim/command.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct Arguments {
  ViewArguments view;
  std::string model = "golden", semantics = "exact", out = "out";
};

int render(const Arguments& arguments) {
  const SimulateOptions options = arguments.view.options();
  const LoadedView loaded = load_view(arguments.view);
  Simulation simulation;
  if (arguments.model != "truth") simulate_golden(loaded.scene, loaded.camera, options, simulation);
  if (arguments.model == "golden") {
    write_images(arguments.out, crop_window(simulation.golden.image, options));
  } else {
    TruthOptions truth;
    truth.semantics = arguments.semantics == "inria" ? Semantics::kInria : arguments.semantics == "gsplat" ? Semantics::kGsplat : Semantics::kExact;
    if (arguments.model == "layered") truth.rank = &simulation.golden.rank;
    truth.near_plane = options.near_plane;
    Progress progress("truth");
    truth.progress = [&](double share) {
      if (interrupted()) throw std::runtime_error("interrupted");
      progress.update(share);
    };
    write_images(arguments.out, crop_window(render_truth(loaded.scene, loaded.camera, truth), options));
  }
  fmt::print("picture {}/frame.png, {}/frame.exr\n", arguments.out, arguments.out);
  return kExitOk;
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("render", "writes frame.exr and frame.png without simulating the RTL");
  command->footer("Example: pipegs render garden.ply --cameras cameras.json --model truth --semantics inria --out inria");
  static Arguments arguments;
  arguments.view.add(*command);
  command->add_option("--model", arguments.model,
                      "truth (float64, global depth order), layered (float64, the hardware's order) or golden (fixed point)")
      ->capture_default_str()->check(CLI::IsMember({"truth", "layered", "golden"}));
  command->add_option("--semantics", arguments.semantics, "of the float64 models: footprints and pixel centres")
      ->capture_default_str()->check(CLI::IsMember({"exact", "inria", "gsplat"}));
  command->add_option("--out", arguments.out, "folder for frame.exr and frame.png")->capture_default_str();
  command->callback([&run] { run = [] { return render(arguments); }; });
}

}  // namespace pipegs
