// SPDX-License-Identifier: Apache-2.0
// render.cpp: `pipegs render`: the pictures without the RTL.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "cpp_model/float/image.hpp"
#include "cpp_model/float/truth.hpp"
#include "scenes/input_error.hpp"
#include "sim/command/command.hpp"
#include "sim/command/frame/picture_arguments.hpp"
#include "sim/progress.hpp"

namespace pipegs {
namespace {

struct RenderArguments {
  ViewArguments view;
  PictureArguments picture;
  std::string model = "golden", semantics = "exact", out = "out", compare;
};

// The picture to compare with, read before anything is rendered.
std::optional<Rgb8> read_other(const std::string& path, const Camera& camera, const SimulateOptions& options) {
  if (path.empty()) return std::nullopt;
  Rgb8 other = read_png8(path);
  const PixelRect r = asked_pixels(camera.width, camera.height, options);
  const int width = r.x1 - r.x0, height = r.y1 - r.y0;
  if (other.width == width && other.height == height) return other;
  throw InputError(path, "",
                   fmt::format("found {}x{} pixels, expected {}x{}", other.width, other.height, width, height));
}

// Prints how the written picture differs from another one, in 8-bit codes; whether it does.
bool differs(const Rgb8& mine, const Rgb8& other, const std::string& path) {
  int largest = 0;
  size_t differing = 0;
  for (size_t i = 0; i < mine.data.size(); i += 3) {
    int pixel = 0;
    for (size_t k = i; k < i + 3; ++k) pixel = std::max(pixel, std::abs(int{mine.data[k]} - int{other.data[k]}));
    largest = std::max(largest, pixel);
    differing += pixel > 0;
  }
  fmt::print("against {}: {} of {} pixels differ, by {} codes at most\n", path, differing, mine.data.size() / 3,
             largest);
  return differing > 0;
}

int render(const RenderArguments& arguments) {
  SimulateOptions options = arguments.view.options();
  arguments.picture.apply(arguments.view, arguments.model == "golden", options);
  try_folder("--out", arguments.out, {"frame.exr", "frame.png"});
  const LoadedView loaded = load_view(arguments.view);
  follow_scene(loaded, options);
  check_picture_memory(loaded.camera, options,
                       kWritePixels + (arguments.model == "truth" ? PixelBytes{} : kGoldenPixels) +
                           (arguments.model == "golden" ? PixelBytes{} : kImagePixels));
  const std::optional<Rgb8> other = read_other(arguments.compare, loaded.camera, options);
  Simulation simulation;
  if (arguments.model != "truth") simulate_golden(loaded.scene, loaded.camera, options, simulation);
  Image image;
  Rgb8 picture;
  if (arguments.model == "golden") {
    picture = arguments.picture.picture(simulation, options);
    image = crop_window(simulation.golden.image, options);
  } else {
    TruthOptions truth;
    truth.semantics = arguments.semantics == "inria"    ? Semantics::kInria
                      : arguments.semantics == "gsplat" ? Semantics::kGsplat
                                                        : Semantics::kExact;
    if (arguments.model == "layered") truth.rank = &simulation.golden.rank;
    truth.near_plane = options.near_plane;
    Progress progress("truth");
    truth.progress = [&](double share) {
      if (interrupted()) throw std::runtime_error("interrupted");
      progress.update(share);
    };
    image = crop_window(render_truth(loaded.scene, loaded.camera, truth), options);
    const Background& behind = arguments.picture.color();
    picture = to_rgb8(image, glm::dvec3(behind[0], behind[1], behind[2]) / 255.0);
  }
  write_images(arguments.out, image, picture);
  fmt::print("picture {}/frame.png, {}/frame.exr\n", arguments.out, arguments.out);
  return other && differs(picture, *other, arguments.compare) ? kExitDiffers : kExitOk;
}

}  // namespace

void add_render(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "render", "the picture of a view, without the RTL",
                  footer("pipegs render garden.ply --cameras cameras.json --model truth --semantics inria --out inria",
                         "written", "with --compare: a pixel differs"));
  static RenderArguments arguments;
  arguments.view.add(command);
  arguments.picture.add(command);
  add_text(command, "--model", arguments.model,
           "truth (float64, global depth order), layered (float64, the hardware's order) or golden (golden model)")
      .shows_default()
      .one_of({"truth", "layered", "golden"});
  add_text(command, "--semantics", arguments.semantics, "of the float64 models: footprints and pixel centres")
      .shows_default()
      .one_of({"exact", "inria", "gsplat"});
  add_text(command, "--out", arguments.out, "folder for frame.exr and frame.png").shows_default();
  add_text(command, "--compare", arguments.compare, "say how the picture differs from this 8-bit PNG of the same size");
  when_chosen(command, run, [] { return render(arguments); });
}

}  // namespace pipegs
