// SPDX-License-Identifier: Apache-2.0
// command.cpp: `pipegs train`: a scene of photographs, or a trained scene again for the order of the machine.
//
// Idea    What was trained is in the checkpoint; scene, cameras and figures are written when the last step is done. An
//         interrupt writes a checkpoint and leaves; --resume takes it up, and begins where there is none.
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <set>

#include "cpp_model/frame_setup.hpp"
#include "scenes/cameras/around.hpp"
#include "scenes/check/view_check.hpp"
#include "scenes/colmap/colmap.hpp"
#include "scenes/input_error.hpp"
#include "scenes/own_failure.hpp"
#include "scenes/ply/ply.hpp"
#include "sim/command/command.hpp"
#include "sim/studies/train/train_report.hpp"
#include "sim/progress.hpp"
#include "sim/studies/train/run/checkpoint.hpp"
#include "sim/studies/train/start/start.hpp"

namespace pipegs {
namespace {

namespace fs = std::filesystem;

struct TrainArguments {
  SceneArguments scene;  // or the folder of photographs
  CameraArguments cameras;
  std::string out = "trained", order = "layered", cldr;
  int around = 0, steps = 3000, downscale = 1, sh_degree = kMaxShDegree, layers = 0, checkpoint_every = 500;
  std::size_t most_gaussians = 200000;
  uint64_t seed = 1;
  unsigned threads = 0;
  double near_plane = 0;  // 0: INRIA's, or as the points of the photographs need it
  bool resume = false, json = false;
};

// Bytes that a pixel of a view takes: its codes; computed colours.
constexpr uint64_t kPhotoBytes = 3, kComputedBytes = 12;

struct TrainInput {
  TrainingViews views;
  std::vector<TrainingView> given;  // of the trained ones, those that more were made about: they are measured, too
  Parameters start;
  glm::dvec3 origin{0};  // was subtracted from scene and cameras
  Findings of_views;     // told when a machine has taken the cameras
  std::shared_ptr<Told> told;
};

void stop_if_interrupted() {
  if (interrupted()) throw std::runtime_error("interrupted");
}

// Shows how far a stage is, and ends it at an interrupt.
Advance shown_in(Progress& progress) {
  return [&progress](double share) {
    stop_if_interrupted();
    progress.update(share);
  };
}

void check_memory(const std::vector<Camera>& cameras, int downscale, uint64_t bytes_per_pixel) {
  uint64_t pixels = 0;
  for (const Camera& camera : cameras)
    pixels += static_cast<uint64_t>(camera.width) * static_cast<uint64_t>(camera.height);
  const uint64_t squared = static_cast<uint64_t>(downscale) * static_cast<uint64_t>(downscale);
  const uint64_t needed = pixels / squared * bytes_per_pixel, free = free_memory();
  if (needed <= free) return;
  throw InputError(
      fmt::format("{} pictures would take {:.1f} GB of memory, {:.1f} GB are free (--downscale makes them "
                  "smaller)",
                  cameras.size(), static_cast<double>(needed) / 1e9, static_cast<double>(free) / 1e9));
}

TrainInput of_photographs(const TrainArguments& arguments, const CLI::App& command) {
  for (const char* option : {"--cameras", "--orbit", "--around", "--size", "--scale", "--from", "--look-at", "--up",
                             "--fov", "--lod", "--axes"}) {
    if (is_given(command, option))
      throw ConfigError(
          fmt::format("{}: found one with a folder of photographs, expected none: COLMAP's model has the "
                      "cameras (--downscale makes pictures smaller)",
                      option));
  }
  Findings findings;
  const ColmapFolder folder = read_colmap(arguments.scene.file, arguments.cameras.ignore_distortion, findings);
  check_memory(folder.cameras, arguments.downscale, kPhotoBytes);
  TrainInput input;
  {
    Progress progress("photographs");
    const double near = arguments.near_plane > 0 ? arguments.near_plane : near_plane_of(folder, findings);
    input.views = views_of_photographs(folder, arguments.downscale, near, shown_in(progress), findings);
  }
  input.told = std::make_shared<Told>(arguments.scene);
  input.told->tell(findings);
  input.start = start_of_points(folder.points, arguments.sh_degree, arguments.most_gaussians, arguments.threads);
  return input;
}

TrainInput of_scene(const TrainArguments& arguments) {
  Findings findings;
  const std::optional<std::vector<Camera>> given = arguments.cameras.read(findings);
  const bool own = arguments.scene.file.empty();
  SceneFormat format;
  const Scene scene = arguments.scene.load(format);
  std::vector<Camera> cameras = arguments.cameras.views(given, scene, own, format.origin);
  TrainInput input;
  std::set<std::string> given_names;
  if (arguments.around > 0) {
    for (const Camera& camera : cameras) given_names.insert(camera.name);
    cameras = cameras_around(cameras, arguments.around, arguments.seed);
  }
  if (cameras.size() < 2)
    throw InputError(arguments.cameras.file, "",
                     "found one view, expected at least two, of which one is held out: --cameras, --orbit or --around");
  check_memory(cameras, arguments.downscale, kComputedBytes);
  start_of_scene(arguments.scene.file, scene, 1);  // refused before it is drawn
  input.told = std::make_shared<Told>(arguments.scene);
  input.told->tell(format.findings);
  input.told->tell(findings);
  const double near = arguments.near_plane > 0 ? arguments.near_plane : kNearPlane;
  input.of_views = check_views(scene, cameras, near);
  Progress progress("targets");
  input.origin = format.origin;
  input.views = views_of_scene(scene, cameras, arguments.downscale, arguments.threads, shown_in(progress), near);
  for (const TrainingView& view : input.views.trained) {
    if (given_names.contains(view.camera.name)) input.given.push_back(view);
  }
  input.start = start_of_scene(arguments.scene.file, scene, input.views.extent);
  return input;
}

TrainOptions options_of(const TrainArguments& arguments, bool fine_tuning) {
  TrainOptions options;
  options.schedule = {arguments.steps, fine_tuning};
  options.seed = arguments.seed;
  options.most_gaussians = arguments.most_gaussians;
  options.layers = arguments.layers;
  options.draws_layered = arguments.order == "layered";
  // Where the picture can be met, nothing needs to be asked for beside it.
  options.regularised = arguments.cldr.empty() ? !fine_tuning : arguments.cldr != "none";
  if (arguments.cldr == "printed") options.cldr = {CldrForm::kPrinted, 0.05};
  else options.cldr = {CldrForm::kLogarithm, 0.03};
  options.layers_begin = fine_tuning ? 0 : 0.5;
  options.threads = arguments.threads;
  return options;
}

TrainQuality quality_of(const Parameters& parameters, const std::vector<TrainingView>& views, int layers,
                        unsigned threads, Told& told) {
  const LayerGrid grid = layer_grid(parameters, layers);
  const Scene scene = scene_of(parameters, "");
  Progress progress("held out");
  const auto quarter = [&](int number) {
    return [&progress, number](double share) {
      stop_if_interrupted();
      progress.update((number + share) / 4);
    };
  };
  const auto half = [&](double share) { quarter(2)(2 * share); };
  const auto tell = [&](const Findings& findings) { told.tell_frame(findings); };
  return {likeness(parameters, views, nullptr, threads, quarter(0)),
          likeness(parameters, views, &grid, threads, quarter(1)), both_machines(scene, views, layers, tell, half),
          margin(scene, grid)};
}

// FrameError when a camera is none of a machine that draws the views in the end: before the first step.
void check_cameras(const TrainInput& input, int layers) {
  std::vector<Camera> cameras;
  for (const auto* views : {&input.views.trained, &input.views.held_out, &input.given}) {
    for (const TrainingView& view : *views) cameras.push_back(view.camera);
  }
  const Scene scene = scene_of(input.start, "");
  for (const std::string_view name : {std::string_view("dop"), kDefaultDesignPoint}) {
    SimulateOptions options;
    options.config = find_design_point(name).config;
    if (name == "dop") options.config.grid = layers;
    const PackedScene packed = pack_views(scene, cameras, options);
    for (const Camera& camera : cameras) frame_setup(options.config, packed, camera, {}, options.near_plane);
  }
}

// Takes the steps that are left; checkpoints on the way, at the end and at an interrupt.
TrainState train(const TrainArguments& arguments, const TrainOptions& options, const TrainInput& input) {
  const fs::path path = fs::path(arguments.out) / "checkpoint.bin";
  const uint64_t mark = run_mark(options, input.views, input.start);
  std::error_code ignored;
  const bool goes_on = arguments.resume && fs::exists(path, ignored);
  Trainer trainer(options, input.views, goes_on ? read_checkpoint(path, mark) : Trainer::begin(input.start));
  make_folder_of(path);
  const int first = trainer.state().step;
  Progress progress("training");
  Stopwatch all, since;
  const auto keep = [&] {
    trainer.add_seconds(since.seconds());
    since = Stopwatch();
    write_checkpoint(path, mark, trainer.state());
  };
  while (!trainer.done()) {
    trainer.step();
    const int step = trainer.state().step;
    const double done = step - first;
    progress.update(done / (options.schedule.steps - first), fmt::format("{:.1f} steps/s", done / all.seconds()));
    if (interrupted()) {
      keep();
      throw std::runtime_error(fmt::format("interrupted after step {} of {}; --resume goes on from {}", step,
                                           options.schedule.steps, path.string()));
    }
    if (step % arguments.checkpoint_every == 0 || trainer.done()) keep();
  }
  return trainer.state();
}

std::vector<Camera> cameras_of(const std::vector<TrainingView>& views, const glm::dvec3& origin) {
  std::vector<Camera> cameras;
  for (const TrainingView& view : views) {
    cameras.push_back(view.camera);
    cameras.back().position += origin;
  }
  return cameras;
}

int run_train(const TrainArguments& arguments, const CLI::App& command) {
  std::error_code ignored;
  const bool fine_tuning = !fs::is_directory(arguments.scene.file, ignored);
  const TrainOptions options = options_of(arguments, fine_tuning);
  if (options.layers != 0 && options.layers != 2 && options.layers != 4 && options.layers != 8)
    throw ConfigError(fmt::format("--layers: found {}, expected 0 for none, or 2, 4 or 8", options.layers));
  const fs::path out = arguments.out;
  try_folder("--out", out, {"scene.ply", "cameras.json", "held_out.json", "train.json", "checkpoint.bin"});
  const TrainInput input = fine_tuning ? of_scene(arguments) : of_photographs(arguments, command);

  TrainReport report{arguments.scene.file,
                     arguments.downscale,
                     input.views.trained.size(),
                     input.views.held_out.size(),
                     {},
                     options.layers > 0 ? options.layers : Config().grid,
                     std::nullopt,
                     {}};
  std::vector<TrainingView> measured = input.views.held_out;
  measured.insert(measured.end(), input.given.begin(), input.given.end());
  for (const TrainingView& view : measured) report.measured.push_back(view.camera.name);
  check_cameras(input, report.layers);
  input.told->tell(input.of_views);
  const TrainState state = train(arguments, options, input);
  if (state.parameters.size() == 0) throw OwnFailure("no Gaussian is left: the views ask for none");
  if (fine_tuning) report.before = quality_of(input.start, measured, report.layers, options.threads, *input.told);
  report.after = quality_of(state.parameters, measured, report.layers, options.threads, *input.told);

  std::vector<Camera> cameras = cameras_of(input.views.trained, input.origin);
  const std::vector<Camera> held_out = cameras_of(input.views.held_out, input.origin);
  cameras.insert(cameras.end(), held_out.begin(), held_out.end());
  std::sort(cameras.begin(), cameras.end(), [](const Camera& a, const Camera& b) { return a.id < b.id; });
  write_ply(out / "scene.ply", scene_of(state.parameters, "scene"), input.origin);
  write_cameras(out / "cameras.json", cameras);
  write_cameras(out / "held_out.json", held_out);
  nlohmann::ordered_json figures = train_json(options, state, report);
  figures["findings"] = to_json(input.told->all());
  const std::string json = figures.dump(2) + "\n";
  write_text(out / "train.json", json);
  if (arguments.json) fmt::print("{}", json);
  else
    fmt::print("{}scene {}/scene.ply, cameras {}/cameras.json, figures {}/train.json\n", train_text(state, report),
               arguments.out, arguments.out, arguments.out);
  return kExitOk;
}

}  // namespace

void add_train(CLI::App& app, Run& run) {
  CLI::App& command =
      add_command(app, "train", "trains a scene on photographs, or for layers",
                  footer("pipegs train garden --steps 7000 --layers 8 --out garden_trained", "trained", "",
                         "A folder of photographs has COLMAP's sparse/0 and images. A scene is fine-tuned on its own "
                         "pictures in exact\norder, from its views. Every 8th view is held out. An "
                         "interrupt (exit code 130) writes\nOUT/checkpoint.bin, and --resume goes on from it."));
  static TrainArguments arguments;
  arguments.scene.add(command, "a folder of photographs, or a scene in any format; without it our own");
  arguments.cameras.add(command);
  add_integer(command, "--around", arguments.around, "of a scene: so many more views about each of its views", 1, 1000);
  add_text(command, "--out", arguments.out, "folder for scene.ply, cameras.json, held_out.json, train.json")
      .shows_default();
  add_integer(command, "--steps", arguments.steps, "how many views are taken, one a step", 1, 10000000).shows_default();
  add_integer(command, "--downscale", arguments.downscale, "sides of the pictures are divided by this", 1, 64)
      .shows_default();
  add_integer(command, "--max-gaussians", arguments.most_gaussians, "no more than these", std::size_t{kFewestPoints},
              std::size_t{1} << 24)
      .shows_default();
  add_integer(command, "--sh-degree", arguments.sh_degree, "of photographs: highest degree of SH", 0, kMaxShDegree)
      .shows_default();
  add_real(command, "--near", arguments.near_plane,
           "near plane, scene units; without it 0.2, or nearer when points of photographs lie before that", kPositive);
  add_integer(command, "--seed", arguments.seed, "of the views' order and of what is split").shows_default();
  add_integer(command, "--layers", arguments.layers, "train for layers of a grid of 2, 4 or 8 cells an axis; 0: none",
              0, 8)
      .shows_default();
  add_text(command, "--order", arguments.order, "with --layers: the order in which the steps draw")
      .shows_default()
      .one_of({"layered", "exact"});
  add_text(command, "--cldr", arguments.cldr,
           "with --layers: the loss that keeps Gaussians inside their layer; without it logarithm of photographs, "
           "none of a scene")
      .one_of({"logarithm", "printed", "none"});
  add_integer(command, "--checkpoint-every", arguments.checkpoint_every, "steps between two checkpoints", 1, 10000000)
      .shows_default();
  add_flag(command, "--resume", arguments.resume, "go on from the checkpoint in --out, if there is one");
  add_flag(command, "--json", arguments.json, "print train.json");
  add_integer(command, "--threads", arguments.threads, "0: as many as the computer has; no result depends on it", 0u,
              1024u)
      .shows_default();
  when_chosen(command, run, [&command] { return run_train(arguments, command); });
}

}  // namespace pipegs
